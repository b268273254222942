// SPDX-License-Identifier: MIT
/// @file
/// Estimates, before refinement starts, how many elements it will create and which options require them.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include "geomesh/core/refine.hpp"

namespace geomesh {

/// Estimated numbers of elements by cause. Each cause counts only the elements that it adds to those of earlier causes.
struct ElementEstimate {
  double by_volume = 0;  ///< number of elements if SizeOptions::global were the only size
  double by_sizes = 0;   ///< elements added by target sizes of units, surfaces, curves and places, and by input edges
  double by_thin_units = 0;  ///< elements added by the first `n_thin` entries of SizeOptions::sources
  double by_bends = 0;       ///< elements added to follow the bends of surfaces closely enough
  double by_gaps = 0;        ///< elements added by gaps between surfaces and by layers across components
  double total() const { return by_volume + by_sizes + by_thin_units + by_bends + by_gaps; }
};

/// Estimates the number of elements of one model for many choices of target sizes. Everything that does not depend on
/// sizes is computed once, in time nearly linear in the cells of the mesh. Each estimate then takes seconds at most,
/// whatever the number of elements.
class ElementEstimator {
 public:
  /// Preconditions and errors are those of refine_and_improve. `plc` is stored by reference.
  ElementEstimator(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                   const RefineOptions& options);
  ElementEstimator(ElementEstimator&&) noexcept;
  ElementEstimator& operator=(ElementEstimator&&) noexcept;
  ~ElementEstimator();

  /// Returns the estimated number of elements, within 30 % of the number after meshing. `options` are those of the
  /// constructor, except for sizes and tolerances.
  double total(const RefineOptions& options) const;
  /// Returns whether the estimated number of elements is above `limit`; faster than total() if the number is far above.
  bool is_above(double limit, const RefineOptions& options) const;
  /// Returns how many elements each cause requires. The first `n_thin` entries of SizeOptions::sources are those of
  /// thin units. `known_total` is total(options), if the caller has already computed it.
  ElementEstimate by_cause(const RefineOptions& options, std::size_t n_thin = 0,
                           std::optional<double> known_total = std::nullopt) const;

 private:
  double count(const RefineOptions& options, double enough) const;
  struct Basis;
  std::unique_ptr<Basis> basis_;
};

}  // namespace geomesh
