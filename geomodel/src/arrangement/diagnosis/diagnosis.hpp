// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Describes what crosses, touches, overlaps and dangles, as spots and in a geologist's words.
#pragma once

#include "arrangement/model/arranged.hpp"
#include "arrangement/model/ingest.hpp"

namespace geomesh::geomodel::arrangement {

/// A complex with its contacts, and the results of arranging both.
struct ArrangedContacts {
  const Complex& complex;
  const Contacts& contacts;
  const Arranged& arranged;
};

/// Finds crossings of input surfaces (excluding the sides of the box), inside the box if there is one. Adds spots and
/// warnings, fills n_crossing_pairs; `crosses_itself` is set per given surface.
void diagnose_crossings(const ArrangedContacts& round, const SurfaceList& surfaces, const std::optional<Box3>& box,
                        ArrangementResult& result, std::vector<std::uint8_t>& crosses_itself);

/// Throws Error{invalid_input} that names the pairs and places if any input surfaces cross.
void refuse_crossings(const ArrangementResult& result, const SurfaceList& surfaces);

/// Describes free borders and overlaps of the finished soup, and everything that was merged, vanished or clipped.
void diagnose_soup(const SurfaceList& surfaces, const std::vector<VanishedFacet>& vanished, ArrangementResult& result);

}  // namespace geomesh::geomodel::arrangement
