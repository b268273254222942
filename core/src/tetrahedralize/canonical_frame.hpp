// SPDX-License-Identifier: MIT
/// @file
/// One of the 48 frames of permuted and turned axes, chosen by what does not depend on the frame the model is given in.
#pragma once

#include <vector>

#include "geomesh/core/plc.hpp"
#include "plc/model_names.hpp"

namespace geomesh {

/// The same frame, as seen from the model, however its vertices and facets are numbered, and its axes permuted or
/// mirrored. Its coordinates may be scaled by a power of two or moved without rounding: up to symmetries of the model
/// itself. `used`: the rows of plc.points that something names.
///
/// Each end of each axis has a signature: a sum, in any order, of hashes of the distances of the points from that end
/// of their box. The distances are in a power of two near the box's extent. Differences are rounded, but the same way
/// in all these images. Axes are ordered, and pointed, by their ends' signatures; where these are equal the frames in
/// question are told apart by signatures of whole points, then of facets and segments. O(n); up to 48 times that where
/// the model is nearly symmetric.
AxisFrame canonical_frame(const PiecewiseLinearComplex& plc, const std::vector<VertexIndex>& used);

}  // namespace geomesh
