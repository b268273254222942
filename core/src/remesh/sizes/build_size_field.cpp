// SPDX-License-Identifier: MIT
// The size field from what was asked, declared in remesh/sizes/sizes.hpp.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/geometry.hpp"
#include "quality/measure/shape.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/domain/merge_pieces.hpp"
#include "remesh/sizes/flat_extent.hpp"
#include "remesh/sizes/gap_width.hpp"
#include "remesh/sizes/size_sources.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// Per facet a number that pieces of one have in common. Surfaces that are kept have it as their patches.
std::vector<Index> pieces_merged(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options) {
  if (options.honour == Honour::tolerance) return merge_pieces(plc, options.facet_parent).row_of_facet;
  std::vector<Index> rows;
  for (Index f = 0; f < plc.n_facets(); ++f) rows.push_back(mesh.patch_of_facet(f));
  return rows;
}

class SizeFieldBuilder {
 public:
  SizeFieldBuilder(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                   const LocalTolerance& tolerance)
      : tolerance_(tolerance),
        by_longest_edges_(options.honour == Honour::exact && !options.size_surfaces),
        mesh_(mesh),
        options_(options.size),
        patch_(named_patches(plc, options)),
        merged_(pieces_merged(plc, mesh, options)),
        sources_(options.size.sources),
        at_vertex_(mesh.n_vertices(), infinity) {}

