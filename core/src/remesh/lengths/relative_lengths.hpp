// SPDX-License-Identifier: MIT
/// @file
/// Lengths relative to the requested size. Passes and operations compare edges and distances with sizes only through
/// these two classes, so that a metric tensor could stand in place of the size.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "common/geometry.hpp"
#include "geomesh/core/size_field.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// The requested size at one place, or a multiple of it.
class LocalLength {
 public:
  LocalLength() = default;  ///< zero, which exceeds nothing
  explicit LocalLength(double length) : length_(length) {}
  /// Returns whether a vector is shorter than this length.
  bool exceeds(const Vec3& d) const { return squared_length(d) < length_ * length_; }
  /// Returns the length of a vector as a multiple of this length.
  double measure(const Vec3& d) const { return length(d) / length_; }
  friend LocalLength operator*(double factor, const LocalLength& l) { return LocalLength(factor * l.length_); }
  friend LocalLength least(const LocalLength& a, const LocalLength& b) {
    return LocalLength(std::min(a.length_, b.length_));
  }

 private:
  double length_ = 0;
};

/// The lengths of a mesh's edges relative to the mean of the requested sizes at both ends. The size at a vertex is that
/// of the component of one of its cells. It is kept until the vertex is forgotten.
class RelativeLengths {
 public:
  RelativeLengths(const DomainMesh& mesh, const SizeField& field) : mesh_(mesh), field_(field) {}

  /// Returns the length of the edge relative to its size: 1 is as requested.
  double length(VertexIndex a, VertexIndex b) { return distance(mesh_.point(a), mesh_.point(b)) / size_of_edge(a, b); }
  /// Return whether the relative length is above or below a limit. They compute no root.
  bool is_longer(VertexIndex a, VertexIndex b, double limit) {
    const double l = absolute(a, b, limit);
    return squared_distance(mesh_.point(a), mesh_.point(b)) > l * l;
  }
  bool is_shorter(VertexIndex a, VertexIndex b, double limit) { return is_shorter(a, mesh_.point(a), b, limit); }
  /// Returns whether the edge would be shorter than the limit if `a` were moved to p, with the size that it has now.
  bool is_shorter(VertexIndex a, const Vec3& p, VertexIndex b, double limit) {
    const double l = absolute(a, b, limit);
    return squared_distance(p, mesh_.point(b)) < l * l;
  }
  /// Returns the length of an edge in this direction that has the given relative length.
  double absolute(VertexIndex a, VertexIndex b, double relative) { return relative * size_of_edge(a, b); }
  /// Returns the size at any place.
  LocalLength at(const Vec3& p, Index component) const { return LocalLength(field_.at(p, component)); }

  /// The size at a vertex, and the means of the sizes at the vertices of a face or cell, for passes that choose places
  /// of new points.
  double size_at(VertexIndex v) {
    if (v >= sizes_.size() || sizes_[v] < 0) [[unlikely]]
      set_size(v, evaluated(v));
    return sizes_[v];
  }
  double size_of_face(const Triangle& t) { return (size_at(t[0]) + size_at(t[1]) + size_at(t[2])) / 3; }
  double size_of_cell(CellIndex c) {
    double sum = 0;
    for (const VertexIndex v : mesh_.vertices(c)) sum += size_at(v);
    return sum / 4;
  }
  const SizeField& field() const { return field_; }
  /// Returns whether the field calls a function of the caller, which is evaluated on one thread only.
  bool asks_caller() const { return field_.limits().background != nullptr; }

  /// Evaluates all vertices that are not yet known, in parallel. Afterwards lengths can be taken concurrently.
  void evaluate(unsigned threads);
  /// Stores the size at the vertex, which has been evaluated elsewhere.
  void set_size(VertexIndex v, double size);
  /// Must be called for each vertex that is moved.
  void forget(VertexIndex v) {
    if (v < sizes_.size()) sizes_[v] = -1;
  }
  void forget_all() { sizes_ = {}; }
  /// Returns what is known of the vertices from `first` on, which another mesh receives by `add_known`.
  std::vector<double> known_from(VertexIndex first);
  void add_known(VertexIndex first, std::span<const double> known);

 private:
  double size_of_edge(VertexIndex a, VertexIndex b) { return 0.5 * (size_at(a) + size_at(b)); }
  double evaluated(VertexIndex v) const { return field_.at(mesh_.point(v), mesh_.component(mesh_.incident_cell(v))); }

  const DomainMesh& mesh_;
  const SizeField& field_;
  std::vector<double> sizes_;  // of each vertex; negative if not yet evaluated
};

}  // namespace geomesh::remesh
