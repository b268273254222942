// SPDX-License-Identifier: MIT
/// @file
/// Keeps surfaces and curves within the tolerance (the envelope) while they are remeshed.
///
/// `exact`: a patch is one facet, or several in one plane. A vertex within a patch therefore moves in this plane, a
/// curve is one input edge, and no face can leave its plane except by rounding. In a strip of triangles that is a few
/// roundings wide, the plane is not reliable in doubles, so new vertices must be on the removed faces as well.
///
/// `tolerance`: every point of a new face is proven to be within 0.8 of the tolerance of the ORIGINAL surface of its
/// patch (search/reference_surfaces.hpp); otherwise the change is refused. Within a flat patch, a change is admitted
/// without this proof if the new faces cover the same area as the removed ones (flat_patches.hpp). In the other
/// direction, nothing is required if the original is a single smooth layer around the change. Elsewhere, samples of the
/// original patch near the removed faces must be within 0.7 of the tolerance of the new faces or their neighbours.
/// Samples are at most eight tolerances apart on a triangle of up to a hundred tolerances. Curves are kept within 0.7
/// of the tolerance, at samples in both directions. Deviations do not add up over operations. No new face may be turned
/// by 78 degrees or more from the nearest part of the original, which is close to a fold: nothing else prevents folds
/// on a side where nothing is meshed. The whole result is proven in the end (verify_surfaces.hpp).
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "geomesh/core/refine.hpp"
#include "remesh/tolerance/cavity.hpp"
#include "remesh/tolerance/flat_patches.hpp"
#include "remesh/tolerance/local_tolerance.hpp"
#include "remesh/tolerance/verify_surfaces.hpp"
#include "search/recent_places.hpp"

namespace geomesh::remesh {

/// How surfaces are kept within the tolerance.
struct Hold {
  /// Share of the tolerance that samples may use, so that the final proof seldom fails or has to subdivide faces.
  double margin = 0.7;
  std::vector<TightZone> zones;  ///< zones in which a smaller tolerance applies
  unsigned run = 0;              ///< number of this run of refinement, from 0; earlier runs had larger tolerances
  /// Reference surfaces, by patch; null: the triangles of the input. Reference curves are always those of the input.
  std::shared_ptr<const search::ReferenceSurfaces> surfaces = nullptr;
};

class SurfaceGuard {
 public:
  SurfaceGuard() = default;
  /// Distances are measured from the surfaces in `hold` (if null, from the faces of `given`) and from the curves that
  /// `mesh` has at construction. `given` and `mesh` have the same surfaces, but `mesh` may have more points, and lacks
  /// the edges between coplanar pieces of a facet. The planes of patches are those of the facets of `plc`.
  SurfaceGuard(const DomainMesh& given, const DomainMesh& mesh, const PiecewiseLinearComplex& plc, Honour honour,
               LocalTolerance tolerance, const Hold& hold = {});

  bool exact() const { return honour_ == Honour::exact; }
  /// Returns a distance that may be caused by rounding alone.
  double rounding() const { return rounding_; }

  /// Returns the direction in which a vertex on a patch may not move: the normal of the reference surface near p.
  Vec3 normal(Index patch, const Vec3& p) const;
  /// Returns whether the original of the patch lies in one plane. Not for exact mode.
  bool is_flat(Index patch) const { return flat_.is_flat(patch); }
  /// Returns the normal of the reference surface at p; `facet` is the facet of that surface nearest to p.
  Vec3 normal_of(Index facet, const Vec3& p) const { return given_->normal(facet, p); }
  /// Projects p to the patch; in exact mode to the facet's plane, without rounding if this is normal to an axis.
  Vec3 project_to_patch(Index patch, const Vec3& p) const;
  /// Projects p to the curve. Not for exact mode, in which vertices on curves do not move.
  Vec3 project_to_curve(Index curve, const Vec3& p) const;
  /// Returns the facet of the patch nearest to a place, which becomes the provenance of a new face. Not for exact mode.
  Index nearest_facet(Index patch, const Vec3& p) const;

  /// Returns whether the faces and curve pieces `before` may be replaced by `after`. `around` are kept faces that share
  /// a vertex with removed ones. In exact mode: whether new corners are on the removed faces up to rounding, and no
  /// face folds onto others in its plane.
  bool admits(const SurfacePart& before, const SurfacePart& after, const std::vector<SurfaceFace>& around = {}) const;

