// SPDX-License-Identifier: MIT
/// @file
/// Numbers with twice the precision of a double. They are computed with doubles only and are therefore the same on
/// every processor, unlike long double.
#pragma once

#include "predicates/expansion.hpp"

namespace geomesh::exact {

/// A number of about 106 bits: hi + lo, where lo is at most half an ulp of hi. Sums and products have errors below 6
/// u^2 of the sum of the magnitudes (of the product); differences of doubles are exact.
struct TwoDouble {
  double hi = 0, lo = 0;
  static TwoDouble difference(double a, double b) {
    TwoDouble r;
    two_difference(a, b, r.hi, r.lo);
    return r;
  }
  friend TwoDouble operator+(const TwoDouble& a, const TwoDouble& b) {
    double s, e;
    two_sum(a.hi, b.hi, s, e);
    TwoDouble r;
    fast_two_sum(s, e + (a.lo + b.lo), r.hi, r.lo);
    return r;
  }
  friend TwoDouble operator-(const TwoDouble& a, const TwoDouble& b) { return a + TwoDouble{-b.hi, -b.lo}; }
  friend TwoDouble operator*(const TwoDouble& a, const TwoDouble& b) {
    double p, e;
    two_product(a.hi, b.hi, p, e);
    TwoDouble r;
    fast_two_sum(p, e + (a.hi * b.lo + a.lo * b.hi), r.hi, r.lo);
    return r;
  }
  /// Quotient, accurate to about 100 bits; b is not zero.
  friend TwoDouble operator/(const TwoDouble& a, const TwoDouble& b) {
    const double quotient = a.hi / b.hi;
    const TwoDouble rest = a - TwoDouble{quotient} * b;
    TwoDouble r;
    fast_two_sum(quotient, rest.hi / b.hi, r.hi, r.lo);
    return r;
  }
};

}  // namespace geomesh::exact
