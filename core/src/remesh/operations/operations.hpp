// SPDX-License-Identifier: MIT
/// @file
/// The local operations of refinement: split, collapse, insertion. Each checks everything first and changes nothing
/// where it refuses.
#pragma once

#include <optional>
#include <span>

#include "geomesh/core/refine.hpp"
#include "remesh/tolerance/surface_guard.hpp"

namespace geomesh::remesh {

/// The objects that operations work with.
struct Toolbox {
  DomainMesh& mesh;
  const SurfaceGuard& guard;
  const SizeField& size;
  RefineStatistics& statistics;
  Workspace work;
  std::vector<double> vertex_size;  ///< target size by vertex, negative if not evaluated yet
  /// The nearest item of its patch, by vertex and place. Kept because it is needed again and again.
  struct NearestFacet {
    Vec3 place;
    Index patch = no_index, facet = no_index;
  };
  std::vector<NearestFacet> nearest_facet;
  /// Whether the worst shape may be raised at the price of more bad cells: only where kept surfaces impose bad cells
  /// all over.
  bool bad_cells_may_spread = false;
  bool borders_stay = false;  ///< whether curves and faces of no facet get no points
  bool points_in_thin_gaps =
      false;                   ///< whether improvement may put points there, where they mostly make more flat elements
  BlockEdit* block = nullptr;  ///< the block that operations keep to, where they are done beside others
  MeshBlocks::Rules block_rules;

  Toolbox(DomainMesh& m, const SurfaceGuard& g, const SizeField& s, RefineStatistics& st)
      : mesh(m), guard(g), size(s), statistics(st) {}
  /// Target size at a vertex: at its place, of the component of a cell there. Cached; forget_size clears it.
  double size_at(VertexIndex v) {
    if (v >= vertex_size.size() || vertex_size[v] < 0) [[unlikely]]
      ask_size(v);
    return vertex_size[v];
  }
  /// Evaluates the sizes of all vertices that are not known, on all cores. Afterwards size_at changes nothing.
  void know_sizes(unsigned threads);
  /// Sets a size that was evaluated already, at the place of the vertex.
  void set_size(VertexIndex v, double size);
  void forget_size(VertexIndex v) {
    if (v < vertex_size.size()) vertex_size[v] = -1;
  }
  double size_of_edge(VertexIndex a, VertexIndex b) { return 0.5 * (size_at(a) + size_at(b)); }
  /// Normal of the envelope at a vertex on a surface. May be called for several vertices concurrently, once there is
  /// room for all.
  Vec3 normal_at(VertexIndex v);
  void make_room_for_normals() {
    if (nearest_facet.size() < mesh.n_vertices()) nearest_facet.resize(mesh.n_vertices() + mesh.n_vertices() / 8);
  }
  /// Exchanges the cells for work.added, which makes work.created. False where the block does not allow it.
  bool exchange(std::span<const CellIndex> removed) {
    if (!block) {
      mesh.replace(removed, work.added, work.created);
      return true;
    }
    if (!block->may_exchange(mesh, removed, work.added.size())) return false;
    mesh.replace(removed, work.added, work.created, *block);
    return true;
  }
  /// DomainMesh::tick, of the block where there is one.
  std::uint64_t tick() { return block ? block->clock++ : mesh.tick(); }
  /// Returns whether all of the cells belong to the block, if there is one. (Others may change concurrently: do not
  /// look at their neighbours.)
  bool may_touch(std::span<const CellIndex> cells) { return !block || block->owns(mesh, cells); }
  /// Returns whether a star of p in the cavity would have more bad cells than are removed, which is not allowed.
  bool spoils(const StarCavity& cavity, const Vec3& p) const {
    return !bad_cells_may_spread && adds_bad_cells(mesh, cavity, p);
  }
  bool spoils(const StarCavity& cavity, std::span<const double> shapes) const {
    return !bad_cells_may_spread && adds_bad_cells(mesh, cavity, shapes);
  }
  /// Returns whether the edge of the cavity must get no points.
  bool stays(const StarCavity& cavity, Index curve) const {
    if (!borders_stay) return false;
    return curve != no_index || (!cavity.spokes.empty() && mesh.patch_of_facet(cavity.spokes[0].facet) == hull_patch);
  }
  /// Mean of the sizes at its vertices.
  double size_of_cell(CellIndex c) {
    double sum = 0;
    for (const VertexIndex v : mesh.vertices(c)) sum += size_at(v);
    return sum / 4;
  }

