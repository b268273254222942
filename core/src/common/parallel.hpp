// SPDX-License-Identifier: MIT
/// @file
/// Loops on a given number of threads. Results must not depend on how the work is distributed.
#pragma once

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <cstddef>

#if defined(__SANITIZE_THREAD__)
#include <atomic>
#include <thread>
#include <vector>
#endif

namespace geomesh {

/// Returns the number of threads to use: all cores if `asked` is 0, and never more threads than cores.
inline unsigned thread_count(unsigned asked) {
  const auto cores = static_cast<unsigned>(tbb::this_task_arena::max_concurrency());
  return asked == 0 || asked > cores ? cores : asked;
}

/// Calls task(k) for k in [0, n), with one call at a time on each thread.
template <class Task>
void for_each_task(std::size_t n, unsigned threads, const Task& task) {
  if (threads <= 1 || n <= 1) {
    for (std::size_t k = 0; k < n; ++k) task(k);
    return;
  }
#if defined(__SANITIZE_THREAD__)
  // The thread sanitizer does not see how oneTBB synchronises its threads and would report races that do not exist.
  std::atomic<std::size_t> next{0};
  std::vector<std::thread> workers;
  for (unsigned t = 0; t < threads; ++t)
    workers.emplace_back([&] {
      for (std::size_t k; (k = next++) < n;) task(k);
    });
  for (std::thread& worker : workers) worker.join();
#else
  tbb::task_arena arena(static_cast<int>(threads));
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(0, n, 1),
        [&](const tbb::blocked_range<std::size_t>& range) {
          for (std::size_t k = range.begin(); k < range.end(); ++k) task(k);
        },
        tbb::simple_partitioner());
  });
#endif
}

/// Calls body(i) for i in [0, n). The calls are distributed in large chunks because the body is short.
template <class Body>
void for_each_index(std::size_t n, unsigned threads, const Body& body) {
  constexpr std::size_t chunk = 16384;
  for_each_task((n + chunk - 1) / chunk, threads, [&](std::size_t k) {
    const std::size_t end = k * chunk + chunk < n ? k * chunk + chunk : n;
    for (std::size_t i = k * chunk; i < end; ++i) body(i);
  });
}

}  // namespace geomesh
