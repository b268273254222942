// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Describes the places where surfaces cross, touch, overlap or dangle as findings (Spot), in a geologist's words.
#pragma once

#include "arrangement/model/arranged.hpp"
#include "arrangement/model/ingest.hpp"

namespace geomesh::geomodel::arrangement {

/// A complex, the contacts (places where its facets meet), and the arrangement computed from both.
struct ArrangedContacts {
  const Complex& complex;
  const Contacts& contacts;
  const Arranged& arranged;
};

/// Finds crossings of input surfaces (excluding the sides of the box), inside the box if there is one. Adds spots and
/// warnings, counts the pairs in n_crossing_pairs, and sets `crosses_itself` for each input surface.
void diagnose_crossings(const ArrangedContacts& round, const SurfaceList& surfaces, const std::optional<Box3>& box,
                        ArrangementResult& result, std::vector<std::uint8_t>& crosses_itself);

/// Throws Error{invalid_input} that names the pairs of surfaces and the places if any input surfaces cross.
void refuse_crossings(const ArrangementResult& result, const SurfaceList& surfaces);

/// Reports free borders and overlaps of the polygon soup, and all that was merged, vanished or clipped (as Spot).
void diagnose_soup(const SurfaceList& surfaces, const std::vector<VanishedFacet>& vanished, ArrangementResult& result);

}  // namespace geomesh::geomodel::arrangement
