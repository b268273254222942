// SPDX-License-Identifier: MIT
/// @file
/// What is promised of surfaces remeshed within a tolerance, proven of the whole result and not of each change alone.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "remesh/domain/domain_mesh.hpp"
#include "remesh/tolerance/local_tolerance.hpp"
#include "search/closest_point.hpp"
#include "search/cover_proof.hpp"

namespace geomesh::remesh {

/// Surfaces by patch and curves by class, as triangles and line pieces.
struct SurfaceItems {
  search::ClosestPointTrees faces, curves;
  std::vector<std::uint8_t> open_edges;  ///< of faces (search::find_open_edges)
};
/// The faces of one mesh and the curves of another.
SurfaceItems surface_items(const DomainMesh& faces_of, const DomainMesh& curves_of);

/// Each constrained face once, but for those that stand for no facet: group: its patch; id: its facet.
std::vector<search::ClosestPointTrees::Item> face_items(const DomainMesh& mesh);
/// Each edge of a curve; group: the curve's class; no id.
std::vector<search::ClosestPointTrees::Item> curve_items(const DomainMesh& mesh);

/// A triangle or line piece of the input or of the result that is not proven to be within the tolerance of the other.
struct Breach {
  Vec3 place{};
  double distance = 0;     ///< of a point looked at, at most the tolerance where nothing was decided
  Index group = no_index;  ///< patch or curve class
  Index facet = no_index;  ///< of the input; none on curves
  bool on_curve = false;
  bool of_input = false;  ///< what is off is a part of the input
};

struct Deviations {
  double result_to_input = 0,
         input_to_result =
             0;  ///< largest distances found: lower bounds that are nearly reached; the tolerance is above them
  std::vector<Breach> breaches;  ///< empty: all of both is proven to be within the tolerance of the other
};

/// Data that a verification leaves to the next one, of the same input and a result that differs in few places.
struct VerifiedSurfaces {
  /// By item of the result, and of the input.
  struct Covers {
    std::vector<search::Cover> result, input;
  };
  SurfaceItems result;
  Covers faces, curves;
};

/// Faces and curve edges of the mesh against those of the same patch or curve of the input, and the other way round.
/// Each of the result is held to the least that is allowed at its corners; each of the input to no less than what is
/// allowed anywhere on it. Near-linear where sizes of both are alike; on all threads given, with the same result. What
/// was proven `before` is not looked at again where nothing has changed about it.
Deviations verify_surfaces(const DomainMesh& mesh, const SurfaceItems& input, const LocalTolerance& tolerance,
                           unsigned threads, VerifiedSurfaces* before = nullptr);

/// A place where surfaces are held more closely than by the tolerance.
struct TightZone {
  Box3 box;
  double tolerance;
};

/// Returns places where faces on the outside of the model meet others beyond shared vertices and edges. Nothing is
/// meshed there, so no cell shows when surfaces nearer to each other than the tolerance come to cross. If there are
/// none, the mesh fills space once. Exact. Boxes are those of the edges and faces that meet, their tolerance 0. O(n log
/// n).
std::vector<TightZone> crossings_outside(const DomainMesh& mesh, unsigned threads = 1);

}  // namespace geomesh::remesh
