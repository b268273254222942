// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Provides the rotatable picture of the model in the HTML report: the model as JSON, and the script that draws it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "geomesh/geomodel/palette.hpp"
#include "geomesh/geomodel/report.hpp"
#include "report_html/model/drawn_mesh.hpp"

namespace geomesh::geomodel::page {

/// Colours of regions, surfaces and curves of a mesh as "#rrggbb", in the order of the mesh's lists.
struct MeshColours {
  std::vector<Colour> regions, surfaces, curves;
};
MeshColours colours_of(const ModelMesh& mesh, const GivenColours& given);

/// A quantity by which the viewer can colour the mesh, in 255 steps from `low` to `high`; not_known without a value.
struct Quantity {
  static constexpr std::uint8_t not_known = 255;
  std::string name, unit;
  double low = 0, high = 1;
  bool is_of_points = false;          ///< else of tetrahedra
  std::vector<std::uint8_t> steps{};  ///< values of the quantity, from 0 to 255, one for each tetrahedron or each point
};

/// Returns the quantities by which the viewer can colour the mesh: the least dihedral angle, the edge length, arrays of
/// cells and points, and attributes of units. There are at most a dozen, so that the HTML file remains small. The range
/// of an array excludes the outermost hundredth at both ends.
std::vector<Quantity> quantities_of(const ModelMesh& mesh);

/// Returns the model as one JSON object for the viewer. Arrays are encoded as base64. Points are Float32, relative to
/// the middle of the model. Corners of faces and tetrahedra and ends of curve edges are Uint32. Each face has its
/// surface and the regions of both sides, each tetrahedron its region (Int32). Quantities are given for both sides of
/// each face and for each tetrahedron, or for each point (Uint8). It also contains lists of regions, surfaces and
/// curves with names, colours and measures, and corners of the worst elements if `quality` is given.
std::string viewer_data(const ModelMesh& mesh, const Box3& bounds, const MeshColours& colours,
                        const QualityReport* quality = nullptr, const DrawingLimits& limits = {});

/// Returns JavaScript (WebGL 2) that fills the HTML element with id `viewer` from the JSON text in the element with id
/// `model`. It is under the MIT licence, so that users may pass on the HTML file.
std::string_view viewer_script();

std::string_view page_style();

}  // namespace geomesh::geomodel::page
