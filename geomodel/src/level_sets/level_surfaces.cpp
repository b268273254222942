// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/level_surfaces.hpp"

#include <algorithm>
#include <cmath>
#include <compare>
#include <optional>
#include <tuple>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/words.hpp"
#include "level_sets/fields/function_field.hpp"
#include "level_sets/fields/place_words.hpp"
#include "level_sets/isosurfaces_of_field.hpp"
#include "level_sets/sheet_topology.hpp"

namespace geomesh::geomodel {
namespace {

/// Identifies one of the fields of a surface, by the row of the surface in Project::surfaces and that of the field in
/// SurfaceSpec::level_sets.
struct PartKey {
  std::size_t surface, part;
  auto operator<=>(const PartKey&) const = default;
};
using Group = std::vector<PartKey>;  ///< of one field

const LevelSetSpec& level_set(const Project& project, PartKey key) {
  return project.surfaces[key.surface].level_sets[key.part];
}

std::vector<Group> group_by_field(const Project& project) {
  const auto is_same = [](const LevelSetSpec& a, const LevelSetSpec& b) {
    return a.file == b.file && a.array == b.array && a.function == b.function && a.origin == b.origin &&
           a.spacing == b.spacing;
  };
  std::vector<Group> groups;
  for (std::size_t row = 0; row < project.surfaces.size(); ++row)
    for (std::size_t part = 0; part < project.surfaces[row].level_sets.size(); ++part) {
      const auto of_field = std::find_if(groups.begin(), groups.end(), [&](const Group& group) {
        return is_same(level_set(project, group.front()), level_set(project, {row, part}));
      });
      if (of_field == groups.end())
        groups.push_back({{row, part}});
      else
        of_field->push_back({row, part});
    }
  for (Group& group : groups)
    std::stable_sort(group.begin(), group.end(), [&](const PartKey& a, const PartKey& b) {
      return level_set(project, a).value < level_set(project, b).value;
    });
  return groups;
}

/// Returns the bounds of the project's box in the coordinates of the project file; nothing if it is derived from the
/// surfaces.
std::optional<Box3> bounds_of_volume(const Project& project) {
  if (!project.box) return std::nullopt;
  const VolumeSpec& volume = *project.box;
  if (volume.shape == VolumeSpec::Shape::box) return volume.box;
  if (volume.shape == VolumeSpec::Shape::margin || !volume.bottom || !volume.top) return std::nullopt;
  Box3 bounds;
  const double z[] = {*volume.bottom, *volume.top};
  for (const Vec2& corner : volume.polygon)
    for (const double height : z) bounds.add({corner.x, corner.y, height});
  if (volume.shape == VolumeSpec::Shape::turned) {
    const double reach = 0.5 * std::hypot(volume.size.x, volume.size.y);
    for (const double height : z) {
      bounds.add({volume.center.x - reach, volume.center.y - reach, height});
      bounds.add({volume.center.x + reach, volume.center.y + reach, height});
    }
  }
  return bounds;
}

std::string box_words(const Box3& box) { return place_words(box.min) + " to " + place_words(box.max); }

/// Returns the allowed distance between a triangulated level set and the true one: a share of the tolerance, or of the
/// default tolerance.
double distance_for(const Project& project, const Box3& bounds) {
  RefinementSettings settings = project.mesh.refinement;
  if (!settings.refine || settings.honour == Honour::exact) {
    settings.tolerance = ToleranceLedger::of_sizes(default_tolerance_share);
    settings.derive_size = settings.derive_size || !(settings.size.base.global > 0);
  }
  Box3 upright = bounds;  // the box may be upside down if z is depth, but its lengths are the same
  settle_sizes(settings, upright, project.naming.attributes, project.output.origin);
  return level_set_share * settings.tolerance.left();
}

std::string field_words(const LevelSetSpec& spec) {
  if (spec.function) return "its function";
  return spec.file_as_written + (spec.array.empty() ? "" : " (" + spec.array + ")");
}

/// The triangles of a level set that come from one scalar field, with those not proven near the true isosurface.
struct MadePart {
  Isosurface surface;
  FieldPart facts;
};
using MadeParts = std::map<PartKey, MadePart>;

class GroupMaker {
 public:
  GroupMaker(const Project& project, const Group& group, LevelSurfaces& made, MadeParts& parts)
      : project_(project), group_(group), made_(made), parts_(parts), spec_(level_set(project, group.front())) {
    for (const PartKey& key : group)
      if (values_.empty() || values_.back() != level_set(project, key).value)
        values_.push_back(level_set(project, key).value);
  }

