// SPDX-License-Identifier: MIT
/// @file
/// Chooses one of the 48 frames of permuted and reversed axes independently of the frame in which the model is given.
#pragma once

#include <vector>

#include "geomesh/core/plc.hpp"
#include "plc/model_names.hpp"

namespace geomesh {

/// Returns a frame that is the same relative to the model, up to symmetries of the model, however its vertices and
/// facets are numbered, its axes permuted or mirrored, and its coordinates scaled by a power of two or moved without
/// rounding. `used` are the rows of plc.points that items of the model refer to.
///
/// Each end of each axis has a signature: a sum, in any order, of hashes of the distances of the points from that end
/// of their box. The distances are divided by a power of two near the box's extent. Differences are rounded, but the
/// same way in all these images. Axes are ordered and directed by the signatures of their ends. If these are equal, the
/// possible frames are distinguished by signatures of whole points, then of facets and segments. O(n), or up to 48
/// times that if the model is nearly symmetric.
AxisFrame canonical_frame(const PiecewiseLinearComplex& plc, const std::vector<VertexIndex>& used);

}  // namespace geomesh
