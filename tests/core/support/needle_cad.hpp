// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Solids as CAD exports them: thin plates with many holes and posts, whose flat parts are fans of needle triangles.
/// Each model follows from its seed alone.
#pragma once

#include <cstddef>

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

struct NeedleCadOptions {
  unsigned cells_x = 4, cells_y = 3;  ///< squares of side 1, each with a hole or a post
  double thickness = 0.05;            ///< of the plate
  double web = 0.01;                  ///< between a hole and the side of its square: what is left of 1/2
  unsigned sides = 48;                ///< of a hole or post, a multiple of four
  double least_spacing = 1e-4;        ///< of neighbouring points on a circle; log-uniform from here
  double post_share = 0.25;           ///< of all squares
};

struct NeedleCadModel {
  PiecewiseLinearComplex plc;   ///< one component
  double volume = 0;            ///< of the solid before it is turned
  double smallest_angle = 180;  ///< degrees, of a triangle
};

/// Triangles alone, turned by odd angles: no double lies in the planes of the plate. Corners of squares and first
/// points of caps are centres of fans.
NeedleCadModel needle_cad(unsigned seed, const NeedleCadOptions& options);

/// Thickness from 1e-3 to 1, webs from 1e-4 to 0.4, spacings from 1e-6, 16 to 96 sides, 1 to 30 squares: as they follow
/// from the seed.
NeedleCadOptions needle_cad_options(unsigned seed);

}  // namespace geomesh::test
