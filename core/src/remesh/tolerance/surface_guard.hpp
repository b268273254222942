// SPDX-License-Identifier: MIT
/// @file
/// Keeps surfaces and curves within the tolerance (the envelope) while they are remeshed.
///
/// `exact`: a patch is one facet, or several in its plane. So a vertex within a patch moves in that plane, a curve is
/// one input edge, and no face can leave its plane except by rounding. A strip a few roundings wide has no reliable
/// plane in doubles, so a place must be on the removed faces as well.
///
/// `tolerance`: every point of a new face is proven to be within 0.8 of the tolerance of the ORIGINAL triangles of its
/// patch (search/proven_distance.hpp); otherwise the change is refused. Within a flat patch it covers what the removed
/// faces did (flat_patches.hpp). In the other direction nothing is required if
/// the original is a smooth sheet around the change. Elsewhere samples of the original patch near the removed faces
/// must be within 0.7 of the tolerance of the new ones or their neighbours. They are at most eight tolerances apart if
/// a triangle is not longer than a hundred. Curves are kept within 0.7 of it at samples both ways. Deviations do not
/// add up over operations. No new face may be turned by 78 degrees or more from the original where it is nearest, which
/// is close to a fold: nothing else prevents folds on a side where nothing is meshed. The whole result is proven in the
/// end (verify_surfaces.hpp).
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "geomesh/core/refine.hpp"
#include "remesh/tolerance/cavity.hpp"
#include "remesh/tolerance/flat_patches.hpp"
#include "remesh/tolerance/local_tolerance.hpp"
#include "remesh/tolerance/verify_surfaces.hpp"
#include "search/proven_distance.hpp"

namespace geomesh::remesh {

/// How surfaces are kept within the tolerance.
struct Hold {
  double margin = 0.7;  ///< of the tolerance, for samples: so that the proof that follows seldom fails and seldom has
                        ///< to look closely
  std::vector<TightZone> zones;  ///< what is in them is held to less
  unsigned run = 0;              ///< from 0: runs before this one held surfaces less closely
};

class SurfaceGuard {
 public:
  SurfaceGuard() = default;
  /// References are the faces of `given` and the curves of `mesh`, as they are now: the same surfaces, in `mesh`
  /// perhaps with more points and without the edges between coplanar pieces. Planes are those of the facets.
  SurfaceGuard(const DomainMesh& given, const DomainMesh& mesh, const PiecewiseLinearComplex& plc, Honour honour,
               LocalTolerance tolerance, const Hold& hold = {});

  bool exact() const { return honour_ == Honour::exact; }
  /// A distance that rounding alone makes.
  double rounding() const { return rounding_; }

  /// Direction in which a vertex on a patch may not move: normal of the reference near p.
  Vec3 normal(Index patch, const Vec3& p) const;
  /// Whether the patch's original lies in one plane. Not for exact.
  bool is_flat(Index patch) const { return flat_.is_flat(patch); }
  /// Normal by the nearest item: nearest_facet, in exact the patch.
  Vec3 normal_of(Index row) const;
  /// p brought back to the patch (exact: to the facet's plane; without rounding where that is normal to an axis).
  Vec3 project_to_patch(Index patch, const Vec3& p) const;
  /// p brought back to the curve. Not for exact, where curve vertices do not move.
  Vec3 project_to_curve(Index curve, const Vec3& p) const;
  /// Facet of the patch nearest to a place: provenance of a remade face. Not for exact.
  Index nearest_facet(Index patch, const Vec3& p) const;

  /// Must not be called by several threads at once. Returns whether faces and curve pieces may be exchanged. `around`
  /// are kept faces that share a vertex with removed ones. Exact: whether new corners are on the removed faces up to
  /// rounding, and no face folds onto others in its plane.
  bool admits(const SurfacePart& before, const SurfacePart& after, const std::vector<SurfaceFace>& around = {}) const;

