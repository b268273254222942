// SPDX-License-Identifier: GPL-3.0-or-later
// Derives the specification from a project or from surface files, declared in `check/specification/specification.hpp`.
#include <algorithm>
#include <cmath>

#include "check/specification/specification.hpp"
#include "coordinates/project_inputs.hpp"
#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/ask_stack.hpp"
#include "geomesh/geomodel/gridding_in_blocks.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "geomesh/geomodel/project.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "level_sets/level_surfaces.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Determines what the project's rules may remove from each surface, from the rules alone.
class TrimReader {
 public:
  explicit TrimReader(const Project& project) : project_(project) {}

  TrimRules of(Index row) const {
    TrimRules trim;
    const SurfaceSpec& spec = project_.surfaces[row];
    add(project_.rules.topography, row, trim.above);
    add(project_.rules.floor, row, trim.below);
    if (spec.kind != SurfaceKind::body) trim.near_others = project_.rules.trim_overshoot;
    const bool has_throw = spec.rules.has_throw();
    trim.continuation = !spec.rules.stop_at.empty() || has_throw;
    trim.given_beyond_faults = has_throw && !spec.rules.has_fault_domain();
    for (const std::string& name : spec.rules.holds_above) add(name, row, trim.below);
    for (const std::string& name : spec.rules.holds_below) add(name, row, trim.above);
    add_order_of_horizons(row, trim);
    add_cut_units(row, trim);
    return trim;
  }

 private:
  Index row_of(const std::string& name) const {
    for (Index s = 0; s < project_.surfaces.size(); ++s)
      if (project_.surfaces[s].name == name) return s;
    return no_index;
  }
  void add(const std::string& name, Index but, std::vector<Index>& rows) const {
    const Index row = name.empty() ? no_index : row_of(name);
    if (row != no_index && row != but) rows.push_back(row);
  }
  /// Returns the index of the horizon in the column, youngest first; no_index if it is not in the column.
  Index rank_of(const std::string& horizon) const {
    for (std::size_t i = 1; i < project_.column.size(); i += 2)
      if (project_.column[i] == horizon) return static_cast<Index>(i / 2);
    return no_index;
  }

  /// Adds the surfaces that may cut a horizon by erosion, by onlap or because horizons cross.
  void add_order_of_horizons(Index row, TrimRules& trim) const {
    const Index own = rank_of(project_.surfaces[row].name);
    if (own == no_index) return;
    for (const SurfaceSpec& other : project_.surfaces) {
      const Index rank = rank_of(other.name);
      if (rank == no_index || rank == own) continue;
      const bool is_older = rank > own;  // the other one
      if (!is_older && (other.rules.base == BaseRule::erode || project_.rules.on_crossing == OnCrossing::clip_older))
        add(other.name, row, trim.above);
      if (is_older && (other.rules.base == BaseRule::onlap || project_.rules.on_crossing == OnCrossing::clip_younger))
        add(other.name, row, trim.below);
    }
  }

  /// Adds the horizons at which a fault ends that cuts only some units: the one above the first and the one below the
  /// last of them.
  void add_cut_units(Index row, TrimRules& trim) const {
    const auto& units = project_.surfaces[row].rules.cut_units;
    if (units.empty()) return;
    std::size_t first = project_.column.size(), last = 0;
    for (std::size_t i = 0; i < project_.column.size(); i += 2)
      if (std::find(units.begin(), units.end(), project_.column[i]) != units.end()) {
        first = std::min(first, i);
        last = i;
      }
    for (std::size_t i = 1; i < project_.column.size(); i += 2) {
      if (i < first) add(project_.column[i], row, trim.above);
      if (i > last) add(project_.column[i], row, trim.below);
    }
  }

  const Project& project_;
};

/// For a horizon with throw, returns the triangles that extend its faults beyond their ends.
std::vector<std::array<Vec3, 3>> partings_of(const BuiltSurfaces& built, const std::vector<Index>& faults) {
  std::vector<std::array<Vec3, 3>> partings;
  for (const Index s : faults) {
    const TriangulatedSurface& fault = built.surfaces[s];
    for (std::size_t t = built.rows.first_only_parting[s]; t < fault.triangles.size(); ++t) {
      const Triangle& v = fault.triangles[t];
      partings.push_back({fault.points[v[0]], fault.points[v[1]], fault.points[v[2]]});
    }
  }
  return partings;
}

SpecifiedNames names_of(const Project& project, const ProjectInputs& inputs) {
  SpecifiedNames names;
  names.column = project.column;
  names.seeds = project.naming.seeds;
  for (NamedPoint& seed : names.seeds) seed.point = inputs.frame.point(seed.point);
  names.groups = project.naming.groups;
  names.attributes = project.naming.attributes;
  names.fault_blocks = project.naming.fault_blocks;
  names.min_volume = project.naming.min_volume;
  names.merges_small = project.naming.merge_small && project.naming.min_volume > 0;
  return names;
}

