// SPDX-License-Identifier: MIT
/// @file
/// Keeps triangulations of plane patches that are long needles, without an edge of the mesh for each crossing of two
/// patches' needles. Each convex part of a patch is meshed as a Delaunay triangulation with points inside it
/// (roof.hpp). On each side, these points are then lifted off the plane a little: cells stay positive, because their
/// volumes depend on the points continuously. The space under this roof sees one point, which is joined with the roof
/// and with the given triangles. So a part takes a number of cells linear in its triangles, where flips would take as
/// many as needles cross.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"

namespace geomesh {

/// A convex part with its roof, which both turn one way.
struct RoofedPart {
  std::vector<Index> facets;        ///< of the complex given
  std::vector<Triangle> as_given;   ///< their corners
  std::vector<Triangle> triangles;  ///< these, turned
  std::vector<bool> is_turned;      ///< which of them run the other way in the complex
  std::vector<VertexIndex> inner;   ///< the roof's points, ascending
  std::vector<double> rise;         ///< of these points, by which they are lifted, up to a common factor
  std::vector<Triangle> roof;
};

class RoofedParts {
 public:
  /// Keeps a reference to `plc`, a valid complex. Nothing if its plane patches together are near to Delaunay
  /// (coplanar_patches.hpp), or if no part of them takes fewer points on both sides than it has inner edges.
  /// `provenance`: by facet. O(n log n).
  static std::optional<RoofedParts> of(const PiecewiseLinearComplex& plc, std::span<const Index> provenance);

  /// The complex given, with roofs that are not lifted yet in place of parts. Their points are its last ones.
  const PiecewiseLinearComplex& plc() const { return plc_; }

  /// Makes a mesh of plc() that has no added points on facets one of the complex given. False if a roof cannot be
  /// lifted in doubles; the mesh is of no use then.
  bool fill(ConstrainedTetrahedralization& mesh) const;

 private:
  explicit RoofedParts(const PiecewiseLinearComplex& given) : given_(given), plc_(given) {}
  void find_parts(std::span<const Index> provenance);
  void write_facets();

  const PiecewiseLinearComplex& given_;
  PiecewiseLinearComplex plc_;
  std::vector<RoofedPart> parts_;
  std::vector<Index> facet_;  ///< by facet of plc_: the given one, or of a roof the number of given ones and the part
};

}  // namespace geomesh
