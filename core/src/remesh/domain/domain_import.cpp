// SPDX-License-Identifier: MIT
// Converts the caller's mesh to the mesh that refinement works on. Declared in remesh/domain/domain_io.hpp.
#include <algorithm>
#include <cmath>
#include <map>

#include "common/epoch_marks.hpp"
#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/domain/face_directions.hpp"
#include "remesh/domain/merge_pieces.hpp"

namespace geomesh::remesh {

namespace {

/// A face is narrow if its height is below this share of the tolerance. The normal of a narrow face is unreliable.
constexpr double narrow_share = 0.5;

using Edge = std::array<VertexIndex, 2>;

/// Finds vertices of edges with more than two outer faces, and outer vertices with more cells than a walk across faces
/// reaches. At these vertices the boundary is not a manifold.
std::vector<bool> pinched_vertices(const DomainMesh& mesh) {
  std::vector<bool> pinched(mesh.n_vertices(), false), is_counted = pinched;
  std::vector<std::uint32_t> n_cells(mesh.n_vertices(), 0);
  std::vector<Edge> outer_edges;
  for (CellIndex c = 0; c < mesh.n_slots(); ++c) {
    for (const VertexIndex v : mesh.vertices(c)) ++n_cells[v];
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh.has_neighbor(c, i)) continue;
      const Triangle f = mesh.face(c, i);
      for (unsigned k = 0; k < 3; ++k) outer_edges.push_back(sorted(Edge{f[k], f[(k + 1) % 3]}));
    }
  }
  std::sort(outer_edges.begin(), outer_edges.end());
  EpochMarks marks;
  std::vector<CellIndex> star;
  for (std::size_t i = 0, j; i < outer_edges.size(); i = j) {
    for (j = i; j < outer_edges.size() && outer_edges[j] == outer_edges[i];) ++j;
    for (const VertexIndex v : outer_edges[i]) {
      if (j - i > 2) pinched[v] = true;
      if (is_counted[v]) continue;
      is_counted[v] = true;
      mesh.star(v, marks, star);
      if (star.size() < n_cells[v]) pinched[v] = true;
    }
  }
  return pinched;
}

/// Returns whether the faces at v are connected across edges. If not, two surfaces or a surface and a curve meet.
bool is_one_fan(VertexIndex v, const std::vector<Index>& faces, const std::vector<Triangle>& corners) {
  std::vector<Index> left(faces.begin() + 1, faces.end());
  std::vector<VertexIndex> reached(corners[faces[0]].begin(), corners[faces[0]].end());
  const auto joins = [&](Index f) {
    const Triangle& t = corners[f];
    if (std::none_of(t.begin(), t.end(), [&](VertexIndex x) {
          return x != v && std::find(reached.begin(), reached.end(), x) != reached.end();
        }))
      return false;
    reached.insert(reached.end(), t.begin(), t.end());
    return true;
  };
  while (std::erase_if(left, joins) > 0) continue;
  return left.empty();
}

/// Returns, for each vertex of the mesh, whether it must be kept regardless of the faces and curves around it.
std::vector<bool> pinned_vertices(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input,
                                  const RefineOptions& options) {
  std::vector<bool> pinned_input(plc.points.size(), false), pinned(input.points.size(), false);
  if (options.honour == Honour::exact || !options.fixed_points) {
    for (const auto& p : plc.facet_points) pinned_input[p.v] = true;
  } else {
    for (const VertexIndex v : *options.fixed_points) pinned_input[v] = true;
  }
  for (VertexIndex v = 0; v < pinned.size(); ++v)
    pinned[v] = input.input_vertex[v] != no_vertex && pinned_input[input.input_vertex[v]];
  for (const VertexIndex v : input.isolated_points) pinned[v] = true;
  return pinned;
}

/// Builds the mesh that refinement works on, and the kinds of its vertices, from faces and curves of the caller's mesh.
class Importer {
 public:
  Importer(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input, const RefineOptions& options,
           std::vector<Index> patches)
      : input_(input),
        exact_(options.honour == Honour::exact),
        narrow_(narrow_share * options.tolerance),
        cos_sharp_(std::cos(options.sharp_angle * pi / 180)) {
    domain_.set_measure(options.quality_measure);
    domain_.set_facet_patches(std::move(patches));
    std::map<Index, Index> first;
    for (Index s = 0; s < plc.segments.size(); ++s) {
      const Index curve = exact_ || options.segment_curve.empty() ? no_index : options.segment_curve[s];
      first_of_curve_.push_back(curve == no_index ? s : first.try_emplace(curve, s).first->second);
    }
  }

