// SPDX-License-Identifier: GPL-3.0-or-later
#include "rules/continuation/apron.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include "rules/continuation/chain_in_plane.hpp"
#include "rules/planar/planar_fill.hpp"

namespace geomesh::geomodel {
namespace {

/// Least share of the distance by which points of the grid are apart: an apron has at most some ten rows.
constexpr double least_step = 1.0 / 8;
/// Grid points come no nearer to the border than this share of their distance from each other.
constexpr double room_at_border = 0.5;

using Corners = std::array<Index, 3>;

class ApronMaker {
 public:
  ApronMaker(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
             const ApronSetting& setting)
      : surface_(surface),
        row_(row),
        border_(chain),
        walls_(walls),
        frame_(setting.frame),
        within_(setting.within),
        bounds_(setting.bounds),
        chain_(surface, chain, setting.frame, setting.within),
        step_(std::clamp(chain_.mean_edge(), least_step * within_, within_)) {}

  Apron make() {
    for (const Vec3& p : chain_.points()) add({p.x, p.y}, p.z, {0, 0, p});
    add_grid();
    if (places_.size() == chain_.points().size()) return {};
    find_triangles();
    find_seen();
    leave_out_open();
    return result();
  }

 private:
  /// What a point has nearest on the border.
  struct Border {
    double distance;
    Index edge;
    Vec3 foot;  ///< in the frame
  };
  void add(const Vec2& place, double height, const Border& nearest) {
    places_.push_back(place);
    points_.push_back(frame_.to_model({place.x, place.y, height}));
    distance_.push_back(nearest.distance);
    edge_.push_back(nearest.edge);
    feet_.push_back(frame_.to_model(nearest.foot));
  }

  /// Points beside the chain on a grid whose origin depends on the place in space alone.
  void add_grid() {
    Vec2 low = places_.front(), high = low;
    for (const Vec2& p : places_) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double reach = within_ + step_;
    const auto first = [&](double v) { return static_cast<std::int64_t>(std::floor((v - reach) / step_)); };
    const auto last = [&](double v) { return static_cast<std::int64_t>(std::ceil((v + reach) / step_)); };
    for (std::int64_t j = first(low.y); j <= last(high.y); ++j)
      for (std::int64_t i = first(low.x); i <= last(high.x); ++i) {
        const Vec2 p{static_cast<double>(i) * step_, static_cast<double>(j) * step_};
        const auto at = chain_.nearest(p);
        if (!at || at->distance < room_at_border * step_ || at->distance > reach || !chain_.is_outside(p, *at))
          continue;
        add(p, chain_.height(p, *at), {at->distance, at->edge, chain_.foot(*at)});
      }
  }

  void find_triangles() {
    std::vector<std::pair<Index, Index>> constraints;
    for (std::size_t e = 0; e < chain_.n_edges(); ++e)
      constraints.emplace_back(static_cast<Index>(e), static_cast<Index>(chain_.end_of(e)));
    const auto all = triangulate_plane(places_, constraints);
    if (!all) return;
    for (const PlanarTriangle& t : *all) {
      const auto& v = t.vertices;
      const Vec2 centre{(places_[v[0]].x + places_[v[1]].x + places_[v[2]].x) / 3,
                        (places_[v[0]].y + places_[v[1]].y + places_[v[2]].y) / 3};
      const auto at = chain_.nearest(centre);
      if (at && at->distance <= within_ + step_ && chain_.is_outside(centre, *at)) triangles_.push_back(v);
    }
  }

  /// Which points the nearest place of the border sees past all walls.
  void find_seen() {
    is_seen_.assign(places_.size(), 1);
    for (std::size_t v = chain_.points().size(); v < places_.size(); ++v) {
      // What lies beyond the sides of the model is cut off there in any case.
      const auto hit = walls_.first_surface(feet_[v], points_[v], row_);
      if (!hit) continue;
      is_seen_[v] = 0;
      crossed_.insert(hit->surface);
    }
  }

