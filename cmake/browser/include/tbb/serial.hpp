// SPDX-License-Identifier: MIT
/// @file
/// The part of oneTBB's interface that this tree uses, on one thread: a page in a browser has no others unless its
/// server sends special headers, and a page opened from a folder never has. Loops run in the order of their indices.
/// The results are those of any number of threads, because no result of this tree depends on that number.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>
#include <utility>

namespace tbb {

template <class Index>
class blocked_range {
 public:
  blocked_range(Index begin, Index end, std::size_t /*grain*/ = 1) : begin_(begin), end_(end) {}
  Index begin() const { return begin_; }
  Index end() const { return end_; }

 private:
  Index begin_, end_;
};

struct simple_partitioner {};

template <class Index, class Body>
void parallel_for(const blocked_range<Index>& range, const Body& body, const simple_partitioner& = {}) {
  if (range.begin() < range.end()) body(range);
}

template <class Index, class Body>
void parallel_for(Index begin, Index end, const Body& body) {
  for (; begin < end; ++begin) body(begin);
}

template <class Iterator, class... Less>
void parallel_sort(Iterator begin, Iterator end, const Less&... less) {
  std::sort(begin, end, less...);
}

namespace this_task_arena {
inline int max_concurrency() { return 1; }
}  // namespace this_task_arena

class task_arena {
 public:
  explicit task_arena(int /*threads*/ = 1) {}
  template <class Work>
  auto execute(const Work& work) {
    return work();
  }
};

class global_control {
 public:
  enum parameter { max_allowed_parallelism };
  global_control(parameter, std::size_t) {}
  static std::size_t active_value(parameter) { return 1; }
};

/// One value, made when it is first asked for.
template <class T>
class enumerable_thread_specific {
 public:
  enumerable_thread_specific() : make_([] { return std::make_unique<T>(); }) {}
  explicit enumerable_thread_specific(const T& first) : make_([first] { return std::make_unique<T>(first); }) {}
  T& local() {
    if (!value_) value_ = make_();
    return *value_;
  }
  T* begin() { return value_.get(); }
  T* end() { return value_.get() + (value_ ? 1 : 0); }

 private:
  std::function<std::unique_ptr<T>()> make_;
  std::unique_ptr<T> value_;
};

}  // namespace tbb
