// SPDX-License-Identifier: GPL-3.0-or-later
// That stages which may take long say how far they are.
#include <catch2/catch.hpp>
#include <string>
#include <string_view>
#include <thread>
#include <utility>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "noisy_faults.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

/// Keeps what was said in one stage: (done, total), from which thread. An empty name: in any stage.
struct Heard {
  std::string current;
  std::vector<std::pair<std::size_t, std::size_t>> counts;
  bool from_caller = true;
  RunContext context;

  explicit Heard(const std::string& stage) {
    context.stage = [this](std::string_view name, bool begins) { current = begins ? name : ""; };
    context.progress = [this, stage, caller = std::this_thread::get_id()](std::size_t done, std::size_t total) {
      if (!stage.empty() && stage != current) return;
      counts.emplace_back(done, total);
      from_caller = from_caller && std::this_thread::get_id() == caller;
    };
  }
  bool has_totals() const {
    for (const auto& [done, total] : counts)
      if (total == 0 || done > total) return false;
    return !counts.empty() && from_caller;
  }
};

}  // namespace

TEST_CASE("intersection and recovery tell counts done of a total, from the thread of the caller",
          "[pipeline][progress]") {
  Heard intersecting(""), recovering("recover");
  ArrangementOptions options;
  options.box = Box3{{0, 0, 0}, {4000, 3000, 2000}};
  const auto faults = noisy_faults(3, noisy_faults_options(3));
  arrange(faults, {}, {}, options, intersecting.context);
  CHECK(intersecting.has_totals());
  tetrahedralize(noisy_faults_model(3, noisy_faults_options(3)).plc, {}, recovering.context);
  CHECK(recovering.has_totals());
}
