// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The page's rotatable picture of the model: the faces as data, and the script that draws them.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geomesh/geomodel/palette.hpp"
#include "geomesh/geomodel/report.hpp"
#include "report_html/model/drawn_mesh.hpp"

namespace geomesh::geomodel::page {

/// Colours of the parts of a mesh, as "#rrggbb" by row.
struct MeshColours {
  std::vector<Colour> regions, surfaces, curves;
};
MeshColours colours_of(const ModelMesh& mesh, const GivenColours& given);

/// A quantity by which the viewer can colour, in 255 steps from `low` to `high`; not_known if there is no value.
struct Quantity {
  static constexpr std::uint8_t not_known = 255;
  std::string name, unit;
  double low = 0, high = 1;
  bool is_of_points = false;          ///< else of tetrahedra
  std::vector<std::uint8_t> steps{};  ///< by row of tetrahedra, or of points
};

/// Returns the least dihedral angle, the edge length, and what the mesh carries: arrays of cells and points, attributes
/// of units. There are at most a dozen, so that a page remains small. The range of an array excludes the outermost
/// hundredth at both ends.
std::vector<Quantity> quantities_of(const ModelMesh& mesh);

/// Returns the model as one JSON object. Arrays are base64. Points are Float32, from the middle of the model. Corners
/// of faces and tetrahedra and ends of curve edges are Uint32. Each face has its surface and the regions of both sides,
/// each tetrahedron its region (Int32). Quantities are given for both sides of each face and for each tetrahedron, or
/// for each point (Uint8). It also contains lists of regions, surfaces and curves with names, colours and measures, and
/// corners of the worst elements if `quality` is given.
std::string viewer_data(const ModelMesh& mesh, const Box3& bounds, const MeshColours& colours,
                        const QualityReport* quality = nullptr, const DrawingLimits& limits = {});

/// Returns JavaScript (WebGL 2) that fills the element with id `viewer` from the JSON text in the element with id
/// `model`. It is under the MIT licence, so that a page may be passed on.
std::string_view viewer_script();

/// Returns the style sheet of the page.
std::string_view page_style();

}  // namespace geomesh::geomodel::page
