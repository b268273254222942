// SPDX-License-Identifier: MIT
#include <catch2/catch.hpp>
#include <map>
#include <random>

#include "common/flat_map.hpp"

using namespace geomesh;

TEST_CASE("A map of edges finds an edge in both directions, and no longer once it is erased", "[common]") {
  EdgeMap table;
  CHECK(table.find({0, 1}) == no_index);
  std::map<std::array<VertexIndex, 2>, Index> expected;
  std::mt19937 random(3);
  for (unsigned k = 0; k < 20000; ++k) {
    VertexIndex a = random() % 300, b = random() % 300;
    if (a == b) continue;
    if (random() % 3 == 0) {
      table.erase({a, b});
      expected.erase({std::min(a, b), std::max(a, b)});
    } else {
      table.insert({a, b}, k);
      expected[{std::min(a, b), std::max(a, b)}] = k;
    }
  }
  std::size_t n = 0;
  for (VertexIndex a = 0; a < 300; ++a)
    for (VertexIndex b = 0; b < 300; ++b) {
      if (a == b) continue;
      const auto it = expected.find({std::min(a, b), std::max(a, b)});
      n += table.find({a, b}) == (it == expected.end() ? no_index : it->second);
    }
  CHECK(n == 300 * 299);
  const auto sorted = table.sorted_keys();
  REQUIRE(sorted.size() == expected.size());
  CHECK(std::equal(sorted.begin(), sorted.end(), expected.begin(),
                   [](const auto& edge, const auto& entry) { return edge == entry.first; }));
}
