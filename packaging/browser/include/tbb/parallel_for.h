// SPDX-License-Identifier: MIT
#pragma once

#include "blocked_range.h"

namespace tbb {

struct simple_partitioner {};

template <class Value, class Body>
void parallel_for(const blocked_range<Value>& range, const Body& body, simple_partitioner = {}) {
  if (range.begin() < range.end()) body(range);
}
template <class Index, class Task>
void parallel_for(Index first, Index last, const Task& task) {
  for (; first < last; ++first) task(first);
}

}  // namespace tbb
