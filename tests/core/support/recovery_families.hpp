// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Families of valid models whose recovery may take long, with the volume that a mesh must fill. Each model follows
/// from its options alone. Plane caps lie on a grid of 2^-32 and are tilted by whole slopes, so they are exactly plane.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::test {

struct FamilyModel {
  std::string name;
  PiecewiseLinearComplex plc;
  double volume = 0;  ///< of all regions together
};

/// How the plane polygons of a plate are given as triangles.
enum class CapTriangles {
  zigzag,         ///< long needles, the same on all caps
  turned_zigzag,  ///< long needles; those of one cap cross those of the next one as seen from above
  random_ears,    ///< triangulations at random, another one for each cap
};

struct PlateOptions {
  unsigned seed = 0;
  unsigned n = 100;  ///< points of each cap's outline, at random on an ellipse
  CapTriangles triangles = CapTriangles::turned_zigzag;
  double thickness = 0.01;  ///< of each layer; the ellipse's axes are 2 and 4 long
  unsigned layers = 1;      ///< plates on top of each other, which share caps
  bool has_hole = false;    ///< another ellipse of n points goes through
  bool is_tilted = false;   ///< sheared by whole slopes
};
FamilyModel plate_of_needles(const PlateOptions& options);

/// Two fans of `n` needles of length 1 in a box, their apexes at opposite ends; the needles of one cross those of the
/// other as seen from above. They are apart by `gap`, and rough by a third of that, so nothing is coplanar.
FamilyModel crossing_fans(unsigned seed, unsigned n, double gap);

/// `n` flat square sheets of size 1 `gap` apart in a box, each of `cells` by `cells` squares in triangles.
FamilyModel flat_sheets(unsigned n, unsigned cells, double gap);

/// `n` isolated points on one line through a box that no axis is parallel to.
FamilyModel points_on_line(unsigned n);

/// Volume of all tetrahedra together.
double volume_of(const ConstrainedTetrahedralization& mesh);

/// A family of 50 models whose sizes grow geometrically and whose other options alternate, so that a time that is not
/// near to linear, or a model that falls out of the row, is seen.
struct ModelFamily {
  static constexpr unsigned n_models = 50;

  std::string name;
  FamilyModel (*make)(unsigned i);  ///< i < n_models
};

/// - plates: ellipses of 100 to 20,000 points, one to three layers, with holes, tilted, 1e-1 to 1e-3 thick;
/// - fans: 10 to 2,000 needles that cross each other, 1e-1 to 1e-3 apart;
/// - sheets: 2 to 200 sheets 1e-6 to 1 of their size apart;
/// - lines: 100 to 100,000 points on a line.
const std::vector<ModelFamily>& model_families();

}  // namespace geomesh::test
