// SPDX-License-Identifier: MIT
// From a mesh in the caller's terms to the domain, declared in remesh/domain/domain_io.hpp.
#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>

#include "common/epoch_marks.hpp"
#include "common/geometry.hpp"
#include "common/sort_unique.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/domain/face_directions.hpp"
#include "remesh/domain/merge_pieces.hpp"

namespace geomesh::remesh {

namespace {

/// Of the tolerance: lower faces have no direction of their own.
constexpr double narrow_share = 1e-3;

class Importer {
 public:
  Importer(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input, const RefineOptions& options,
           std::vector<Index> patches)
      : plc_(plc),
        input_(input),
        fixed_points_(options.fixed_points),
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

  DomainMesh run() {
    add_cells();
    tag_faces();
    collect_edges();
    register_curves();
    find_pinched();
    classify_vertices();
    return std::move(domain_);
  }

 private:
  void add_cells() {
    domain_.reserve(2 * input_.points.size(), 2 * input_.tetrahedra.size());
    for (const Vec3& p : input_.points) domain_.add_vertex(p, VertexKind::inside);
    for (std::size_t t = 0; t < input_.tetrahedra.size(); ++t)
      domain_.add_cell(input_.tetrahedra[t], input_.component[t]);
    domain_.link_cells();
  }

  void tag_face(Index tetrahedron, const Triangle& f, FaceTag tag) {
    if (tetrahedron == no_index) return;
    const Tetrahedron& t = domain_.vertices(tetrahedron);
    for (unsigned i = 0; i < 4; ++i)
      if (t[i] != f[0] && t[i] != f[1] && t[i] != f[2]) {
        domain_.set_tag(tetrahedron, i, tag);
        return;
      }
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
        const Tetrahedron& t = domain_.vertices(c);
        faces_.push_back({t[face_vertices[i][0]], t[face_vertices[i][1]], t[face_vertices[i][2]]});
        facets_.push_back(hull_facet);
      }
  }

  void collect_edges() {
    for (Index f = 0; f < faces_.size(); ++f)
      for (unsigned i = 0; i < 3; ++i) {
        const VertexIndex a = faces_[f][i], b = faces_[f][(i + 1) % 3];
        uses_.push_back({{std::min(a, b), std::max(a, b)}, f});
      }
    std::sort(uses_.begin(), uses_.end(),
              [](const EdgeUse& a, const EdgeUse& b) { return a.edge != b.edge ? a.edge < b.edge : a.face < b.face; });
    for (const auto& e : input_.edges) segments_[{std::min(e.a, e.b), std::max(e.a, e.b)}].push_back(e.segment);
    for (auto& [edge, rows] : segments_) std::sort(rows.begin(), rows.end());
  }

  /// By face; empty where edges are not sharp whatever their faces' directions.
  std::vector<Vec3> directions() const {
    if (exact_) return {};
    std::vector<Index> patches;
    for (const Index f : facets_) patches.push_back(domain_.patch_of_facet(f));
    return face_directions(input_.points, faces_, patches, uses_, narrow_);
  }

  /// Not where a face is so narrow that it has no direction.
  bool is_sharp(const EdgeUse& a, const EdgeUse& b, const std::vector<Vec3>& directions) const {
    if (exact_) return false;
    const Vec3 &n = directions[a.face], &m = directions[b.face];
    if (n == Vec3{} || m == Vec3{}) return false;
    const bool consistent =
        runs_along(faces_[a.face], a.edge[0], a.edge[1]) != runs_along(faces_[b.face], a.edge[0], a.edge[1]);
    return (consistent ? dot(n, m) : -dot(n, m)) < cos_sharp_;
  }

  std::vector<Index> first_of_their_curves(std::vector<Index> rows) const {
    for (Index& s : rows) s = first_of_curve_[s];
    sort_unique(rows);
    return rows;
  }

  Index intern(CurveClass c) {
    const auto [it, is_new] =
        classes_.try_emplace({c.segments, c.patches}, static_cast<Index>(domain_.n_curve_classes()));
    if (is_new) domain_.add_curve_class(std::move(c));
    return it->second;
  }

  void add_curve(const std::array<VertexIndex, 2>& edge, CurveClass c) {
    const Index curve = intern(std::move(c));
    domain_.set_curve(edge[0], edge[1], curve);
    for (const VertexIndex v : edge) curve_ends_[v].push_back({edge[0] == v ? edge[1] : edge[0], curve});
  }

