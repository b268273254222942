// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the elements of fault zones in the mesh, declared in check/zones/check_zones.hpp.
#include "check/zones/check_zones.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

#include "check/mesh/faults.hpp"
#include "check/mesh/walls.hpp"
#include "check/zones/zone_names.hpp"
#include "naming/sums.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// Largest factor by which a fault zone's thickness at one face may deviate, and largest relative deviation of the
/// whole zone's volume divided by area.
constexpr double most_by_face = 2, most_in_all = 0.125;

struct Seen {
  std::set<VertexIndex> minus, plus;  ///< nodes of the fault zone's two walls
  /// Actual and required volume of the fault zone. Required is the area of the minus wall times the thickness, less at
  /// ends.
  CompensatedSum volume, due;
  std::map<VertexIndex, std::set<VertexIndex>> edges;  ///< of its elements
};

class ZoneChecker {
 public:
  ZoneChecker(const CheckedMesh& mesh, const FacesFile& faces, const std::vector<FaultZone>& zones)
      : mesh_(mesh), faces_(faces), zones_(zones), faults_(faults_of(zones)), seen_(zones.size()) {
    const auto ids = zone_ids(mesh.file.region_names, zones);
    for (std::size_t t = 0; t < mesh.cells.size(); ++t)
      if (const auto zone = ids.find(mesh.file.region[t]); zone != ids.end()) see(mesh.cells[t], seen_[zone->second]);
    for (std::size_t f = 0; f < faces.triangles.size(); ++f)
      if (const auto zone = ids.find(faces.region_plus[f]); zone != ids.end()) see_wall(f, zone->second);
  }

  void check(CheckResult& result) {
    for (std::size_t z = 0; z < zones_.size(); ++z) {
      if (seen_[z].edges.empty() || seen_[z].minus.empty() || seen_[z].plus.empty()) {
        wrong_.add(z, {});
        continue;
      }
      check_faces(z);
      check_volume(z);
      check_layers(z);
    }
    wrong_.report(result,
                  "places of fault zones are not as the project asks: no such region between two walls of the fault, "
                  "another thickness, or another number of layers");
    result.checks_done.push_back(std::to_string(zones_.size()) +
                                 " fault zones: walls as far apart and with as many layers between as requested" +
                                 seen_text_);
  }

 private:
  void see(const Tetrahedron& t, Seen& seen) {
    seen.volume.add(signed_volume(mesh_.point(t[0]), mesh_.point(t[1]), mesh_.point(t[2]), mesh_.point(t[3])));
    for (const VertexIndex a : t)
      for (const VertexIndex b : t)
        if (a != b) seen.edges[a].insert(b);
  }
  void see_wall(std::size_t f, std::size_t zone) {
    const Wall wall = wall_of_face(faces_, f, faults_);
    Triangle t{};
    for (std::size_t i = 0; i < 3; ++i) t[i] = static_cast<VertexIndex>(faces_.mesh_point[faces_.triangles[f][i]]);
    (wall == Wall::plus ? seen_[zone].plus : seen_[zone].minus).insert(t.begin(), t.end());
    walls_.push_back({t, zone, wall != Wall::plus});
  }
  bool is_closed(const Seen& seen, VertexIndex v) const { return seen.minus.contains(v) && seen.plus.contains(v); }

  void check_faces(std::size_t z) {
    for (const auto& [t, zone, is_minus] : walls_) {
      if (zone != z) continue;
      std::array<Vec3, 3> closed{};
      int n_open = 0;
      double across = 0;
      for (std::size_t i = 0; i < 3; ++i) {
        closed[i] = mesh_.file.before_zones[t[i]];
        n_open += !is_closed(seen_[z], t[i]);
      }
      const Vec3 area = 0.5 * cross(closed[1] - closed[0], closed[2] - closed[0]);
      const double size = norm(area);
      if (!(size > 0)) continue;
      for (std::size_t i = 0; i < 3; ++i)
        across += std::abs(dot(mesh_.point(t[i]) - closed[i], area)) / (size * std::max(n_open, 1));
      const double half = zones_[z].thickness / 2;
      if (is_minus) seen_[z].due.add(size * zones_[z].thickness * n_open / 3);
      if (n_open > 0 && (across > most_by_face * half || across * most_by_face < half)) wrong_.add(z, closed[0]);
    }
  }
  void check_volume(std::size_t z) {
    const double ratio = seen_[z].volume.value() / seen_[z].due.value();
    char text[160];
    std::snprintf(text, sizeof text, "; %.60s is %.4g thick in the mean, %.4g requested", zones_[z].fault.c_str(),
                  ratio * zones_[z].thickness, zones_[z].thickness);
    seen_text_ += text;
    if (!(std::abs(ratio - 1) <= most_in_all)) wrong_.add(z, mesh_.point(*seen_[z].minus.begin()));
  }
  /// Checks that the shortest path along the zone's edges from its minus wall to each node of its plus wall has as many
  /// edges as layers are requested. Nodes that are on both walls, at the zone's ends, are left out.
  void check_layers(std::size_t z) {
    const Seen& seen = seen_[z];
    std::map<VertexIndex, unsigned> steps;
    std::vector<VertexIndex> front;
    for (const VertexIndex v : seen.minus)
      if (!is_closed(seen, v)) {
        steps[v] = 0;
        front.push_back(v);
      }
    for (std::size_t k = 0; k < front.size(); ++k)
      if (const auto at = seen.edges.find(front[k]); at != seen.edges.end())
        for (const VertexIndex w : at->second)
          if (!is_closed(seen, w) && steps.try_emplace(w, steps[front[k]] + 1).second) front.push_back(w);
    for (const VertexIndex v : seen.plus)
      if (!is_closed(seen, v) && (!steps.contains(v) || steps[v] != zones_[z].layers)) wrong_.add(z, mesh_.point(v));
  }

  struct WallFace {
    Triangle nodes;
    std::size_t zone;
    bool is_minus;
  };
  const CheckedMesh& mesh_;
  const FacesFile& faces_;
  const std::vector<FaultZone>& zones_;
  std::vector<std::string> faults_;
  std::vector<Seen> seen_;
  std::vector<WallFace> walls_;
  std::string seen_text_;
  FaultCollector wrong_{"wrong_fault_zones"};
};

}  // namespace

void check_zones(const CheckedMesh& mesh, const FacesFile& faces, const std::vector<FaultZone>& zones,
                 CheckResult& result) {
  ZoneChecker(mesh, faces, zones).check(result);
}

}  // namespace geomesh::geomodel::checking
