// SPDX-License-Identifier: MIT
/// @file
/// Floating-point expansions: exact sums and products of doubles (Shewchuk 1997, "Adaptive precision floating-point arithmetic and fast
/// robust geometric predicates", sections 2.1 to 2.7). An expansion is a sum of non-overlapping doubles in increasing magnitude, zeros
/// left out; its sign is that of its last component.
///
/// Precondition of every operation: no component over- or underflows (see `exponents_are_safe`); round to nearest even; no contraction.
#pragma once

#include <cmath>
#include <utility>

#include "geomesh/core/geometry.hpp"

namespace geomesh::exact {

/// a + b == sum + error exactly.
inline void two_sum(double a, double b, double& sum, double& error) {
  sum = a + b;
  const double bb = sum - a;
  error = (a - (sum - bb)) + (b - bb);
}

/// As two_sum, where |a| >= |b| or a == 0.
inline void fast_two_sum(double a, double b, double& sum, double& error) {
  sum = a + b;
  error = b - (sum - a);
}

/// a * b == product + error exactly. std::fma is exact by definition, in hardware or not.
inline void two_product(double a, double b, double& product, double& error) {
  product = a * b;
  error = std::fma(a, b, -product);
}

/// Fixed capacity, on the stack. N bounds the number of components.
template <int N>
struct Expansion {
  double component[N];
  int n = 0;

  Sign sign() const {
    if (n == 0) return Sign::zero;
    return component[n - 1] > 0 ? Sign::positive : Sign::negative;
  }
  double estimate() const {
    double sum = 0;
    for (int i = 0; i < n; ++i) sum += component[i];
    return sum;
  }
  void push(double value) {
    if (value != 0) component[n++] = value;
  }
};

/// a - b exactly.
inline Expansion<2> difference(double a, double b) {
  Expansion<2> result;
  double sum, error;
  two_sum(a, -b, sum, error);
  result.push(error);
  result.push(sum);
  return result;
}

/// Merges by magnitude and sums with carry: "fast expansion sum" with zero elimination.
template <int A, int B>
Expansion<A + B> operator+(const Expansion<A>& a, const Expansion<B>& b) {
  Expansion<A + B> result;
  int i = 0, j = 0;
  const auto next = [&] {
    if (j == b.n || (i < a.n && std::abs(a.component[i]) < std::abs(b.component[j]))) return a.component[i++];
    return b.component[j++];
  };
  const int total = a.n + b.n;
  if (total == 0) return result;
  double q = next();
  for (int k = 1; k < total; ++k) {
    double sum, error;
    two_sum(q, next(), sum, error);
    result.push(error);
    q = sum;
  }
  result.push(q);
  return result;
}

template <int A>
Expansion<A> operator-(const Expansion<A>& a) {
  Expansion<A> result;
  result.n = a.n;
  for (int i = 0; i < a.n; ++i) result.component[i] = -a.component[i];
  return result;
}

template <int A, int B>
Expansion<A + B> operator-(const Expansion<A>& a, const Expansion<B>& b) {
  return a + (-b);
}

/// a times one double: "scale expansion" with zero elimination.
template <int A>
Expansion<2 * A> scale(const Expansion<A>& a, double s) {
  Expansion<2 * A> result;
  if (a.n == 0 || s == 0) return result;
  double q, error;
  two_product(a.component[0], s, q, error);
  result.push(error);
  for (int i = 1; i < a.n; ++i) {
    double product, product_error, sum;
    two_product(a.component[i], s, product, product_error);
    two_sum(q, product_error, sum, error);
    result.push(error);
    fast_two_sum(product, sum, q, error);
    result.push(error);
  }
  result.push(q);
  return result;
}

namespace detail {
/// Sum of a * b[first .. last) by halving, so that the parts stay of like length.
template <int A, int B>
Expansion<2 * A * B> product_range(const Expansion<A>& a, const Expansion<B>& b, int first, int last) {
  Expansion<2 * A * B> result;
  for (int i = first; i < last; ++i) {
    const Expansion<2 * A> part = scale(a, b.component[i]);
    Expansion<2 * A * B> sum;
    const auto both = result + part;
    sum.n = both.n;
    for (int k = 0; k < both.n; ++k) sum.component[k] = both.component[k];
    result = sum;
  }
  return result;
}
}  // namespace detail

template <int A, int B>
Expansion<2 * A * B> operator*(const Expansion<A>& a, const Expansion<B>& b) {
  return detail::product_range(a, b, 0, b.n);
}

}  // namespace geomesh::exact