  void make() {
    const FieldSurfaces found = spec_.function ? from_function() : from_file();
    for (const PartKey& key : group_) {
      const auto at = std::lower_bound(values_.begin(), values_.end(), level_set(project_, key).value);
      take(key, found, static_cast<std::size_t>(at - values_.begin()));
    }
  }

 private:
  const std::string& name() const { return project_.surfaces[group_.front().surface].name; }

  FieldSurfaces from_function() const {
    const std::optional<Box3> box = bounds_of_volume(project_);
    if (!box)
      throw Error(ErrorKind::usage, "surface " + name() +
                                        ": a function needs to know where it holds; give the project a box with "
                                        "corners (or a polygon with bottom and top)");
    return isosurfaces_of(FunctionField(spec_.function, *box, name()), *box, values_, distance_for(project_, *box));
  }

  FieldSurfaces from_file() const {
    FieldOfFile field = read_field_file(spec_);
    if (const auto* tetrahedra = std::get_if<TetrahedralField>(&field)) return isosurfaces_of(*tetrahedra, values_);
    const GridField grid(std::move(std::get<GridField::Lattice>(field)));
    const Box3 domain = within_box(grid.domain());
    return isosurfaces_of(grid, domain, values_, distance_for(project_, domain));
  }

  /// Returns the part of a field's grid that lies inside the box. Throws if there is none.
  Box3 within_box(Box3 domain) const {
    const std::optional<Box3> box = bounds_of_volume(project_);
    if (!box) return domain;
    const Box3 whole = domain;
    bool is_short = false;
    for (std::size_t a = 0; a < 3; ++a) {
      const double rounding = 1e-9 * (box->max[a] - box->min[a]);
      is_short = is_short || domain.min[a] > box->min[a] + rounding || domain.max[a] < box->max[a] - rounding;
      domain.min[a] = std::max(domain.min[a], box->min[a]);
      domain.max[a] = std::min(domain.max[a], box->max[a]);
    }
    if (!(domain.min.x < domain.max.x && domain.min.y < domain.max.y && domain.min.z < domain.max.z))
      throw Error(ErrorKind::invalid_input, "surface " + name() + ": the grid of " + field_words(spec_) +
                                                " reaches from " + box_words(whole) + " and does not meet the box, " +
                                                box_words(*box) +
                                                "; are its origin and spacing in the coordinates of the project?");
    if (is_short)
      made_.warnings.push_back(name() + ": the grid of " + field_words(spec_) + " reaches from " + box_words(whole) +
                               " and does not fill the box; its surfaces end where the grid ends (extend continues "
                               "them)");
    return domain;
  }

  void take(PartKey key, const FieldSurfaces& found, std::size_t of_value) {
    const SurfaceSpec& spec = project_.surfaces[key.surface];
    const double value = level_set(project_, key).value;
    if (found.surfaces[of_value].triangles.empty())
      throw Error(ErrorKind::invalid_input, "surface " + spec.name + ": " + field_words(spec_) + " has values from " +
                                                short_words(found.found.low) + " to " + short_words(found.found.high) +
                                                " in the model, and " + short_words(value) +
                                                " is not among them; there is no surface");
    MadePart& part = parts_[key];
    part.surface = found.surfaces[of_value];
    part.facts.field = field_words(spec_);
    report(spec.name, value, found, found.beyond[of_value], part);
    if (!level_set(project_, key).domain.is_everywhere()) return;
    for (FieldPart::Doubt& doubt : part.facts.doubts) made_.warnings.push_back(std::move(doubt.warning));
    part.facts.doubts.clear();
  }

