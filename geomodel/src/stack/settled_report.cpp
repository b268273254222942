// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/settled_report.hpp"

#include <algorithm>
#include <cmath>

#include "common/by_rounding.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "stack/sheets/sheet_locator.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double most_pixels = 160;  // number of pixels of a thickness map along its longer side

double area_of(const MapSheets& sheets, const Triangle& t) {
  const Vec2 &a = sheets.points[t[0]], &b = sheets.points[t[1]], &c = sheets.points[t[2]];
  return 0.5 * ((b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x));
}

bool is_there(const MapSheets& sheets, const Triangle& t, std::size_t horizon) {
  return std::none_of(t.begin(), t.end(), [&](VertexIndex v) { return std::isnan(sheets.height(v, horizon)); });
}

Vec3 centre_of(const MapSheets& sheets, const Triangle& t, std::size_t horizon) {
  Vec3 sum{0, 0, 0};
  for (const VertexIndex v : t) sum = sum + Vec3{sheets.points[v].x, sheets.points[v].y, sheets.height(v, horizon)};
  return (1.0 / 3) * sum;
}

/// Sums the areas and volumes of horizons and units, which follow from the triangles alone.
void sum_triangles(const MapSheets& sheets, const SettledFrom& from, SettledStack& stack) {
  for (std::size_t f = 0; f < sheets.triangles.size(); ++f) {
    const Triangle& t = sheets.triangles[f];
    const double area = area_of(sheets, t);
    for (std::size_t k = 0; k < sheets.n_horizons; ++k) {
      if (!is_there(sheets, t, k) || (from.counts && !from.counts(centre_of(sheets, t, k)))) continue;
      stack.horizons[k].area += area;
      const bool above = k > 0 && (sheets.merged[f] >> (k - 1) & 1), below = sheets.merged[f] >> k & 1;
      if (above || below) stack.horizons[k].area_merged += area;
      if (k + 1 == sheets.n_horizons || !is_there(sheets, t, k + 1)) continue;
      SettledUnit& unit = stack.units[k];
      double thickness = 0;
      for (const VertexIndex v : t) {
        const double at = sheets.height(v, k) - sheets.height(v, k + 1);
        thickness += at / 3;
        unit.largest_thickness = std::max(unit.largest_thickness, at);
      }
      unit.volume += area * thickness;
      (thickness > 0 ? unit.area : unit.area_merged) += area;
    }
  }
  for (SettledUnit& unit : stack.units) unit.mean_thickness = unit.area > 0 ? unit.volume / unit.area : 0;
}

/// Measures how far the input's points were moved. Each point represents an equal share of its horizon's area.
void measure_moves(const MapSheets& sheets, const SettledFrom& from, const SheetLocator& locator, SettledStack& stack) {
  const MapSamples& samples = from.samples;
  std::vector<std::size_t> n(sheets.n_horizons, 0), n_moved(sheets.n_horizons, 0), n_above(sheets.n_horizons, 0);
  std::vector<double> sum(sheets.n_horizons, 0);
  for (std::size_t s = 0; s < samples.size(); ++s) {
    const Vec2 p = samples.place(s);
    const SheetLocator::Place at = locator.find(p);
    if (at.triangle == no_index || from.strips.holds(p)) continue;
    for (std::size_t k = 0; k < sheets.n_horizons; ++k) {
      const double given = samples.heights(s)[k], move = std::abs(locator.height(at, k) - given);
      if (std::isnan(move) || (from.counts && !from.counts({p.x, p.y, given}))) continue;
      SettledHorizon& told = stack.horizons[k];
      ++n[k];
      if (from.has_topography && given > samples.heights(s)[0]) {
        ++n_above[k];
        continue;
      }
      if (move <= from.options.allowed * (1 + by_rounding)) {
        told.largest_off = std::max(told.largest_off, move);
        continue;
      }
      ++n_moved[k];
      sum[k] += move;
      if (move > told.largest_move) {
        told.largest_move = move;
        told.place = {p.x, p.y, given};
      }
    }
  }
  for (std::size_t k = 0; k < sheets.n_horizons; ++k) {
    if (n[k] == 0) continue;
    const double share = stack.horizons[k].area / static_cast<double>(n[k]);
    stack.horizons[k].area_above_topography = share * static_cast<double>(n_above[k]);
    if (n_moved[k] == 0) continue;
    stack.horizons[k].mean_move = sum[k] / static_cast<double>(n_moved[k]);
    stack.horizons[k].area_moved = share * static_cast<double>(n_moved[k]);
  }
}

