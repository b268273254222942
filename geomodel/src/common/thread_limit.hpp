// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// How many threads loops of oneTBB may use, over a whole stage.
#pragma once

#include <tbb/global_control.h>

#include <optional>

namespace geomesh::geomodel {

/// While it lives, loops use at most so many threads. 0 stands for all cores.
class ThreadLimit {
 public:
  explicit ThreadLimit(unsigned threads) {
    if (threads > 0) limit_.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }

 private:
  std::optional<tbb::global_control> limit_;
};

}  // namespace geomesh::geomodel