  void register_curves() {
    for (VertexIndex v = 0; v < domain_.n_vertices(); ++v)
      domain_.set_kind(v, VertexKind::corner, no_index);  // curve_of must not filter
    curve_ends_.resize(domain_.n_vertices());
    const std::vector<Vec3> looks = directions();
    for (std::size_t i = 0, j; i < uses_.size(); i = j) {
      for (j = i; j < uses_.size() && uses_[j].edge == uses_[i].edge;) ++j;
      CurveClass c;
      for (std::size_t k = i; k < j; ++k) c.patches.push_back(domain_.patch_of_facet(facets_[uses_[k].face]));
      std::sort(c.patches.begin(), c.patches.end());
      const auto listed = segments_.find(uses_[i].edge);
      if (listed != segments_.end()) {
        c.segments = first_of_their_curves(listed->second);
        segments_.erase(listed);
      }
      if (!c.segments.empty() || j - i != 2 || c.patches[0] != c.patches[1] || is_sharp(uses_[i], uses_[i + 1], looks))
        add_curve(uses_[i].edge, std::move(c));
    }
    for (const auto& [edge, rows] : segments_) add_curve(edge, {rows, {}});  // in the inside of regions
  }

  /// Vertices of edges with more than two outer faces, and those on the outside that have more cells than a walk
  /// through faces finds.
  void find_pinched() {
    std::vector<bool> pinched(domain_.n_vertices(), false);
    std::vector<std::uint32_t> n_cells(domain_.n_vertices(), 0);
    std::vector<std::array<VertexIndex, 2>> outer_edges;
    for (CellIndex c = 0; c < domain_.n_slots(); ++c) {
      const Tetrahedron& t = domain_.vertices(c);
      for (const VertexIndex v : t) ++n_cells[v];
      for (unsigned i = 0; i < 4; ++i) {
        if (domain_.has_neighbor(c, i)) continue;
        for (unsigned k = 0; k < 3; ++k) {
          const VertexIndex a = t[face_vertices[i][k]], b = t[face_vertices[i][(k + 1) % 3]];
          outer_edges.push_back({std::min(a, b), std::max(a, b)});
        }
      }
    }
    std::sort(outer_edges.begin(), outer_edges.end());
    EpochMarks marks;
    std::vector<CellIndex> star;
    std::vector<bool> is_counted(domain_.n_vertices(), false);
    for (std::size_t i = 0, j; i < outer_edges.size(); i = j) {
      for (j = i; j < outer_edges.size() && outer_edges[j] == outer_edges[i];) ++j;
      for (const VertexIndex v : outer_edges[i]) {
        if (j - i > 2) pinched[v] = true;
        if (is_counted[v]) continue;
        is_counted[v] = true;
        domain_.star(v, marks, star);
        if (star.size() < n_cells[v]) pinched[v] = true;
      }
    }
    domain_.set_pinched(std::move(pinched));
  }

  bool is_fixed(VertexIndex v) const { return exact_ && input_.input_vertex[v] != no_vertex; }

  bool turns_sharply(VertexIndex v) const {
    const Vec3 a = input_.points[curve_ends_[v][0].first] - input_.points[v],
               b = input_.points[curve_ends_[v][1].first] - input_.points[v];
    return -dot(a, b) < cos_sharp_ * length(a) * length(b);
  }

  /// Whether the faces about v (a range of at_vertex_) form one fan: else two sheets touch there.
  bool is_one_fan(VertexIndex v, std::span<const Index> faces) const {
    std::vector<VertexIndex> reached;
    std::vector<bool> used(faces.size(), false);
    const auto others = [&](Index f) {
      const Triangle& t = faces_[f];
      return t[0] == v ? std::array{t[1], t[2]} : t[1] == v ? std::array{t[2], t[0]} : std::array{t[0], t[1]};
    };
    used[0] = true;
    for (const VertexIndex x : others(faces[0])) reached.push_back(x);
    for (bool grown = true; grown;) {
      grown = false;
      for (std::size_t k = 0; k < faces.size(); ++k) {
        if (used[k]) continue;
        const auto o = others(faces[k]);
        if (std::find(reached.begin(), reached.end(), o[0]) == reached.end() &&
            std::find(reached.begin(), reached.end(), o[1]) == reached.end())
          continue;
        used[k] = grown = true;
        reached.insert(reached.end(), o.begin(), o.end());
      }
    }
    return std::all_of(used.begin(), used.end(), [](bool u) { return u; });
  }

