// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Models of the quality benchmark and files of them for command-line peers.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::bench {

struct QualityModel {
  std::string name;
  PiecewiseLinearComplex plc;
  /// Closed shells, a range of facets each; those after the first lie side by side inside the first where `nested`.
  std::vector<std::pair<Index, Index>> shells;
};

/// Eight grains of 320 triangles on a 2 x 2 x 2 lattice in a box whose sides are gridded at the grains' edge length: nine
/// regions. roughness 0: round; else radii vary by that share, smoothly, from the seed.
QualityModel grains(double roughness, unsigned seed);
/// A solid of the outside test data as it is; an empty PLC where the file is absent.
QualityModel solid(const std::string& file);

/// TetGen's PLC file, with facet markers.
void write_poly(const PiecewiseLinearComplex& plc, const std::string& path);
/// One STL a shell and a Gmsh script that meshes the regions with those surfaces kept: STEM.geo, STEM.0.stl ...
void write_gmsh(const QualityModel& model, const std::string& stem);

}  // namespace geomesh::bench