  DomainMesh make(const std::vector<bool>& pinned) {
    add_cells();
    tag_faces();
    register_curves();
    domain_.set_pinched(pinched_vertices(domain_));
    std::vector<std::vector<Index>> faces_at(domain_.n_vertices());
    for (Index f = 0; f < faces_.size(); ++f)
      for (const VertexIndex v : faces_[f]) faces_at[v].push_back(f);
    for (VertexIndex v = 0; v < domain_.n_vertices(); ++v)
      if (!pinned[v] && !domain_.is_pinched(v)) classify(v, faces_at[v]);
    return std::move(domain_);
  }

 private:
  void add_cells() {
    domain_.reserve(2 * input_.points.size(), 2 * input_.tetrahedra.size());
    // All vertices start as corners, because curve edges are found only between vertices of the kinds corner and curve.
    for (const Vec3& p : input_.points) domain_.add_vertex(p, VertexKind::corner);
    for (std::size_t t = 0; t < input_.tetrahedra.size(); ++t)
      domain_.add_cell(input_.tetrahedra[t], input_.component[t]);
    domain_.link_cells();
  }

  void tag_face(Index tetrahedron, const Triangle& f, FaceTag tag) {
    if (tetrahedron == no_index) return;
    const Tetrahedron& t = domain_.vertices(tetrahedron);
    const auto apex = std::find_if(t.begin(), t.end(), [&](VertexIndex v) { return std::ranges::count(f, v) == 0; });
    domain_.set_tag(tetrahedron, static_cast<unsigned>(apex - t.begin()), tag);
  }

  void tag_faces() {
    for (const auto& f : input_.faces) {
      tag_face(f.tetrahedron_below, f.vertices, FaceTag(f.facet, false));
      tag_face(f.tetrahedron_above, f.vertices, FaceTag(f.facet, true));
      faces_.push_back(f.vertices);
      facets_.push_back(f.facet);
    }
    for (CellIndex c = 0; c < domain_.n_slots(); ++c)
      for (unsigned i = 0; i < 4; ++i) {
        if (domain_.has_neighbor(c, i) || domain_.tag(c, i).constrained()) continue;
        domain_.set_tag(c, i, FaceTag(hull_facet, true));
        faces_.push_back(domain_.face(c, i));
        facets_.push_back(hull_facet);
      }
  }

  std::vector<EdgeUse> edges_of_faces() const {
    std::vector<EdgeUse> uses;
    for (Index f = 0; f < faces_.size(); ++f)
      for (unsigned i = 0; i < 3; ++i) uses.push_back({sorted(Edge{faces_[f][i], faces_[f][(i + 1) % 3]}), f});
    std::sort(uses.begin(), uses.end(),
              [](const EdgeUse& a, const EdgeUse& b) { return a.edge != b.edge ? a.edge < b.edge : a.face < b.face; });
    return uses;
  }

  /// Returns the normal direction of each face. The result is empty if edges are not to be classified by angle.
  std::vector<Vec3> directions(const std::vector<EdgeUse>& uses) const {
    if (exact_) return {};
    std::vector<Index> patches;
    for (const Index f : facets_) patches.push_back(domain_.patch_of_facet(f));
    return face_directions(input_.points, faces_, patches, uses, narrow_);
  }

  /// Returns whether two faces meet at a feature edge; false for faces too narrow to have a reliable normal.
  bool is_sharp(const EdgeUse& a, const EdgeUse& b, const std::vector<Vec3>& directions) const {
    if (exact_) return false;
    const Vec3 &n = directions[a.face], &m = directions[b.face];
    if (n == Vec3{} || m == Vec3{}) return false;
    const bool consistent =
        runs_along(faces_[a.face], a.edge[0], a.edge[1]) != runs_along(faces_[b.face], a.edge[0], a.edge[1]);
    return (consistent ? dot(n, m) : -dot(n, m)) < cos_sharp_;
  }

  void add_curve(const Edge& edge, CurveClass c) {
    const auto [known, is_new] =
        classes_.try_emplace({c.segments, c.patches}, static_cast<Index>(domain_.n_curve_classes()));
    if (is_new) domain_.add_curve_class(std::move(c));
    domain_.set_curve(edge[0], edge[1], known->second);
    for (const VertexIndex v : edge) curve_ends_[v].push_back({edge[0] == v ? edge[1] : edge[0], known->second});
  }

