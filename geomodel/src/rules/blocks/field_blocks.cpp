// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/blocks/field_blocks.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "common/by_rounding.hpp"
#include "geomesh/core/error.hpp"
#include "naming/region_facts.hpp"
#include "naming/sheets.hpp"
#include "rules/blocks/build_blocks.hpp"
#include "rules/throw/sheet_sides.hpp"

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

/// For each fault, returns whether one of the horizon's fields is valid above it; empty if it is valid on both sides.
std::vector<std::optional<bool>> sides_of(const FieldPart& part, const std::vector<const TriangulatedSurface*>& faults,
                                          const TriangulatedSurface& horizon) {
  std::vector<std::optional<bool>> sides;
  for (const TriangulatedSurface* fault : faults) {
    std::optional<bool>& side = sides.emplace_back();
    if (part.block) side = FaultSides(*fault).is_above(*part.block);
    for (const auto& [name, is_above] : part.sides) {
      if (name != fault->name) continue;
      refuse_upright(*fault, horizon);
      side = is_above;
    }
  }
  return sides;
}

void refuse_one_block(const Parting& p, FieldOfHorizon field) {
  const std::vector<FieldPart> parts = p.rules.of(field.horizon).field_parts;
  const std::optional<Vec3>& own = parts[field.part].block;
  for (Index k = 0; k < field.part; ++k)
    if (own && parts[k].block && p.in_one_block(*own, *parts[k].block))
      throw Error(ErrorKind::invalid_input, "horizon " + p.surfaces[field.horizon].name + ": the places " +
                                                to_text(*parts[k].block) + " and " + to_text(*own) +
                                                ", at which two of its fields are to hold, lie in one block");
}

/// Warns if a field that is valid only on one side of a fault continues around the fault's end to the other side.
void warn_of_open_ends(const Parting& p, FieldOfHorizon field) {
  const std::vector<Index>& block_of = p.built.block_of_triangle[field.horizon];
  const auto is_mine = [&](Index f) {
    return std::any_of(p.soup.origins[f].begin(), p.soup.origins[f].end(), [&](const PolygonSoup::Origin& o) {
      return o.surface == field.horizon && block_of[o.triangle] == field.part;
    });
  };
  const std::vector<Index>& faults = p.built.parted_at[field.horizon];
  for (std::size_t k = 0; k < faults.size(); ++k) {
    if (p.built.is_on_both_sides(field.horizon, field.part, k)) continue;
    std::vector<Index> others = faults;
    std::erase(others, faults[k]);
    const UpwardSides sides = orient_upward(p.surfaces[faults[k]]);
    for (const Piece& piece : pieces_of(p.soup, is_mine, {faults[k]}, &sides, BeyondEnd::has_a_side, others))
      if (piece.above > 0 && piece.below > 0)
        p.warnings.push_back("horizon " + p.surfaces[field.horizon].name + ": the surface of " +
                             p.rules.of(field.horizon).field_parts[field.part].field +
                             " passes round the end of fault " + p.surfaces[faults[k]].name + ", near " +
                             to_text(p.soup.centre(piece.largest)) +
                             ", so that the fault does not bound its domain; continue the fault (extent: to_box)");
  }
}

}  // namespace

std::vector<bool> pieces_in_domain(const Parting& p, FieldOfHorizon field, const std::vector<Piece>& pieces,
                                   const std::function<bool(const Piece&)>& is_on_own_side) {
  const FieldPart part = p.rules.of(field.horizon).field_parts[field.part];
  refuse_one_block(p, field);
  std::vector<bool> kept;
  for (const Piece& piece : pieces)
    kept.push_back(part.block ? p.in_one_block(p.soup.centre(piece.largest), *part.block) : is_on_own_side(piece));
  if (std::find(kept.begin(), kept.end(), true) == kept.end())
    throw Error(ErrorKind::invalid_input,
                "horizon " + p.surfaces[field.horizon].name + ": where " + part.field +
                    " has the value lies wholly outside of the domain given for it, as near " +
                    to_text(p.soup.centre(pieces.front().largest)) +
                    "; are above and below, or the places of two entries, interchanged?");
  if (!part.block) warn_of_open_ends(p, field);
  return kept;
}

void part_by_fields(BuiltSurfaces& built, std::size_t s, const ModelRules& rules) {
  const SurfaceRules rule = rules.of(s);
  const TriangulatedSurface& horizon = built.surfaces[s];
  std::vector<const TriangulatedSurface*> faults;
  for (const std::string& name : rule.throw_at) {
    built.rows.parted_at[s].push_back(static_cast<Index>(throw_fault(built.surfaces, horizon, name)));
    faults.push_back(&built.surfaces[built.rows.parted_at[s].back()]);
  }
  std::vector<Index>& block = built.rows.block_of_triangle[s];
  for (const FieldPart& part : rule.field_parts) {
    block.resize(part.end, static_cast<Index>(built.rows.sides_of_block[s].size()));
    std::vector<bool>& sides = built.rows.sides_of_block[s].emplace_back();
    std::vector<bool>& has_both = built.rows.on_both_sides[s].emplace_back();
    for (const std::optional<bool>& side : sides_of(part, faults, horizon)) {
      sides.push_back(side.value_or(false));
      has_both.push_back(!side);
    }
  }
}

}  // namespace geomesh::geomodel