  bool is_in_model(Index v) const {
    const Vec3& p = points_[v];
    return p.x > bounds_.min.x && p.y > bounds_.min.y && p.z > bounds_.min.z && p.x < bounds_.max.x &&
           p.y < bounds_.max.y && p.z < bounds_.max.z;
  }

  /// Where a point of the model beyond the distance is seen no wall stops the surface: the border stays open there.
  void leave_out_open() {
    const auto n_border = static_cast<Index>(chain_.points().size());
    std::vector<std::uint8_t> is_open(chain_.n_edges(), 0);
    for (Index v = n_border; v < places_.size(); ++v)
      if (is_seen_[v] && distance_[v] > within_ && is_in_model(v)) is_open[edge_[v]] = 1;
    const auto is_seen_and_closed = [&](const Corners& t) {
      return std::any_of(t.begin(), t.end(), [&](Index v) { return is_seen_[v]; }) && !touches_open(t, is_open);
    };
    std::set<std::pair<Index, Index>> sides;  // of triangles of which a corner is seen
    for (const Corners& t : triangles_)
      if (is_seen_and_closed(t))
        for (std::size_t i = 0; i < 3; ++i) sides.insert(std::minmax(t[i], t[(i + 1) % 3]));
    // Of a triangle beside these an inner part may be seen though no corner is: where two walls meet, say.
    std::erase_if(triangles_, [&](const Corners& t) {
      bool is_beside = false;
      for (std::size_t i = 0; i < 3; ++i) is_beside = is_beside || sides.contains(std::minmax(t[i], t[(i + 1) % 3]));
      return !is_beside || touches_open(t, is_open);
    });
  }

  bool touches_open(const Corners& t, const std::vector<std::uint8_t>& is_open) const {
    return std::any_of(t.begin(), t.end(), [&](Index v) { return v >= chain_.points().size() && is_open[edge_[v]]; });
  }

  Apron result() const {
    Apron apron;
    std::vector<VertexIndex> row(places_.size(), no_vertex);
    for (std::size_t k = 0; k < border_.vertices.size(); ++k) row[k] = border_.vertices[k];
    const bool up = faces_up();
    for (const auto& t : triangles_) {
      Triangle own;
      for (std::size_t i = 0; i < 3; ++i) {
        if (row[t[i]] == no_vertex) {
          row[t[i]] = static_cast<VertexIndex>(surface_.points.size() + apron.added.size());
          apron.added.push_back(points_[t[i]]);
        }
        own[i] = row[t[i]];
      }
      if (!up) std::swap(own[1], own[2]);
      apron.triangles.push_back(own);
    }
    apron.walls.assign(crossed_.begin(), crossed_.end());
    return apron;
  }

  /// Whether the surface's triangles at the chain are counter-clockwise in the frame, for most of the chain.
  bool faces_up() const {
    double up = 0;
    for (const Index t : border_.triangles) {
      const Triangle& v = surface_.triangles[t];
      const Vec3 a = frame_.to_frame(surface_.points[v[0]]), b = frame_.to_frame(surface_.points[v[1]]),
                 c = frame_.to_frame(surface_.points[v[2]]);
      up += cross(b - a, c - a).z;
    }
    return up >= 0;
  }

  const TriangulatedSurface& surface_;
  Index row_;
  const BorderChain& border_;
  const Walls& walls_;
  const Frame& frame_;
  double within_;
  const Box3& bounds_;
  ChainInPlane chain_;
  double step_;
  std::vector<Vec2> places_;  ///< the chain's vertices, then the grid's
  std::vector<Vec3> points_;  ///< in the model
  std::vector<double> distance_;
  std::vector<Index> edge_;  ///< the nearest one of the chain
  std::vector<Vec3> feet_;   ///< nearest places of the border, in the model
  std::vector<Corners> triangles_;
  std::vector<std::uint8_t> is_seen_;
  std::set<Index> crossed_;
};

}  // namespace

Apron make_apron(const TriangulatedSurface& surface, Index row, const BorderChain& chain, const Walls& walls,
                 const ApronSetting& setting) {
  return ApronMaker(surface, row, chain, walls, setting).make();
}

}  // namespace geomesh::geomodel
