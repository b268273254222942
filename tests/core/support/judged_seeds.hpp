// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What tests of families by seed share: the judge with a limit on Steiner points, and seeds asked for in the
/// environment.
#pragma once

#include <catch2/catch.hpp>
#include <cstdlib>
#include <sstream>
#include <vector>

#include "corpus_run.hpp"

namespace geomesh::test {

/// The mesh passes the judge and has at most one Steiner point for `points_each` of the model's. Nothing more can be
/// said of a run that is not ok.
inline CorpusRun mesh_with_few_points(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options,
                                      std::size_t points_each, double time_limit) {
  INFO((options.recover.preserve_boundary ? "boundary kept" : "constrained"));
  CorpusRun run = run_and_judge(plc, options, time_limit);
  CHECK(run.trouble == "");
  if (!run.ok()) return run;
  const RecoveryStatistics& s = run.mesh->recovery;
  CHECK(points_each * (s.steiner_on_segments + s.steiner_on_facets + s.steiner_inside) <= plc.points.size());
  return run;
}

/// Numbers in an environment variable, as "FIRST COUNT": any range of seeds, to share a long run among processes.
inline std::vector<unsigned> seeds_asked(const char* variable, std::size_t n_numbers = 2) {
  const char* asked = std::getenv(variable);
  REQUIRE(asked != nullptr);
  std::istringstream words(asked);
  std::vector<unsigned> numbers(n_numbers);
  for (unsigned& n : numbers) REQUIRE(words >> n);
  return numbers;
}

}  // namespace geomesh::test
