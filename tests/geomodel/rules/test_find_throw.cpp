// SPDX-License-Identifier: GPL-3.0-or-later
// Faults found across which a horizon has throw.
#include <catch2/catch.hpp>
#include <cmath>

#include "geomesh/geomodel/model_rules.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

/// A fault that dips to the east at 60 degrees and passes x at z = -1000.
TriangulatedSurface fault_at(const std::string& name, double x) {
  TriangulatedSurface s{name, SurfaceKind::fault, false, false, "", {}, {}};
  const double off = 1000 / std::tan(3.14159265358979 / 3);
  s.points = {{x - off, -100, 0}, {x - off, 2100, 0}, {x + off, 2100, -2000}, {x + off, -100, -2000}};
  s.triangles = {{0, 1, 2}, {0, 2, 3}};
  return s;
}

/// Strips between the places given, each a lattice with a gap at its sides; `down`: how deep each strip lies. They may
/// hang together by their last row, as one sheet torn along its faults.
TriangulatedSurface strips(const std::vector<double>& ends, const std::vector<double>& down, double noise,
                           bool hang_together) {
  TriangulatedSurface s{"top", SurfaceKind::horizon, false, false, "", {}, {}};
  std::uint64_t state = 7;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
    const auto first = static_cast<VertexIndex>(s.points.size());
    const double from = ends[k] + 30, step = (ends[k + 1] - ends[k] - 60) / 20;
    for (int j = 0; j <= 40; ++j)
      for (int i = 0; i <= 20; ++i) {
        state = state * 6364136223846793005ULL + 1442695040888963407ULL;
        const double x = from + step * i, y = 50.0 * j, r = static_cast<double>(state >> 11) / 9007199254740992.0 - 0.5;
        s.points.push_back({x, y, -1000 - down[k] + 0.05 * x - 0.03 * y + 2 * noise * r});
      }
    for (VertexIndex j = 0; j < 40; ++j)
      for (VertexIndex i = 0; i < 20; ++i) {
        const VertexIndex a = first + j * 21 + i;
        s.triangles.push_back({a, a + 1, a + 22});
        s.triangles.push_back({a, a + 22, a + 21});
      }
    if (hang_together && k > 0) {
      const VertexIndex left = first - 22, right = first + 39 * 21;  // last but one row
      s.triangles.push_back({left, right, right + 21});
      s.triangles.push_back({left, right + 21, left + 21});
    }
  }
  return s;
}

/// The faults found for the first surface, and how much was said of it.
struct Told {
  std::vector<std::string> faults, notes{}, warnings{};
};
Told find(const std::vector<TriangulatedSurface>& surfaces) {
  ModelRules rules;
  rules.surfaces.resize(surfaces.size());
  rules.surfaces[0].throw_auto = true;
  Told told;
  find_throws(surfaces, rules, told.notes, told.warnings);
  told.faults = rules.surfaces[0].throw_at;
  return told;
}

std::vector<std::string> found(const std::vector<double>& down, double noise, bool hang_together = true) {
  const Told told = find({strips({0, 1000, 2000, 3000}, down, noise, hang_together), fault_at("west", 1000),
                          fault_at("east", 2000), fault_at("far", 9000)});
  CHECK(told.notes.size() == 2);  // of the fault that is nowhere near nothing is said
  CHECK(told.warnings.empty() == !told.faults.empty());
  return told.faults;
}

}  // namespace

TEST_CASE("faults across which a horizon has throw are found, others are not", "[throw_auto]") {
  CHECK(found({0, 40, 40}, 2) == std::vector<std::string>{"west"});
  CHECK(found({0, 0, -60}, 2) == std::vector<std::string>{"east"});
  CHECK(found({0, 40, 90}, 2) == std::vector<std::string>{"west", "east"});
  CHECK(found({0, 0, 0}, 2).empty());
  CHECK(found({0, 1, 1}, 4).empty());  // less than the spread
}

TEST_CASE("a fault between two sheets of a horizon parts them, however small the throw", "[throw_auto]") {
  const std::vector<std::string> both{"west", "east"};
  CHECK(found({0, 40, 40}, 2, false) == both);
  CHECK(found({0, 0, 0}, 2, false) == both);
}

TEST_CASE("of faults between the same sheets the nearest to their borders counts", "[throw_auto]") {
  const Told told =
      find({strips({0, 1000, 2000}, {0, 40}, 2, false), fault_at("near", 1000), fault_at("beside", 1150)});
  CHECK(told.faults == std::vector<std::string>{"near"});
}
