// SPDX-License-Identifier: MIT
/// @file
/// Preserves plane patches that are triangulated with long needles, without a mesh edge for each crossing between
/// needles of two patches. Each convex part of a patch is meshed as a Delaunay triangulation with points inside it
/// (roof.hpp). On each side, these points are then lifted off the plane a little: cells stay positive, because their
/// volumes depend on the points continuously. All faces of the space under this roof are visible from one point, which
/// is connected with the roof and with the given triangles. A part therefore needs a number of cells linear in its
/// triangles, instead of as many as there are crossings of needles.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh {

/// A convex part of a plane patch, and a Delaunay triangulation of it with inner points (its roof, later lifted off).
struct RoofedPart {
  std::vector<Index> facets;        ///< rows, in the given complex, of the facets that make up the part of the patch
  std::vector<Triangle> as_given;   ///< corners of the part's facets, in the orientation of the complex
  std::vector<Triangle> triangles;  ///< corners of the part's facets, all with the same orientation
  std::vector<bool> is_turned;      ///< whether each facet of the part is oriented oppositely in the complex
  std::vector<VertexIndex> inner;   ///< points that the triangulation adds inside the part, ascending
  std::vector<double> rise;         ///< relative heights by which the points inside the part are lifted off its plane
  std::vector<Triangle> roof;
};

class RoofedParts {
 public:
  /// Chooses convex parts of plane patches that get roofs: triangulations with inner points, lifted off on both sides.
  /// Returns nothing if the patches are nearly Delaunay, or if no part's roofs need fewer points than the part has
  /// inner edges. Keeps a reference to `plc`, a valid complex. `provenance` has an entry per facet. O(n log n).
  static std::optional<RoofedParts> of(const PiecewiseLinearComplex& plc, std::span<const Index> provenance);

  /// Returns the given complex with each part's triangles replaced by those of its roof, still in the plane.
  const PiecewiseLinearComplex& plc() const { return plc_; }

  /// Converts a mesh of plc() that has no added points on facets to one of the given complex: lifts each roof off its
  /// plane and fills the space between. Returns false if that is impossible in doubles; the mesh is then invalid.
  bool fill(ConstrainedTetrahedralization& mesh) const;

 private:
  explicit RoofedParts(const PiecewiseLinearComplex& given) : given_(given), plc_(given) {}
  void find_parts(std::span<const Index> provenance);
  void write_facets();

  const PiecewiseLinearComplex& given_;
  PiecewiseLinearComplex plc_;
  std::vector<RoofedPart> parts_;
  /// For each facet of plc_, its row among the given facets; for one of the roof of part k, n_given_facets + k.
  std::vector<Index> facet_;
};

}  // namespace geomesh
