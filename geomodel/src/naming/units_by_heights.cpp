// SPDX-License-Identifier: GPL-3.0-or-later
#include "naming/units_by_heights.hpp"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <utility>

namespace geomesh::geomodel {

namespace {

constexpr std::size_t most_asked = 64;   // largest number of tetrahedra sampled in a component
constexpr double least_majority = 0.75;  // share of conclusive samples, by volume, that must agree on one unit
constexpr double least_telling = 0.25;   // least volume of conclusive samples, relative to all samples of the component

/// The units that the horizons leave possible at one of the component's largest tetrahedra, and its volume.
struct Answer {
  UnitRange units{};
  double volume = 0;
};

/// Returns, for each of the component's largest tetrahedra, the units that `units_at` allows there and that are within
/// `possible`; the range is empty if none is. Moves the largest of `cells` to its front.
std::vector<Answer> answers_of(std::vector<std::pair<double, Index>>& cells, const ConstrainedTetrahedralization& mesh,
                               const std::function<UnitRange(const Vec3&)>& units_at, const UnitRange& possible) {
  const std::size_t n = std::min(cells.size(), most_asked);
  std::partial_sort(
      cells.begin(), cells.begin() + static_cast<std::ptrdiff_t>(n), cells.end(),
      [](const auto& a, const auto& b) { return a.first != b.first ? a.first > b.first : a.second < b.second; });
  std::vector<Answer> answers;
  for (std::size_t k = 0; k < n; ++k) {
    const Tetrahedron& v = mesh.tetrahedra[cells[k].second];
    const Vec3 centre = 0.25 * ((mesh.points[v[0]] + mesh.points[v[1]]) + (mesh.points[v[2]] + mesh.points[v[3]]));
    const UnitRange at = units_at(centre);
    answers.push_back({{std::max(at.first, possible.first), std::min(at.last, possible.last)}, cells[k].first});
  }
  return answers;
}

/// Returns the total volume of the sampled tetrahedra whose possible units satisfy `counts`.
template <class Predicate>
double volume_of(const std::vector<Answer>& answers, const Predicate& counts) {
  double volume = 0;
  for (const Answer& answer : answers)
    if (counts(answer.units)) volume += answer.volume;
  return volume;
}

/// Each sampled tetrahedron has a range of units that the horizons leave possible there. If most of the tetrahedra
/// whose range is a single unit agree on it, by volume, returns that unit. Otherwise drops units from the ends of
/// `possible` that most of the ranges other than `possible` exclude. Returns `possible` if too few ranges differ from
/// it.
UnitRange most_agree_on(const std::vector<Answer>& answers, const UnitRange& possible) {
  const double all = volume_of(answers, [](const UnitRange&) { return true; });
  const auto tells_one = [](const UnitRange& units) { return units.first >= units.last; };  // empty ranges, too
  const auto tells = [&](const UnitRange& units) { return units != possible; };
  const double of_one = volume_of(answers, tells_one), telling = volume_of(answers, tells);
  for (Index unit = possible.first; unit <= possible.last && of_one >= least_telling * all; ++unit)
    if (volume_of(answers, [&](const UnitRange& units) {
          return units == UnitRange{unit, unit};
        }) >= least_majority * of_one)
      return {unit, unit};
  if (telling == 0 || telling < least_telling * all) return possible;
  const auto most = [&](const auto& counts) {
    return volume_of(answers, [&](const UnitRange& units) {
             return tells(units) && !units.empty() && counts(units);
           }) >= least_majority * telling;
  };
  UnitRange left = possible;
  while (left.first < possible.last && most([&](const UnitRange& units) { return units.first > left.first; }))
    ++left.first;
  while (left.last > possible.first && most([&](const UnitRange& units) { return units.last < left.last; }))
    --left.last;
  return left.empty() ? possible : left;
}

/// Restricts the verdict on a component's unit to the range `left`, which the order of deposition of the horizons
/// leaves possible.
void narrow(UnitVerdict& verdict, const UnitRange& possible, const UnitRange& left) {
  if (left == possible) return;
  if (left.first == left.last) {
    verdict.first = verdict.last = left.first;
    verdict.by_heights = true;
    return;
  }
  const Index nearest = std::clamp(verdict.first, left.first, left.last);
  if (verdict.kind == UnitVerdict::Kind::vertical) verdict.by_heights = nearest != verdict.first;
  verdict.first = verdict.last = nearest;
  verdict.first_possible = left.first;
  verdict.last_possible = left.last;
}

}  // namespace

void find_units_by_heights(const ConstrainedTetrahedralization& mesh, const NamingRules& rules, const Column& column,
                           std::vector<UnitVerdict>& verdicts) {
  if (!rules.units_at) return;
  // Volume and index of the tetrahedra of each component that is sampled.
  std::map<Index, std::vector<std::pair<double, Index>>> cells;
  for (std::size_t c = 0; c < verdicts.size(); ++c)
    if (verdicts[c].kind == UnitVerdict::Kind::incomplete || verdicts[c].kind == UnitVerdict::Kind::vertical)
      cells[static_cast<Index>(c)];
  if (cells.empty()) return;
  for (Index t = 0; t < mesh.tetrahedra.size(); ++t) {
    const auto at = cells.find(mesh.component[t]);
    if (at == cells.end()) continue;
    const Tetrahedron& v = mesh.tetrahedra[t];
    const Vec3 &a = mesh.points[v[0]], &b = mesh.points[v[1]], &c = mesh.points[v[2]], &d = mesh.points[v[3]];
    at->second.emplace_back(std::abs(dot(b - a, cross(c - a, d - a))), t);
  }
  for (auto& [c, volumes] : cells) {
    UnitVerdict& verdict = verdicts[c];
    UnitRange possible{0, static_cast<Index>(column.horizons.size())};
    if (verdict.kind == UnitVerdict::Kind::incomplete) possible = {verdict.first_possible, verdict.last_possible};
    narrow(verdict, possible, most_agree_on(answers_of(volumes, mesh, rules.units_at, possible), possible));
  }
}

}  // namespace geomesh::geomodel