/// Returns the largest growth of target sizes within one region per unit of distance; 0 if sizes follow a grid or
/// depth, so that the growth is unknown.
double size_growth(const NamedSizes& sizes) {
  constexpr double most_of_searches = 1;  // steepest gradation used when sizes are derived from a number of elements
  if (!sizes.background.empty() || !sizes.by_depth.empty()) return 0;
  return std::max(most_of_searches, sizes.base.gradation);
}

double volume_of_element(double edge) { return edge * edge * edge / (6 * std::sqrt(2.0)); }

}  // namespace

Specification specification_of_project(const std::filesystem::path& file) {
  const Project project = read_project(file);
  ProjectInputs inputs = read_project_inputs(project, {});
  Specification specification;
  specification.named = true;
  specification.names = names_of(project, inputs);
  specification.wells = std::move(inputs.wells);
  specification.points = std::move(inputs.points);
  if (inputs.volume) specification.volume = make_volume(*inputs.volume, inputs.surfaces, Vec3{});
  specification.ends_inside = !project.rules.topography.empty() || !project.rules.floor.empty();
  ModelRules rules = project.rules;
  if (specification.volume) rules.box = specification.volume->bounds;
  RefinementSettings refinement = project.mesh.refinement;
  settle_sizes(refinement, specification.volume ? specification.volume->bounds : bounds_of(inputs.surfaces),
               project.naming.attributes, Vec3{});
  // Mesh settings whose tolerance is reduced by the part that triangulated level sets use up.
  RefinementSettings of_build = refinement;
  if (has_level_sets(project)) of_build.tolerance.take({"level sets", level_set_share * of_build.tolerance.left()});
  if (specification.volume) {
    ask_stack(rules, of_build, *specification.volume);
    ask_continuation(rules, of_build, *specification.volume);
  }
  inputs.add_throws(rules);
  grid_in_blocks(inputs.surfaces, inputs.gridded, rules);
  inputs.complete_field_parts(rules);
  std::vector<std::string> found, doubts;  // warnings, unused because the run that made the mesh gave them
  find_ramps(inputs.surfaces, rules, found);
  leave_out_unreached_faults(inputs.surfaces, rules, doubts);
  const BuiltSurfaces built = build_surfaces(inputs.surfaces, rules);
  if (built.stack.settled) {  // horizons were put in order: regions are units in fault blocks, small parts are merged
    specification.names.fault_blocks = true;
    specification.names.merges_small = true;
    if (!(specification.names.min_volume > 0))
      specification.names.min_volume = 0.1 * volume_of_element(built.stack.size);
  }
  for (const TriangulatedSurface& s : built.surfaces)
    specification.input_points.insert(specification.input_points.end(), s.points.begin(), s.points.end());
  specification.surfaces = built.model_surfaces();
  specification.names.unconformities = unconformities(built.surfaces, built.rows, rules);
  specification.names.continued_within = rules.continuation.within_of_horizons;
  const TrimReader reader(project);
  for (Index row = 0; row < specification.surfaces.size(); ++row) {
    specification.trims.push_back(reader.of(row));
    if (rules.of(row).has_fault_domain()) specification.trims.back().fields = rules.of(row).field_parts;
    if (rules.of(row).continues && std::ranges::count(project.column, specification.surfaces[row].name) > 0)
      specification.names.continued.push_back(row);
    specification.trims.back().continuation |= !built.rows.part_of_triangle[row].empty();
    if (std::binary_search(built.rows.overshooting.begin(), built.rows.overshooting.end(), row))
      specification.trims.back().near_faults = rules.continuation.within_of_faults;
    for (const auto& [fault, horizon] : built.rows.truncations)
      if (fault == row) specification.trims.back().above.push_back(horizon);
    specification.trims.back().partings = partings_of(built, built.rows.parted_at[row]);
    const auto& settled = built.stack.horizons;
    const bool is_new = std::any_of(settled.begin(), settled.end(), [&](const SettledHorizon& h) {
      return h.name == specification.surfaces[row].name;
    });
    const bool has_parts = is_new && !built.rows.part_of_triangle[row].empty();
    specification.trims.back().n_given_triangles =
        has_parts ? built.rows.n_given_triangles[row]
                  : (is_new ? specification.surfaces : inputs.surfaces)[row].triangles.size();
  }
  specification.merging = project.merge_within;
  specification.output = project.output.options;
  specification.refined = refinement.refine;
  specification.cell_arrays = refinement.cell_arrays;
  specification.size_growth = size_growth(refinement.size);
  if (refinement.refine && refinement.honour == Honour::tolerance)
    specification.within = refinement.tolerance.requested();  // a tolerance and crs.z_scale are never combined
  specification.within_by_count = specification.within > 0 && refinement.tolerance.follows_sizes() &&
                                  (refinement.derive_size || refinement.target_elements > 0);
  return specification;
}

Specification specification_of_surfaces(const std::vector<std::filesystem::path>& files) {
  Specification specification;
  for (const auto& file : files) {
    FileContents contents = read_surface_file(file);
    if (contents.surfaces.empty())
      throw Error(ErrorKind::invalid_input, file.string() + ": holds no triangulated surface");
    for (TriangulatedSurface& s : contents.surfaces) specification.surfaces.push_back(std::move(s));
  }
  return specification;
}

}  // namespace geomesh::geomodel::checking
