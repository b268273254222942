// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One model in a process of its own, and models made smaller while they still fail.
#pragma once

#include <functional>
#include <string>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh::test {

/// What became of the model: empty where it is meshed and passes the judge, else "hangs", "crashes (signal N)" or what
/// the run said. Runs in a child process that is stopped after `time_limit` seconds.
std::string outcome_of(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options, double time_limit);

/// The word before the first colon: failures of one kind are taken as the same failure.
std::string kind_of(const std::string& outcome);

/// Deletes facets, segments and isolated points, by halves and then one by one, as long as `is_kept` holds for what is
/// left; drops unused points. At most `budget` questions.
PiecewiseLinearComplex minimised_while(PiecewiseLinearComplex plc,
                                       const std::function<bool(const PiecewiseLinearComplex&)>& is_kept,
                                       int budget = 1500);

/// The same, as long as the failure stays of the same kind.
PiecewiseLinearComplex minimised(PiecewiseLinearComplex plc, const TetrahedralizeOptions& options, double time_limit,
                                 int budget = 1500);

}  // namespace geomesh::test
