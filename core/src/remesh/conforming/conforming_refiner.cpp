// SPDX-License-Identifier: MIT
#include "remesh/conforming/conforming_refiner.hpp"

#include <algorithm>
#include <cmath>

#include "common/flood.hpp"
#include "common/geometry.hpp"
#include "mesh/circumcentre.hpp"

namespace geomesh::remesh {

namespace {

constexpr Index unlabelled = no_index, outside = no_index - 1;

/// Largest number of rounds of refinement. Each retries refused points, because their neighbourhood may have changed.
constexpr std::size_t max_rounds = 40;

}  // namespace

ConformingRefiner::ConformingRefiner(recover::Recovery& recovery, const RecoverOptions& options, const SizeField& size,
                                     FacetComponents components, std::size_t max_cells)
    : ConformingRecovery(recovery, options), size_(size), components_(std::move(components)), max_cells_(max_cells) {}

bool ConformingRefiner::refine() {
  refine_segments();
  recover_what_was_lost();
  for (counts_.rounds = 0; counts_.rounds < max_rounds; ++counts_.rounds) {
    if (label_cells() > max_cells_) return false;
    std::size_t n = refine_facets();
    recover_what_was_lost();
    label_cells();
    n += refine_cells();
    recover_what_was_lost();
    if (n == 0) break;
  }
  const std::size_t n_cells = label_cells();
  Vec3 centre;
  for (CellIndex c = 0; c < mesh_.cells().n_slots(); ++c)
    counts_.too_large += mesh_.cells().is_live(c) && wants_point(c, centre);
  return n_cells <= max_cells_;
}

void ConformingRefiner::recover_what_was_lost() {
  renew_budget();
  recover_queued_facets();
  for (const Index f : missing_facets_) give_up_facet(f, recover::GivenUpFor::budget);
  missing_facets_.clear();
}

double ConformingRefiner::size_on_facet(const Vec3& p, Index facet) const {
  double size = size_at(p, no_index);
  for (const Index c : components_[facet])
    if (c != no_index) size = std::min(size, size_at(p, c));
  return size;
}

Index ConformingRefiner::facet_of(CellIndex c, unsigned face) const {
  return facet_of_face_.find(face_of(mesh_.cells().vertices(c), face));
}

void ConformingRefiner::flood(CellIndex start, Index label) {
  if (label_[start] != unlabelled) return;
  flood_cells(mesh_.cells(), start, label_, unlabelled, label,
              [&](FaceRef f) { return facet_of(f.cell(), f.face()) == no_index; });
}

/// Computes each cell's component from the facets whose components are known. Cells outside and in holes have none.
/// Returns the number of cells that have a component.
std::size_t ConformingRefiner::label_cells() {
  const TetMesh& cells = mesh_.cells();
  label_.assign(cells.n_slots(), unlabelled);
  for (std::size_t k = 0; k < 8; ++k) flood(mesh_.cell_of(static_cast<VertexIndex>(mesh_.n_input() + k)), outside);
  for (CellIndex c = 0; c < cells.n_slots(); ++c) {
    if (!cells.is_live(c) || cells.is_ghost(c) || label_[c] != unlabelled) continue;
    for (unsigned i = 0; i < 4; ++i) {
      const Index f = facet_of(c, i);
      if (f == no_index) continue;
      const recover::Subfacet& s = constraints_.subfacets[f];
      const Sign side = mesh_.orient(s.vertices[0], s.vertices[1], s.vertices[2], cells.vertices(c)[i]);
      if (side == Sign::zero) continue;
      const Index component = components_[s.facet][side == Sign::positive ? 1 : 0];
      if (component == no_index) continue;
      flood(c, component);
      break;
    }
  }
  return static_cast<std::size_t>(std::count_if(label_.begin(), label_.end(), [](Index l) { return l < outside; }));
}

void ConformingRefiner::refine_segments() {
  // The halves of a split subsegment are appended to constraints_.subsegments, so this loop visits them later.
  for (Index s = 0; s < constraints_.subsegments.size(); ++s) {
    recovery_.context.check_cancelled();
    const recover::Subsegment& sub = constraints_.subsegments[s];
    if (!sub.live || sub.segment == no_index || segment_is_given_up_[sub.segment]) continue;
    const Vec3 a = mesh_.point(sub.a), b = mesh_.point(sub.b), middle = 0.5 * (a + b);
    double size = size_at(middle, no_index);
    for (const Index f : sub.subfacets) size = std::min(size, size_on_facet(middle, constraints_.subfacets[f].facet));
    if (distance(a, b) > max_length * size) split_long(s);
  }
}

std::size_t ConformingRefiner::refine_facets() {
  const std::size_t before = counts_.on_segments + counts_.on_facets;
  std::vector<FaceOfFacet> large;
  for (CellIndex c = 0; c < mesh_.cells().n_slots(); ++c) {
    if (!mesh_.cells().is_live(c) || mesh_.cells().is_ghost(c)) continue;
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh_.cells().neighbor_cell(c, i) < c) continue;
      const Index f = facet_of(c, i);
      if (f == no_index || facet_is_given_up_[f]) continue;
      const Triangle t = face_of(mesh_.cells().vertices(c), i);
      const auto centre = circumcentre(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]));
      if (!centre) continue;
      const Vec3 middle = (1.0 / 3) * (mesh_.point(t[0]) + mesh_.point(t[1]) + mesh_.point(t[2]));
      if (distance(*centre, mesh_.point(t[0])) > max_radius * size_on_facet(middle, constraints_.subfacets[f].facet))
        large.push_back({t, f});
    }
  }
  for (const FaceOfFacet& face : large) {
    recovery_.context.check_cancelled();
    if (facet_of_face_.find(face.vertices) == face.facet) insert_in_face(face);
  }
  return counts_.on_segments + counts_.on_facets - before;
}

bool ConformingRefiner::wants_point(CellIndex c, Vec3& centre) const {
  if (mesh_.cells().is_ghost(c) || label_[c] >= outside) return false;
  const auto& v = mesh_.cells().vertices(c);
  const std::array<Vec3, 4> p{mesh_.point(v[0]), mesh_.point(v[1]), mesh_.point(v[2]), mesh_.point(v[3])};
  const auto found = circumcentre(p[0], p[1], p[2], p[3]);
  if (!found) return false;
  centre = *found;
  const double radius = distance(centre, p[0]);
  double shortest = distance(p[0], p[1]);
  for (const auto& e : edge_vertices) shortest = std::min(shortest, distance(p[e[0]], p[e[1]]));
  const double size = size_at(0.25 * (p[0] + p[1] + p[2] + p[3]), label_[c]);
  return radius > max_radius * size || (radius > max_radius_to_edge * shortest && radius > min_spacing * size);
}

std::size_t ConformingRefiner::refine_cells() {
  const auto n_points = [&] { return counts_.on_segments + counts_.on_facets + counts_.inside; };
  const std::size_t before = n_points();
  std::vector<std::pair<CellIndex, Tetrahedron>> poor;
  Vec3 centre;
  for (CellIndex c = 0; c < mesh_.cells().n_slots(); ++c)
    if (mesh_.cells().is_live(c) && wants_point(c, centre)) poor.push_back({c, mesh_.cells().vertices(c)});
  for (const auto& [c, vertices] : poor) {
    recovery_.context.check_cancelled();
    if (!mesh_.cells().is_live(c) || mesh_.cells().vertices(c) != vertices) continue;
    if (wants_point(c, centre)) insert_in_cell(c, centre);
  }
  return n_points() - before;
}

}  // namespace geomesh::remesh
