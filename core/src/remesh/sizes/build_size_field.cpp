// SPDX-License-Identifier: MIT
// Builds the size field from the sizes of the options and of the input. Declared in remesh/sizes/sizes.hpp.
#include <algorithm>
#include <cmath>

#include "common/geometry.hpp"
#include "remesh/sizes/size_basis.hpp"
#include "remesh/sizes/size_sources.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Short edges among long ones, such as those between curves and the sides of triangles that they cross, are not taken
/// as requested sizes; neither are edges shorter than the size requested for the whole model. Sizes grow from them as
/// fast as good shapes permit.
constexpr double uneven_ratio = 0.5, fast_gradation = 0.5, few_shortest = 3;

/// Returns the lower limit of all sizes, whatever short edges and thin gaps the input has. Points nearer to each other
/// than this would be rounded onto each other, or off the edges and faces on which they lie.
double least_of_all(const DomainMesh& mesh) {
  constexpr double share_of_diagonal = 1e-9;
  Box3 box;
  for (VertexIndex v = 0; v < mesh.n_vertices(); ++v) box.add(mesh.point(v));
  return mesh.n_vertices() > 0 ? share_of_diagonal * distance(box.min, box.max) : 0;
}

class SizeFieldBuilder {
 public:
  SizeFieldBuilder(const SizeBasis& basis, const DomainMesh& mesh, const RefineOptions& options)
      : basis_(basis),
        mesh_(mesh),
        options_(options.size),
        sources_(options.size.sources),
        at_vertex_(mesh.n_vertices(), infinity),
        least_(least_of_all(mesh)) {}

  /// Adds the sizes of input edges: a mean of the edges at a vertex, or their longest if surfaces get no points.
  void add_input_edges(bool by_longest) {
    if (!options_.from_input_edges) return;
    for (VertexIndex v = 0; v < mesh_.n_vertices(); ++v) {
      const EdgesAtVertex& e = basis_.edges[v];
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

  /// Adds sources for the target sizes of patches on their faces, and for those of curves along their edges.
  void add_patches_and_curves() {
    mesh_.for_each_facet_face([&](FaceRef f) {
      const Index patch = patch_of(f);
      if (patch < options_.patch_size.size() && options_.patch_size[patch].size > 0)
        cover_triangle(mesh_.places(mesh_.face(f)), options_.patch_size[patch], sources_);
    });
    cover_curves(mesh_, options_.segment_size, sources_);
  }

  /// Adds sizes that follow from curvature: an edge that spans the requested angle is as long as the radius times that
  /// angle. For the tolerance, a surface is flat over lengths over which it remains within the tolerance of a plane;
  /// without this rule every edge of a rough surface would be a bend.
  void add_curvature(const LocalTolerance& tolerance) {
    const bool is_within = tolerance.greatest() > 0;
    if (!(options_.curvature_angle > 0) && !is_within) return;
    const double widest = options_.global > 0 && options_.global < infinity ? options_.global : 0;
    FlatExtent extent(is_within ? basis_.faces : std::vector<FlatExtent::Face>(), widest);
    for (const Bend& bend : basis_.bends) {
      double size = infinity;
      if (options_.curvature_angle > 0) size = options_.curvature_angle * pi / 180 * bend.radius;
      if (is_within) {
        const double chord = tolerance.least_at(bend.centroids);
        const double shortest = std::min(basis_.edges[bend.edge[0]].shortest, basis_.edges[bend.edge[1]].shortest);
        const double by_turn = std::max(std::sqrt(8 * bend.radius * chord), shortest);
        const Vec3 place = 0.5 * (bend.centroids[0] + bend.centroids[1]);
        size = std::min(size, std::max(by_turn, by_turn < widest ? extent.at(bend.patch, place, by_turn, chord) : 0));
      }
      for (const VertexIndex v : bend.edge) ask(v, size);
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
    return facet < basis_.patch.size() ? basis_.patch[facet] : no_index;
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

  /// Returns the size that a gap requires. A requested number of layers is kept for any thickness; otherwise the size
  /// is at least the share `gap_floor` of the other target sizes there.
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

  const SizeBasis& basis_;
  const DomainMesh& mesh_;
  const SizeOptions& options_;
  std::vector<SizeSource> sources_;
  std::vector<double> at_vertex_;
  double least_;
};

}  // namespace

SizeFields build_size_field(const SizeBasis& basis, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance) {
  SizeFieldBuilder builder(basis, mesh, options);
  builder.add_input_edges(options.honour == Honour::exact && !options.size_surfaces);
  builder.add_patches_and_curves();
  builder.add_curvature(tolerance);
  return builder.build();
}

SizeField sizes_asked_by_name(const SizeBasis& basis, const DomainMesh& mesh, RefineOptions options) {
  options.size.gap_layers = 0;
  options.size.component_layers.clear();
  SizeFieldBuilder builder(basis, mesh, options);
  builder.add_input_edges(options.honour == Honour::exact && !options.size_surfaces);
  builder.add_patches_and_curves();
  return builder.build().all;
}

SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                            const LocalTolerance& tolerance) {
  return build_size_field(size_basis(plc, mesh, options), mesh, options, tolerance);
}

SizeFields build_size_field(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options) {
  return build_size_field(plc, mesh, options, allowed_tolerance(plc, mesh, options));
}

}  // namespace geomesh::remesh