  void report(const std::string& name, double value, const FieldSurfaces& found, const std::vector<Index>& beyond,
              MadePart& part) {
    TriangulatedSurface triangulated;
    triangulated.points = part.surface.points;
    triangulated.triangles = part.surface.triangles;
    const SheetTopology topology = topology_of(triangulated);
    std::string note = name + ": the surface where " + field_words(spec_) + " is " + short_words(value) + ", in " +
                       std::to_string(topology.n_parts) + (topology.n_parts == 1 ? " part, " : " parts, ") +
                       std::to_string(part.surface.triangles.size()) + " triangles";
    if (found.distance > 0 && found.is_proven && beyond.empty())
      note += ", proven to be within " + short_words(found.distance) + " of it";
    if (!found.is_proven && beyond.empty())
      note += ", within " + short_words(found.distance) + " of it at each of " + std::to_string(found.n_samples) +
              " samples: with 99 % confidence at all but " + short_words(460.5 / static_cast<double>(found.n_samples)) +
              " % of its area";
    made_.notes.push_back(std::move(note));
    if (topology.n_bad_edges > 0)
      made_.warnings.push_back(name + ": more than two sheets of it meet along " +
                               std::to_string(topology.n_bad_edges) + " edges, as near " +
                               place_words(topology.bad_place) + "; choose a value slightly off this one");
    if (!beyond.empty())
      part.facts.doubts.push_back({beyond,
                                   {},
                                   name + ": in " + std::to_string(beyond.size()) +
                                       " places the surface may be farther than " + short_words(found.distance) +
                                       " from its field, as near " +
                                       place_words(part.surface.points[part.surface.triangles[beyond.front()][0]])});
    if (found.unresolved.empty()) return;
    std::vector<Vec3> places;
    for (const Box3& cell : found.unresolved) places.push_back(0.5 * (cell.min + cell.max));
    const std::string text = name + ": its field bends within less than " + short_words(found.distance) + " near " +
                             place_words(places.front()) +
                             ", so that sheets nearer to each other than that may be one; a smaller "
                             "mesh.surfaces_within would separate them";
    part.facts.doubts.push_back({{}, std::move(places), text});
  }

  const Project& project_;
  const Group& group_;
  LevelSurfaces& made_;
  MadeParts& parts_;
  const LevelSetSpec& spec_;
  std::vector<double> values_;  ///< rising, each once
};

void assemble(const Project& project, const MadeParts& parts, LevelSurfaces& made) {
  for (const auto& [key, part] : parts) {
    FileContents& contents = made.contents[key.surface];
    contents.format = "level set";
    if (contents.surfaces.empty()) contents.surfaces.emplace_back();
    TriangulatedSurface& surface = contents.surfaces.front();
    surface.name = project.surfaces[key.surface].name;
    const auto n_points = static_cast<VertexIndex>(surface.points.size());
    const auto n_triangles = static_cast<Index>(surface.triangles.size());
    surface.points.insert(surface.points.end(), part.surface.points.begin(), part.surface.points.end());
    for (const Triangle& t : part.surface.triangles)
      surface.triangles.push_back({t[0] + n_points, t[1] + n_points, t[2] + n_points});
    FieldPart& facts = made.parts[key.surface].emplace_back(part.facts);
    facts.end = static_cast<Index>(surface.triangles.size());
    for (FieldPart::Doubt& doubt : facts.doubts)
      for (Index& t : doubt.triangles) t += n_triangles;
  }
}

}  // namespace

bool has_level_sets(const Project& project) {
  return std::any_of(project.surfaces.begin(), project.surfaces.end(),
                     [](const SurfaceSpec& spec) { return !spec.level_sets.empty(); });
}

LevelSurfaces make_level_surfaces(const Project& project) {
  LevelSurfaces made;
  MadeParts parts;
  for (const Group& group : group_by_field(project)) GroupMaker(project, group, made, parts).make();
  assemble(project, parts, made);
  return made;
}

}  // namespace geomesh::geomodel
