// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The heights of several single-valued horizons at places of the map.
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "geomesh/geomodel/surface.hpp"
#include "rules/planar/map_locator.hpp"

namespace geomesh::geomodel {

struct MapBounds {
  Vec2 min{1, 1}, max{0, 0};
  void add(Vec2 p);
  bool empty() const { return min.x > max.x; }
  bool holds(Vec2 p) const { return p.x >= min.x && p.x <= max.x && p.y >= min.y && p.y <= max.y; }
  MapBounds grown(double by) const { return {{min.x - by, min.y - by}, {max.x + by, max.y + by}}; }
};

/// Returns the distance between places of the map at which heights of horizons are compared: an eighth of the target
/// size, so that no element fits between them, or more if there would be more than 250,000 places.
double step_between_places(const MapBounds& bounds, double size);

/// All places within bounds at which at least one of the surfaces has a vertex, each once, with the heights of all
/// surfaces at the place. The surfaces must outlive this object.
class MapSamples {
 public:
  MapSamples(const std::vector<const TriangulatedSurface*>& surfaces, const MapBounds& bounds);

  std::size_t size() const { return places_.size(); }
  std::size_t n_surfaces() const { return locators_.size(); }
  const TriangulatedSurface& surface(std::size_t k) const { return *surfaces_[k]; }
  Vec2 place(std::size_t sample) const { return places_[sample]; }
  /// Returns the height of each surface at a sample's place, NaN where the surface is absent.
  std::span<const double> heights(std::size_t sample) const {
    return {heights_.data() + sample * n_surfaces(), n_surfaces()};
  }
  /// Returns the distance beside a surface up to which a place counts as on the surface's border.
  double border_reach() const;
  /// Computes the height of each surface at any place, on its triangles.
  void heights_at(Vec2 p, std::span<double> heights) const;
  /// Computes the height of each surface at a place from a plane fitted by least squares to the samples within
  /// `radius`; from the triangles if there are fewer than six samples.
  void fitted_heights(Vec2 p, double radius, std::span<double> heights) const;
  bool covers(std::size_t surface, Vec2 p) const { return locators_[surface]->find(p).count > 0; }
  /// Returns whether two triangles of the surface lie above each other at some sample that is inside both.
  bool overhangs(std::size_t surface) const { return overhangs_[surface]; }
  double spacing() const { return spacing_; }

 private:
  void collect(const std::vector<const TriangulatedSurface*>& surfaces, const MapBounds& bounds);
  void fill_bins(const MapBounds& bounds);
  std::size_t bin_of(double at, double from, std::size_t n) const;

  std::vector<const TriangulatedSurface*> surfaces_;
  std::vector<std::unique_ptr<MapLocator>> locators_;
  std::vector<Vec2> places_;
  std::vector<double> heights_;
  std::vector<char> overhangs_;
  double spacing_ = 0;
  MapBounds bounds_;
  std::size_t n_columns_ = 1, n_rows_ = 1;
  std::vector<Index> bin_begin_, binned_;  ///< samples by bin
};

}  // namespace geomesh::geomodel
