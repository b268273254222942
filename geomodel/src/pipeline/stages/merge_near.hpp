// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs the stage intersect and merges surfaces where they nearly coincide, within a part of the tolerance.
#pragma once

#include <vector>

#include "pipeline/journal.hpp"
#include "pipeline/records.hpp"

namespace geomesh::geomodel {

/// Returns the arrangement of the model's surfaces. Unless the options request merging, surfaces that meet somewhere
/// are merged where they are closer to each other than merging_distance(), and the movement is taken from the
/// tolerance. If something moves by more than half of the tolerance, or if no arrangement is found, half of the
/// distance is tried, then a quarter, then none. Merging that the options request may move nothing by more than twice
/// its distance, and is tried down to a sixteenth of it, with a warning.
ArrangementResult arrange_merging_near(const Inputs& inputs, const Built& built, ArrangementOptions options,
                                       ToleranceLedger& tolerance, Journal& journal);

}  // namespace geomesh::geomodel
