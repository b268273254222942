// SPDX-License-Identifier: MIT
// Growable arrays, from a few bytes to blocks that are mapped on their own.
#include <catch2/catch.hpp>
#include <cstdint>

#include "geomesh/core/pod_array.hpp"

using namespace geomesh;

namespace {

std::uint64_t value_at(std::size_t i) { return i * 0x9E3779B97F4A7C15ull + 1; }

/// Grows to n items, those that are new with their values.
void fill_to(PodArray<std::uint64_t>& array, std::size_t n) {
  const std::size_t before = array.size();
  array.grow_to(n);
  for (std::size_t i = before; i < n; ++i) array[i] = value_at(i);
}

bool holds_its_values(const PodArray<std::uint64_t>& array) {
  for (std::size_t i = 0; i < array.size(); ++i)
    if (array[i] != value_at(i)) return false;
  return true;
}

bool starts_at_a_line(const PodArray<std::uint64_t>& array) {
  return reinterpret_cast<std::uintptr_t>(array.data()) % 64 == 0;
}

}  // namespace

TEST_CASE("growable arrays keep their items, from a few bytes to tens of megabytes", "[common]") {
  // Two that grow in turn: neither has room behind it for long.
  PodArray<std::uint64_t> one, other;
  for (const std::size_t n : {1u, 100u, 60'000u, 500'000u, 600'000u, 1'100'000u, 3'000'000u, 5'000'000u}) {
    for (PodArray<std::uint64_t>* array : {&one, &other}) {
      fill_to(*array, n);
      REQUIRE(array->size() == n);
      REQUIRE(starts_at_a_line(*array));
    }
    REQUIRE(holds_its_values(one));
    REQUIRE(holds_its_values(other));
  }
}

TEST_CASE("growable arrays are copied, moved and released at any size", "[common]") {
  for (const std::size_t n : {10u, 2'000'000u}) {
    PodArray<std::uint64_t> array;
    fill_to(array, n);
    const PodArray<std::uint64_t> copy = array;
    CHECK(copy.data() != array.data());
    CHECK(holds_its_values(copy));
    PodArray<std::uint64_t> moved = std::move(array);
    CHECK(moved.size() == n);
    CHECK(holds_its_values(moved));
    moved.release();
    CHECK(moved.capacity() == 0);
    fill_to(moved, n);
    CHECK(holds_its_values(moved));
  }
}
