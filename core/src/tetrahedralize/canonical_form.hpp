// SPDX-License-Identifier: MIT
/// @file
/// The model in a form that depends neither on its numbering nor on its frame, in which it is meshed. Recovery tries
/// segments by number, begins rings at the smallest vertex and breaks ties by coordinates, so images of one
/// model would be meshed differently; converted to one form first, they get the same mesh (docs/decisions/recovery.md).
#pragma once

#include "geomesh/core/error.hpp"
#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "plc/model_names.hpp"

namespace geomesh {

struct CanonicalForm {
  /// The complex in the canonical frame: used vertices along a Hilbert curve; loops from their smallest vertex towards
  /// its smaller neighbour; facets, segments, inner segments and points ascending. Seeds keep the caller's order, which
  /// determines who names a region.
  PiecewiseLinearComplex plc;
  ModelNames names;
};

/// Precondition: validate_plc finds no fault. Images of one model get the same form, up to symmetries of the model:
/// with vertices and facets renumbered, loops rotated or reversed, axes permuted, mirrored, or scaled by a power of
/// two; images that are moved without rounding get the same form except for the position. O(n log n).
CanonicalForm canonical_form(const PiecewiseLinearComplex& plc);

/// Returns by facet of the form the row in plc.provenance_sets of the caller's complex.
std::vector<Index> provenance_of(const PiecewiseLinearComplex& plc, const ModelNames& names);

/// Converts a mesh of the canonical form to one of `plc`: points, items, orientations and orders are those that
/// ConstrainedTetrahedralization documents. O(n) except for sorting the input's vertices.
ConstrainedTetrahedralization in_callers_terms(ConstrainedTetrahedralization mesh, const ModelNames& names,
                                               const PiecewiseLinearComplex& plc);

/// Sorted.
std::vector<Index> facets_in_callers_terms(std::vector<Index> facets, const ModelNames& names);

/// Converts an error about the canonical form: its data are translated; its text already refers to the caller's items
/// (recover/messages.hpp).
Error in_callers_terms(const Error& error, const ModelNames& names);

}  // namespace geomesh
