// SPDX-License-Identifier: GPL-3.0-or-later
#include "project/problems.hpp"

#include <algorithm>
#include <tuple>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

void Problems::add(Place place, const std::string& message) { list_.push_back({place, message}); }

void Problems::throw_if_any() const {
  if (list_.empty()) return;
  std::vector<Problem> sorted = list_;
  std::stable_sort(sorted.begin(), sorted.end(), [](const Problem& a, const Problem& b) {
    return std::tie(a.place.line, a.place.column) < std::tie(b.place.line, b.place.column);
  });
  std::string text;
  for (const Problem& p : sorted) {
    text.append(text.empty() ? "" : "\n").append(file_);
    if (p.place.line > 0) text += ":" + std::to_string(p.place.line) + ":" + std::to_string(p.place.column);
    text += ": " + p.message;
  }
  throw Error(ErrorKind::usage, text);
}

}  // namespace geomesh::geomodel
