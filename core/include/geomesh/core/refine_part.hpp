// SPDX-License-Identifier: MIT
/// @file
/// Refines and improves parts of a mesh separately, with all of their borders and surfaces kept.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/refine.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/core/size_field.hpp"

namespace geomesh {

/// Tetrahedra with the items that must be kept. Boundary faces and their points are kept too, without being listed.
struct TetrahedraPart {
  std::vector<Vec3> points;
  std::vector<std::uint8_t> is_kept;  ///< for each point: not 0 if it must be kept unmoved
  std::vector<Tetrahedron> tetrahedra;
  std::vector<Index> component;                        ///< component of each tetrahedron
  std::vector<Triangle> kept_faces;                    ///< kept faces between two tetrahedra
  std::vector<std::array<VertexIndex, 2>> kept_edges;  ///< edges that must be kept, except those of kept faces
  /// For each tetrahedron: not 0 if its shape was repaired before. Its points and faces are kept until the other
  /// tetrahedra are refined; points are added inside it if it is larger than the target size. Empty: none.
  std::vector<std::uint8_t> is_settled;
};

/// Refines a part of a mesh to the target sizes if `options.refine` is set, then improves its elements. Inner points
/// that are not kept have no influence on the refined tetrahedra. Kept points come first in the result, in their order.
/// Uses only the options `refine`, `quality`, `quality_measure`, `max_elements` and `time_budget`.
/// Preconditions: every tetrahedron is positive; components differ only across kept faces. Throws the errors of
/// refine_and_improve, and InternalError if something that must be kept was not.
RefineStatistics refine_part(TetrahedraPart& part, const SizeField& size, const RefineOptions& options,
                             const RunContext& context = {});

}  // namespace geomesh