  /// Returns whether no new face is reversed in its plane. Only for exact. Corners are off an inclined plane by
  /// rounding, so elements with all corners on it may be positive, and do not show a fold.
  bool keeps_sides(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const;

  /// Whether all of a face is proven to be within the tolerance of the reference.
  bool is_proven_near_reference(const SurfaceFace& f) const;

  /// Returns the distances of the mesh's faces and curves from the references, and in the other direction, proven where
  /// not listed (exact: of corners from their planes, for both). `before` is of the same envelope.
  Deviations deviations(const DomainMesh& mesh, unsigned threads, VerifiedSurfaces* before = nullptr) const;

 private:
  struct Plane {
    Vec3 normal;  ///< of length one
    Vec3 point;
    std::uint8_t axis = 3;  ///< the coordinate that is the same for all its points, 3: none
  };
  /// The least share of the tolerance that holds somewhere about these points.
  double share_about(std::span<const Vec3> points) const;
  /// Returns whether each new face is turned from the reference by no more than the removed ones, or not by much.
  /// `over`: by new face, the result of is_proven_within; `curves_stay`: removed and new faces have the same border.
  bool keeps_direction(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after,
                       const std::vector<Index>& over, bool curves_stay) const;
  /// Whether the patch's faces are all over sheets of the reference (`over`) and turned to the same side.
  bool are_turned_alike(Index patch, const std::vector<SurfaceFace>& faces, const std::vector<Index>& over) const;
  /// Cosine between the face's normal and the reference's nearest to its middle; 1 for a face without area.
  double direction_cosine(const SurfaceFace& f) const;
  void find_planes(const DomainMesh& mesh, const PiecewiseLinearComplex& plc);
  /// `over`: a facet that is over the face, where the reference is a sheet over all of it; else no_index.
  bool is_proven_within(const SurfaceFace& f, double limit, Index& over) const;
  bool reference_near(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after,
                      const std::vector<SurfaceFace>& around) const;
  /// Whether the reference in the box is nearly the graph of a function over a plane. Let faces have the same border
  /// as those before and be near to it. They cover it, seen along the plane's normal, since their border winds about
  /// each of its points once; so it is as near to them, but for its slope.
  bool is_even_about(const Box3& box, Index patch) const;
  bool samples_near(Index patch, const Box3& box, const std::vector<SurfaceFace>& before,
                    const std::vector<SurfaceFace>& after, const std::vector<SurfaceFace>& around) const;
  bool curves_near(const std::vector<CurvePiece>& before, const std::vector<CurvePiece>& after) const;

  /// Returns whether each new corner is within rounding of a removed face.
  bool corners_on(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const;

  Honour honour_ = Honour::exact;
  double rounding_ = 0;   // a distance that rounding alone makes
  double tolerance_ = 0;  // what samples are held to, outside of zones
  std::vector<TightZone> zones_;
  search::ClosestPointTrees zone_boxes_;  // as line pieces from corner to corner
  struct Proving {
    search::DistanceProver prover;
    std::vector<search::SheetTriangle> nearby;
    std::vector<Index> rows;      // of nearby, in given_.faces
    search::RecentPlaces recent;  // of allowed_
  };
  mutable tbb::enumerable_thread_specific<Proving> proving_{
      Proving{search::DistanceProver(0), {}, {}, search::RecentPlaces(1)}};  // scratch
  LocalTolerance allowed_;                                                   // what is promised
  double reach_ = 0;            // the greatest of it: what is farther away has no say
  std::vector<Plane> planes_;   // by patch in exact mode, else by facet
  std::vector<bool> oriented_;  // by patch: whether its faces in the reference are oriented alike
  SurfaceItems given_;
  FlatPatches flat_;  // of it
};

/// Deterministic samples of a triangle: corners, mid-edges, centroid and six points between.
std::array<Vec3, 13> triangle_samples(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace geomesh::remesh
