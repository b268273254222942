// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <vector>

namespace geomesh {

template <class T>
void sort_unique(std::vector<T>& v) {
  std::sort(v.begin(), v.end());
  v.erase(std::unique(v.begin(), v.end()), v.end());
}

}  // namespace geomesh
