// SPDX-License-Identifier: MIT
/// @file
/// Loops that measure the cells over the faces of a vertex's link, four at a time. Smoothing spends most time in them.
#pragma once

#include <array>
#include <cstddef>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/quality_measure.hpp"

namespace geomesh::remesh {

/// Four faces of a link, one per lane, with the values that all tetrahedra over a face share.
struct alignas(32) FourFaces {
  using Lanes = double[4];
  Lanes corner[3][3];  ///< coordinates of the faces' corners, by corner and axis
  Lanes normal[3];     ///< inward normals of the faces, each as long as twice the face's area
  Lanes inverse;       ///< reciprocal of the squared length of the face's normal
  Lanes squared[3];    ///< squared lengths of the edges ab, bc, ca of the faces (a, b, c)
  Lanes share;  ///< weight of the face: 0 in lanes that repeat a face to fill the last group of four, otherwise 1
};

/// Functions that compute the shapes of cells between a link and an apex p, for one measure and one instruction set.
struct LinkKernels {
  /// Computes the normals and squared edge lengths of the faces of the link from their corners.
  void (*prepare)(FourFaces* faces, std::size_t n_fours);
  void (*shapes)(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double* shapes);
  /// Returns the worst shape of the cells between a link and its apex p, or some shape that is at most `enough`.
  double (*worst)(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double enough);
  /// Returns the sum of CellQuality::worth of all cells; minus infinity if a shape is not above `floor`.
  double (*sum_of_worths)(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double floor);
  /// Returns the gradient of the sum of CellQuality::worth over all cells, with respect to p. They must be positive.
  Vec3 (*gradient_of_sum)(const FourFaces* faces, std::size_t n_fours, const Vec3& p);
};

/// The functions of LinkKernels for each quality measure.
using LinkKernelTable = std::array<LinkKernels, n_quality_measures>;

namespace detail {
extern const LinkKernelTable baseline_link_kernels, avx2_link_kernels;
}

/// Returns the functions of a measure in the version for this processor. All versions compute the same bits.
const LinkKernels& link_kernels(QualityMeasure measure);

}  // namespace geomesh::remesh