  SizeFields run() {
    add_input_edges();
    visit_faces();
    add_curve_sizes();
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v)
      if (at_vertex_[v] < infinity) sources_.push_back({mesh_.point(v), at_vertex_[v], 0});
    SizeFields fields;
    fields.without_gaps = SizeField(sources_, limits());
    if (asks_for_gaps()) add_gaps();
    fields.all = SizeField(std::move(sources_), limits());
    return fields;
  }

 private:
  SizeField::Limits limits() const {
    SizeField::Limits limits;
    if (options_.global > 0) limits.global = options_.global;
    if (options_.max_size > 0) limits.max_size = options_.max_size;
    limits.min_size = options_.min_size;
    limits.gradation = options_.gradation;
    limits.component_size = options_.component_size;
    limits.background = options_.background;
    return limits;
  }

  static constexpr double infinity = std::numeric_limits<double>::infinity();
  /// Where short edges stand among long ones, as where curves cross the sides of triangles, nobody asked for the short
  /// ones; nor for any that is shorter than the size of the whole model that was asked. Sizes grow as fast from there
  /// as shapes allow.
  static constexpr double uneven_ratio = 0.5, fast_gradation = 0.5, few_shortest = 3;

  void ask(VertexIndex v, double size) {
    if (size > 0) at_vertex_[v] = std::min(at_vertex_[v], size);
  }

  void ask_growing_fast(VertexIndex v, double size) {
    sources_.push_back({mesh_.point(v), size, 0, std::max(options_.gradation, fast_gradation)});
  }

  void ask_by_edges(VertexIndex v, double size) {
    if (size < options_.global) {
      ask_growing_fast(v, size);
    } else {
      ask(v, size);
    }
  }

  /// At each vertex on a surface or curve the harmonic mean of the lengths of the constrained edges there: in an even
  /// triangulation their mean; near a few short edges among long ones a few times the short ones, which is what
  /// elements of good shape need there. Edges between pieces of one input triangle are nobody's wish.
  void add_input_edges() {
    struct Use {
      VertexIndex a, b;
      Index facet;
    };
    std::vector<Use> uses;
    for_each_face_of_facet(mesh_, [&](CellIndex, unsigned, const Triangle& t, Index facet) {
      for (unsigned k = 0; k < 3; ++k)
        uses.push_back({std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), merged_[facet]});
    });
    for (const auto& [a, b] : mesh_.curve_edges()) uses.push_back({a, b, no_index});
    std::sort(uses.begin(), uses.end(),
              [](const Use& x, const Use& y) { return std::tuple(x.a, x.b, x.facet) < std::tuple(y.a, y.b, y.facet); });
    std::vector<double> inverse(mesh_.n_vertices(), 0), sum(mesh_.n_vertices(), 0), count(mesh_.n_vertices(), 0);
    shortest_.assign(mesh_.n_vertices(), infinity);
    longest_.assign(mesh_.n_vertices(), 0);
    for (std::size_t i = 0, j; i < uses.size(); i = j) {
      for (j = i; j < uses.size() && uses[j].a == uses[i].a && uses[j].b == uses[i].b;) ++j;
      const bool is_curve = uses[j - 1].facet == no_index;
      const std::size_t n_faces = j - i - is_curve;
      if (!is_curve && n_faces == 2 && uses[i].facet == uses[i + 1].facet) continue;
      const double l = distance(mesh_.point(uses[i].a), mesh_.point(uses[i].b)),
                   n = static_cast<double>(std::max(n_faces, std::size_t{1}));
      for (const VertexIndex v : {uses[i].a, uses[i].b}) {
        inverse[v] += n / l, sum[v] += n * l, count[v] += n;
        shortest_[v] = std::min(shortest_[v], l), longest_[v] = std::max(longest_[v], l);
      }
    }
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v) {
      if (!options_.from_input_edges || !(count[v] > 0)) continue;
      const double harmonic = count[v] / inverse[v], mean = sum[v] / count[v];
      if (by_longest_edges_) {
        ask_by_edges(v, longest_[v]);
      } else if (harmonic >= uneven_ratio * mean) {
        ask_by_edges(v, harmonic);
      } else {
        ask_by_edges(v, mean);
        ask_growing_fast(v, std::min(harmonic, few_shortest * shortest_[v]));
      }
    }
  }

  /// Sizes of patches hold over their faces, curvature at their edges.
  void visit_faces() {
    for_each_face_of_facet(mesh_, [&](CellIndex, unsigned, const Triangle& t, Index facet) {
      const Index patch = facet < patch_.size() ? patch_[facet] : no_index;
      if (patch >= options_.patch_size.size() || !(options_.patch_size[patch].size > 0)) return;
      cover_triangle({mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2])}, options_.patch_size[patch], sources_);
    });
    if (options_.curvature_angle > 0 || tolerance_.greatest() > 0) add_curvature();
  }

  void add_curve_sizes() {
    for (const auto& [a, b] : mesh_.curve_edges())
      for (const Index s : mesh_.curve_class(mesh_.curve_of(a, b)).segments)
        if (s < options_.segment_size.size() && options_.segment_size[s].size > 0)
          cover_piece(mesh_.point(a), mesh_.point(b), options_.segment_size[s], sources_);
  }

  /// Where the surface turns by an angle over the distance between two faces' centroids, the radius is distance /
  /// angle; the edge that turns by the angle asked is radius times that angle. For the tolerance a surface counts as
  /// flat over lengths over which it is: a rough one turns at every edge.
  void add_curvature() {
    struct Half {
      std::array<VertexIndex, 2> edge;
      Vec3 normal, centroid;
      Index patch;
    };
    std::vector<Half> halves;
    for_each_face_of_facet(mesh_, [&](CellIndex, unsigned, const Triangle& t, Index facet) {
      const Vec3 &a = mesh_.point(t[0]), &b = mesh_.point(t[1]), &c = mesh_.point(t[2]), n = cross(b - a, c - a);
      const double l = length(n);
      if (!(l > 0)) return;
      for (unsigned k = 0; k < 3; ++k)
        halves.push_back({{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3])},
                          (1 / l) * n,
                          (1.0 / 3) * (a + b + c),
                          facet < patch_.size() ? patch_[facet] : no_index});
    });
    const double widest = options_.global > 0 && options_.global < infinity ? options_.global : 0;
    FlatExtent extent(tolerance_.greatest() > 0 ? faces_by_patch() : std::vector<FlatExtent::Face>{}, widest);
    std::sort(halves.begin(), halves.end(), [](const Half& x, const Half& y) {
      return x.edge != y.edge ? x.edge < y.edge : compare(x.centroid, y.centroid);
    });
    for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
      const Half &x = halves[i], &y = halves[i + 1];
      if (x.edge != y.edge || x.patch != y.patch) continue;
      const double turn = std::acos(std::clamp(std::abs(dot(x.normal, y.normal)), 0.0, 1.0));
      if (turn < 1e-3 || turn > 0.8) continue;  // flat, or a crease
      const double radius = distance(x.centroid, y.centroid) / turn;
      double size = infinity;
      if (options_.curvature_angle > 0) size = options_.curvature_angle * pi / 180 * radius;
      if (tolerance_.greatest() > 0) {
        const double chord = tolerance_.least_at(std::array{x.centroid, y.centroid});
        const double by_turn = std::max(std::sqrt(8 * radius * chord), shortest_at(x.edge));
        const Vec3 place = 0.5 * (x.centroid + y.centroid);
        size = std::min(size, std::max(by_turn, by_turn < widest ? extent.at(x.patch, place, by_turn, chord) : 0));
      }
      for (const VertexIndex v : x.edge) ask(v, size);
    }
  }
  std::vector<FlatExtent::Face> faces_by_patch() const {
    std::vector<FlatExtent::Face> faces;
    for_each_face_of_facet(mesh_, [&](CellIndex, unsigned, const Triangle& t, Index facet) {
      faces.push_back({{mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2])},
                       facet < patch_.size() ? patch_[facet] : no_index});
    });
    return faces;
  }
  double shortest_at(const std::array<VertexIndex, 2>& edge) const {
    return edge[0] < shortest_.size() ? std::min(shortest_[edge[0]], shortest_[edge[1]]) : 0;
  }
  static bool compare(const Vec3& a, const Vec3& b) {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  }

  double layers_of(Index component) const {
    return component < options_.component_layers.size() ? options_.component_layers[component] : 0;
  }
  bool asks_for_gaps() const { return options_.gap_layers > 0 || !options_.component_layers.empty(); }

  /// Asked layers come whatever their thickness; others never below a share of what is asked otherwise.
  double size_across(double width, Index component, double asked) const {
    const double layers = layers_of(component);
    if (layers > 0) return width / layers;
    return options_.gap_layers > 0 ? std::max(width / options_.gap_layers, options_.gap_floor * asked) : infinity;
  }

  void add_gaps() {
    std::vector<SizeSource> found;
    const double global = options_.global > 0 ? options_.global : infinity;
    const SizeField others(sources_, {global, 0, infinity, options_.gradation, {}, {}});
    const auto visit = [&](CellIndex c, unsigned i, const Vec3& place, double radius) {
      const double width = gap_width(mesh_, c, i, place);
      if (!(width < infinity)) return;
      const double asked = others.at(place), size = size_across(width, mesh_.component(c), asked);
      if (size < asked) found.push_back({place, size, radius});
    };
    for (CellIndex c = 0; c < mesh_.n_slots(); ++c)
      for (unsigned i = 0; i < 4; ++i) {
        if (!mesh_.is_live(c) || !mesh_.tag(c, i).constrained()) continue;
        const Tetrahedron& v = mesh_.vertices(c);
        const std::array<Vec3, 3> corners{mesh_.point(v[face_vertices[i][0]]), mesh_.point(v[face_vertices[i][1]]),
                                          mesh_.point(v[face_vertices[i][2]])};
        if (layers_of(mesh_.component(c)) > 0) {
          visit_pieces(corners, global, [&](const Vec3& p, double radius) { visit(c, i, p, radius); });
        } else {
          visit(c, i, (1.0 / 3) * (corners[0] + corners[1] + corners[2]), 0);
        }
      }
    sources_.insert(sources_.end(), found.begin(), found.end());
  }

  const LocalTolerance& tolerance_;  // of surfaces; 0 where they are kept exactly
  bool by_longest_edges_;            // not by means of edges
  const DomainMesh& mesh_;
  const SizeOptions& options_;
  std::vector<Index> patch_;   // by facet
  std::vector<Index> merged_;  // by facet: equal for pieces of one input triangle
  std::vector<SizeSource> sources_;
  std::vector<double> at_vertex_;
  std::vector<double> shortest_, longest_;  // input edge at a vertex
};

}  // namespace

SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance) {
  return SizeFieldBuilder(plc, mesh, options, tolerance).run();
}

SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options) {
  return build_size_field(plc, mesh, options, allowed_tolerance(plc, mesh, options));
}

}  // namespace geomesh::remesh
