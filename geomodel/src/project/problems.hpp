// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Collects the mistakes in a project file, so that one run reports all of them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geomesh/geomodel/words.hpp"

namespace geomesh::geomodel {

/// Line and column in the project file, from 1; 0 if not known.
struct Place {
  int line = 0, column = 0;
};

class Problems {
 public:
  explicit Problems(std::string file) : file_(std::move(file)) {}
  void add(Place place, const std::string& message);
  bool empty() const { return list_.empty(); }
  /// Throws Error{usage} with one line per problem, in the order of the project file; returns if there are none.
  void throw_if_any() const;

 private:
  struct Problem {
    Place place;
    std::string message;
  };
  std::string file_;
  std::vector<Problem> list_;
};

}  // namespace geomesh::geomodel
