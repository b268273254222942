// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>

namespace tbb {

template <class Iterator, class... Less>
void parallel_sort(Iterator begin, Iterator end, const Less&... less) {
  std::sort(begin, end, less...);
}

}  // namespace tbb
