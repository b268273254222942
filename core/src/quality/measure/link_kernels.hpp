// SPDX-License-Identifier: MIT
/// @file
/// Loops over the faces of a link, four at a time. Smoothing spends most of its time in them.
#pragma once

#include <array>
#include <cstddef>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/quality_measure.hpp"

namespace geomesh::remesh {

/// Four faces, one in each lane, with the values that all tetrahedra over them share (as Base has for one).
struct alignas(32) FourFaces {
  using Lanes = double[4];
  Lanes corner[3][3];  ///< by corner and coordinate
  Lanes normal[3];     ///< inward normal, whose length is twice the area
  Lanes inverse;       ///< reciprocal of the squared length of the normal
  Lanes squared[3];    ///< lengths of the edges ab, bc, ca
  Lanes share;         ///< 1; 0 in lanes that repeat a face to fill the last group of four
};

/// The loops over a link, for one measure and one instruction set.
struct LinkKernels {
  /// Computes all members except corners and shares.
  void (*prepare)(FourFaces* faces, std::size_t n_fours);
  void (*shapes)(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double* shapes);
  /// Returns the least shape, or some shape that is at most `enough`.
  double (*worst)(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double enough);
  /// Returns the sum of CellQuality::worth; minus infinity if a shape is not above `floor`.
  double (*sum_of_worths)(const FourFaces* faces, std::size_t n_fours, const Vec3& p, double floor);
  /// Returns the gradient with respect to p, which must make all cells positive.
  Vec3 (*gradient_of_sum)(const FourFaces* faces, std::size_t n_fours, const Vec3& p);
};

/// The kernels of each measure.
using LinkKernelTable = std::array<LinkKernels, n_quality_measures>;

namespace detail {
extern const LinkKernelTable baseline_link_kernels, avx2_link_kernels;
}

/// The version for this machine; all versions compute the same bits.
const LinkKernels& link_kernels(QualityMeasure measure);

}  // namespace geomesh::remesh
