// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs the engine on a model within a time limit and judges what comes back.
#pragma once

#include <optional>
#include <string>

#include "corpus_judge.hpp"
#include "corpus_models.hpp"
#include "geomesh/core/run_context.hpp"

namespace geomesh::test {

struct CorpusRun {
  std::optional<ConstrainedTetrahedralization> mesh;
  std::optional<ErrorKind> error;  ///< kind of the geomesh::Error thrown
  std::string trouble;             ///< empty where the mesh passed the judge; else the error or the faults
  double cpu_seconds = 0;          ///< of tetrahedralize alone
  bool ok() const { return trouble.empty(); }
};

/// Runs on one thread. After `time_limit` seconds the cancel token is set and the run counts as "hangs". `watch`: its
/// log and stage observer are called.
CorpusRun run_and_judge(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options = {},
                        double time_limit = 60, const RunContext& watch = {});

/// CPU seconds of the calling thread so far.
double thread_cpu_seconds();

TetrahedralizeOptions constrained_mode();
TetrahedralizeOptions preserving_mode();
TetrahedralizeOptions conforming_mode();

/// TetGen .poly, so that a failing model can be looked at with other tools and kept. Inner points of facets and
/// isolated points are written as vertices only, listed segments that lie in no facet as facets of two vertices.
void write_poly(const PiecewiseLinearComplex& plc, const std::string& path);

}  // namespace geomesh::test
