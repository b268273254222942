// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Limits the number of threads of oneTBB loops during a whole stage.
#pragma once

#include <tbb/global_control.h>

#include <optional>

namespace geomesh::geomodel {

/// While an object of this class exists, oneTBB loops use at most the given number of threads; 0 means all cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned threads) {
    if (threads > 0) limit_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

 private:
  std::optional<tbb::global_control> limit_;
};

}  // namespace geomesh::geomodel
