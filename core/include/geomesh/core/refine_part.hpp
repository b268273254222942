// SPDX-License-Identifier: MIT
/// @file
/// Parts of a mesh, refined and improved each on its own, with all of their borders and surfaces kept.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/refine.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/size_field.hpp"

namespace geomesh {

/// Tetrahedra with what of them stays. Faces without a neighbour stay too, with their points, without being listed.
struct TetrahedraPart {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> is_kept;  ///< by point: not 0 where it stays
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Index> component;                        ///< by tetrahedron: what SizeField::at takes
  std::vector<Triangle> kept_faces;                    ///< faces with tetrahedra on both sides that stay
  std::vector<std::array<VertexIndex, 2>> kept_edges;  ///< edges of no kept face that stay
  /// By tetrahedron: not 0 where its shape was mended before. Its points and faces stay until the others are refined;
  /// points are put into it where it is larger than asked. Empty: nowhere, as in the result.
  std::vector<std::uint8_t> is_settled;
};

/// Refines to the sizes where the options say so, then improves. Points inside that do not stay have no say where they
/// are refined. Those that stay are first in the result, in their order. Of the options, `refine`, `quality`,
/// `quality_measure`, `max_elements` and `time_budget` are followed.
///
/// Preconditions: every tetrahedron is positive; components differ across kept faces alone. Throws as
/// refine_and_improve, and InternalError where what was to stay has not.
RefineStatistics refine_part(TetrahedraPart& part, const SizeField& size, const RefineOptions& options,
                             const RunContext& context = {});

}  // namespace geomesh
