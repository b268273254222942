// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Limits the memory of the arrangement. It grows with the number of places in which triangles meet, which the size of
/// the input does not bound: surfaces may coincide, and triangles may be far larger than the model. Each large step
/// therefore counts the items that it makes, and throws an error long before the machine swaps.
#pragma once

#include <atomic>
#include <cstddef>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel::arrangement {

/// Returns three quarters of the machine's memory, or of the limit of the container in which the program runs.
std::size_t default_memory_bound();

/// Memory that one step may still use, counted over all threads. The bytes assumed for each item were measured on
/// crossing grids and on random triangles: contacts with their identification, and facets with their exact vertices.
class MemoryUse {
 public:
  static constexpr std::size_t per_contact = 300, per_facet = 350;

  explicit MemoryUse(std::size_t bound, std::size_t used = 0) : bound_(bound), used_(used) {}

  /// Counts memory of new items. Throws Error{cannot_mesh}, naming the place in the model, if the bound is exceeded.
  void take(std::size_t n_items, std::size_t bytes_each, const Vec3& place) {
    if (used_.fetch_add(n_items * bytes_each, std::memory_order_relaxed) + n_items * bytes_each > bound_) refuse(place);
  }

 private:
  [[noreturn]] void refuse(const Vec3& place) const;

  std::size_t bound_;
  std::atomic<std::size_t> used_;
};

}  // namespace geomesh::geomodel::arrangement
