// SPDX-License-Identifier: MIT
/// @file
/// Exact sums of doubles of any length (expansions, see expansion.hpp), for numbers whose length is not known when the
/// program is compiled: coordinates of points that are held exactly.
///
/// Precondition: every term is a multiple of 2^-300 and below 2^300, so that no product of three under- or overflows.
#pragma once

#include <cmath>
#include <vector>

#include "predicates/expansion.hpp"

namespace geomesh::exact {

/// Terms do not overlap and grow in magnitude; zero is the empty sum.
class LongExpansion {
 public:
  LongExpansion() = default;
  LongExpansion(double x) {  // NOLINT: a double is an expansion
    if (x != 0) terms_.push_back(x);
  }

  const std::vector<double>& terms() const { return terms_; }
  bool is_zero() const { return terms_.empty(); }
  Sign sign() const {
    if (terms_.empty()) return Sign::zero;
    return terms_.back() > 0 ? Sign::positive : Sign::negative;
  }
  /// The nearest double but for an ulp.
  double estimate() const {
    double sum = 0;
    for (const double t : terms_) sum += t;
    return sum;
  }
  /// Of the smallest term that is not zero; 0 where all is zero.
  double least_term() const { return terms_.empty() ? 0 : std::fabs(terms_.front()); }

  /// Drops terms below `least`: the rest is a number near this one.
  LongExpansion without_below(double least) const {
    LongExpansion out;
    for (const double t : terms_)
      if (std::fabs(t) >= least) out.terms_.push_back(t);
    return out;
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
  void append(double x) {
    if (x != 0) terms_.push_back(x);
  }
  /// As few terms as can be, the greatest within an ulp of the whole (Shewchuk 1997, figure 15).
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
    std::size_t i = 0, j = 0;
    const auto next = [&] {
      if (j >= f.terms_.size()) return e.terms_[i++];
      if (i >= e.terms_.size()) return sign * f.terms_[j++];
      return std::fabs(e.terms_[i]) < std::fabs(f.terms_[j]) ? e.terms_[i++] : sign * f.terms_[j++];
    };
    const std::size_t n = e.terms_.size() + f.terms_.size();
    if (n == 0) return h;
    double q = next();
    for (std::size_t k = 1; k < n; ++k) {
      double head, tail;
      two_sum(q, next(), head, tail);
      h.append(tail);
      q = head;
    }
    h.append(q);
    h.compress();
    return h;
  }
  static LongExpansion scaled(const LongExpansion& e, double b) {
    LongExpansion h;
    if (e.terms_.empty() || b == 0) return h;
    h.terms_.reserve(2 * e.terms_.size());
    double b_high, b_low, q, tail;
    split(b, b_high, b_low);
    two_product(e.terms_[0], b, b_high, b_low, q, tail);
    h.append(tail);
    for (std::size_t i = 1; i < e.terms_.size(); ++i) {
      double product, product_tail, s;
      two_product(e.terms_[i], b, b_high, b_low, product, product_tail);
      two_sum(q, product_tail, s, tail);
      h.append(tail);
      fast_two_sum(product, s, q, tail);
      h.append(tail);
    }
    h.append(q);
    return h;
  }

  std::vector<double> terms_;
};

/// n / d as a sum of doubles, off by less than `part` of itself and of its distance from 1. d is not zero.
LongExpansion quotient(const LongExpansion& n, const LongExpansion& d, double part);

}  // namespace geomesh::exact
