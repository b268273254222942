// SPDX-License-Identifier: GPL-3.0-or-later
// Units by the areas that horizons show to a region.
#include <catch2/catch.hpp>

#include "naming/column.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

TEST_CASE("what rounding leaves of a horizon that ends in a region bounds no unit", "[sets]") {
  // Found by seed 822285 of the random models (--light): 4e-10 m2 on a fault named a region of 10 km3.
  Column column;
  column.units = {"u1", "u2", "u3"};
  column.horizons = {0, 1};
  HorizonContacts contacts;
  contacts.on_both_sides = {{0, 4e6}, {1, 5e6}};
  contacts.lies_above = {{1, 4e-10}};
  CHECK(unit_name(judge_unit(contacts, column), column) == "u1+u2+u3");
  // Seed 990086, within a tolerance: 205 m2 at the fault where a horizon of 4 km2 ends named u2 what is u2 and u3.
  contacts.lies_above = {{1, 205}};
  CHECK(unit_name(judge_unit(contacts, column), column) == "u1+u2+u3");
  contacts.lies_above = {{1, 1e5}};  // a contact
  CHECK(unit_name(judge_unit(contacts, column), column) == "u1+u2");
  contacts.on_both_sides.clear();
  contacts.lies_above = {{1, 4e-10}};  // all that there is
  CHECK(unit_name(judge_unit(contacts, column), column) == "u2");
}
