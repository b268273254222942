// SPDX-License-Identifier: MIT
/// @file
/// Models that are hard for recovery, generated. All are valid PLCs whose volumes are known.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::corpus {

struct Model {
  std::string name;
  PiecewiseLinearComplex plc;
  double volume = 0;             ///< of all that is enclosed; 0: not known in closed form
  std::size_t n_components = 0;  ///< 0: not asserted
};

Model schonhardt(double degrees, bool in_box);                   ///< twisted prism
Model chazelle(unsigned n);                                      ///< box with n slits from below and n from above, 0.01 apart
Model pyramids_and_block();                                      ///< four pyramids that touch at their apices, a block across them
Model fan_of_segments(unsigned n);                               ///< a vertex with n segments at small angles over a base that is not planar
Model wedge(double angle_in_radians);                            ///< a layer of this angle that pinches out in a box
Model close_triangles();                                         ///< two triangles 1e-7 apart at coordinates of 1e4
Model nested_spheres(unsigned n_shells);                         ///< concentric
Model touching_spheres();                                        ///< two octahedra that share one vertex, two more that share one edge
Model hanging_facet();                                           ///< a facet in a box that hangs by one edge
Model well_and_vertex();                                         ///< an isolated segment and an isolated vertex in a box
Model lattice(unsigned n);                                       ///< n^3 cubes, every vertex cospherical with its neighbours
Model coplanar_stack(unsigned n);                                ///< boxes on top of each other with collinear edges and coplanar sides
Model pinching_layers(unsigned n_cells);                         ///< horizons on a grid that come together along lines

/// All of them at the sizes of the default tests.
std::vector<Model> all_models();

/// The model after p -> scale * rotated(p) + shift, rounded.
struct Placement {
  std::string name;
  std::function<Vec3(const Vec3&)> place;
  double volume_factor = 1;
  bool is_exact = false;  ///< no rounding, so a polygon stays exactly planar
};
Model placed(const Model& model, const Placement& placement);
/// Turned by odd angles, moved to UTM coordinates, stretched by 1e-4 in z, and all of these together.
std::vector<Placement> placements();

}  // namespace geomesh::corpus