 private:
  void ask_size(VertexIndex v);
};

/// Splits the edge (a, b) of cell c at its midpoint, or at `place` (of its curve or patch) where given. The new vertex
/// lies on the edge's curve or patch. Returns it, or nothing where a new cell would not be positive or the worst new
/// shape not above `min_shape`.
std::optional<VertexIndex> split_edge(Toolbox& tools, CellIndex c, VertexIndex a, VertexIndex b, double min_shape = 0,
                                      const Vec3* place = nullptr);

enum class CollapseRule {
  improve,   ///< the worst shape about u must rise
  coarsen,   ///< it must not fall below the lesser of what it was and `floor`, and no new edge may be longer than 1.4
             ///< times its size
  thin_out,  ///< as coarsen, and where bad cells may not spread there are no more of them than before
};

/// Moves u into its neighbour v where u is no corner and the edge lies on u's curve or patch. Surfaces and curves keep
/// their topology (Dey et al. 1999: link conditions) and stay within the tolerance. Each new cell is positive.
bool try_collapse(Toolbox& tools, VertexIndex u, VertexIndex v, CollapseRule rule, double floor = 0.05);
/// Into the first of its neighbours that takes it. The cells about u are gathered once, where try_collapse for each
/// neighbour takes the square of their number.
bool try_collapse_into_any(Toolbox& tools, VertexIndex u, std::span<const VertexIndex> neighbours, CollapseRule rule,
                           double floor);

/// Moves u away from its neighbour v, within its patch or along its curve, until they are `length` apart. The worst
/// shape at u does not fall below the lesser of its former value and `floor`. No other edge at u becomes short, and
/// surfaces remain within the tolerance. Each cell remains positive. Kept surfaces are not changed.
bool try_stretch(Toolbox& tools, VertexIndex u, VertexIndex v, double length, double floor);

/// Centre of the sphere through the corners, and its radius. Far away where they are nearly coplanar.
struct Sphere {
  Vec3 centre;
  double radius;
};

struct InsertionRule {
  double spacing = 0;                         ///< no vertex of the cavity nearer than this
  double min_shape = 0;                       ///< the worst new shape must be above this
  const PodArray<Sphere>* spheres = nullptr;  ///< those of all live cells, where the caller keeps them
};

/// The cell that p is in, by a walk from `start`; nothing where a constrained face is in the way, or the walk does not
/// end soon.
std::optional<CellIndex> locate(const DomainMesh& mesh, const Vec3& p, CellIndex start);

/// Inserts p, in the same component as `start` and visible along a walk from it that crosses no constrained face, by a
/// constrained Delaunay cavity (Bowyer 1981, Watson 1981; the cavity stops at constrained faces and is shrunk until p
/// sees all of its border).
std::optional<VertexIndex> insert_inside(Toolbox& tools, const Vec3& p, CellIndex start, const InsertionRule& rule);
/// Inserts p into the cell that contains it, which is known (locate).
std::optional<VertexIndex> insert_in_cell(Toolbox& tools, const Vec3& p, CellIndex home, const InsertionRule& rule);

/// Inserts p, moved to the patch of the face `start`. One cavity is on the surface (faces of the patch whose
/// circumcircle contains p), one in the cells on both sides. The full spacing is required from the surface's vertices,
/// three tenths of it from others.
std::optional<VertexIndex> insert_on_surface(Toolbox& tools, const Vec3& p, FaceRef start, const InsertionRule& rule);

/// Replaces the cavity of the edge by the star of a new vertex at p, which lies on the edge's curve or patch.
VertexIndex fill_from_edge(Toolbox& tools, const StarCavity& cavity, VertexIndex a, VertexIndex b, const Vec3& p);

/// Faces and curve pieces at a cavity with the apex at p, for the envelope.
SurfacePart surface_of(const DomainMesh& mesh, const StarCavity& cavity, const Vec3& p);
/// Faces that go where the cavity of the edge is filled from a point of it, each once.
std::vector<SurfaceFace> faces_at_edge(const DomainMesh& mesh, const StarCavity& cavity, VertexIndex a, VertexIndex b);

Sphere circumsphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
Sphere circumsphere(const DomainMesh& mesh, CellIndex c);
/// Centre of the circle through its corners, from the first. Not finite where it has no area.
Vec3 offset_of_circumcentre(const DomainMesh& mesh, const Triangle& t);

}  // namespace geomesh::remesh
