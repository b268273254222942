// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Stage intersect where surfaces may be off their input by a share of the size: places where they nearly coincide are
/// brought together within a part of it.
#pragma once

#include <vector>

#include "pipeline/journal.hpp"
#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// The arrangement of the model's surfaces. Those that meet somewhere merge where they are nearer to each other than
/// merging_distance(). That is so where the options ask for no merging of their own. What it used is taken from
/// the tolerance. Half of the distance is tried where something moves by more than half of the tolerance, or where no
/// arrangement comes of it; then a quarter; then none. Merging that the options ask for may move nothing by more than
/// twice its distance, and is tried down to a sixteenth of that; a warning tells.
ArrangementResult arrange_merging_near(const Inputs& inputs, const Built& built, ArrangementOptions options,
                                       ToleranceLedger& tolerance, Journal& journal);

}  // namespace geomesh::geomodel
