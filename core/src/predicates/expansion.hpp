// SPDX-License-Identifier: MIT
/// @file
/// Floating-point expansions: exact sums and products of doubles as unevaluated sums of non-overlapping doubles,
/// smallest first. Source: Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast robust geometric
/// predicates", section 2.
///
/// Precondition throughout: round-to-even doubles, no contraction into fused operations, no over- or underflow
/// (exponents_are_safe). All results are non-adjacent, as fast_expansion_sum requires of its arguments (Shewchuk 1997,
/// theorem 13 and section 2.4).
#pragma once

#include <cstddef>
#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh::exact {

/// Computes head + tail == a + b exactly (Knuth 1969).
inline void two_sum(double a, double b, double& head, double& tail) {
  head = a + b;
  const double b_virtual = head - a;
  const double a_virtual = head - b_virtual;
  tail = (a - a_virtual) + (b - b_virtual);
}

/// Computes head + tail == a + b exactly if |a| >= |b| (Dekker 1971).
inline void fast_two_sum(double a, double b, double& head, double& tail) {
  head = a + b;
  tail = b - (head - a);
}

/// Computes head + tail == a - b exactly.
inline void two_difference(double a, double b, double& head, double& tail) { two_sum(a, -b, head, tail); }

/// Splits a into high + low == a with at most 26 bits each (Veltkamp's splitting).
inline void split(double a, double& high, double& low) {
  const double c = 134217729.0 * a;
  high = c - (c - a);
  low = a - high;
}

/// Computes head + tail == a * b exactly, for a number b that is already split.
inline void two_product(double a, double b, double b_high, double b_low, double& head, double& tail) {
  double a_high, a_low;
  head = a * b;
  split(a, a_high, a_low);
  tail = a_low * b_low - (((head - a_high * b_high) - a_low * b_high) - a_high * b_low);
}

inline void two_product(double a, double b, double& head, double& tail) {
  double b_high, b_low;
  split(b, b_high, b_low);
  two_product(a, b, b_high, b_low, head, tail);
}

/// A sum of at most Capacity doubles, non-overlapping, of increasing magnitude, without zeros; zero is the empty sum.
template <int Capacity>
struct Expansion {
  int size = 0;
  double term[Capacity];

  Expansion() = default;
  /// Copies the `size` terms of the expansion that are in use, not the whole array.
  Expansion(const Expansion& other) : size(other.size) {
    for (int i = 0; i < size; ++i) term[i] = other.term[i];
  }
  Expansion& operator=(const Expansion&) = delete;

  void append(double x) {
    if (x != 0) term[size++] = x;
  }
  std::span<const double> terms() const { return {term, static_cast<std::size_t>(size)}; }
  Sign sign() const {
    if (size == 0) return Sign::zero;
    return term[size - 1] > 0 ? Sign::positive : Sign::negative;
  }
};

inline Expansion<1> single(double a) {
  Expansion<1> r;
  r.append(a);
  return r;
}

/// Appends e + sign * f to h, sign being 1 or -1: fast_expansion_sum with zero elimination (Shewchuk 1997, figure 8).
template <class Sum>
void append_sum(std::span<const double> e, std::span<const double> f, double sign, Sum& h) {
  std::size_t i = 0, j = 0;
  const auto next = [&] {
    if (j >= f.size()) return e[i++];
    if (i >= e.size()) return sign * f[j++];
    const double a = e[i], b = f[j];
    const bool take_e = (a < 0 ? -a : a) < (b < 0 ? -b : b);
    return take_e ? (++i, a) : (++j, sign * b);
  };
  const std::size_t n = e.size() + f.size();
  if (n == 0) return;
  double q = next();
  for (std::size_t k = 1; k < n; ++k) {
    double head, tail;
    two_sum(q, next(), head, tail);
    h.append(tail);
    q = head;
  }
  h.append(q);
}

/// Appends e * b to h: scale_expansion with zero elimination (Shewchuk 1997, figure 13).
template <class Product>
void append_scaled(std::span<const double> e, double b, Product& h) {
  if (e.empty() || b == 0) return;
  double b_high, b_low, q, tail;
  split(b, b_high, b_low);
  two_product(e[0], b, b_high, b_low, q, tail);
  h.append(tail);
  for (const double x : e.subspan(1)) {
    double product, product_tail, s;
    two_product(x, b, b_high, b_low, product, product_tail);
    two_sum(q, product_tail, s, tail);
    h.append(tail);
    fast_two_sum(product, s, q, tail);
    h.append(tail);
  }
  h.append(q);
}

template <int N, int M>
Expansion<N + M> operator+(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> h;
  append_sum(e.terms(), f.terms(), 1, h);
  return h;
}
template <int N, int M>
Expansion<N + M> operator-(const Expansion<N>& e, const Expansion<M>& f) {
  Expansion<N + M> h;
  append_sum(e.terms(), f.terms(), -1, h);
  return h;
}
template <int N>
Expansion<2 * N> operator*(const Expansion<N>& e, double b) {
  Expansion<2 * N> h;
  append_scaled(e.terms(), b, h);
  return h;
}

/// Returns a * b - c * d exactly.
inline Expansion<4> minor2(double a, double b, double c, double d) {
  Expansion<2> ab, cd;
  double head, tail;
  two_product(a, b, head, tail);
  ab.append(tail);
  ab.append(head);
  two_product(c, d, head, tail);
  cd.append(tail);
  cd.append(head);
  return ab - cd;
}

}  // namespace geomesh::exact
