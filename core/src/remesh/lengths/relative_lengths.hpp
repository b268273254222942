// SPDX-License-Identifier: MIT
/// @file
/// Lengths relative to the requested size. Passes and operations compare edges and distances with sizes only through
/// the classes LocalLength and RelativeLengths, so that a metric tensor could stand in place of the size.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include "common/geometry.hpp"
#include "geomesh/core/size_field.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// The target edge length at one place, or a multiple of it, with which vectors are compared.
class LocalLength {
 public:
  LocalLength() = default;  ///< length zero, than which no vector is shorter
  explicit LocalLength(double length) : length_(length) {}
  /// Returns whether a vector is shorter than this target length.
  bool exceeds(const Vec3& d) const { return squared_length(d) < length_ * length_; }
  /// Returns the length of a vector as a multiple of this target length.
  double measure(const Vec3& d) const { return length(d) / length_; }
  friend LocalLength operator*(double factor, const LocalLength& l) { return LocalLength(factor * l.length_); }
  friend LocalLength least(const LocalLength& a, const LocalLength& b) {
    return LocalLength(std::min(a.length_, b.length_));
  }

 private:
  double length_ = 0;
};

/// The lengths of a mesh's edges relative to the mean of the requested sizes at both ends. The size at a vertex is
/// evaluated for the component of one of its cells, and stored until `forget` is called.
class RelativeLengths {
 public:
  RelativeLengths(const DomainMesh& mesh, const SizeField& field) : mesh_(mesh), field_(field) {}

  /// Returns the length of an edge divided by its target size.
  double length(VertexIndex a, VertexIndex b) { return distance(mesh_.point(a), mesh_.point(b)) / size_of_edge(a, b); }
  /// Return whether the relative length of an edge is above or below a limit, without computing a square root.
  bool is_longer(VertexIndex a, VertexIndex b, double limit) {
    const double l = absolute(a, b, limit);
    return squared_distance(mesh_.point(a), mesh_.point(b)) > l * l;
  }
  bool is_shorter(VertexIndex a, VertexIndex b, double limit) { return is_shorter(a, mesh_.point(a), b, limit); }
  /// Returns whether the edge a-b would be shorter than the limit if `a` were moved to p but kept its target size.
  bool is_shorter(VertexIndex a, const Vec3& p, VertexIndex b, double limit) {
    const double l = absolute(a, b, limit);
    return squared_distance(p, mesh_.point(b)) < l * l;
  }
  /// Returns the length in model units that the edge a-b would have with the given relative length.
  double absolute(VertexIndex a, VertexIndex b, double relative) { return relative * size_of_edge(a, b); }
  /// Returns the target size at any point of a component.
  LocalLength at(const Vec3& p, Index component) const { return LocalLength(field_.at(p, component)); }

  /// Return the target size at a vertex, or its mean over a face or cell, for passes that choose places of new points.
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
  /// Returns whether the size field calls a function of the caller, which may be evaluated on one thread only.
  bool asks_caller() const { return field_.limits().background != nullptr; }

  /// Evaluates and stores all missing target sizes at vertices, in parallel. Lengths may then be used concurrently.
  void evaluate(unsigned threads);
  /// Stores the target size at a vertex, evaluated elsewhere.
  void set_size(VertexIndex v, double size);
  /// Drops the stored target size at a vertex. Must be called for each vertex that is moved.
  void forget(VertexIndex v) {
    if (v < sizes_.size()) sizes_[v] = -1;
  }
  void forget_all() { sizes_ = {}; }
  /// Returns the target sizes at the vertices from `first` on, as arguments for add_known() of another mesh's lengths.
  std::vector<double> known_from(VertexIndex first);
  void add_known(VertexIndex first, std::span<const double> known);

 private:
  double size_of_edge(VertexIndex a, VertexIndex b) { return 0.5 * (size_at(a) + size_at(b)); }
  double evaluated(VertexIndex v) const { return field_.at(mesh_.point(v), mesh_.component(mesh_.incident_cell(v))); }

  const DomainMesh& mesh_;
  const SizeField& field_;
  std::vector<double> sizes_;  // target size at each vertex; negative if not evaluated
};

}  // namespace geomesh::remesh