  void register_curves() {
    curve_ends_.resize(domain_.n_vertices());
    std::map<Edge, std::vector<Index>> segments;
    for (const auto& e : input_.edges) segments[sorted(Edge{e.a, e.b})].push_back(e.segment);
    const std::vector<EdgeUse> uses = edges_of_faces();
    const std::vector<Vec3> looks = directions(uses);
    for (std::size_t i = 0, j; i < uses.size(); i = j) {
      for (j = i; j < uses.size() && uses[j].edge == uses[i].edge;) ++j;
      CurveClass c;
      for (std::size_t k = i; k < j; ++k) c.patches.push_back(domain_.patch_of_facet(facets_[uses[k].face]));
      std::sort(c.patches.begin(), c.patches.end());
      if (const auto listed = segments.find(uses[i].edge); listed != segments.end()) {
        for (const Index s : listed->second) c.segments.push_back(first_of_curve_[s]);
        sort_unique(c.segments);
        segments.erase(listed);
      }
      if (!c.segments.empty() || j - i != 2 || c.patches[0] != c.patches[1] || is_sharp(uses[i], uses[i + 1], looks))
        add_curve(uses[i].edge, std::move(c));
    }
    for (auto& [edge, rows] : segments) {  // curves inside regions, which lie on no face
      std::sort(rows.begin(), rows.end());
      add_curve(edge, {rows, {}});
    }
  }

  bool turns_sharply(VertexIndex v) const {
    const Vec3 a = input_.points[curve_ends_[v][0].first] - input_.points[v],
               b = input_.points[curve_ends_[v][1].first] - input_.points[v];
    return -dot(a, b) < cos_sharp_ * length(a) * length(b);
  }

  /// Sets the kind of a vertex. It remains a corner if it is neither inside a curve nor inside a patch.
  void classify(VertexIndex v, const std::vector<Index>& faces) {
    const auto& curves = curve_ends_[v];
    const bool is_given = input_.input_vertex[v] != no_vertex;
    if (exact_ && is_given) return;
    const bool is_alone = faces.empty() || is_one_fan(v, faces, faces_);
    if (curves.size() == 2 && curves[0].second == curves[1].second && is_alone && !turns_sharply(v)) {
      domain_.set_kind(v, VertexKind::curve, curves[0].second);
    } else if (curves.empty() && faces.empty()) {
      if (!is_given) domain_.set_kind(v, VertexKind::inside, no_index);
    } else if (curves.empty()) {
      const Index patch = domain_.patch_of_facet(facets_[faces[0]]);
      if (patch != hull_patch && is_alone) domain_.set_kind(v, VertexKind::surface, patch);
    }
  }

  const ConstrainedTetrahedralization& input_;
  bool exact_;
  double narrow_, cos_sharp_;
  std::vector<Index> first_of_curve_;  // for each segment, the first segment that belongs to the same curve
  DomainMesh domain_;
  std::vector<Triangle> faces_;
  std::vector<Index> facets_;
  std::map<std::pair<std::vector<Index>, std::vector<Index>>, Index> classes_;
  std::vector<std::vector<std::pair<VertexIndex, Index>>> curve_ends_;
};

}  // namespace

std::vector<Index> named_patches(const PiecewiseLinearComplex& plc, const RefineOptions& options) {
  if (!options.facet_patch.empty()) return options.facet_patch;
  std::vector<Index> patch = plc.facet_provenance;
  Index next = 0;
  for (const Index p : patch)
    if (p != no_index) next = std::max(next, p + 1);
  std::replace(patch.begin(), patch.end(), no_index, next);
  return patch;
}

std::vector<Index> patches_of_facets(const PiecewiseLinearComplex& plc, const RefineOptions& options,
                                     const MergedFacets& merged) {
  return options.honour == Honour::tolerance ? named_patches(plc, options) : merged.row_of_facet;
}

DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options, std::vector<Index> patches) {
  return Importer(plc, mesh, options, std::move(patches)).make(pinned_vertices(plc, mesh, options));
}
DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options) {
  return import_domain(plc, mesh, options, patches_of_facets(plc, options, merge_pieces(plc, options.facet_parent)));
}

}  // namespace geomesh::remesh
