// SPDX-License-Identifier: MIT
/// @file
/// The model in a form that does not depend on how it was numbered, nor on the frame: what is meshed. Recovery tries
/// segments by number, begins rings at the least vertex and breaks ties by coordinates. So images of one model
/// would be meshed in different ways; put into one form first, they are meshed in the same one
/// (docs/decisions/recovery.md).
#pragma once

#include "geomesh/core/error.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "plc/model_names.hpp"

namespace geomesh {

struct CanonicalForm {
  /// In the canonical frame: the vertices that something uses, along a Hilbert curve; loops from their least vertex
  /// towards its lesser neighbour; facets, segments, inner segments and points ascending. Seeds in the caller's order,
  /// which says who names a region.
  PiecewiseLinearComplex plc;
  ModelNames names;
};

/// Precondition: validate_plc finds no fault. The same form, up to symmetries of the model, for images of one model:
/// vertices and facets renumbered, loops begun elsewhere or run the other way, axes permuted, mirrored, or scaled by a
/// power of two; and moved, where that is exact, the same but for the place. O(n log n).
CanonicalForm canonical_form(const PiecewiseLinearComplex& plc);

/// By facet of the form: the row in plc.provenance_sets of the caller's complex.
std::vector<Index> provenance_of(const PiecewiseLinearComplex& plc, const ModelNames& names);

/// A mesh of the canonical form as one of `plc`: points, items, orientations and orders are those that
/// ConstrainedTetrahedralization documents. O(n) but for sorting the input's vertices.
ConstrainedTetrahedralization in_callers_terms(ConstrainedTetrahedralization mesh, const ModelNames& names,
                                               const PiecewiseLinearComplex& plc);

/// Sorted.
std::vector<Index> facets_in_callers_terms(std::vector<Index> facets, const ModelNames& names);

/// An error about the canonical form: its data are translated, its words speak of the caller's items already
/// (recover/messages.hpp).
Error in_callers_terms(const Error& error, const ModelNames& names);

}  // namespace geomesh
