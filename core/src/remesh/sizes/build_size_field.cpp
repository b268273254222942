// SPDX-License-Identifier: MIT
// The size field from what was asked, declared in remesh/sizes/sizes.hpp.
#include <algorithm>
#include <cmath>
#include <tuple>

#include "common/geometry.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/sizes/flat_extent.hpp"
#include "remesh/sizes/size_sources.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Where short edges stand among long ones, as where curves cross the sides of triangles, nobody asked for the short
/// ones; nor for any that is shorter than the size of the whole model that was asked. Sizes grow as fast from there
/// as shapes allow.
constexpr double uneven_ratio = 0.5, fast_gradation = 0.5, few_shortest = 3;

/// Per facet a number that pieces of one have in common. Surfaces that are kept have it as their patches.
std::vector<Index> pieces_merged(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options) {
  if (options.honour == Honour::tolerance) return merge_pieces(plc, options.facet_parent).row_of_facet;
  std::vector<Index> rows;
  for (Index f = 0; f < plc.n_facets(); ++f) rows.push_back(mesh.patch_of_facet(f));
  return rows;
}

/// The constrained edges at a vertex on a surface or curve.
struct EdgesAtVertex {
  double inverse = 0, sum = 0, count = 0;  // of their lengths
  double shortest = infinity, longest = 0;
  void add(double length, double times) {
    inverse += times / length, sum += times * length, count += times;
    shortest = std::min(shortest, length), longest = std::max(longest, length);
  }
  /// In an even triangulation the mean. Near a few short edges among long ones a few times the short ones, which is
  /// what elements of good shape need there.
  double harmonic() const { return count / inverse; }
  double mean() const { return sum / count; }
};

/// By vertex. Edges between pieces of one input triangle (equal in `merged`) are nobody's wish.
std::vector<EdgesAtVertex> edges_at_vertices(const DomainMesh& mesh, const std::vector<Index>& merged) {
  struct Use {
    std::array<VertexIndex, 2> edge;
    Index facet;
  };
  std::vector<Use> uses;
  mesh.for_each_facet_face([&](FaceRef f) {
    const Triangle t = mesh.face(f);
    for (unsigned k = 0; k < 3; ++k)
      uses.push_back({sorted(std::array{t[k], t[(k + 1) % 3]}), merged[mesh.tag(f).facet()]});
  });
  for (const auto& edge : mesh.curve_edges()) uses.push_back({edge, no_index});
  std::sort(uses.begin(), uses.end(),
            [](const Use& x, const Use& y) { return std::tie(x.edge, x.facet) < std::tie(y.edge, y.facet); });
  std::vector<EdgesAtVertex> edges(mesh.n_vertices());
  for (std::size_t i = 0, j; i < uses.size(); i = j) {
    for (j = i; j < uses.size() && uses[j].edge == uses[i].edge;) ++j;
    const bool is_curve = uses[j - 1].facet == no_index;
    const std::size_t n_faces = j - i - is_curve;
    if (!is_curve && n_faces == 2 && uses[i].facet == uses[i + 1].facet) continue;
    const auto [a, b] = uses[i].edge;
    const double l = distance(mesh.point(a), mesh.point(b));
    for (const VertexIndex v : {a, b}) edges[v].add(l, static_cast<double>(std::max(n_faces, std::size_t{1})));
  }
  return edges;
}

/// No size is below this, whatever short edges and thin gaps the input has: points that near to each other round onto
/// each other, or off the sides that they are on.
double least_of_all(const DomainMesh& mesh) {
  constexpr double share_of_diagonal = 1e-9;
  Box3 box;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) box.add(mesh.point(v));
  return mesh.n_vertices() > 0 ? share_of_diagonal * distance(box.min, box.max) : 0;
}