  void classify(VertexIndex v, std::span<const Index> faces, bool pinned) {
    const auto& curves = curve_ends_[v];
    if (pinned || is_fixed(v) || domain_.is_pinched(v)) return;  // corner, as set
    if (curves.size() == 2 && curves[0].second == curves[1].second && !turns_sharply(v)) {
      domain_.set_kind(v, VertexKind::curve, curves[0].second);
    } else if (curves.empty() && faces.empty()) {
      if (input_.input_vertex[v] == no_vertex) domain_.set_kind(v, VertexKind::inside, no_index);
    } else if (curves.empty()) {
      const Index patch = domain_.patch_of_facet(facets_[faces[0]]);
      if (patch != hull_patch && is_one_fan(v, faces)) domain_.set_kind(v, VertexKind::surface, patch);
    }
  }

  void classify_vertices() {
    const std::size_t n = domain_.n_vertices();
    std::vector<bool> pinned(n, false);
    for (const VertexIndex v : input_.isolated_points) pinned[v] = true;
    std::vector<bool> pinned_input(plc_.points.size(), false);
    if (exact_ || !fixed_points_) {
      for (const auto& p : plc_.facet_points) pinned_input[p.v] = true;
    } else {
      for (const VertexIndex v : *fixed_points_) pinned_input[v] = true;
    }
    for (VertexIndex v = 0; v < n; ++v)
      if (input_.input_vertex[v] != no_vertex && pinned_input[input_.input_vertex[v]]) pinned[v] = true;
    std::vector<Index> offset(n + 1, 0), at_vertex(3 * faces_.size());
    for (const Triangle& t : faces_)
      for (const VertexIndex v : t) ++offset[v + 1];
    std::partial_sum(offset.begin(), offset.end(), offset.begin());
    std::vector<Index> fill(offset.begin(), offset.end() - 1);
    for (Index f = 0; f < faces_.size(); ++f)
      for (const VertexIndex v : faces_[f]) at_vertex[fill[v]++] = f;
    for (VertexIndex v = 0; v < n; ++v)
      classify(v, std::span(at_vertex).subspan(offset[v], offset[v + 1] - offset[v]), pinned[v]);
  }

  const PiecewiseLinearComplex& plc_;
  const ConstrainedTetrahedralization& input_;
  const std::optional<std::vector<VertexIndex>>& fixed_points_;
  bool exact_;
  double narrow_, cos_sharp_;
  std::vector<Index> first_of_curve_;  // per segment: the first of those that are pieces of one curve with it
  DomainMesh domain_;
  std::vector<Triangle> faces_;
  std::vector<Index> facets_;
  std::vector<EdgeUse> uses_;
  std::map<std::array<VertexIndex, 2>, std::vector<Index>> segments_;
  std::map<std::pair<std::vector<Index>, std::vector<Index>>, Index> classes_;
  std::vector<std::vector<std::pair<VertexIndex, Index>>> curve_ends_;
};

}  // namespace

std::vector<Index> named_patches(const PiecewiseLinearComplex& plc, const RefineOptions& options) {
  if (!options.facet_patch.empty()) return options.facet_patch;
  std::vector<Index> patch = plc.facet_provenance;
  const bool any_missing = std::find(patch.begin(), patch.end(), no_index) != patch.end();
  if (!any_missing) return patch;
  Index next = 0;
  for (const Index p : patch)
    if (p != no_index) next = std::max(next, p + 1);
  for (Index& p : patch)
    if (p == no_index) p = next;
  return patch;
}

std::vector<Index> patches_of_facets(const PiecewiseLinearComplex& plc, const RefineOptions& options) {
  return options.honour == Honour::tolerance ? named_patches(plc, options)
                                             : merge_pieces(plc, options.facet_parent).row_of_facet;
}
std::vector<Index> patches_of_facets(const PiecewiseLinearComplex& plc, const RefineOptions& options,
                                     const MergedFacets& merged) {
  return options.honour == Honour::tolerance ? named_patches(plc, options) : merged.row_of_facet;
}

DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options, std::vector<Index> patches) {
  return Importer(plc, mesh, options, std::move(patches)).run();
}
DomainMesh import_domain(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& mesh,
                         const RefineOptions& options) {
  return import_domain(plc, mesh, options, patches_of_facets(plc, options));
}

}  // namespace geomesh::remesh
