// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Removes parts of surfaces, decided exactly on exact vertices: parts outside the box, parts inside bodies, and inner
/// walls of bodies that cross themselves.
#pragma once

#include <string>
#include <vector>

#include "arrangement/model/arranged.hpp"
#include "arrangement/model/ingest.hpp"
#include "arrangement/model/winding.hpp"

namespace geomesh::geomodel::arrangement {

/// Facets of one arrangement, with the data needed to remove origins (input triangles) from them.
struct ClipContext {
  Arranged& arranged;
  const SurfaceList& surfaces;
  ArrangementResult& result;  ///< receives clipped areas, findings (Spot) and warnings
  double tolerance = 0;       ///< distance within which surfaces were merged before clipping; 0 if nothing was merged
};

/// Removes facets, wells and points outside the closed box. Each facet lies on one side of each box plane, because the
/// box's sides take part in the arrangement.
void clip_to_box(ClipContext context, const Box3& box, const std::vector<Polyline>& polylines);

/// Removes facets, wells and points outside the closed volume that the sides (SurfaceList::box_sides) enclose. The
/// winding number of one exact point of each item decides.
void clip_to_volume(ClipContext context, const Complex& complex, const Ingested& ingested,
                    const std::vector<Polyline>& polylines, const std::vector<NamedPoint>& points);

/// Removes inner parts of bodies that cross themselves (winding number not zero on both sides), then the parts of
/// horizons and faults strictly inside bodies with cuts_all, except for scarps (scarps.hpp). `crosses_itself` has one
/// entry per input surface. Some removed places were outside the body before merging moved them: returns their largest
/// distance from the rest of their surface (lost_beside_body.hpp).
Displacement cut_by_bodies(ClipContext context, const Complex& complex, const Ingested& ingested,
                           const std::optional<Box3>& box, const std::vector<std::uint8_t>& crosses_itself);

/// Removes from each facet f with which[f] the origins (input triangles) that `remove(f, origin)` accepts. A facet
/// without any origin left is removed.
template <typename Remove>
void remove_origins(Arranged& arranged, const std::vector<std::uint8_t>& which, Remove&& remove) {
  std::vector<Triangle> facets;
  std::vector<std::uint8_t> changed;
  OriginLists origins;
  for (std::size_t f = 0; f < arranged.facets.size(); ++f) {
    std::vector<Origin> left;
    for (const Origin& o : arranged.origins.of(f))
      if (!which[f] || !remove(static_cast<Index>(f), o)) left.push_back(o);
    if (left.empty()) continue;
    Triangle t = arranged.facets[f];
    if (left.front().reversed) {
      std::swap(t[1], t[2]);
      for (Origin& o : left) o.reversed = !o.reversed;
    }
    facets.push_back(t);
    changed.push_back(arranged.changed[f]);
    origins.push(left);
  }
  arranged.facets = std::move(facets);
  arranged.changed = std::move(changed);
  arranged.origins = std::move(origins);
}

/// Removes all origins (input triangles) of facets marked `outside`; counts their area as clipped by the box.
void remove_outside(ClipContext context, std::vector<std::uint8_t>& outside);

/// Removes the parts of continued surfaces that walls separate from the original surface (ArrangementOptions::ends_at),
/// before merging can join them with other surfaces beyond the wall. Faults are not cut here, because those that
/// coincide up to rounding are merged first. The parts that faults will lose do not act as walls, however.
void end_continuations(ClipContext context, const ArrangementOptions& options);

/// Removes segments of wells marked `outside`, and reports their length.
void remove_segments(ClipContext context, const std::vector<std::uint8_t>& outside,
                     const std::vector<Polyline>& polylines);

double facet_area(const Arranged& arranged, std::size_t f);

}  // namespace geomesh::geomodel::arrangement
