// SPDX-License-Identifier: MIT
/// @file
/// Estimates before the work how many elements refinement will make, and what requires them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "geomesh/core/refine.hpp"

namespace geomesh {

/// Numbers of elements. Each part is counted in addition to the previous parts.
struct ElementEstimate {
  double by_volume = 0;      ///< SizeOptions::global only, on the surfaces as they are
  double by_sizes = 0;       ///< sizes of units, surfaces, curves and places, a background, and edges of the input
  double by_thin_units = 0;  ///< the first `n_thin` of SizeOptions::sources, which come from thin units
  double by_bends = 0;       ///< surfaces within the tolerance, or within an angle of curvature
  double by_gaps = 0;        ///< gaps between surfaces, and layers across components
  double total() const { return by_volume + by_sizes + by_thin_units + by_bends + by_gaps; }
};

/// Estimates for many sizes of one model: whatever does not depend on sizes is computed once. Nearly linear in the
/// cells of the mesh; an estimate takes seconds at most, whatever the number of elements.
class ElementEstimator {
 public:
  /// Preconditions and errors are those of refine_and_improve. `plc` is stored by reference.
  ElementEstimator(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                   const RefineOptions& options);
  ElementEstimator(ElementEstimator&&) noexcept;
  ElementEstimator& operator=(ElementEstimator&&) noexcept;
  ~ElementEstimator();

  /// Returns the total within 30 % of the actual number. `options` are those of the constructor, with other sizes and
  /// tolerances.
  double total(const RefineOptions& options) const;
  /// Returns whether the total is above `limit`, which is faster than the total if it is far above.
  bool is_above(double limit, const RefineOptions& options) const;
  /// Returns how many of these elements each cause requires. The first `n_thin` sources are those of thin units.
  /// `known_total` is total(options), if the caller has it.
  ElementEstimate by_cause(const RefineOptions& options, std::size_t n_thin = 0,
                           std::optional<double> known_total = std::nullopt) const;

 private:
  double count(const RefineOptions& options, double enough) const;
  struct Basis;
  std::unique_ptr<Basis> basis_;
};

}  // namespace geomesh
