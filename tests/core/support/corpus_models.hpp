// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The corpus of hard models, made here: every function of it returns a valid piecewise linear complex in the doubles
/// it holds.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

struct CorpusModel {
  std::string name;
  std::size_t n_components;  ///< regions that a right mesh has
  std::function<PiecewiseLinearComplex()> make;
  bool is_large = false;  ///< only in the nightly tests
  bool fits_utm = true;   ///< features stay above 1,000 ulps at coordinates of 6e6
};

/// Schönhardt, Chazelle, the paper's Figures 2, 3 and 4, wedges.
std::vector<CorpusModel> corpus_polyhedra();
/// Near, nested and touching shells; hanging facets, wells, points; polygons with holes.
std::vector<CorpusModel> corpus_contacts();
/// Lattices, coplanar stacks, layers that pinch out, flat models.
std::vector<CorpusModel> corpus_layers();
/// All of the above, in this order.
std::vector<CorpusModel> corpus_models();
/// By name; throws std::out_of_range.
CorpusModel corpus_model(const std::string& name);

}  // namespace geomesh::test
