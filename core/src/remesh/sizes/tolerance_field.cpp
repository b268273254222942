// SPDX-License-Identifier: MIT
#include "remesh/sizes/tolerance_field.hpp"

#include "remesh/domain/domain_io.hpp"
#include "remesh/sizes/gap_width.hpp"
#include "remesh/sizes/size_sources.hpp"

namespace geomesh::remesh {

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

std::array<Vec3, 3> places(const DomainMesh& mesh, const Triangle& t) {
  return {mesh.point(t[0]), mesh.point(t[1]), mesh.point(t[2])};
}

class ToleranceFieldBuilder {
 public:
  ToleranceFieldBuilder(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options)
      : mesh_(mesh), options_(options), share_(options.tolerance_share), patch_(named_patches(plc, options)) {}

  SizeField run() {
    add_places();
    add_surfaces();
    add_curves();
    add_gaps();
    return SizeField(std::move(sources_), limits());
  }

 private:
  SizeField::Limits limits() const {
    const SizeOptions& size = options_.size;
    SizeField::Limits limits;
    limits.global = options_.tolerance;
    limits.gradation = share_ * size.gradation;
    if (size.background)
      limits.background = [share = share_, background = size.background](const Vec3& p) {
        return share * background(p);
      };
    return limits;
  }

  void add_places() {
    for (const SizeSource& s : options_.size.sources)
      sources_.push_back({s.point, share_ * s.size, s.radius, share_ * s.gradation});
  }

  /// What is asked of a surface, and of the units beside it.
  void add_surfaces() {
    const SizeOptions& size = options_.size;
    if (size.patch_size.empty() && size.component_size.empty()) return;
    const auto unit_size = [&](CellIndex c) {
      const Index k = mesh_.component(c);
      return k < size.component_size.size() && size.component_size[k] > 0 ? size.component_size[k] : infinity;
    };
    for_each_face_of_facet(mesh_, [&](CellIndex c, unsigned i, const Triangle& t, Index facet) {
      const Index patch = facet < patch_.size() ? patch_[facet] : no_index;
      if (patch < size.patch_size.size() && size.patch_size[patch].size > 0)
        cover(places(mesh_, t), size.patch_size[patch]);
      double least = unit_size(c);
      if (mesh_.has_neighbor(c, i)) least = std::min(least, unit_size(mesh_.topology().neighbor(c, i).cell()));
      if (least < infinity) cover(places(mesh_, t), {least, 0});
    });
  }

  void cover(const std::array<Vec3, 3>& corners, const AskedSize& asked) {
    visit_lattice(corners, asked.size, [&](const Vec3& p, double spacing) {
      sources_.push_back({p, share_ * asked.size, asked.radius + 0.75 * spacing});
    });
  }

  void add_curves() {
    const auto& sizes = options_.size.segment_size;
    for (const auto& [a, b] : mesh_.curve_edges())
      for (const Index s : mesh_.curve_class(mesh_.curve_of(a, b)).segments)
        if (s < sizes.size() && sizes[s].size > 0) {
          std::vector<SizeSource> along;
          cover_piece(mesh_.point(a), mesh_.point(b), sizes[s], along);
          for (const SizeSource& source : along)
            sources_.push_back({source.point, share_ * source.size, source.radius});
        }
  }

  /// Half of the gap, at places of a face two sizes apart, or more on a large one. Both sides of each face are looked
  /// at.
  void add_gaps() {
    const double reach = options_.tolerance / share_;
    for (CellIndex c = 0; c < mesh_.n_slots(); ++c)
      for (unsigned i = 0; mesh_.is_live(c) && i < 4; ++i) {
        if (!mesh_.tag(c, i).constrained()) continue;
        const Tetrahedron& v = mesh_.vertices(c);
        visit_pieces(places(mesh_, {v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]}), reach,
                     [&](const Vec3& p, double radius) {
                       const double half = 0.5 * gap_width(mesh_, c, i, p);
                       if (half > 0 && half < options_.tolerance) sources_.push_back({p, half, radius});
                     });
      }
  }

  const DomainMesh& mesh_;
  const RefineOptions& options_;
  double share_;
  std::vector<Index> patch_;
  std::vector<SizeSource> sources_;
};

}  // namespace

LocalTolerance allowed_tolerance(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options) {
  if (options.honour == Honour::exact) return {};
  if (!(options.tolerance_share > 0)) return LocalTolerance(options.tolerance);
  return {options.tolerance, ToleranceFieldBuilder(plc, mesh, options).run()};
}

}  // namespace geomesh::remesh
