// SPDX-License-Identifier: MIT
/// @file
/// The local operations of refinement: split, contraction and insertion. Each checks all conditions first, and changes
/// nothing if it is refused.
#pragma once

#include <optional>
#include <span>

#include "geomesh/core/refine.hpp"
#include "remesh/lengths/relative_lengths.hpp"
#include "remesh/tolerance/surface_guard.hpp"

namespace geomesh::remesh {

/// The mesh and the other objects with which local operations work.
struct Toolbox {
  DomainMesh& mesh;
  const SurfaceGuard& guard;
  RefineStatistics& statistics;
  Workspace work;
  RelativeLengths lengths;
  /// For a vertex on a surface, the nearest facet of its patch, stored with the position for which it was found.
  struct NearestFacet {
    Vec3 place;
    Index patch = no_index, facet = no_index;
  };
  std::vector<NearestFacet> nearest_facet;
  /// Whether raising the worst shape may create more bad cells; true only if kept surfaces impose bad cells everywhere.
  bool bad_cells_may_spread = false;
  bool borders_stay = false;  ///< whether no points are added on curves and on faces that are part of no facet
  /// Whether improvement may add points in thin gaps, where they mostly make more flat elements.
  bool points_in_thin_gaps = false;
  BlockEdit* block = nullptr;  ///< the block within which operations must stay if other blocks are changed concurrently
  MeshBlocks::Rules block_rules;

  Toolbox(DomainMesh& m, const SurfaceGuard& g, const SizeField& s, RefineStatistics& st)
      : mesh(m), guard(g), statistics(st), lengths(m, s) {}
  /// Returns the normal of the input surface at a vertex on a surface. May be called for several vertices concurrently,
  /// after make_room_for_normals().
  Vec3 normal_at(VertexIndex v);
  void make_room_for_normals() {
    if (nearest_facet.size() < mesh.n_vertices()) nearest_facet.resize(mesh.n_vertices() + mesh.n_vertices() / 8);
  }
  /// Replaces the cells `removed` by those in work.added, and lists the new cells in work.created. Returns false if the
  /// block of cells that this thread may change does not permit it.
  bool exchange(std::span<const CellIndex> removed) {
    if (!block) {
      mesh.replace(removed, work.added, work.created);
      return true;
    }
    if (!block->may_exchange(mesh, removed, work.added.size())) return false;
    mesh.replace(removed, work.added, work.created, *block);
    return true;
  }
  /// Advances the modification time of the block, or of the mesh if there is no block. Returns the former value.
  std::uint64_t tick() { return block ? block->clock++ : mesh.tick(); }
  /// Returns whether all cells belong to the current block, or there is no block. Other threads may change cells of
  /// other blocks, so the neighbours of those must not be read.
  bool may_touch(std::span<const CellIndex> cells) { return !block || block->owns(mesh, cells); }
  /// Returns whether filling the cavity from p would increase the number of bad cells although this is not permitted.
  bool spoils(const StarCavity& cavity, const Vec3& p) const {
    return !bad_cells_may_spread && adds_bad_cells(mesh, cavity, p);
  }
  bool spoils(const StarCavity& cavity, std::span<const double> shapes) const {
    return !bad_cells_may_spread && adds_bad_cells(mesh, cavity, shapes);
  }
  /// Returns whether no point may be added on the edge whose cavity this is, because it lies on a border that is kept.
  bool stays(const StarCavity& cavity, Index curve) const {
    if (!borders_stay) return false;
    return curve != no_index || (!cavity.spokes.empty() && mesh.patch_of_facet(cavity.spokes[0].facet) == hull_patch);
  }
};

/// Splits the edge (a, b) of cell c at its midpoint, or at `place`, a point of its curve or patch. The new vertex lies
/// on the edge's curve or patch. Returns the new vertex, or nothing if a new cell would not be positive or the worst
/// new shape would not be above `min_shape`.
std::optional<VertexIndex> split_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double min_shape = 0,
                                      const Vec3* place = nullptr);

enum class CollapseRule {
  improve,  ///< the worst shape around the removed vertex must rise
  /// The worst shape must not fall below both its former value and `floor`, nor new edges exceed 1.4 times their size.
  coarsen,
  thin_out,  ///< as for `coarsen`, and no more bad cells than before the contraction, unless bad_cells_may_spread
};

/// Contracts the edge u-v by moving u to v, if u is no corner and the edge lies on the curve or patch of u. The
/// topology of surfaces and curves is preserved (link conditions: Dey et al. 1999), surfaces remain within the
/// tolerance, and each new cell is positive.
bool try_collapse(Toolbox& tools, VertexIndex u, VertexIndex v, CollapseRule rule, double floor = 0.05);
/// Contracts an edge to the first of u's neighbours for which this is possible. The cells around u are gathered only
/// once, whereas try_collapse for each neighbour takes time proportional to the square of the number of cells.
bool try_collapse_into_any(Toolbox& tools, VertexIndex u, std::span<const VertexIndex> neighbours, CollapseRule rule,
                           double floor);

/// Moves u away from its neighbour v, within its patch or along its curve, until they are `length` apart. The worst
/// shape at u does not fall below the lesser of its former value and `floor`. No other edge at u becomes short, and
/// surfaces remain within the tolerance. Each cell remains positive. Kept surfaces are not changed.
bool try_stretch(Toolbox& tools, VertexIndex u, VertexIndex v, double length, double floor);

/// A circumscribed sphere: centre and radius. The centre is very far away if the vertices are nearly coplanar.
struct Sphere {
  Vec3 centre;
  double radius;
};

struct InsertionRule {
  LocalLength spacing{};  ///< no vertex of the cavity may be nearer to the new point than this length
  double min_shape = 0;   ///< the worst shape of the new cells must be above this limit
};

/// Inserts p by a constrained Delaunay cavity (Bowyer 1981, Watson 1981), which ends at constrained faces and is
/// reduced until p sees its whole border. The point must be in the component of `start`, and the walk from `start` to
/// the point must cross no constrained face.
std::optional<VertexIndex> insert_inside(Toolbox& tools, const Vec3& p, CellIndex start, const InsertionRule& rule);

/// Inserts p after projecting it to the patch of the face `start`. There are two cavities: one on the surface (faces of
/// the patch whose circumcircle contains p), and one in the cells on both sides. The full spacing is required from
/// vertices of the surface, three tenths of it from other vertices.
std::optional<VertexIndex> insert_on_surface(Toolbox& tools, const Vec3& p, FaceRef start, const InsertionRule& rule);

/// Replaces the cells at the edge a-b by the star of a new vertex at p, which lies on the curve or patch of the edge.
VertexIndex fill_from_edge(Toolbox& tools, const StarCavity& cavity, VertexIndex a, VertexIndex b, const Vec3& p);

/// Returns the constrained faces and curve edges of the star that fills the cavity from p, for checks by the envelope.
SurfacePart surface_of(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p);
/// Returns the constrained faces at the edge a-b, each once. They disappear if the edge is split.
std::vector<SurfaceFace> faces_at_edge(const DomainMesh& mesh, const StarCavity& cavity, VertexIndex a, VertexIndex b);

Sphere circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
Sphere circumsphere(const DomainMesh& mesh, CellIndex c);
/// Returns the circumcentre of a triangle relative to its first corner. Not finite if the triangle has no area.
Vec3 offset_of_circumcentre(const DomainMesh& mesh, const Triangle& t);

}  // namespace geomesh::remesh
