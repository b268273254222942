// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Which unit of the stratigraphic column a component is, from the horizons that bound it above and below.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"

namespace geomesh::geomodel {

/// unit, horizon, unit, ..., unit, youngest first, with horizons as rows of surfaces. Unit u lies below horizon u - 1
/// and above horizon u.
struct Column {
  std::vector<std::string> units;
  std::vector<Index> horizons;             ///< rows of surfaces; one fewer than units, none where there is no column
  std::vector<UpwardSides> sides;          ///< per horizon
  std::vector<std::vector<Vec3>> normals;  ///< per horizon: of each triangle, of unit length; zero where it has no area
  bool given() const { return !units.empty(); }
};
/// Throws Error{usage} where the list has even length or a horizon is not among the surfaces. Warns of sheets that have
/// no upper side.
Column make_column(const std::vector<std::string>& names, const std::vector<TriangulatedSurface>& surfaces,
                   std::vector<std::string>& warnings);

/// The faces of horizons about one component: areas by row of the column. A face at 84 degrees or more to the triangle
/// that it stands for shows no side: a horizon that ends on a fault within the tolerance has such faces along it. So
/// does a face that rounding turned over: between two faults an ulp apart a horizon has strips of these.
struct HorizonContacts {
  std::map<Index, double> lies_below, lies_above;  ///< faces that part it from something else
  std::map<Index, double> on_both_sides;           ///< faces with this component on both sides
};
std::vector<HorizonContacts> horizon_contacts(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup,
                                              const ModelPlc& plc, const Column& column);

/// The horizons next above and next below a point on its vertical, as if they were in contact with it (area 1): for
/// components between faults that touch no horizon. Where nothing of a horizon is left on the vertical (all were
/// above the topography), the surfaces before rules and bodies took parts away tell. Linear in both.
HorizonContacts contacts_on_vertical(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                                     const Column& column, const Vec3& p);

/// What the contacts say.
struct UnitVerdict {
  enum class Kind {
    unknown,     ///< no horizon speaks for it
    vertical,    ///< touches none: first == last by the horizons next above and below on the vertical
    unit,        ///< one unit: first == last
    joined,      ///< units first .. last join through a gap in a horizon
    incomplete,  ///< first == last is the nearest unit, if nothing else tells; first_possible .. last_possible agree
                 ///< with the contacts (a horizon is missing here)
    pocket,      ///< lies below an older and above a younger horizon; first == last is the unit above the younger one
  } kind = Kind::unknown;
  Index first = no_index, last = no_index;
  Index first_possible = no_index, last_possible = no_index;
  bool by_heights = false;  ///< the horizons as they were laid down tell first == last
};
/// Rule: below horizon h means unit h + 1 or older, above it unit h or younger; where horizons converge on others
/// (pinch-outs, erosion, onlap) the tightest bounds hold. A horizon with the component on both sides joins units only
/// where those bounds leave both possible; elsewhere it is a flap that ends inside one unit. Less than a hundredth of
/// the area on both sides bounds nothing.
UnitVerdict judge_unit(const HorizonContacts& contacts, const Column& column);

/// "chalk" or "chalk+basement" for joined units; empty for unknown.
std::string unit_name(const UnitVerdict& verdict, const Column& column);

}  // namespace geomesh::geomodel
