// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/isosurfaces_of_field.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/sizes_in_range.hpp"
#include "geomesh/geomodel/words.hpp"
#include "level_sets/distance_proof.hpp"
#include "level_sets/mesh/adapt.hpp"

namespace geomesh::geomodel {
namespace {

/// Number of cubes of the first background mesh along the longest side of the box, for fields with bounds and for
/// functions. A field with bounds loses no feature however coarse the first mesh is. A function is known only at
/// corners and midpoints, so features smaller than half a cube may be missed.
constexpr double cubes_with_bounds = 8, cubes_of_function = 24;
/// Share of a grid's spacing below which the background mesh is not refined to separate two nearly touching parts of an
/// isosurface, because a trilinear field has few of them in one grid cell.
constexpr double sheet_share = 0.25;
/// Largest number of cells of a background mesh, which limits its memory to about 1 GB.
constexpr std::size_t most_cells = 8'000'000;
/// Largest number of rounds of proof and refinement. Each round halves cells at least twice; a smooth field needs two
/// or three rounds.
constexpr int most_rounds = 12;

std::string size_words(const Box3& box) {
  const Vec3 size = box.max - box.min;
  return short_words(size.x) + " by " + short_words(size.y) + " by " + short_words(size.z);
}

/// Returns the edge of the cubes of the first background mesh, at most twice the shortest side of the box. Throws
/// Error{invalid_input} if the box is thinner than least_thickness allows, or if the first mesh would exceed the limit
/// of cells. Either happens if the spacing along one axis has another unit.
double first_edge(const ScalarField& field, const Box3& box) {
  const Vec3 size = box.max - box.min;
  const double longest = std::max({size.x, size.y, size.z}), shortest = std::min({size.x, size.y, size.z});
  const double edge = std::min(longest / (field.has_bounds() ? cubes_with_bounds : cubes_of_function), 2 * shortest);
  constexpr double cells_of_cube = 6;
  double n_cells = cells_of_cube;
  for (std::size_t a = 0; a < 3; ++a) n_cells *= std::max(1.0, std::round(size[a] / edge));
  if (!(n_cells <= static_cast<double>(most_cells)) || shortest < least_thickness * longest)
    throw Error(ErrorKind::invalid_input,
                "a field covers " + size_words(box) +
                    " of the model, too thin a sheet to follow its values in: are its spacing and origin right along "
                    "all three axes?");
  return edge;
}

/// Throws if the requested distance from the true isosurface is below the rounding errors of coordinates in the box;
/// cells would then be bisected up to their limit.
void require_distance(const Box3& box, double distance) {
  const Vec3 size = box.max - box.min;
  if (distance >= least_told_apart * std::max({size.x, size.y, size.z})) return;
  throw Error(ErrorKind::invalid_input,
              "a field covers " + size_words(box) + " of the model, too much to follow a surface in within " +
                  short_words(distance) + ": are its spacing and origin, and mesh.surfaces_within, in the same unit?");
}

Range values_at_vertices(const BackgroundMesh& mesh) {
  Range range{std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};
  for (VertexIndex v = 0; v < mesh.n_points(); ++v)
    range = {std::min(range.low, mesh.value(v)), std::max(range.high, mesh.value(v))};
  return range;
}

class FieldMesher {
 public:
  FieldMesher(const ScalarField& field, const Box3& box, const std::vector<double>& values, double distance)
      : field_(field),
        values_(values),
        limits_{distance, distance, std::max(distance, sheet_share * field.resolution()), most_cells},
        mesh_(field, box, first_edge(field, box)) {
    result_.distance = distance;
    result_.is_proven = field.has_bounds();
  }

  FieldSurfaces mesh() {
    for (int round = 0;; ++round) {
      const AdaptResult adapted = adapt(mesh_, field_, values_, limits_);
      result_.unresolved.insert(result_.unresolved.end(), adapted.unresolved.begin(), adapted.unresolved.end());
      result_.surfaces = extract_isosurfaces(mesh_, &field_, values_);
      find_beyond(static_cast<std::uint64_t>(round));
      const std::vector<std::size_t> chosen = cells_beyond();
      if (chosen.empty() || round + 1 == most_rounds) break;
      mesh_.bisect(chosen);
    }
    result_.n_cells = mesh_.cells().size();
    result_.found = values_at_vertices(mesh_);
    return std::move(result_);
  }

 private:
  /// Finds the isosurface triangles not known to be within the requested distance of the true isosurface. Triangles in
  /// a cell with edges shorter than that are within it, because the true isosurface passes through the cell too.
  void find_beyond(std::uint64_t seed) {
    result_.beyond.assign(values_.size(), {});
    for (std::size_t v = 0; v < values_.size(); ++v) {
      const Isosurface& surface = result_.surfaces[v];
      std::vector<std::size_t> rows;
      if (field_.has_bounds()) {
        rows = not_proven_within(field_, surface, values_[v], limits_.distance);
      } else {
        SampledDistance sampled = sample_within(field_, surface, values_[v], limits_.distance, seed);
        result_.n_samples = sampled.n_samples;
        rows = std::move(sampled.beyond);
      }
      for (const std::size_t t : rows)
        if (BackgroundMesh::longest_edge(mesh_.corners(mesh_.cells()[surface.cell[t]])) > limits_.least_edge)
          result_.beyond[v].push_back(static_cast<Index>(t));
    }
  }

  std::vector<std::size_t> cells_beyond() const {
    std::vector<std::size_t> chosen;
    for (std::size_t v = 0; v < values_.size(); ++v)
      for (const Index t : result_.beyond[v]) chosen.push_back(result_.surfaces[v].cell[t]);
    std::sort(chosen.begin(), chosen.end());
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
    return chosen;
  }

  const ScalarField& field_;
  const std::vector<double>& values_;
  AdaptLimits limits_;
  BackgroundMesh mesh_;
  FieldSurfaces result_;
};

}  // namespace

FieldSurfaces isosurfaces_of(const ScalarField& field, const Box3& box, const std::vector<double>& values,
                             double distance) {
  require_distance(box, distance);
  return FieldMesher(field, box, values, distance).mesh();
}

FieldSurfaces isosurfaces_of(const TetrahedralField& field, const std::vector<double>& values) {
  const BackgroundMesh mesh(field.points, field.values, field.cells);
  FieldSurfaces result;
  result.surfaces = extract_isosurfaces(mesh, nullptr, values);
  result.beyond.resize(values.size());
  result.n_cells = mesh.cells().size();
  result.found = values_at_vertices(mesh);
  return result;
}

}  // namespace geomesh::geomodel
