// SPDX-License-Identifier: GPL-3.0-or-later
// Finds faults that end above or below a horizon across which they are meant to have throw, declared in
// geomesh/geomodel/model_rules.hpp. A vertex of the fault is above or below the horizon; beyond the horizon's extent in
// the map it is compared with the nearest vertex. All vertices must be on one side, none in a gap between blocks, and
// no triangle of the horizon may cross the fault.
#include <algorithm>

#include "geomesh/geomodel/model_rules.hpp"
#include "rules/planar/map_locator.hpp"
#include "rules/throw/fault_crossings.hpp"
#include "rules/throw/nearest_point.hpp"

namespace geomesh::geomodel {
namespace {

/// The heights of a horizon in the map; beyond its extent, the height of its nearest vertex.
class Heights {
 public:
  explicit Heights(const TriangulatedSurface& horizon)
      : horizon_(horizon), locator_(horizon), nearest_(flat(horizon.points)) {
    for (const Triangle& t : horizon.triangles)
      for (const VertexIndex v : t) extent_.add(horizon.points[v]);
  }

  /// Returns 1 if p is above all heights of the horizon at its place, -1 if below, 0 if neither or unknown.
  int side(const Vec3& p) const {
    bool above = true, below = true, found = false;
    locator_.for_each({p.x, p.y}, [&](Index triangle, bool) {
      const double height = locator_.height(triangle, {p.x, p.y});
      found = true;
      above = above && p.z > height;
      below = below && p.z < height;
    });
    if (!found) {
      const bool in_a_gap =
          p.x >= extent_.min.x && p.x <= extent_.max.x && p.y >= extent_.min.y && p.y <= extent_.max.y;
      if (in_a_gap) return 0;
      const Index v = nearest_.find({p.x, p.y, 0});
      if (v == no_index) return 0;
      above = p.z > horizon_.points[v].z;
      below = p.z < horizon_.points[v].z;
    }
    return above ? 1 : (below ? -1 : 0);
  }

 private:
  static std::vector<Vec3> flat(std::vector<Vec3> points) {
    for (Vec3& p : points) p.z = 0;
    return points;
  }
  const TriangulatedSurface& horizon_;
  Box3 extent_;
  MapLocator locator_;
  NearestPoint nearest_;
};

/// Returns 1 if all of the fault lies above the horizon, -1 if below, 0 if it reaches the horizon.
int side_of_fault(const TriangulatedSurface& horizon, const Heights& heights, const TriangulatedSurface& fault) {
  int side = 0;
  for (const Triangle& t : fault.triangles)
    for (const VertexIndex v : t) {
      const int here = heights.side(fault.points[v]);
      if (here == 0 || (side != 0 && here != side)) return 0;
      side = here;
    }
  const std::vector<ThrowFault> as_given{{&fault, static_cast<Index>(fault.triangles.size())}};
  const std::vector<Crossing> crossing = find_crossings(horizon, 0, as_given, everywhere);
  const bool crosses = std::any_of(crossing.begin(), crossing.end(), [](Crossing c) { return c != Crossing::none; });
  return crosses ? 0 : side;
}

}  // namespace

void leave_out_unreached_faults(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules,
                                std::vector<std::string>& warnings) {
  for (std::size_t s = 0; s < rules.surfaces.size() && s < surfaces.size(); ++s) {
    std::vector<std::string>& names = rules.surfaces[s].throw_at;
    if (names.empty() || surfaces[s].triangles.empty()) continue;
    const Heights heights(surfaces[s]);
    const auto is_unreached = [&](const std::string& name) {
      const auto fault = std::find_if(surfaces.begin(), surfaces.end(),
                                      [&](const TriangulatedSurface& other) { return other.name == name; });
      if (fault == surfaces.end()) return false;  // an unknown surface name is reported by build_surfaces()
      const auto row = static_cast<std::size_t>(fault - surfaces.begin());
      if (rules.of(row).extend != Extend::none) return false;
      const int side = side_of_fault(surfaces[s], heights, *fault);
      if (side == 0) return false;
      warnings.push_back("horizon " + surfaces[s].name + ": fault " + name + " of its throw_at ends " +
                         (side > 0 ? "above" : "below") + " it, so that it has no throw there (extent: to_box would " +
                         "continue the fault)");
      return true;
    };
    names.erase(std::remove_if(names.begin(), names.end(), is_unreached), names.end());
  }
}

}  // namespace geomesh::geomodel
