// SPDX-License-Identifier: MIT
/// @file
/// Meshes one model in canonical form: runs the stages of recovery, in one attempt or several.
#pragma once

#include <optional>

#include "recover/model/declare.hpp"
#include "recover/model/recover.hpp"
#include "recover/start/start_triangulation.hpp"
#include "tetrahedralize/conforming_step.hpp"
#include "tetrahedralize/recovery_attempts.hpp"

namespace geomesh {

/// The mesh with all constraints in it, or the reason why there is none.
struct RecoveryOutcome {
  std::optional<recover::ConstrainedMesh> mesh;
  std::optional<Error> refusal;
};

class RecoveryRun {
 public:
  RecoveryRun(const PiecewiseLinearComplex& plc, const ModelNames& names, const TetrahedralizeOptions& options,
              const RunContext& context, const ConformingStep& conform);

  /// Makes the triangulation that recovery starts from (Cavalcanti and Mello 1999). May throw Error{invalid_input}.
  void triangulate();
  /// Makes attempts at recovery (section 3) until one succeeds.
  RecoveryOutcome recover();

  recover::DeclaredModel& model() { return model_; }
  const RecoveryStatistics& statistics() const { return statistics_; }
  const DelaunayStatistics& delaunay() const { return delaunay_; }

 private:
  recover::StartTriangulation start(const Attempt& attempt);
  void recover_stages(const Attempt& attempt, recover::Recovery& recovery);
  std::optional<Attempt> attempt_after(const Attempt& attempt, const Error& dead_end,
                                       const recover::Recovery& recovery) const;
  Error with_way_out(const Error& dead_end) const;

  const PiecewiseLinearComplex& plc_;
  const ModelNames& names_;
  const TetrahedralizeOptions& options_;
  const RunContext& context_;
  const ConformingStep& conform_;
  double least_spacing_;
  recover::DeclaredModel model_{};
  std::optional<recover::StartTriangulation> first_start_;
  RecoveryStatistics statistics_{};
  DelaunayStatistics delaunay_{};
  recover::HardPartsFirst hard_parts_{};
  std::size_t n_without_double_ = 0;  ///< number of points that no double in their stars can replace, over all attempts
  std::size_t n_decided_ = 0;         ///< number of orientations decided that involve exact places
};

}  // namespace geomesh
