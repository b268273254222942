// SPDX-License-Identifier: GPL-3.0-or-later
#include "check/names/check_names.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>

#include "check/mesh/faults.hpp"
#include "check/names/name_parts.hpp"
#include "check/names/region_labels.hpp"
#include "check/names/sheet_sides.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Returns the cosine of the angle between the normals of a mesh face and its source triangle; 1 if the face has none.
double agreement_with_source(const CheckedFaces& checked, Index face) {
  const Index row = checked.surface_of(checked.faces()->surface[face]);
  const auto source = static_cast<std::size_t>(checked.faces()->source_triangle[face]);
  if (row == no_index || source >= checked.specification().surfaces[row].triangles.size()) return 1;
  const TriangulatedSurface& s = checked.specification().surfaces[row];
  const Triangle &t = s.triangles[source], &f = checked.candidates()[face];
  const auto normal = [](const Vec3& a, const Vec3& b, const Vec3& c) { return cross(b - a, c - a); };
  const Vec3 m = normal(s.points[t[0]], s.points[t[1]], s.points[t[2]]);
  const Vec3 n = normal(checked.corner(f, 0), checked.corner(f, 1), checked.corner(f, 2));
  const double lengths = std::sqrt(dot(m, m) * dot(n, n));
  return lengths > 0 ? dot(m, n) / lengths : 0;
}

class NameChecker {
 public:
  NameChecker(const CheckedFaces& checked, const Allowed& allowed)
      : checked_(checked), finder_(checked, allowed), labels_(finder_.labels()) {}

  void check(CheckResult& result);

 private:
  struct Row {
    std::int32_t id;
    std::string name;
    NameParts parts;
    RegionLabel label;
  };
  void check_same_everywhere(CheckResult& result) const;
  bool read_rows(CheckResult& result);
  std::vector<Row*> unnamed_in_order(bool turns_steep_faces);
  void number_unnamed();
  void check_suffixes(CheckResult& result) const;
  void check_ids(CheckResult& result) const;
  std::map<std::int32_t, std::size_t> blocks() const;
  void check_blocks(CheckResult& result) const;
  bool comes_first(const Row& a, const Row& b) const;
  const Vec3& place_of(std::int32_t region) const { return finder_.places().at(region).samples.front(); }

  const CheckedFaces& checked_;
  LabelFinder finder_;
  std::map<std::int32_t, AllowedLabels> labels_;
  std::vector<Row> rows_;  ///< by id
  std::size_t n_undecided_ = 0;
};

/// Checks that the face set gives the same names to regions as the mesh.
void NameChecker::check_same_everywhere(CheckResult& result) const {
  FaultCollector differ("names_differ");
  for (const auto& [id, name] : checked_.mesh().file.region_names) {
    const auto other = checked_.faces()->region_names.find(id);
    if (other == checked_.faces()->region_names.end() || other->second != name)
      differ.add(static_cast<std::size_t>(id), {});
  }
  for (const auto& [id, name] : checked_.faces()->region_names)
    if (!checked_.mesh().file.region_names.contains(id)) differ.add(static_cast<std::size_t>(id), {});
  differ.report(result, "regions bear one name in the mesh and another one, or none, in the face set");
}

/// Checks region names against those that the project allows. Returns false if suffixes and ids cannot be checked.
bool NameChecker::read_rows(CheckResult& result) {
  FaultCollector wrong("wrong_region_names");
  const std::set<std::string> known = names_of_specification(checked_.specification());
  std::string how;
  for (const auto& [id, allowed] : labels_) {
    const auto name = checked_.mesh().file.region_names.find(id);
    Row row{id, name == checked_.mesh().file.region_names.end() ? "" : name->second, {}, {}};
    row.parts = parts_of(row.name, known);
    if (allowed.empty()) {
      ++n_undecided_;
      continue;
    }
    const auto fits = std::find_if(allowed.begin(), allowed.end(), [&](const RegionLabel& label) {
      return label.name.empty() ? row.name.starts_with("region_") : label.name == row.parts.base;
    });
    if (fits == allowed.end()) {
      wrong.add(static_cast<std::size_t>(id), place_of(id));
      const std::string should = allowed[0].name.empty() ? "region_k" : allowed[0].name;
      if (wrong.count() <= 5) how += (how.empty() ? "" : "; ") + row.name + " should be " + should;
      continue;
    }
    row.label = *fits;
    rows_.push_back(std::move(row));
  }
  const bool all_right = wrong.count() == 0;
  wrong.report(result, "regions bear a name that seeds, bodies and the column do not give them (" + how + ")");
  return all_right && n_undecided_ == 0;
}

