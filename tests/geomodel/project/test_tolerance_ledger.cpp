// SPDX-License-Identifier: GPL-3.0-or-later
// The one record of the tolerance: what was requested, what stages used, what is left.
#include <catch2/catch.hpp>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"

namespace geomesh::geomodel {

TEST_CASE("tolerance: what stages take and what is left come to what was requested", "[tolerance]") {
  ToleranceLedger ledger = ToleranceLedger::of_length(10);
  ledger.take({"settling", 5});
  ledger.take({"merging", 1});
  CHECK(ledger.requested() == 10);
  CHECK(ledger.left() == 4);
  CHECK(ledger.bound() == 10);
  REQUIRE(ledger.uses().size() == 2);
  CHECK(ledger.uses()[0].stage == "settling");
  CHECK_FALSE(ledger.follows_sizes());
}

TEST_CASE("tolerance: a share of the size falls as its length does", "[tolerance]") {
  ToleranceLedger ledger = ToleranceLedger::of_sizes(0.05);
  CHECK(ledger.left() == 0);
  ledger.follow_size(400);
  CHECK(ledger.left() == 20);
  ledger.take({"settling", 10});
  CHECK(ledger.left_share() == 0.025);
  ledger.limit_share(0.02);
  CHECK(ledger.left_share() == 0.02);
  ledger.rescale_left(15);  // sizes half as large again
  CHECK(ledger.requested() == 25);
}

TEST_CASE("tolerance: what a key of its own allows is booked beside it", "[tolerance]") {
  ToleranceLedger ledger;  // surfaces are kept
  ToleranceUse use{"merging", 3};
  use.by_own_key = true;
  ledger.take(use);
  CHECK(ledger.requested() == 0);
  CHECK(ledger.left() == 0);
  CHECK(ledger.bound() == 3);
}

TEST_CASE("tolerance: no stage takes more than is left", "[tolerance]") {
  ToleranceLedger ledger = ToleranceLedger::of_length(2);
  ledger.take({"settling", 1});
  CHECK_THROWS_AS(ledger.take({"merging", 1.5}), InternalError);
  CHECK(ledger.left() == 1);
}

}  // namespace geomesh::geomodel
