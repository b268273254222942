// SPDX-License-Identifier: MIT
/// @file
/// Computes the shapes of all cells between the faces of a link and a common apex, four at a time.
#pragma once

#include <cstddef>
#include <vector>

#include "quality/measure/link_kernels.hpp"

namespace geomesh::remesh {

/// The faces (a, b, c) of a link, oriented so that (a, b, c, p) is positive for an admissible apex p. The shapes of
/// these cells are computed with the same bits as by CellQuality::shape.
class LinkShapes {
 public:
  /// Removes all faces of the link, and sets the measure of the shapes that will be computed.
  void clear(const LinkKernels& kernels) {
    n_ = 0;
    kernels_ = &kernels;
  }
  void add(const Vec3& a, const Vec3& b, const Vec3& c);
  /// Computes normals and edge lengths of the link's faces. Must be called after the last `add` and before any shape.
  void prepare();
  std::size_t size() const { return n_; }
  Vec3 corner(std::size_t face, unsigned k) const {
    const auto& c = fours_[face / 4].corner[k];
    return {c[0][face % 4], c[1][face % 4], c[2][face % 4]};
  }
  Vec3 normal(std::size_t face) const {
    const auto& n = fours_[face / 4].normal;
    return {n[0][face % 4], n[1][face % 4], n[2][face % 4]};
  }

  double worst(const Vec3& p, double enough) const { return kernels_->worst(fours_.data(), n_fours(), p, enough); }
  double sum_of_worths(const Vec3& p, double floor) const {
    return kernels_->sum_of_worths(fours_.data(), n_fours(), p, floor);
  }
  Vec3 gradient_of_sum(const Vec3& p) const { return kernels_->gradient_of_sum(fours_.data(), n_fours(), p); }
  /// Returns the shape of the cell over each face, followed by up to three unused values. Valid until the next call.
  const std::vector<double>& shapes(const Vec3& p) const {
    shapes_.resize(4 * n_fours());
    kernels_->shapes(fours_.data(), n_fours(), p, shapes_.data());
    return shapes_;
  }

 private:
  std::size_t n_fours() const { return (n_ + 3) / 4; }
  void set(std::size_t face, const Vec3& a, const Vec3& b, const Vec3& c, double share);

  std::vector<FourFaces> fours_;  // the faces of the link; the array may be longer than the link
  mutable std::vector<double> shapes_;
  std::size_t n_ = 0;
  const LinkKernels* kernels_ = &link_kernels(QualityMeasure::dihedral);
};

}  // namespace geomesh::remesh
