// SPDX-License-Identifier: MIT
/// @file
/// The model as it is meshed: in canonical form, with coplanar triangles merged into polygons if their own
/// triangulation would be expensive to keep (plc/coplanar_facets.hpp). Results are translated back.
#pragma once

#include <optional>

#include "plc/coplanar_facets.hpp"
#include "tetrahedralize/canonical_form.hpp"

namespace geomesh {

class ModelForm {
 public:
  /// Keeps a reference to `plc`. Precondition: validate_plc finds no fault. O(n log n).
  ModelForm(const PiecewiseLinearComplex& plc, const RecoverOptions& options, const RunContext& context);

  const PiecewiseLinearComplex& plc() const { return form_.plc; }
  /// Returns the caller's rows of the items; a merged facet has the row of its first triangle.
  const ModelNames& names() const { return merged_ ? names_ : form_.names; }

  /// Converts a mesh of plc() to a mesh of the caller's model. Each face of a merged facet is assigned to the triangle
  /// that contains its centroid (rounded to doubles).
  ConstrainedTetrahedralization in_callers_terms(ConstrainedTetrahedralization mesh) const;

 private:
  void merge(const RunContext& context);

  const PiecewiseLinearComplex& given_;
  CanonicalForm form_;  ///< canonical form of the model, with coplanar facets merged where that was worthwhile
  std::optional<CanonicalForm> before_merging_;
  std::optional<MergedFacets> merged_;  ///< of before_merging_
  ModelNames names_;
};

}  // namespace geomesh
