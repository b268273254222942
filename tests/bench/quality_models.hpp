// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Models of the quality benchmark.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::bench {

struct QualityModel {
  std::string name;
  PiecewiseLinearComplex plc;  ///< empty where the data are absent
  /// Surfaces made for meshing ask for sizes by their own edges; seams of intersected ones are full of needles: where
  /// those surfaces are kept they get no points for sizes, and where they are remeshed one size is asked for the whole
  /// model.
  bool sizes_from_edges = true;
  std::vector<Index> facet_parent = {};  ///< RefineOptions::facet_parent; empty where nothing was intersected
  /// The same surfaces for programs that know no parents: pieces of one triangle merged.
  PiecewiseLinearComplex merged() const;
  double diagonal() const;  ///< of the box of its points
};

/// The same by name, made only where it is asked for.
struct NamedModel {
  std::string name;
  std::function<QualityModel()> make;
};

/// Eight grains of 320 triangles on a 2 x 2 x 2 lattice in a box whose sides are gridded at the grains' edge length:
/// nine regions. roughness 0: round; else radii vary by that share, smoothly, from the seed.
QualityModel grains(double roughness, unsigned seed);
/// A solid of the outside test data as it is.
QualityModel solid(const std::string& file);
/// A sample of this repository, or modelA4 of the outside test data, read, intersected and clipped as the program does.
/// Needs geomodel.
QualityModel sample(const std::string& name);
QualityModel model_a4();
/// The surfaces of modelA4 as geomesh remeshes them by default within a thousandth of its diagonal at a size of a
/// fiftieth of it: each face of the result a facet of its own. No program but geomesh was seen to mesh modelA4 as it
/// is; these surfaces are the same for each.
QualityModel model_a4_remeshed();

}  // namespace geomesh::bench
