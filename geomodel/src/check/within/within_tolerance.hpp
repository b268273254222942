// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Checks meshes whose surfaces were remeshed within a tolerance of the input, in place of the exact coverage check.
#pragma once

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "check/exact/deviation.hpp"
#include "check/mesh/checked_faces.hpp"

namespace geomesh::geomodel::checking {

/// Largest distances between mesh faces and input surfaces that a check accepts, in the mesh's unit.
struct Allowed {
  double surfaces = 0;  ///< allowed distance between a surface and its input, in both directions
  double rounding = 0;  ///< allowed distance due to rounding of coordinates
  double both() const { return surfaces + rounding; }
};

/// One surface of the specification (or all of them, if faces have no names) with the mesh faces that represent it.
struct SurfacePair {
  std::string name;
  std::vector<Index> rows;   ///< of `specification.surfaces`
  std::vector<Index> faces;  ///< indices of the mesh faces that may represent the surface
};
/// Pairs surfaces with the mesh faces that may represent them. Faces on the volume's sides are excluded.
std::vector<SurfacePair> pair_surfaces(const CheckedFaces& checked, double rounding);
Corners corners_of(const CheckedFaces& checked, Index face);
std::vector<Corners> triangles_of(const TriangulatedSurface& surface);

/// Checks that mesh faces of each surface lie within the allowed distance of the surface's input
/// (`faces_off_their_surface`), that the input, minus the parts that the box and the rules remove, lies within the same
/// distance of these faces (`input_off_the_mesh`), and that no face of a horizon or fault lies deeper inside a body
/// that cuts (`faces_inside_bodies`). `checks_done` lists what was proven and what was sampled.
void check_surfaces_within(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result);

/// Checks that midpoint nodes lie within the allowed distance of their surfaces (`midpoints_off`).
void check_midpoints_within(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result);

/// Checks that each mesh face names a triangle of its surface (`wrong_source_triangles`) and lies within twice the
/// allowed distance of that triangle (`faces_off_their_triangle`). Precondition: the files give names to faces.
void check_sources_within(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result);

/// Checks that every surface is present (`missing_surfaces`); that surfaces which nothing clips have the pieces,
/// borders and handles of their input (`surfaces_changed`); and that borders, tips and intersection curves lie where
/// those of the input do (`borders_off`, `curves_off`). Precondition: the files give names to faces.
void check_surface_topology(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result);

/// Checks that volumes of regions and of closed bodies differ little from those of the input (`region_volumes`,
/// `body_volumes`): by at most the area of their movable boundary times the allowed distance. The input's volumes of
/// regions are taken from the report beside the mesh, and must fill the box; those of bodies are computed from the
/// input surfaces. Precondition: the files give names to faces.
void check_volumes_within(const CheckedFaces& checked, const Allowed& allowed,
                          const std::optional<nlohmann::json>& report, CheckResult& result);

}  // namespace geomesh::geomodel::checking
