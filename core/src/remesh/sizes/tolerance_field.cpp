// SPDX-License-Identifier: MIT
// Computes the permitted distance from the input by place, if it follows the sizes. Declared in remesh/sizes/sizes.hpp.
#include "remesh/domain/domain_io.hpp"
#include "remesh/sizes/size_sources.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// Adds the sizes requested for surfaces and for the units beside them.
void cover_surfaces(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options,
                    std::vector<SizeSource>& sources) {
  const SizeOptions& size = options.size;
  if (size.patch_size.empty() && size.component_size.empty()) return;
  const std::vector<Index> patches = named_patches(plc, options);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const auto unit_size = [&](FaceRef f) {
    const Index k = f.valid() ? mesh.component(f.cell()) : no_index;
    return k < size.component_size.size() && size.component_size[k] > 0 ? size.component_size[k] : infinity;
  };
  mesh.for_each_facet_face([&](FaceRef f) {
    const std::array<Vec3, 3> corners = mesh.places(mesh.face(f));
    const Index facet = mesh.tag(f).facet(), patch = facet < patches.size() ? patches[facet] : no_index;
    if (patch < size.patch_size.size() && size.patch_size[patch].size > 0)
      cover_triangle(corners, size.patch_size[patch], sources);
    const double least = std::min(unit_size(f), unit_size(mesh.cells().mirror(f)));
    if (least < infinity) cover_triangle(corners, {least, 0}, sources);
  });
}

/// Largest width, as a share of the tolerance, of needles behind which a curve may lie at which two surfaces meet.
/// Surfaces farther apart count as a gap, because a unit that thins out there would be lost otherwise.
constexpr double needle_share = 0.05;

SizeField tolerance_by_place(const PiecewiseLinearComplex& plc, const DomainMesh& mesh, const RefineOptions& options) {
  const double share = options.tolerance_share;
  std::vector<SizeSource> sources = options.size.sources;
  cover_surfaces(plc, mesh, options, sources);
  cover_curves(mesh, options.size.segment_size, sources);
  for (SizeSource& s : sources) s.size *= share, s.gradation *= share;
  // Limits the tolerance to half of the gap, at places on each face twice the size apart, or more on a large face.
  for_each_side_of_surfaces(mesh, [&](FaceRef f) {
    visit_pieces(mesh.places(mesh.face(f)), options.tolerance / share, [&](const Vec3& p, double radius) {
      const double half = 0.5 * gap_width(mesh, f, p, needle_share * options.tolerance);
      if (half > 0 && half < options.tolerance) sources.push_back({p, half, radius});
    });
  });
  SizeField::Limits limits;
  limits.global = options.tolerance;
  limits.gradation = share * options.size.gradation;
  if (options.size.background)
    limits.background = [share, background = options.size.background](const Vec3& p) { return share * background(p); };
  return SizeField(std::move(sources), limits);
}

}  // namespace

LocalTolerance allowed_tolerance(const PiecewiseLinearComplex& plc, const DomainMesh& mesh,
                                 const RefineOptions& options) {
  if (options.honour == Honour::exact) return {};
  if (!(options.tolerance_share > 0)) return LocalTolerance(options.tolerance);
  return {options.tolerance, tolerance_by_place(plc, mesh, options)};
}

}  // namespace geomesh::remesh
