// SPDX-License-Identifier: GPL-3.0-or-later
// Rules after the arrangement, in order, declared in geomesh/geomodel/model_rules.hpp.
#include <algorithm>
#include <functional>
#include <map>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/model_rules.hpp"
#include "naming/region_facts.hpp"
#include "naming/sums.hpp"
#include "rules/part_blocks.hpp"
#include "rules/planar/pieces.hpp"

namespace geomesh::geomodel {

namespace {

/// Everything that trimming one soup needs.
class Trimmer {
 public:
  Trimmer(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
          const ModelRules& rules)
      : working_(soup), surfaces_(surfaces), built_(built), rules_(rules), removed_(surfaces.size(), 0) {}

  TrimmedSoup run() {
    end_at(rules_.topography, 1, "nothing is kept above the topography");
    end_at(rules_.floor, -1, "nothing is kept below the bottom of the model");
    stop_continuations();
    part_blocks({working_, surfaces_, built_, rules_, removed_, notes_, warnings_});
    order_horizons();
    for (Index s = 0; s < n_given(); ++s) cut_units_alone(s);
    if (rules_.trim_overshoot > 0) trim_overshoots();
    return {working_.result(), std::move(removed_), std::move(notes_), std::move(warnings_)};
  }

 private:
  Index row_of(const std::string& name) const {
    for (Index s = 0; s < surfaces_.size(); ++s)
      if (surfaces_[s].name == name) return s;
    throw Error(ErrorKind::usage, "no surface is named " + name + " (in a rule of the model)");
  }

  const UpwardSides& sides_of(Index s) {
    const auto at = sides_.find(s);
    return at != sides_.end() ? at->second : sides_.emplace(s, orient_upward(surfaces_[s])).first->second;
  }

  double remove(const Piece& piece, Index surface) {
    const double area = working_.remove(piece.facets, surface);
    removed_[surface] += area;
    return area;
  }

  Index n_given() const { return static_cast<Index>(built_.n_given_triangles.size()); }
  bool is_given(const PolygonSoup::Origin& o) const { return o.triangle < built_.n_given_triangles[o.surface]; }

  /// stop_at, targets first: what ends on a surface that ends itself does not go on beyond what is left of that one.
  void stop_continuations() {
    std::vector<bool> done(n_given(), false);
    const std::function<void(Index)> stop = [&](Index s) {
      if (s >= n_given() || done[s]) return;
      done[s] = true;
      const std::string target = rules_.of(s).stop_at;
      if (target.empty()) return;
      stop(row_of(target));
      stop_at(s, row_of(target));
    };
    for (Index s = 0; s < n_given(); ++s) stop(s);
  }

  /// Pieces beyond the target that the continuation alone made go.
  void stop_at(Index s, Index target) {
    double area = 0;
    std::size_t n = 0;
    for (const Piece& piece : pieces_of(working_, s, {target}, nullptr)) {
      const bool given = std::any_of(piece.facets.begin(), piece.facets.end(),
                                     [&](Index f) { return is_given(*working_.origin_of(f, s)); });
      if (given) continue;
      area += remove(piece, s);
      ++n;
    }
    if (n > 0)
      notes_.push_back("surface " + surfaces_[s].name + " ends at " + surfaces_[target].name + ": " +
                       std::to_string(n) + " continued pieces beyond it removed (area " + to_text(area) + ")");
  }

  /// cut_units: pieces of a fault above the units that it cuts, or below them, go.
  void cut_units_alone(Index s) {
    const std::vector<std::string> units = rules_.of(s).cut_units;
    if (units.empty()) return;
    const auto unit_row = [&](const std::string& name) {
      return static_cast<std::size_t>(std::find(rules_.column.begin(), rules_.column.end(), name) -
                                      rules_.column.begin()) /
             2;
    };
    std::size_t first = rules_.column.size(), last = 0;
    for (const std::string& unit : units) {
      first = std::min(first, unit_row(unit));
      last = std::max(last, unit_row(unit));
    }
    const std::string because = "fault " + surfaces_[s].name + " cuts " + units.front() +
                                (units.size() > 1 ? " to " + units.back() : "") + " alone";
    for (std::size_t h = 0; 2 * h + 1 < rules_.column.size(); ++h) {
      const Index horizon = row_of(rules_.column[2 * h + 1]);
      if (h < first) clip(s, horizon, 1, because);
      if (h >= last) clip(s, horizon, -1, because);
    }
  }

  /// Removes the pieces of x on one side of y (1 above, -1 below).
  void clip(Index x, Index y, int side, const std::string& because) {
    double area = 0;
    Index largest = no_index;
    const UpwardSides& sides = sides_of(y);
    std::vector<Piece> gone;
    for (Piece& piece : pieces_of(working_, x, {y}, &sides))
      if (side_of(working_, piece, y, sides) == side) gone.push_back(std::move(piece));
    for (const Piece& piece : gone) {
      if (largest == no_index || working_.area(piece.largest) > working_.area(largest)) largest = piece.largest;
      area += remove(piece, x);
    }
    if (!gone.empty())
      notes_.push_back(because + ": " + std::to_string(gone.size()) + " pieces of " + surfaces_[x].name +
                       (side > 0 ? " above " : " below ") + surfaces_[y].name + " removed (area " + to_text(area) +
                       ", near " + to_text(working_.centre(largest)) + ")");
  }

  /// Parts of all other surfaces on one side of the one named go; box sides go with the tetrahedra.
  void end_at(const std::string& name, int side, const std::string& because) {
    if (name.empty()) return;
    const Index end = row_of(name);
    for (Index s = 0; s < surfaces_.size(); ++s)
      if (s != end && surfaces_[s].kind != SurfaceKind::box) clip(s, end, side, because);
  }

