// SPDX-License-Identifier: MIT
/// @file
/// Exact sums of doubles of any length (expansions, see expansion.hpp), for numbers whose length is not known when the
/// program is compiled: coordinates of points that are represented exactly.
///
/// Precondition: every term is a multiple of 2^-300 and below 2^300, so that no product of three under- or overflows.
#pragma once

#include <cmath>
#include <vector>

#include "predicates/expansion.hpp"

namespace geomesh::exact {

/// An expansion of any length. Terms do not overlap and increase in magnitude; zero is the empty sum.
class LongExpansion {
 public:
  LongExpansion() = default;
  LongExpansion(double x) { append(x); }  // NOLINT: implicit, because a double is an expansion of one term

  const std::vector<double>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  Sign sign() const {
    if (terms_.empty()) return Sign::zero;
    return terms_.back() > 0 ? Sign::positive : Sign::negative;
  }
  /// Returns the nearest double, with an error of up to one ulp.
  double estimate() const {
    double sum = 0;
    for (const double t : terms_) sum += t;
    return sum;
  }
  /// Returns the magnitude of this sum's smallest nonzero term; 0 if there is none.
  double least_term() const { return terms_.empty() ? 0 : std::fabs(terms_.front()); }

  /// Returns the sum of this expansion's terms with a magnitude of at least `least`, which approximates the whole sum.
  LongExpansion without_below(double least) const {
    LongExpansion out;
    for (const double t : terms_)
      if (std::fabs(t) >= least) out.terms_.push_back(t);
    return out;
  }

  void append(double x) {
    if (x != 0) terms_.push_back(x);
  }

  friend LongExpansion operator+(const LongExpansion& e, const LongExpansion& f) { return sum(e, f, 1); }
  friend LongExpansion operator-(const LongExpansion& e, const LongExpansion& f) { return sum(e, f, -1); }
  friend LongExpansion operator*(const LongExpansion& e, double b) {
    LongExpansion h = scaled(e, b);
    h.compress();
    return h;
  }
  friend LongExpansion operator*(const LongExpansion& e, const LongExpansion& f) {
    const LongExpansion &longer = e.terms_.size() >= f.terms_.size() ? e : f, &shorter = &longer == &e ? f : e;
    LongExpansion out;
    for (const double t : shorter.terms_) out = sum(out, scaled(longer, t), 1);
    return out;
  }

 private:
  /// Reduces the sum to the fewest terms, with the greatest within an ulp of the whole (Shewchuk 1997, figure 15).
  void compress() {
    if (terms_.size() < 2) return;
    std::vector<double> g;
    double q = terms_.back();
    for (std::size_t i = terms_.size() - 1; i-- > 0;) {
      double head, tail;
      fast_two_sum(q, terms_[i], head, tail);
      if (tail != 0) {
        g.push_back(head);
        q = tail;
      } else {
        q = head;
      }
    }
    g.push_back(q);  // greatest first
    terms_.clear();
    double top = g.back();
    for (std::size_t i = g.size() - 1; i-- > 0;) {
      double head, tail;
      fast_two_sum(g[i], top, head, tail);
      append(tail);
      top = head;
    }
    append(top);
  }
  static LongExpansion sum(const LongExpansion& e, const LongExpansion& f, double sign) {
    LongExpansion h;
    h.terms_.reserve(e.terms_.size() + f.terms_.size());
    append_sum(e.terms_, f.terms_, sign, h);
    h.compress();
    return h;
  }
  static LongExpansion scaled(const LongExpansion& e, double b) {
    LongExpansion h;
    h.terms_.reserve(2 * e.terms_.size());
    append_scaled(e.terms_, b, h);
    return h;
  }

  std::vector<double> terms_;
};

/// Returns n / d as a sum of doubles. Its error is less than `part` times the quotient and less than `part` times the
/// quotient's distance from 1. d is not zero.
LongExpansion quotient(const LongExpansion& n, const LongExpansion& d, double part);

}  // namespace geomesh::exact
