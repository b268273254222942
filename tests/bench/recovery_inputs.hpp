// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The inputs of the recovery benchmark.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"

namespace geomesh::bench {

struct RecoveryInput {
  std::string name;
  std::function<PiecewiseLinearComplex()> make;
};

/// The valid complexes of the outside data (solids, classic, grains, modelA4), the faults of the outside data
/// intersected in a box (where geomodel is built), and the larger models of the corpus.
std::vector<RecoveryInput> recovery_inputs(const std::string& data_folder);

}  // namespace geomesh::bench