/// Returns regions without a name of their own, ordered by the first input triangle that bounds them. Mesh faces nearly
/// perpendicular to their source triangle may count for either side of it.
std::vector<NameChecker::Row*> NameChecker::unnamed_in_order(bool turns_steep_faces) {
  using Key = std::tuple<std::int32_t, std::int32_t, int>;
  std::map<std::int32_t, Key> first;
  const FacesFile& faces = *checked_.faces();
  for (Index f = 0; f < faces.surface.size(); ++f) {
    const double agreement = agreement_with_source(checked_, f);
    const bool along = (agreement >= 0) != (turns_steep_faces && std::abs(agreement) < least_cosine);
    for (const bool plus : {false, true}) {
      const Key key{faces.surface[f], faces.source_triangle[f], plus == along ? 1 : 0};
      const auto [at, is_new] = first.try_emplace(plus ? faces.region_plus[f] : faces.region_minus[f], key);
      if (!is_new) at->second = std::min(at->second, key);
    }
  }
  std::vector<Row*> unnamed;
  for (Row& row : rows_)
    if (row.label.kind == LabelKind::unnamed) unnamed.push_back(&row);
  std::sort(unnamed.begin(), unnamed.end(),
            [&](const Row* a, const Row* b) { return std::tie(first[a->id], a->id) < std::tie(first[b->id], b->id); });
  return unnamed;
}

/// `region_1`, `region_2` ...
void NameChecker::number_unnamed() {
  std::vector<Row*> unnamed = unnamed_in_order(false);
  const auto number = [](std::size_t k) { return "region_" + std::to_string(k + 1); };
  const auto is_as_named = [&](const std::vector<Row*>& rows) {
    for (std::size_t k = 0; k < rows.size(); ++k)
      if (rows[k]->name != number(k)) return false;
    return true;
  };
  if (!is_as_named(unnamed)) {
    std::vector<Row*> turned = unnamed_in_order(true);
    if (is_as_named(turned)) unnamed = std::move(turned);
  }
  for (std::size_t k = 0; k < unnamed.size(); ++k) {
    unnamed[k]->label.rank = static_cast<Index>(k);
    unnamed[k]->label.name = number(k);
    unnamed[k]->parts = {unnamed[k]->name};
  }
}

bool NameChecker::comes_first(const Row& a, const Row& b) const {
  const RegionPlace &p = finder_.places().at(a.id), &q = finder_.places().at(b.id);
  if (p.least != q.least) return comes_before(p.least, q.least);
  if (p.greatest != q.greatest) return comes_before(p.greatest, q.greatest);
  return comes_before(p.centroid, q.centroid);
}

/// Checks the suffixes of region names: a name of one region has none; regions with equal names have `__1`, `__2` ...
/// in the order of their positions.
void NameChecker::check_suffixes(CheckResult& result) const {
  FaultCollector wrong("wrong_name_suffixes");
  std::map<std::pair<std::string, std::size_t>, std::vector<const Row*>> named;
  for (const Row& row : rows_) named[{row.label.name, row.parts.block}].push_back(&row);
  for (auto& [name, rows] : named) {
    std::sort(rows.begin(), rows.end(), [&](const Row* a, const Row* b) { return comes_first(*a, *b); });
    for (std::size_t k = 0; k < rows.size(); ++k) {
      const bool right =
          rows[k]->parts.base == rows[k]->label.name && rows[k]->parts.number == (rows.size() == 1 ? 0 : k + 1);
      if (!right) wrong.add(static_cast<std::size_t>(rows[k]->id), place_of(rows[k]->id));
    }
  }
  wrong.report(result, "regions do not bear the suffix that their place among those of one name gives them");
}

