// SPDX-License-Identifier: GPL-3.0-or-later
#include "stack/merge_stack_reports.hpp"

#include <algorithm>
#include <cmath>

namespace geomesh::geomodel {
namespace {

template <class T>
T& named(std::vector<T>& all, const std::string& name) {
  const auto at = std::ranges::find(all, name, &T::name);
  if (at != all.end()) return *at;
  all.emplace_back().name = name;
  return all.back();
}

void merge(const SettledHorizon& block, SettledHorizon& whole) {
  const double moved = whole.area_moved + block.area_moved;
  if (moved > 0) whole.mean_move = (whole.area_moved * whole.mean_move + block.area_moved * block.mean_move) / moved;
  if (block.largest_move > whole.largest_move) {
    whole.largest_move = block.largest_move;
    whole.place = block.place;
  }
  whole.largest_off = std::max(whole.largest_off, block.largest_off);
  whole.area += block.area;
  whole.area_merged += block.area_merged;
  whole.area_above_topography += block.area_above_topography;
  whole.area_moved = moved;
}

void merge(const SettledUnit& block, SettledUnit& whole) {
  whole.top = block.top;
  whole.base = block.base;
  whole.area += block.area;
  whole.area_merged += block.area_merged;
  whole.volume += block.volume;
  whole.n_islands += block.n_islands;
  whole.largest_thickness = std::max(whole.largest_thickness, block.largest_thickness);
  whole.mean_thickness = whole.area > 0 ? whole.volume / whole.area : 0;
  whole.pinch_outs.insert(whole.pinch_outs.end(), block.pinch_outs.begin(), block.pinch_outs.end());
}

void lay_over(const ThicknessMaps& block, std::size_t from, ThicknessMaps& whole, std::size_t to) {
  const std::size_t n = block.n_columns * block.n_rows;
  whole.values.resize(std::max(whole.values.size(), to + 1), std::vector<double>(n, std::nan("")));
  for (std::size_t i = 0; i < n; ++i)
    if (std::isnan(whole.values[to][i])) whole.values[to][i] = block.values[from][i];
}

}  // namespace

void merge_stack_reports(const SettledStack& block, SettledStack& whole) {
  whole.settled = true;
  whole.min_thickness = block.min_thickness;
  for (const SettledHorizon& h : block.horizons) merge(h, named(whole.horizons, h.name));
  if (!block.units.empty()) {
    whole.maps.origin = block.maps.origin;
    whole.maps.step = block.maps.step;
    whole.maps.n_columns = block.maps.n_columns;
    whole.maps.n_rows = block.maps.n_rows;
  }
  for (std::size_t k = 0; k < block.units.size(); ++k) {
    SettledUnit& unit = named(whole.units, block.units[k].name);
    merge(block.units[k], unit);
    lay_over(block.maps, k, whole.maps, static_cast<std::size_t>(&unit - whole.units.data()));
  }
  whole.sizes.insert(whole.sizes.end(), block.sizes.begin(), block.sizes.end());
}

}  // namespace geomesh::geomodel
