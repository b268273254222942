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
  CHECK(unit_name(find_unit(contacts, column), column) == "u1+u2+u3");
  // Seed 990086, within a tolerance: 205 m2 at the fault where a horizon of 4 km2 ends named u2 what is u2 and u3.
  contacts.lies_above = {{1, 205}};
  CHECK(unit_name(find_unit(contacts, column), column) == "u1+u2+u3");
  contacts.lies_above = {{1, 6e6}};  // it bounds the region over more than it ends in it
  CHECK(unit_name(find_unit(contacts, column), column) == "u1+u2");
  contacts.on_both_sides.clear();
  contacts.lies_above = {{1, 4e-10}};  // all that there is
  CHECK(unit_name(find_unit(contacts, column), column) == "u2");
}

TEST_CASE("a region that goes on beyond a horizon is named by all that it reaches", "[sets]") {
  // Family noisy_grid 5: pockets between the two lower horizons, which cross by noise, bounded the block to u3 alone.
  Column column;
  column.units = {"u1", "u2", "u3", "u4"};
  column.horizons = {0, 1, 2};
  HorizonContacts contacts;
  contacts.on_both_sides = {{0, 5e6}, {1, 4e6}, {2, 4e6}};
  contacts.lies_below = {{1, 1e5}};
  contacts.lies_above = {{2, 1e5}};
  CHECK(unit_name(find_unit(contacts, column), column) == "u1+u2+u3+u4");
  // A horizon that overshoots into a unit and ends there joins nothing.
  contacts.on_both_sides = {{0, 1e4}};
  contacts.lies_below = {{1, 4e6}};
  contacts.lies_above = {{2, 4e6}};
  CHECK(unit_name(find_unit(contacts, column), column) == "u3");
}
