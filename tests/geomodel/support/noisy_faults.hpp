// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Faults that cross each other again and again by noise and leave strips far narrower than their triangles: what
/// automatic picking in seismic data gives. Each model follows from its seed alone.
#pragma once

#include <cstddef>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel::testing {

struct NoisyFaultsOptions {
  unsigned n_bundles = 2;     ///< of faults that follow one plane; bundles cross each other
  unsigned n_in_bundle = 2;   ///< faults
  unsigned cells = 12;        ///< along a fault; neighbours in a bundle have a few more
  double noise = 0.5;         ///< m, of each point along the fault's normal
  double waviness = 2;        ///< m, of the whole fault about its plane
  double least_angle = 0.01;  ///< degrees between faults of one bundle; up to 2
};

struct NoisyFaultsModel {
  PiecewiseLinearComplex plc;  ///< of the arranged faults in a box of 4 x 3 x 2 km
  std::size_t n_given = 0;     ///< triangles before they were intersected
  double narrowest = 0;        ///< m, the least height of a triangle
};

/// The faults before they are intersected.
std::vector<TriangulatedSurface> noisy_faults(unsigned seed, const NoisyFaultsOptions& options);

/// Throws Error{cannot_mesh} where the arrangement refuses the faults.
NoisyFaultsModel noisy_faults_model(unsigned seed, const NoisyFaultsOptions& options);

/// Noise from 0.01 to 10 m, angles from 1e-4 degrees, 8 to 20 cells, 3 to 8 faults: as they follow from the seed.
NoisyFaultsOptions noisy_faults_options(unsigned seed);

}  // namespace geomesh::geomodel::testing
