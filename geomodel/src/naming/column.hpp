// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Determines which unit of the stratigraphic column a component is, from the horizons that bound it above and below.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {

/// Alternating units and horizons, youngest first, with horizons as rows of surfaces. Unit u lies below horizon u - 1
/// and above horizon u.
struct Column {
  std::vector<std::string> units;
  std::vector<Index> horizons;     ///< rows of the horizons' surfaces; one fewer than units, none if there is no column
  std::vector<UpwardSides> sides;  ///< per horizon
  /// For each horizon, the unit normals of its triangles; zero for triangles without area.
  std::vector<std::vector<Vec3>> normals;
  bool given() const { return !units.empty(); }
};
/// Throws Error{usage} if the list has even length or a horizon is not among the surfaces. Warns of sheets that have no
/// upper side.
Column make_column(const std::vector<std::string>& names, const std::vector<TriangulatedSurface>& surfaces,
                   std::vector<std::string>& warnings);

/// The faces of horizons about one component: areas by row of the column. A face at 84 degrees or more to its input
/// triangle is ignored, because it does not show on which side it lies: a horizon that ends on a fault within the
/// tolerance has such faces. Faces that rounding inverted are ignored too: between two faults an ulp apart a horizon
/// has strips of these.
struct HorizonContacts {
  /// Area of faces below (above) which the component lies, with something else on their other side.
  std::map<Index, double> lies_below, lies_above;
  std::map<Index, double> on_both_sides;  ///< area of faces that have this component on both sides
};
std::vector<HorizonContacts> horizon_contacts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                              const ModelPlc& plc, const Column& column);

/// Returns the horizons next above and next below a point on its vertical, as if they were in contact with it (area 1);
/// used for components between faults that touch no horizon. If the vertical meets no remaining part of a horizon (all
/// of it was above the topography), the surfaces before trimming by rules and bodies are used. Linear in both.
HorizonContacts contacts_on_vertical(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                     const Column& column, const Vec3& p);

/// The unit of a component, as far as its contacts with horizons determine it.
struct UnitVerdict {
  enum class Kind {
    unknown,   ///< no horizon gives information about it
    vertical,  ///< touches no horizon: first == last from the horizons next above and below on the vertical
    unit,      ///< exactly one unit: first == last
    joined,    ///< units first .. last are connected through a gap in a horizon
    /// A horizon is missing here: units first_possible .. last_possible agree with the contacts, and first == last is
    /// the nearest of them, used if nothing else decides.
    incomplete,
    pocket,  ///< lies below an older and above a younger horizon; first == last is the unit above the younger one
  } kind = Kind::unknown;
  Index first = no_index, last = no_index;
  Index first_possible = no_index, last_possible = no_index;
  bool by_heights = false;  ///< whether first == last was determined from the order of deposition of the horizons
};
/// Rule: below horizon h means unit h + 1 or older, above it unit h or younger; where horizons converge on others
/// (pinch-outs, erosion, onlap) the tightest bounds are used. A horizon that has the component on both sides joins two
/// units only if those bounds leave both possible; elsewhere it is a dangling face inside one unit. A horizon bounds
/// nothing if a horizon beyond it, or it itself, has the component on both sides over a larger area.
UnitVerdict find_unit(const HorizonContacts& contacts, const Column& column);

/// Returns "chalk", or "chalk+basement" for joined units; empty if unknown.
std::string unit_name(const UnitVerdict& verdict, const Column& column);

}  // namespace geomesh::geomodel
