// SPDX-License-Identifier: GPL-3.0-or-later
#include <CGAL/Gmpq.h>

#include <catch2/catch.hpp>
#include <random>

#include "predicates/long_expansion.hpp"

using namespace geomesh;
using exact::LongExpansion;

namespace {

CGAL::Gmpq value(const LongExpansion& e) {
  CGAL::Gmpq out(0);
  for (const double t : e.terms()) out += CGAL::Gmpq(t);
  return out;
}

/// A few terms of magnitudes far apart, some of them equal but for the sign, so that sums cancel.
LongExpansion random_expansion(std::mt19937& random) {
  LongExpansion out;
  for (unsigned i = 0; i < 1 + random() % 4; ++i) {
    const double mantissa = static_cast<double>(random()) + static_cast<double>(random()) / 4294967296.0;
    const double term = std::ldexp(mantissa, -static_cast<int>(random() % 120));
    out = random() % 2 == 0 ? out + LongExpansion(term) : out - LongExpansion(term);
  }
  return out;
}

}  // namespace

TEST_CASE("sums, differences and products of long expansions are those of exact rational numbers", "[predicates]") {
  std::mt19937 random(3);
  for (int i = 0; i < 2000; ++i) {
    const LongExpansion a = random_expansion(random), b = random_expansion(random);
    const double c = std::ldexp(static_cast<double>(random()), -20);
    REQUIRE(value(a + b) == value(a) + value(b));
    REQUIRE(value(a - b) == value(a) - value(b));
    REQUIRE(value(a * b) == value(a) * value(b));
    REQUIRE(value(a * c) == value(a) * CGAL::Gmpq(c));
    REQUIRE(static_cast<int>((a - b).sign()) == CGAL::sign(value(a) - value(b)));
    REQUIRE((a - a).is_zero());
  }
}

TEST_CASE("a quotient of long expansions is as near to the exact one as was asked for, from zero and from one",
          "[predicates]") {
  std::mt19937 random(5);
  for (int i = 0; i < 500; ++i) {
    const LongExpansion d = random_expansion(random), n = d * (static_cast<double>(random()) / 4294967296.0);
    if (d.is_zero() || n.is_zero()) continue;
    const CGAL::Gmpq exact = value(n) / value(d), from_one = abs(CGAL::Gmpq(1) - exact);
    for (const double error : {0x1p-40, 0x1p-80, 0x1p-120}) {
      const CGAL::Gmpq off = abs(value(exact::quotient(n, d, error)) - exact);
      CHECK(off <= CGAL::Gmpq(8 * error) * exact);
      CHECK(off <= CGAL::Gmpq(8 * error) * from_one);
    }
  }
}