  bool cross(Index younger, Index older) {
    const UpwardSides& sides = sides_of(older);
    for (const Piece& piece : pieces_of(working_, younger, {older}, &sides))
      if (piece.contact > 0 && piece.below > piece.above) {
        crossing_area_ += piece.area;
        crossing_place_ = working_.centre(piece.largest);
      }
    return crossing_area_ > 0;
  }

  void order_horizons() {
    std::vector<Index> horizons;  // youngest first
    for (std::size_t i = 1; i < rules_.column.size(); i += 2) horizons.push_back(row_of(rules_.column[i]));
    for (std::size_t i = 0; i < horizons.size(); ++i) {
      for (std::size_t k = i + 1; k < horizons.size(); ++k) {
        const Index younger = horizons[i], older = horizons[k];
        if (rules_.of(younger).base == BaseRule::erode) {
          clip(older, younger, 1, surfaces_[younger].name + " erodes");
        } else if (rules_.of(older).base == BaseRule::onlap) {
          clip(younger, older, -1, surfaces_[younger].name + " onlaps");
        } else if (rules_.on_crossing == OnCrossing::clip_older) {
          clip(older, younger, 1, "crossing resolved for the younger horizon");
        } else if (rules_.on_crossing == OnCrossing::clip_younger) {
          clip(younger, older, -1, "crossing resolved for the older horizon");
        } else if (rules_.on_crossing == OnCrossing::error && cross(younger, older)) {
          throw Error(ErrorKind::invalid_input,
                      "horizon " + surfaces_[younger].name + " runs below the older horizon " + surfaces_[older].name +
                          " over an area of " + to_text(crossing_area_) + " near " + to_text(crossing_place_) +
                          "; correct one of them, or choose on_crossing: clip_younger or clip_older",
                      {{}, {}, {}, {crossing_place_}});
        }
      }
    }
  }

  /// The furthest that a piece reaches from the edges where it meets other surfaces than box sides.
  double reach(const Piece& piece, const std::vector<std::pair<VertexIndex, VertexIndex>>& contacts) const {
    const auto distance = [&](const Vec3& p) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const auto& [i, j] : contacts) {
        const Vec3 &a = working_.soup.points[i], d = working_.soup.points[j] - a;
        const double t = std::clamp(dot(p - a, d) / dot(d, d), 0.0, 1.0);
        nearest = std::min(nearest, norm(p - (a + t * d)));
      }
      return nearest;
    };
    double furthest = 0;
    for (const Index f : piece.facets) {
      const Triangle& t = working_.soup.facets[f];
      const Vec3 &a = working_.soup.points[t[0]], &b = working_.soup.points[t[1]], &c = working_.soup.points[t[2]];
      // A strip between two surfaces has all its corners on them: its middle tells how wide it is.
      for (const Vec3& p : {a, b, c, 0.5 * (a + b), 0.5 * (b + c), 0.5 * (c + a), (1.0 / 3) * (a + b + c)})
        furthest = std::max(furthest, distance(p));
    }
    return furthest;
  }

  /// Pieces of horizons and faults that hang on another surface by one side, end freely and reach no further than
  /// trim_overshoot.
  void trim_overshoots() {
    for (Index s = 0; s < surfaces_.size(); ++s) {
      if (surfaces_[s].kind != SurfaceKind::horizon && surfaces_[s].kind != SurfaceKind::fault) continue;
      std::vector<Index> cutters;
      for (Index c = 0; c < surfaces_.size(); ++c)
        if (c != s && surfaces_[c].kind != SurfaceKind::box) cutters.push_back(c);
      const std::vector<Piece> pieces = pieces_of(working_, s, cutters, nullptr);
      double largest = 0, area = 0;
      for (const Piece& piece : pieces) largest = std::max(largest, piece.area);
      std::size_t n = 0;
      Vec3 place;
      for (const Piece& piece : pieces) {
        if (piece.free_border == 0 || piece.contact == 0 || piece.area == largest) continue;
        if (reach(piece, contacts_of(piece, s)) > rules_.trim_overshoot) continue;
        place = working_.centre(piece.largest);
        area += remove(piece, s);
        ++n;
      }
      if (n > 0)
        notes_.push_back("surface " + surfaces_[s].name + ": " + std::to_string(n) +
                         " overshooting pieces removed (area " + to_text(area) + ", one near " + to_text(place) + ")");
    }
  }

  std::vector<std::pair<VertexIndex, VertexIndex>> contacts_of(const Piece& piece, Index s) const {
    std::vector<std::pair<VertexIndex, VertexIndex>> contacts;
    for_each_edge(working_.uses, [&](std::span<const EdgeUse> edge) {
      bool mine = false, other = false;
      for (const EdgeUse& u : edge) {
        mine = mine || std::binary_search(piece.facets.begin(), piece.facets.end(), u.facet);
        other = other ||
                std::any_of(working_.origins[u.facet].begin(), working_.origins[u.facet].end(), [&](const auto& o) {
                  return o.surface != s && surfaces_[o.surface].kind != SurfaceKind::box;
                });
      }
      if (mine && other) contacts.emplace_back(edge[0].a, edge[0].b);
    });
    return contacts;
  }

  WorkingSoup working_;
  const std::vector<TriangulatedSurface>& surfaces_;
  const BuiltRows& built_;
  const ModelRules& rules_;
  std::vector<double> removed_;  ///< area, per surface
  std::map<Index, UpwardSides> sides_;
  std::vector<std::string> notes_, warnings_;
  double crossing_area_ = 0;
  Vec3 crossing_place_;
};

}  // namespace

TrimmedSoup trim_soup(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                      const ModelRules& rules) {
  return Trimmer(soup, surfaces, built, rules).run();
}

}  // namespace geomesh::geomodel
