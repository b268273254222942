// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/field_blocks.hpp"

#include <algorithm>
#include <cmath>

#include "common/by_rounding.hpp"
#include "geomesh/core/error.hpp"
#include "naming/region_facts.hpp"
#include "rules/blocks/build_blocks.hpp"
#include "rules/framework/horizon_blocks.hpp"

namespace geomesh::geomodel {
namespace {

void refuse_upright(const TriangulatedSurface& fault, const TriangulatedSurface& horizon) {
  Vec3 sum;
  double area = 0;
  for (const Triangle& t : fault.triangles) {
    const Vec3 normal = cross(fault.points[t[1]] - fault.points[t[0]], fault.points[t[2]] - fault.points[t[0]]);
    sum = sum + Vec3{0, 0, std::abs(normal.z)};
    area += std::sqrt(dot(normal, normal));
  }
  if (sum.z > by_rounding * area) return;
  throw Error(ErrorKind::invalid_input, "horizon " + horizon.name + ": the domain of its field is above or below " +
                                            fault.name +
                                            ", which is upright, so that neither side of it is the upper one; give a "
                                            "place in the fault block (domain: {block: [x, y, z]})");
}

void refuse_one_block(const TriangulatedSurface& horizon, const FieldPart& part, const FieldPart& other) {
  throw Error(ErrorKind::invalid_input, "horizon " + horizon.name + ": the places " + to_text(*other.block) + " and " +
                                            to_text(*part.block) +
                                            ", at which two of its fields are to hold, lie in one block");
}

/// The blocks of the framework in which a field holds: that of its place, and those on the sides of faults that it
/// names. A fault whose two sides one block has does not bound the field there.
std::vector<bool> blocks_of_field(const FieldPart& part, const BuiltSurfaces& built, const TriangulatedSurface& horizon,
                                  const BlockFramework& framework) {
  std::vector<bool> holds(framework.n_blocks(), true);
  if (part.block) {
    holds.assign(framework.n_blocks(), false);
    if (const Index block = framework.block_at(*part.block); block != no_index) holds[block] = true;
  }
  for (const auto& [name, is_above] : part.sides) {
    const std::size_t fault = throw_fault(built.surfaces, horizon, name);
    refuse_upright(built.surfaces[fault], horizon);
    const std::vector<int> sides = framework.sides_of(static_cast<Index>(fault));
    for (Index b = 0; b < holds.size(); ++b) holds[b] = holds[b] && sides[b] != (is_above ? -1 : 1);
  }
  return holds;
}

/// Warns if a field that is valid only on one side of a fault continues around the fault's end to the other side.
void warn_of_open_ends(const FieldPart& part, const BuiltSurfaces& built, const TriangulatedSurface& horizon,
                       const std::vector<bool>& holds, const BuildLog& log) {
  const BlockFramework& framework = built.rows.throw_blocks[&horizon - built.surfaces.data()]->framework;
  for (const auto& [name, is_above] : part.sides) {
    const std::vector<int> sides = framework.sides_of(static_cast<Index>(throw_fault(built.surfaces, horizon, name)));
    for (Index b = 0; b < holds.size(); ++b)
      if (holds[b] && sides[b] == 0) {
        log.warnings.push_back("horizon " + horizon.name + ": the surface of " + part.field +
                               " goes round the end of fault " + name + ", near " + to_text(framework.place_in(b)) +
                               ", so that the fault does not bound its domain; continue the fault (extent: to_box)");
        break;
      }
  }
}

}  // namespace

void refuse_field_outside(const Parting& p, FieldOfHorizon field, const Vec3& place) {
  throw Error(ErrorKind::invalid_input, "horizon " + p.surfaces[field.horizon].name + ": where " +
                                            p.rules.of(field.horizon).field_parts[field.part].field +
                                            " has the value lies wholly outside of the domain given for it, as near " +
                                            to_text(place) +
                                            "; are above and below, or the places of two entries, interchanged?");
}

void part_by_fields(BuiltSurfaces& built, Index row, const ModelRules& rules, const BuildLog& log) {
  const SurfaceRules rule = rules.of(row);
  const TriangulatedSurface& horizon = built.surfaces[row];
  set_throw_blocks(built, row, rules);
  const BlockFramework& framework = built.rows.throw_blocks[row]->framework;
  std::vector<Index>& field_of_block = built.rows.field_of_block[row];
  field_of_block.assign(framework.n_blocks(), no_index);
  std::vector<Index>& field_of_triangle = built.rows.block_of_triangle[row];
  for (Index k = 0; k < rule.field_parts.size(); ++k) {
    const FieldPart& part = rule.field_parts[k];
    field_of_triangle.resize(part.end, k);
    const std::vector<bool> holds = blocks_of_field(part, built, horizon, framework);
    for (Index b = 0; b < holds.size(); ++b) {
      if (!holds[b]) continue;
      if (field_of_block[b] == no_index)
        field_of_block[b] = k;
      else if (part.block && rule.field_parts[field_of_block[b]].block)
        refuse_one_block(horizon, part, rule.field_parts[field_of_block[b]]);
    }
    warn_of_open_ends(part, built, horizon, holds, log);
  }
}

}  // namespace geomesh::geomodel
