// SPDX-License-Identifier: MIT
/// @file
/// The canonical form of a model, which depends neither on its numbering nor on its frame, and in which it is meshed.
/// Recovery tries segments by number, begins rings at the smallest vertex and breaks ties by coordinates, so that
/// renumbered, mirrored or moved images of one model would be meshed differently. If they are converted to one form
/// first, they get the same mesh (docs/decisions/recovery.md).
#pragma once

#include "geomesh/core/error.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "plc/model_names.hpp"

namespace geomesh {

struct CanonicalForm {
  /// The complex in the canonical frame: used vertices along a Hilbert curve; loops from their smallest vertex towards
  /// its smaller neighbour; facets, segments, inner segments and points ascending. Seeds keep the caller's order, which
  /// determines the seed that names a region.
  PiecewiseLinearComplex plc;
  ModelNames names;
};

/// Returns the canonical form of a complex in which validate_plc finds no fault. Up to symmetries of the model, it
/// remains the same if vertices and facets are renumbered, loops rotated or reversed, axes permuted or mirrored, or
/// coordinates scaled by a power of two. If the model is moved without rounding, only the position changes. O(n log n).
CanonicalForm canonical_form(const PiecewiseLinearComplex& plc);

/// Returns for each facet of the canonical form its row in plc.provenance_sets, where `plc` is the caller's complex.
std::vector<Index> provenance_of(const PiecewiseLinearComplex& plc, const ModelNames& names);

/// Converts a mesh of the canonical form to a mesh of the caller's complex `plc`: points, items, orientations and
/// orders are those that ConstrainedTetrahedralization documents. O(n) except for sorting the input's vertices.
ConstrainedTetrahedralization in_callers_terms(ConstrainedTetrahedralization mesh, const ModelNames& names,
                                               const PiecewiseLinearComplex& plc);

/// Sorted.
std::vector<Index> facets_in_callers_terms(std::vector<Index> facets, const ModelNames& names);

/// Converts an error's rows and coordinates to the caller's model; its text needs no conversion (recover/messages.hpp).
Error in_callers_terms(const Error& error, const ModelNames& names);

}  // namespace geomesh