class SizeFieldBuilder {
 public:
  SizeFieldBuilder(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options)
      : mesh_(mesh),
        options_(options.size),
        patch_(named_patches(plc, options)),
        edges_(edges_at_vertices(mesh, pieces_merged(plc, mesh, options))),
        sources_(options.size.sources),
        at_vertex_(mesh.n_vertices(), infinity),
        least_(least_of_all(mesh)) {}

  /// Not by means of edges where surfaces get no points: by the longest.
  void add_input_edges(bool by_longest) {
    if (!options_.from_input_edges) return;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v) {
      const EdgesAtVertex& e = edges_[v];
      if (!(e.count > 0)) continue;
      if (by_longest) {
        ask_by_edges(v, e.longest);
      } else if (e.harmonic() >= uneven_ratio * e.mean()) {
        ask_by_edges(v, e.harmonic());
      } else {
        ask_by_edges(v, e.mean());
        ask_growing_fast(v, std::min(e.harmonic(), few_shortest * e.shortest));
      }
    }
  }

  /// Sizes of patches hold over their faces, those of curves along them.
  void add_patches_and_curves() {
    mesh_.for_each_facet_face([&](FaceRef f) {
      const Index patch = patch_of(f);
      if (patch < options_.patch_size.size() && options_.patch_size[patch].size > 0)
        cover_triangle(mesh_.places(mesh_.face(f)), options_.patch_size[patch], sources_);
    });
    cover_curves(mesh_, options_.segment_size, sources_);
  }

  /// Where the surface turns by an angle over the distance between two faces' centroids, the radius is distance /
  /// angle; the edge that turns by the angle asked is radius times that angle. For the tolerance a surface counts as
  /// flat over lengths over which it is: a rough one turns at every edge.
  void add_curvature(const LocalTolerance& tolerance) {
    const bool is_within = tolerance.greatest() > 0;
    if (!(options_.curvature_angle > 0) && !is_within) return;
    struct Half {
      std::array<VertexIndex, 2> edge;
      Vec3 normal, centroid;
      Index patch;
    };
    std::vector<Half> halves;
    std::vector<FlatExtent::Face> faces;
    mesh_.for_each_facet_face([&](FaceRef f) {
      const Triangle t = mesh_.face(f);
      if (is_within) faces.push_back({mesh_.places(t), patch_of(f)});
      const Vec3 n = unit(mesh_.normal(t));
      if (n == Vec3{}) return;
      for (unsigned k = 0; k < 3; ++k)
        halves.push_back({sorted(std::array{t[k], t[(k + 1) % 3]}), n, mesh_.middle(t), patch_of(f)});
    });
    const double widest = options_.global > 0 && options_.global < infinity ? options_.global : 0;
    FlatExtent extent(std::move(faces), widest);
    const auto key = [](const Half& h) { return std::tie(h.edge, h.centroid.x, h.centroid.y, h.centroid.z); };
    std::sort(halves.begin(), halves.end(), [&](const Half& x, const Half& y) { return key(x) < key(y); });
    for (std::size_t i = 0; i + 1 < halves.size(); ++i) {
      const Half &x = halves[i], &y = halves[i + 1];
      if (x.edge != y.edge || x.patch != y.patch) continue;
      const double turn = std::acos(std::clamp(std::abs(dot(x.normal, y.normal)), 0.0, 1.0));
      if (turn < 1e-3 || turn > 0.8) continue;  // flat, or a crease
      const double radius = distance(x.centroid, y.centroid) / turn;
      double size = infinity;
      if (options_.curvature_angle > 0) size = options_.curvature_angle * pi / 180 * radius;
      if (is_within) {
        const double chord = tolerance.least_at(std::array{x.centroid, y.centroid});
        const double shortest = std::min(edges_[x.edge[0]].shortest, edges_[x.edge[1]].shortest);
        const double by_turn = std::max(std::sqrt(8 * radius * chord), shortest);
        const Vec3 place = 0.5 * (x.centroid + y.centroid);
        size = std::min(size, std::max(by_turn, by_turn < widest ? extent.at(x.patch, place, by_turn, chord) : 0));
      }
      for (const VertexIndex v : x.edge) ask(v, size);
    }
  }

  SizeFields build() {
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v)
      if (at_vertex_[v] < infinity) sources_.push_back({mesh_.point(v), at_vertex_[v], 0});
    SizeFields fields;
    fields.without_gaps = SizeField(sources_, limits());
    if (options_.gap_layers > 0 || !options_.component_layers.empty()) add_gaps();
    fields.all = SizeField(std::move(sources_), limits());
    return fields;
  }

 private:
  SizeField::Limits limits() const {
    SizeField::Limits limits;
    if (options_.global > 0) limits.global = options_.global;
    if (options_.max_size > 0) limits.max_size = options_.max_size;
    limits.min_size = std::max(options_.min_size, least_);
    limits.gradation = options_.gradation;
    limits.component_size = options_.component_size;
    limits.background = options_.background;
    return limits;
  }

  Index patch_of(FaceRef f) const {
    const Index facet = mesh_.tag(f).facet();
    return facet < patch_.size() ? patch_[facet] : no_index;
  }

  void ask(VertexIndex v, double size) {
    if (size > 0) at_vertex_[v] = std::min(at_vertex_[v], size);
  }
  void ask_growing_fast(VertexIndex v, double size) {
    sources_.push_back({mesh_.point(v), size, 0, std::max(options_.gradation, fast_gradation)});
  }
  void ask_by_edges(VertexIndex v, double size) {
    if (size < options_.global)
      ask_growing_fast(v, size);
    else
      ask(v, size);
  }

  /// Asked layers come whatever their thickness; others never below a share of what is asked otherwise.
  double size_across(double width, double layers, double asked) const {
    if (layers > 0) return width / layers;
    return options_.gap_layers > 0 ? std::max(width / options_.gap_layers, options_.gap_floor * asked) : infinity;
  }

  void add_gaps() {
    std::vector<SizeSource> found;
    const double global = options_.global > 0 ? options_.global : infinity;
    const SizeField others(sources_, {global, 0, infinity, options_.gradation, {}, {}});
    for_each_side_of_surfaces(mesh_, [&](FaceRef f) {
      const Index c = mesh_.component(f.cell());
      const double layers = c < options_.component_layers.size() ? options_.component_layers[c] : 0;
      const auto look_from = [&](const Vec3& place, double radius) {
        const double width = gap_width(mesh_, f, place);
        if (!(width < infinity)) return;
        const double asked = others.at(place), size = size_across(width, layers, asked);
        if (size < asked) found.push_back({place, size, radius});
      };
      if (layers > 0)
        visit_pieces(mesh_.places(mesh_.face(f)), global, look_from);
      else
        look_from(mesh_.middle(mesh_.face(f)), 0);
    });
    sources_.insert(sources_.end(), found.begin(), found.end());
  }

  const DomainMesh& mesh_;
  const SizeOptions& options_;
  std::vector<Index> patch_;  // by facet
  std::vector<EdgesAtVertex> edges_;
  std::vector<SizeSource> sources_;
  std::vector<double> at_vertex_;
  double least_;
};

}  // namespace

SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance) {
  SizeFieldBuilder builder(plc, mesh, options);
  builder.add_input_edges(options.honour == Honour::exact && !options.size_surfaces);
  builder.add_patches_and_curves();
  builder.add_curvature(tolerance);
  return builder.build();
}

SizeField sizes_asked_by_name(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, RefineOptions options) {
  options.size.gap_layers = 0;
  options.size.component_layers.clear();
  SizeFieldBuilder builder(plc, mesh, options);
  builder.add_input_edges(options.honour == Honour::exact && !options.size_surfaces);
  builder.add_patches_and_curves();
  return builder.build().all;
}

SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options) {
  return build_size_field(plc, mesh, options, allowed_tolerance(plc, mesh, options));
}

}  // namespace geomesh::remesh
