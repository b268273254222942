// SPDX-License-Identifier: MIT
// Marks in a small table, beside a set that knows no epochs.
#include <catch2/catch.hpp>
#include <random>
#include <set>

#include "common/epoch_marks.hpp"

using namespace geomesh;

TEST_CASE("Marks are those of a set, whatever is marked, taken off again and begun anew", "[common]") {
  EpochMarks marks;
  std::mt19937 chance(7);
  for (unsigned epoch = 0; epoch < 300; ++epoch) {
    marks.begin();
    std::set<std::uint32_t> expected;
    // Few and many; indices that hash alike (multiples of a power of two), and any.
    const std::uint32_t n = epoch % 10 == 0 ? 3000 : 40, step = epoch % 3 == 0 ? 1u << 20 : 1;
    for (std::uint32_t k = 0; k < n; ++k) {
      const std::uint32_t i = step * (chance() % (2 * n));
      switch (chance() % 3) {
        case 0:
          marks.mark(i);
          expected.insert(i);
          break;
        case 1:
          marks.unmark(i);
          expected.erase(i);
          break;
        default:
          REQUIRE(marks.mark_first(i) == expected.insert(i).second);
      }
      const std::uint32_t asked = step * (chance() % (2 * n));
      REQUIRE(marks.marked(asked) == expected.contains(asked));
    }
    for (std::uint32_t i = 0; i < 2 * n; ++i) REQUIRE(marks.marked(step * i) == expected.contains(step * i));
  }
}
