// SPDX-License-Identifier: MIT
#include "delaunay/cavity_stage.hpp"

#include <algorithm>
#include <deque>

#include "common/parallel.hpp"
#include "mesh/spatial_order.hpp"

namespace geomesh {
namespace {

constexpr std::size_t points_a_part = 300000, fewest_in_parts = 40000;

/// The points that one part of a parallel run inserts, and the outcome for those that it could not insert.
struct PartRun {
  Ownership owned;
  std::size_t begin, end;
  std::vector<VertexIndex> left, too_near;
  std::vector<Twin> twins;
};

void insert_part(CavityInsertion<Space3, true>& part, PartRun& run, const std::vector<VertexIndex>& positions,
                 std::size_t first, double distance, const RunContext& context) {
  run.left.assign(positions.begin() + static_cast<std::ptrdiff_t>(run.begin),
                  positions.begin() + static_cast<std::ptrdiff_t>(first));
  for (std::size_t i = first; i < run.end; ++i) {
    if (i % 16384 == 0) context.check_cancelled();
    const VertexIndex v = positions[i];
    switch (part.insert(v, distance)) {
      case InsertionOutcome::inserted:
        break;
      case InsertionOutcome::duplicate:
        run.twins.push_back({v, part.twin()});
        break;
      case InsertionOutcome::too_near:
        run.too_near.push_back(v);
        break;
      case InsertionOutcome::not_owned:
        run.left.push_back(v);
        break;
    }
  }
}

/// Divides the Hilbert curve into `n_parts` runs of equally many of the places of SpatialOrder.
std::vector<PartRun> cut_curve(std::size_t n_parts) {
  std::vector<PartRun> runs;
  const auto place = [&](std::size_t k) { return static_cast<std::uint16_t>(k * SpatialOrder::n_places / n_parts); };
  for (std::size_t k = 0; k < n_parts; ++k) runs.push_back({{place(k), place(k + 1)}, 0, 0, {}, {}, {}});
  return runs;
}

}  // namespace

CavityStage::CavityStage(TetMesh& mesh, PointRecord* records, VertexIndex n_points, double unit,
                         double cluster_distance, const RunContext& context)
    : mesh_(mesh),
      records_(records),
      n_points_(n_points),
      space_(records, n_points, unit),
      cluster_distance_(cluster_distance),
      context_(context),
      threads_(thread_count(context.threads)),
      sequential_(mesh, space_, SlotSource(0, 0, 0, 1)) {}

void CavityStage::report() {
  context_.check_cancelled();
  context_.report(n_done_, n_points_);
}

void CavityStage::insert_round(VertexIndex begin, VertexIndex end) {
  std::vector<VertexIndex> positions(end - begin);
  for (VertexIndex v = begin; v < end; ++v) positions[v - begin] = v;
  insert_all(positions, cluster_distance_);
}

void CavityStage::insert_waiting() {
  statistics_.points_deferred = waiting_.size();
  std::vector<VertexIndex> positions;
  positions.swap(waiting_);
  std::sort(positions.begin(), positions.end(), [&](VertexIndex a, VertexIndex b) {
    return records_[a].place != records_[b].place ? records_[a].place < records_[b].place : a < b;
  });
  insert_all(positions, 0);
}

/// Inserts the points at `positions` of the insertion order, which are sorted along the Hilbert curve.
void CavityStage::insert_all(const std::vector<VertexIndex>& positions, double distance) {
  if (positions.size() < fewest_in_parts) return insert_one_by_one(positions, distance);
  insert_one_by_one(insert_in_parts(positions, distance), distance);
}

void CavityStage::insert_one_by_one(const std::vector<VertexIndex>& positions, double distance) {
  for (const VertexIndex v : positions) {
    switch (sequential_.insert(v, distance)) {
      case InsertionOutcome::duplicate:
        twins_.push_back({v, sequential_.twin()});
        break;
      case InsertionOutcome::too_near:
        waiting_.push_back(v);
        break;
      default:
        break;
    }
    if (++n_done_ % 65536 == 0) report();
  }
}

/// Returns the first position whose point lies in a cell that a part of the parallel run owns, and lets the part's
/// walks start at this cell. Returns `end` if a few tries find none.
std::size_t CavityStage::start_part(Part& part, const std::vector<VertexIndex>& positions, std::size_t begin,
                                    std::size_t end, Ownership owned) {
  constexpr std::size_t step = 48, tries = 64;
  for (std::size_t i = begin; i < std::min(end, begin + step * tries); i += step) {
    const CellIndex c = sequential_.locate(records_[positions[i]]);
    bool own = true;
    for (const VertexIndex u : mesh_.vertices(c))
      own = own && (u == space_.infinite() || (owned.first <= records_[u].place && records_[u].place < owned.end));
    if (!own) continue;
    part.set_hint(c);
    return i;
  }
  return end;
}

/// Inserts points in concurrent parts. Returns the positions that no part could insert, in Hilbert order.
std::vector<VertexIndex> CavityStage::insert_in_parts(const std::vector<VertexIndex>& positions, double distance) {
  const std::size_t n_parts = std::clamp<std::size_t>(positions.size() / points_a_part, 2, 256);
  std::vector<PartRun> runs = cut_curve(n_parts);
  const CellIndex base = sequential_.slots().used_end();
  mesh_.grow_to(
      std::max<std::size_t>(mesh_.n_slots(), base + 8 * positions.size() + 2 * runs.size() * SlotSource::block));
  sequential_.refresh();
  std::deque<Part> parts;
  std::vector<std::size_t> first(runs.size());
  std::size_t at = 0;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    PartRun& run = runs[k];
    run.begin = at;
    while (at < positions.size() && records_[positions[at]].place < run.owned.end) ++at;
    run.end = at;
    const SlotSource slots(base, mesh_.n_slots(), static_cast<unsigned>(k), static_cast<unsigned>(runs.size()));
    parts.emplace_back(mesh_, space_, slots, run.owned);
    first[k] = start_part(parts.back(), positions, run.begin, run.end, run.owned);
  }
  for_each_task(runs.size(), threads_,
                [&](std::size_t k) { insert_part(parts[k], runs[k], positions, first[k], distance, context_); });

  CellIndex used_end = base;
  for (const Part& part : parts) used_end = std::max(used_end, part.slots().used_end());
  used_end = std::min(used_end, mesh_.n_slots());
  sequential_.slots().restart(used_end, mesh_.n_slots());
  std::vector<VertexIndex> left;
  for (std::size_t k = 0; k < runs.size(); ++k) {
    sequential_.slots().adopt(parts[k].slots().unused(used_end));
    if (parts[k].hint() != no_cell) sequential_.set_hint(parts[k].hint());
    statistics_.walk_steps += parts[k].walk_steps();
    statistics_.exact_calls += parts[k].space().exact_calls();
    left.insert(left.end(), runs[k].left.begin(), runs[k].left.end());
    waiting_.insert(waiting_.end(), runs[k].too_near.begin(), runs[k].too_near.end());
    twins_.insert(twins_.end(), runs[k].twins.begin(), runs[k].twins.end());
  }
  n_done_ += positions.size() - left.size();
  report();
  return left;
}

void CavityStage::finish(DelaunayStatistics& statistics) {
  sequential_.slots().finish(mesh_);
  statistics_.walk_steps += sequential_.walk_steps();
  statistics_.exact_calls += sequential_.space().exact_calls();
  statistics = statistics_;
}

}  // namespace geomesh
