// SPDX-License-Identifier: MIT
/// @file
/// The calls of oneTBB that the engine and the front end make, on one thread: a WebAssembly program without shared memory
/// has no other.
#pragma once

namespace tbb {

class task_arena {
 public:
  explicit task_arena(int = 1) {}
  template <class Work>
  auto execute(Work&& work) {
    return work();
  }
};

namespace this_task_arena {
inline int max_concurrency() { return 1; }
}  // namespace this_task_arena

}  // namespace tbb
