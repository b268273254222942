// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Errors that name the surfaces and triangles of a model at which they occurred.
#pragma once

#include <string>
#include <utility>
#include <vector>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

/// The surfaces and triangles to which an error refers. Both lists may be empty.
struct ModelItems {
  std::vector<std::string> surfaces;  ///< each once
  struct SourceTriangle {
    std::string surface;
    Index row;  ///< row of the triangle in its surface as read or passed in memory, from 0
  };
  std::vector<SourceTriangle> triangles;

  void add_surface(const std::string& name) {
    for (const std::string& known : surfaces)
      if (known == name) return;
    surfaces.push_back(name);
  }
  void add_triangle(const std::string& name, Index row) {
    add_surface(name);
    triangles.push_back({name, row});
  }
};

class ModelError : public Error {
 public:
  ModelError(ErrorKind kind, const std::string& message, ModelItems items, ErrorContext context = {})
      : Error(kind, message, std::move(context)), items_(std::move(items)) {}
  const ModelItems& items() const { return items_; }

 private:
  ModelItems items_;
};

}  // namespace geomesh::geomodel