void NameChecker::check_ids(CheckResult& result) const {
  FaultCollector wrong("wrong_region_ids");
  std::vector<const Row*> order;
  for (const Row& row : rows_) order.push_back(&row);
  const auto key = [](const Row& r) {
    return std::tuple(r.label.kind, r.label.rank,
                      r.parts.block == 0 ? r.label.name : r.label.name + "__B" + std::to_string(r.parts.block));
  };
  std::sort(order.begin(), order.end(),
            [&](const Row* a, const Row* b) { return key(*a) != key(*b) ? key(*a) < key(*b) : comes_first(*a, *b); });
  for (std::size_t k = 0; k < order.size(); ++k)
    if (order[k]->id != static_cast<std::int32_t>(k + 1))
      wrong.add(static_cast<std::size_t>(order[k]->id), place_of(order[k]->id));
  wrong.report(result, "region ids are not those that names and places give (units youngest first, bodies, seeds)");
}

/// Returns the number of the fault block of each region that contains a unit. A block consists of regions joined across
/// horizons of the column; blocks are numbered by their positions.
std::map<std::int32_t, std::size_t> NameChecker::blocks() const {
  std::map<std::int32_t, std::int32_t> root;
  for (const Row& row : rows_) root[row.id] = row.id;
  const auto find = [&](std::int32_t r) {
    while (root.at(r) != r) r = root.at(r);
    return r;
  };
  const FacesFile& faces = *checked_.faces();
  for (Index f = 0; f < faces.surface.size(); ++f) {
    const auto& set = checked_.set_of(f);
    const bool horizons = std::all_of(
        set.begin(), set.end(), [&](std::int32_t id) { return finder_.units().is_horizon(checked_.surface_of(id)); });
    const std::int32_t a = faces.region_minus[f], b = faces.region_plus[f];
    if (horizons && root.contains(a) && root.contains(b)) root[std::max(find(a), find(b))] = std::min(find(a), find(b));
  }
  std::map<std::int32_t, Vec3> least;  // by root
  std::set<std::int32_t> with_unit;
  for (const Row& row : rows_) {
    const std::int32_t r = find(row.id);
    const auto [at, is_new] = least.try_emplace(r, finder_.places().at(row.id).least);
    if (!is_new && comes_before(finder_.places().at(row.id).least, at->second))
      at->second = finder_.places().at(row.id).least;
    if (row.label.kind == LabelKind::unit) with_unit.insert(r);
  }
  std::vector<std::int32_t> order(with_unit.begin(), with_unit.end());
  std::sort(order.begin(), order.end(),
            [&](std::int32_t a, std::int32_t b) { return comes_before(least[a], least[b]); });
  std::map<std::int32_t, std::size_t> number;
  for (const Row& row : rows_) {
    const auto at = std::find(order.begin(), order.end(), find(row.id));
    if (row.label.kind == LabelKind::unit && order.size() > 1)
      number[row.id] = static_cast<std::size_t>(at - order.begin()) + 1;
  }
  return number;
}

void NameChecker::check_blocks(CheckResult& result) const {
  FaultCollector wrong("wrong_name_suffixes");
  const auto number = checked_.specification().names.fault_blocks ? blocks() : std::map<std::int32_t, std::size_t>{};
  for (const Row& row : rows_) {
    const auto at = number.find(row.id);
    if (row.parts.block != (at == number.end() ? 0 : at->second))
      wrong.add(static_cast<std::size_t>(row.id), place_of(row.id));
  }
  wrong.report(result, "regions do not bear the number of their fault block");
}

void NameChecker::check(CheckResult& result) {
  check_same_everywhere(result);
  if (!read_rows(result)) {
    result.checks_done.push_back("region names were checked; suffixes and ids were not (" +
                                 std::to_string(n_undecided_) + " regions too close to call)");
    return;
  }
  number_unnamed();
  if (checked_.specification().names.merges_small) {
    result.checks_done.emplace_back(
        "region names are those of the project; small regions were merged: suffixes and ids were not checked");
    return;
  }
  check_blocks(result);
  check_suffixes(result);
  check_ids(result);
  result.checks_done.emplace_back(
      "regions were held against seeds (located exactly), bodies (winding numbers) and the column (sides of the faces "
      "at them, verticals); suffixes and ids against their places");
}

}  // namespace

void check_region_names(const CheckedFaces& checked, const Allowed& allowed, CheckResult& result) {
  if (!checked.faces() || !checked.specification().named || checked.mesh().file.region.empty()) return;
  NameChecker(checked, allowed).check(result);
}

}  // namespace geomesh::geomodel::checking