void draw_maps(const SheetLocator& locator, const MapBounds& bounds, SettledStack& stack) {
  ThicknessMaps& maps = stack.maps;
  const double width = bounds.max.x - bounds.min.x, height = bounds.max.y - bounds.min.y;
  maps.step = std::max(width, height) / most_pixels;
  maps.n_columns = static_cast<std::size_t>(std::max(1.0, std::floor(width / maps.step)));
  maps.n_rows = static_cast<std::size_t>(std::max(1.0, std::floor(height / maps.step)));
  maps.origin = {bounds.min.x + 0.5 * maps.step, bounds.min.y + 0.5 * maps.step};
  maps.values.resize(stack.units.size());
  for (std::size_t j = 0; j < maps.n_rows; ++j)
    for (std::size_t i = 0; i < maps.n_columns; ++i) {
      const Vec2 p{maps.origin.x + maps.step * static_cast<double>(i),
                   maps.origin.y + maps.step * static_cast<double>(j)};
      const SheetLocator::Place at = locator.find(p);
      for (std::size_t k = 0; k < maps.values.size(); ++k) {
        double thickness = std::nan("");
        if (at.triangle != no_index) thickness = locator.height(at, k) - locator.height(at, k + 1);
        maps.values[k].push_back(thickness);
      }
    }
}

}  // namespace

SettledStack describe_settled(const MapSheets& sheets, const SettledFrom& from) {
  SettledStack stack;
  stack.settled = true;
  stack.horizons.resize(sheets.n_horizons);
  stack.units.resize(sheets.n_horizons - 1);
  for (std::size_t k = 0; k < from.areas.size(); ++k) {
    stack.units[k].n_islands = from.areas[k].n_islands;
    stack.units[k].pinch_outs = from.areas[k].curves;
  }
  sum_triangles(sheets, from, stack);
  const SheetLocator locator(sheets);
  measure_moves(sheets, from, locator, stack);
  draw_maps(locator, from.bounds, stack);
  return stack;
}

std::vector<std::string> notes_of(const SettledStack& stack) {
  std::vector<std::string> notes;
  for (const SettledHorizon& h : stack.horizons) {
    std::string text = "horizon " + h.name + ": settled in the stack, " + std::to_string(h.n_triangles_given) +
                       " triangles became " + std::to_string(h.n_triangles) + ", within " + to_text(h.largest_off) +
                       " m";
    if (h.area_merged > 0) text += "; shares one surface with a neighbour over an area of " + to_text(h.area_merged);
    if (h.area_above_topography > 0)
      text += "; cut off above the topography over an area of " + to_text(h.area_above_topography);
    if (h.area_moved > 0)
      text += "; moved over an area of " + to_text(h.area_moved) + " by " + to_text(h.mean_move) +
              " m in the mean, at most " + to_text(h.largest_move) + " m near " + to_text(h.place);
    if (h.area_at_faults > 0)
      text += "; made anew from both sides of its faults over an area of " + to_text(h.area_at_faults) +
              ", where order moved it by " + to_text(h.largest_move_at_faults) + " m at most" +
              (h.largest_move_at_faults > 0 ? " near " + to_text(h.place_at_faults) : std::string());
    notes.push_back(text);
  }
  for (const SettledUnit& u : stack.units)
    if (u.area_merged > 0)
      notes.push_back("unit " + u.name + " is thinner than " + to_text(stack.min_thickness) +
                      " m, and left out, over an area of " + to_text(u.area_merged) + "; it is there over an area of " +
                      to_text(u.area) + ", " + to_text(u.mean_thickness) + " m thick in the mean");
  if (!stack.sizes.empty()) {
    const auto shorter = [](const SizeSource& a, const SizeSource& b) { return a.size < b.size; };
    notes.push_back("thin units of the stack require edges down to " +
                    to_text(std::min_element(stack.sizes.begin(), stack.sizes.end(), shorter)->size) +
                    " m (rules.min_thickness sets how thin a unit can be)");
  }
  return notes;
}

std::vector<ToleranceUse> uses_of(const SettledStack& stack) {
  ToleranceUse whole{"settling", stack_share * stack.tolerance};
  whole.moved = 0;
  std::vector<ToleranceUse> uses;
  for (const SettledHorizon& h : stack.horizons) {
    if (h.largest_off > *whole.moved) whole.moved = h.largest_off, whole.surface = h.name;
    if (!(h.area_moved > 0)) continue;
    ToleranceUse& beyond = uses.emplace_back(ToleranceUse{"order and thickness"});
    beyond.moved = h.largest_move;
    beyond.surface = h.name;
    beyond.place = h.place;
  }
  uses.insert(uses.begin(), std::move(whole));
  return uses;
}

}  // namespace geomesh::geomodel
