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

/// The valid complexes of the outside data (solids, classic, grains, modelA4), and its faults intersected in a box
/// (where geomodel is built). Then models of our own making: needle plates, structural models and noisy faults by seed
/// (the last two where geomodel is built), the larger ones of the corpus, and families of growing size.
std::vector<RecoveryInput> recovery_inputs(const std::string& data_folder);

}  // namespace geomesh::bench
