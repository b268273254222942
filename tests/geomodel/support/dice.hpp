// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Random choices of generators of models: the same for a seed on every machine.
#pragma once

#include <cmath>
#include <random>

namespace geomesh::geomodel::testing {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double unit() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }  ///< above 0, below 1
  double between(double a, double b) { return a + (b - a) * unit(); }
  double log_between(double a, double b) { return a * std::pow(b / a, unit()); }
  std::size_t below(std::size_t n) { return random_() % n; }
  unsigned from_to(unsigned a, unsigned b) { return a + static_cast<unsigned>(random_() % (b - a + 1)); }

 private:
  std::mt19937 random_;
};

}  // namespace geomesh::geomodel::testing
