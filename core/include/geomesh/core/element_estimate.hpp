// SPDX-License-Identifier: MIT
/// @file
/// How many elements refinement will make, and what asks for them, before the work.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "geomesh/core/refine.hpp"

namespace geomesh {

/// Numbers of elements. Each part is what comes on top of the parts before it.
struct ElementEstimate {
  double by_volume = 0;      ///< SizeOptions::global alone, on the surfaces as they are
  double by_sizes = 0;       ///< sizes of units, surfaces, curves and places, a background, edges of the input
  double by_thin_units = 0;  ///< the first `n_thin` of SizeOptions::sources
  double by_bends = 0;       ///< surfaces within the tolerance, or within an angle of curvature
  double by_gaps = 0;        ///< gaps between surfaces, and layers across components
  double total() const { return by_volume + by_sizes + by_thin_units + by_bends + by_gaps; }
};

/// Estimates for many sizes of one model: what does not depend on sizes is computed once. Near-linear in the cells of
/// the mesh; an estimate takes seconds at most, however many elements that are.
class ElementEstimator {
 public:
  /// Preconditions and errors are those of refine_and_improve. `plc` is kept by reference.
  ElementEstimator(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                   const RefineOptions& options);
  ElementEstimator(ElementEstimator&&) noexcept;
  ElementEstimator& operator=(ElementEstimator&&) noexcept;
  ~ElementEstimator();

  /// Within 30 % of what comes out. `options` are those of the constructor, with other sizes and tolerances.
  double total(const RefineOptions& options) const;
  /// Whether the total is above `limit`; sooner known than the total where it is far above.
  bool is_above(double limit, const RefineOptions& options) const;
  /// Tells how much of that number each cause asks for. The first `n_thin` sources are those of thin units.
  /// `known_total`: total(options), if the caller has it.
  ElementEstimate by_cause(const RefineOptions& options, std::size_t n_thin = 0,
                           std::optional<double> known_total = std::nullopt) const;

 private:
  double count(const RefineOptions& options, double enough) const;
  struct Basis;
  std::unique_ptr<Basis> basis_;
};

}  // namespace geomesh
