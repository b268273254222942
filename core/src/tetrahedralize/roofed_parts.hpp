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

/// A convex part of a plane patch and its roof, which have the same orientation.
struct RoofedPart {
  std::vector<Index> facets;        ///< facets of the given complex
  std::vector<Triangle> as_given;   ///< corners of these facets in the complex
  std::vector<Triangle> triangles;  ///< corners in the orientation of the part
  std::vector<bool> is_turned;      ///< whether each facet has the opposite orientation in the complex
  std::vector<VertexIndex> inner;   ///< the roof's points, ascending
  std::vector<double> rise;         ///< by how much each of these points is lifted, up to a common factor
  std::vector<Triangle> roof;
};

class RoofedParts {
 public:
  /// Keeps a reference to `plc`, a valid complex. Returns nothing if its plane patches together are nearly Delaunay
  /// (coplanar_patches.hpp), or if no part of them takes fewer points on both sides than it has inner edges.
  /// `provenance` has an entry per facet. O(n log n).
  static std::optional<RoofedParts> of(const PiecewiseLinearComplex& plc, std::span<const Index> provenance);

  /// Returns the given complex in which roofs replace the parts; the roofs are not lifted yet. Their points come last.
  const PiecewiseLinearComplex& plc() const { return plc_; }

  /// Converts a mesh of plc() that has no added points on facets to one of the given complex. Returns false if a roof
  /// cannot be lifted in doubles; the mesh is then invalid.
  bool fill(ConstrainedTetrahedralization& mesh) const;

 private:
  explicit RoofedParts(const PiecewiseLinearComplex& given) : given_(given), plc_(given) {}
  void find_parts(std::span<const Index> provenance);
  void write_facets();

  const PiecewiseLinearComplex& given_;
  PiecewiseLinearComplex plc_;
  std::vector<RoofedPart> parts_;
  /// The given facet of each facet of plc_. For a facet of a roof, the number of given facets plus that of the part.
  std::vector<Index> facet_;
};

}  // namespace geomesh
