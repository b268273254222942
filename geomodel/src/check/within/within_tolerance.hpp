// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Meshes whose surfaces were remeshed within a distance of the input (`honour: tolerance`): what takes the place of
/// coverage.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "check/exact/deviation.hpp"
#include "check/judged/claimed_faces.hpp"

namespace geomesh::geomodel::checking {

/// What is allowed, in the mesh's unit.
struct Allowed {
  double surfaces = 0;  ///< between a surface and its input, both ways
  double rounding = 0;  ///< of coordinates, as for coverage
  double both() const { return surfaces + rounding; }
};

/// One surface of the claim (or all of them, where faces bear no names) with the faces of the mesh that stand for it.
struct SurfacePair {
  std::string name;
  std::vector<Index> rows;   ///< of claim.surfaces
  std::vector<Index> faces;  ///< rows of the candidates
};
/// What lies on the sides of the volume, to `rounding`, stands for none.
std::vector<SurfacePair> pair_surfaces(const ClaimedFaces& claimed, double rounding);
Corners corners_of(const ClaimedFaces& claimed, Index face);
std::vector<Corners> triangles_of(const TriangulatedSurface& surface);

/// Faces of each surface lie within what is allowed of the surface's input (fault `faces_off_their_surface`). The
/// input, less what the box and the rules take, lies within it of these faces (`input_off_the_mesh`); no face of a
/// horizon or fault lies deeper inside a body that cuts (`faces_inside_bodies`). What was proven and what sampled goes
/// to `checks_done`.
void check_surfaces_within(const ClaimedFaces& claimed, const Allowed& allowed, CheckResult& result);

/// Nodes in the middle of edges lie within what is allowed of their surfaces (`midpoints_off`).
void check_midpoints_within(const ClaimedFaces& claimed, const Allowed& allowed, CheckResult& result);

/// Each face names a triangle of its surface (`wrong_source_triangles`) that it comes within twice what is allowed of
/// (`faces_off_their_triangle`). Only with names.
void check_sources_within(const ClaimedFaces& claimed, const Allowed& allowed, CheckResult& result);

/// Every surface is there (`missing_surfaces`); whole ones have the pieces, borders and handles of their input
/// (`surfaces_changed`); borders and tips, and intersection curves, lie where the input's do (`borders_off`,
/// `curves_off`). Only with names.
void check_surface_topology(const ClaimedFaces& claimed, const Allowed& allowed, CheckResult& result);

/// Volumes of regions and of closed bodies differ little from the input's (`region_volumes`, `body_volumes`). The most
/// is the area of their movable boundary times what is allowed. The input's region volumes are those that the report
/// beside the mesh tells, which must fill the box; bodies' are computed here. Only with names.
void check_volumes_within(const ClaimedFaces& claimed, const Allowed& allowed,
                          const std::optional<nlohmann::json>& report, CheckResult& result);

}  // namespace geomesh::geomodel::checking
