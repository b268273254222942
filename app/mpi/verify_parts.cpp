// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify_parts.hpp"

#include <algorithm>
#include <cmath>

#include "geomesh/core/error.hpp"
#include "geomesh/core/predicates.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "naming/sums.hpp"
#include "shared_points.hpp"

namespace geomesh::app {

namespace {

/// Relative accuracy of the volume of a region, a sum of as many rounded terms as the region has tetrahedra.
constexpr double volume_accuracy = 1e-10;

[[noreturn]] void fail(const std::string& what) {
  throw InternalError("the mesh of all ranks does not hold what it must (" + what + "), so nothing was written");
}

std::uint64_t sum_over(const Ranks& ranks, std::uint64_t own) {
  std::uint64_t sum = 0;
  for (const std::uint64_t x : ranks.gather_all(own)) sum += x;
  return sum;
}

/// Returns for each point of the part its number in the model.
std::vector<std::uint32_t> model_numbers(const RankModel& model, const RankMesh& mesh) {
  std::vector<std::uint32_t> number;
  number.reserve(mesh.points.size());
  for (const Vec3& p : mesh.points) number.push_back(model.points.number_at(p));
  return number;
}

class FaceChecks {
 public:
  FaceChecks(const RankModel& model, const RankMesh& mesh, const std::vector<std::uint32_t>& number)
      : model_(model), mesh_(mesh), number_(number) {}

  /// Checks the faces that only one tetrahedron of this rank has. Returns how many have a tetrahedron on another rank.
  std::size_t check_open(const std::vector<OpenFace>& open, const std::vector<Across>& across) {
    std::size_t n_between = 0;
    for (std::size_t k = 0; k < open.size(); ++k) {
      const OpenFace& f = open[k];
      const Index row = model_face({f.vertices[0], f.vertices[1], f.vertices[2]});
      n_between += across[k].rank >= 0;
      if (row != no_index) {
        count_side(row, mesh_.component[f.cell]);
        const auto& face = model_.sparse.mesh.faces[row];
        const bool is_outside = face.region_minus == 0 || face.region_plus == 0;
        if (is_outside != (across[k].rank < 0)) fail("a face of the model has another side than it should");
      } else if (across[k].rank < 0) {
        fail("a face between ranks is on one side alone");
      } else if (across[k].component != mesh_.component[f.cell]) {
        fail("regions meet where no surface is");
      }
    }
    return n_between;
  }
  void check_inner(const MeshFaces& faces) {
    faces.for_each_inner([&](const InnerFace& f) {
      const Index a = mesh_.component[f.cells[0]], b = mesh_.component[f.cells[1]];
      const Index row = model_face(f.corners);
      if (row != no_index) {
        count_side(row, a);
        count_side(row, b);
      } else if (a != b) {
        fail("regions meet where no surface is");
      }
    });
  }
  /// Checks that each face of the model exists once on each of its sides, so no face has two tetrahedra on one side.
  void require_all(const Ranks& ranks) const {
    std::uint64_t wanted = 0;
    for (const auto& face : model_.sparse.mesh.faces) wanted += (face.region_minus != 0) + (face.region_plus != 0);
    if (sum_over(ranks, n_sides_) != wanted) fail("a face of the model is missing");
  }

 private:
  Index model_face(const Corners& f) const {
    for (const VertexIndex v : f)
      if (number_[v] == ModelPoints::none) return no_index;
    return model_.simplices.face_of(sorted_corners({number_[f[0]], number_[f[1]], number_[f[2]]}));
  }
  void count_side(Index row, Index component) {
    const auto& face = model_.sparse.mesh.faces[row];
    const std::int32_t region = model_.region_of_component[component];
    if (region != face.region_minus && region != face.region_plus)
      fail("a face of the model lies at another region than it should");
    ++n_sides_;
  }

  const RankModel& model_;
  const RankMesh& mesh_;
  const std::vector<std::uint32_t>& number_;
  std::uint64_t n_sides_ = 0;
};

void require_edges(const RankModel& model, const RankMesh& mesh, const std::vector<std::uint32_t>& number,
                   const Ranks& ranks) {
  const auto& edges = model.simplices.edges;
  Bytes found(edges.size(), 0);
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const auto& e : edge_vertices) {
      const std::uint32_t a = number[t[e[0]]], b = number[t[e[1]]];
      if (a == ModelPoints::none || b == ModelPoints::none) continue;
      const std::array<std::uint32_t, 2> edge{std::min(a, b), std::max(a, b)};
      const auto at = std::lower_bound(edges.begin(), edges.end(), edge);
      if (at != edges.end() && *at == edge) found[static_cast<std::size_t>(at - edges.begin())] = 1;
    }
  ranks.greatest(found);
  if (std::find(found.begin(), found.end(), 0) != found.end()) fail("an edge of a curve is missing");
}

std::vector<double> volumes_of_regions(const RankModel& model, const RankMesh& mesh, const Ranks& ranks) {
  const auto& regions = model.sparse.mesh.regions;
  std::vector<geomodel::CompensatedSum> own(regions.size()), all(regions.size());
  for (Index c = 0; c < mesh.tetrahedra.size(); ++c) {
    const auto& [p, q, r, s] = mesh.tetrahedra[c];
    own[static_cast<std::size_t>(model.region_of_component[mesh.component[c]] - 1)].add(
        geomodel::signed_volume(mesh.points[p], mesh.points[q], mesh.points[r], mesh.points[s]));
  }
  std::vector<double> volumes, result;
  for (const geomodel::CompensatedSum& s : own) volumes.push_back(s.value());
  for (const auto& of_rank :
       ranks.exchange(std::vector<std::vector<double>>(static_cast<std::size_t>(ranks.size()), volumes)))
    for (std::size_t k = 0; k < regions.size(); ++k) all[k].add(of_rank[k]);
  for (std::size_t k = 0; k < regions.size(); ++k) {
    const double volume = all[k].value(), wanted = regions[k].volume;
    if (!(std::abs(volume - wanted) <= volume_accuracy * wanted))
      fail("the volume of " + regions[k].name + " is not that between its surfaces");
    result.push_back(volume);
  }
  return result;
}

}  // namespace

VerifiedParts verify_parts(const RankModel& model, const RankMesh& mesh, const MeshFaces& faces, const Ranks& ranks) {
  for (const Tetrahedron& t : mesh.tetrahedra)
    if (orient3d(mesh.points[t[0]], mesh.points[t[1]], mesh.points[t[2]], mesh.points[t[3]]) != Sign::positive)
      fail("a tetrahedron is not positive");
  const std::vector<std::uint32_t> number = model_numbers(model, mesh);
  FaceChecks checks(model, mesh, number);
  const std::size_t n_between = checks.check_open(faces.open, match_faces(mesh, faces.open, ranks));
  checks.check_inner(faces);
  checks.require_all(ranks);
  require_edges(model, mesh, number, ranks);
  return {sum_over(ranks, mesh.tetrahedra.size()), sum_over(ranks, n_between) / 2,
          volumes_of_regions(model, mesh, ranks)};
}

}  // namespace geomesh::app
