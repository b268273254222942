// SPDX-License-Identifier: GPL-3.0-or-later
#include <catch2/catch.hpp>
#include <set>

#include "stack/map/joined_lines.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;

namespace {

using Pieces = std::set<std::pair<std::pair<double, double>, std::pair<double, double>>>;

Pieces pieces_of(const std::vector<std::vector<Vec2>>& lines) {
  Pieces pieces;
  for (const auto& line : lines)
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      std::pair a{line[k].x, line[k].y}, b{line[k + 1].x, line[k + 1].y};
      if (b < a) std::swap(a, b);
      pieces.emplace(a, b);
    }
  return pieces;
}

}  // namespace

TEST_CASE("joined lines: borders on one line with other vertices become the same pieces", "[stack]") {
  const double off = 1e-9;
  const std::vector<std::vector<Vec2>> lines{{{0, 0}, {0, 4}, {0, 10}}, {{off, 0}, {off, 6}, {off, 10}}};
  const Pieces pieces = pieces_of(join_lines(lines, 1e-6));
  CHECK(pieces.size() == 3);
  CHECK(pieces == pieces_of({join_lines(lines, 1e-6)[0]}));
  CHECK(pieces_of(join_lines(lines, 1e-12)).size() == 4);
}

TEST_CASE("joined lines: of vertices that merge the first stays, and pieces without length go", "[stack]") {
  const auto joined = join_lines({{{0, 0}, {1, 0}}, {{1 + 1e-8, 0}, {1, 1e-8}, {1, 5}}}, 1e-6);
  REQUIRE(joined.size() == 2);
  CHECK(joined[1] == std::vector<Vec2>{{1, 0}, {1, 5}});
}

TEST_CASE("joined lines: what crosses or lies farther off stays as it is", "[stack]") {
  const std::vector<std::vector<Vec2>> lines{{{0, 0}, {10, 10}}, {{0, 10}, {10, 0}}, {{20, 0}, {20, 1}}};
  CHECK(join_lines(lines, 1e-3) == lines);
}