  /// Returns whether no new face is reversed in its plane. Only for exact mode. Rounding moves corners off an inclined
  /// plane, so cells with all corners on the plane may be positive and do not reveal a fold.
  bool keeps_sides(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const;

  /// Returns whether the whole face is proven to be within the tolerance of the reference surface.
  bool is_proven_near_reference(const SurfaceFace& f) const;

  /// Returns the largest distances of the faces and curves of the mesh from the references, and in the other direction.
  /// All pieces that are not listed are proven to be within the tolerance. In exact mode the distances are those of
  /// corners from their planes. `before` has the results of an earlier call for the same envelope.
  Deviations deviations(const DomainMesh& mesh, unsigned threads, VerifiedSurfaces* before = nullptr) const;

 private:
  struct Plane {
    Vec3 normal;  ///< of length one
    Vec3 point;
    std::uint8_t axis = 3;  ///< the coordinate that all points of the plane have in common; 3 if there is none
  };
  /// Returns the smallest share of the tolerance that applies near the given points.
  double share_about(std::span<const Vec3> points) const;
  /// Returns whether the angle between each new face and the reference surface is small, or no larger than for removed
  /// faces. `over` has the result of is_proven_within for each new face; `curves_stay` is true if removed and new faces
  /// have the same border.
  bool keeps_direction(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after,
                       const std::vector<Index>& over, bool curves_stay) const;
  /// Returns whether the reference surface is one smooth layer over the patch's faces (`over`), and these are on one
  /// side of it.
  bool are_turned_alike(Index patch, const std::vector<SurfaceFace>& faces, const std::vector<Index>& over) const;
  /// Returns the cosine between the normals of a face and of the nearest reference surface; 1 for a face without area.
  double direction_cosine(const SurfaceFace& f) const;
  void find_planes(const DomainMesh& mesh, const PiecewiseLinearComplex& plc);
  /// Returns whether the whole face is proven to be within the limit (times the local share of the tolerance) of the
  /// reference surface. `over` receives a facet of that surface if it is a single smooth layer over the whole face, and
  /// no_index otherwise.
  bool is_proven_within(const SurfaceFace& f, double limit, Index& over) const;
  /// Returns whether the reference surface near the removed faces is near to the new faces. If it is nearly the graph
  /// of a function over a plane there, and the new faces have the same border as the removed ones and are near to it,
  /// they cover it as seen along the normal of the plane, because their border winds once around each of its points. So
  /// the surface is equally near to the new faces, apart from the effect of its slope, and no samples are needed.
  bool reference_near(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after,
                      const std::vector<SurfaceFace>& around) const;
  bool samples_near(Index patch, const Box3& box, const std::vector<SurfaceFace>& before,
                    const std::vector<SurfaceFace>& after, const std::vector<SurfaceFace>& around) const;
  bool curves_near(const std::vector<CurvePiece>& before, const std::vector<CurvePiece>& after) const;

  /// Returns whether each corner of the new faces is on a removed face, up to rounding.
  bool corners_on(const std::vector<SurfaceFace>& before, const std::vector<SurfaceFace>& after) const;

  Honour honour_ = Honour::exact;
  double rounding_ = 0;   // a distance that may be caused by rounding alone
  double tolerance_ = 0;  // largest permitted distance of a sample of input or result from the other
  std::vector<TightZone> zones_;
  search::ClosestPointTrees zone_boxes_;  // search tree of boxes in which smaller tolerances apply
  mutable tbb::enumerable_thread_specific<search::RecentPlaces> recent_{search::RecentPlaces(1)};  // of allowed_
  LocalTolerance allowed_;                                                                         // what is promised
  double reach_ = 0;            // largest tolerance anywhere
  std::vector<Plane> planes_;   // plane of each patch; in exact mode only
  std::vector<bool> oriented_;  // for each patch, whether its reference faces are consistently oriented
  std::shared_ptr<const search::ReferenceSurfaces> given_;  // the faces
  search::TriangleSurfaces given_curves_;
  FlatPatches flat_;  // planar patches of the reference surface, if it consists of triangles
};

/// Returns deterministic sample points of a triangle: corners, edge midpoints, centroid and six more.
std::array<Vec3, 13> triangle_samples(const Vec3& a, const Vec3& b, const Vec3& c);

}  // namespace geomesh::remesh
