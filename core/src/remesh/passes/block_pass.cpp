// SPDX-License-Identifier: MIT
#include "remesh/passes/block_pass.hpp"

#include <algorithm>
#include <memory>
#include <string>
#include <utility>

#include "common/parallel.hpp"

namespace geomesh::remesh {

namespace {

/// With fewer vertices than MeshBlocks::Rules::vertices_a_block / fewest_a_block, one thread is as fast as blocks.
constexpr std::size_t fewest_a_block = 4;
constexpr std::size_t visits_between_looks = 256;  ///< number of visits between two checks of the cancel token
/// A block has `least_slots` spare slots for cells that are created before others are removed, and one more for every
/// `visits_a_slot` vertices of the block that the pass visits.
constexpr std::size_t least_slots = 32, visits_a_slot = 8;

void add(RefineStatistics& all, const RefineStatistics& of_block) {
  all.edge_removals += of_block.edge_removals;
  all.face_removals += of_block.face_removals;
  all.collapses += of_block.collapses;
  all.smoothing_moves += of_block.smoothing_moves;
}

}  // namespace

const MeshBlocks& BlockPass::division(unsigned k) {
  std::optional<MeshBlocks>& blocks = divisions_.at(k);
  if (!blocks) blocks.emplace(tools_.mesh, k, tools_.block_rules, thread_count(context_.threads));
  return *blocks;
}

void BlockPass::run(std::vector<VertexIndex> vertices, std::size_t least, const Visit& visit) {
  for (unsigned k = 0; k < divisions_.size() && vertices.size() >= least; ++k) {
    if (vertices.size() * fewest_a_block < tools_.block_rules.vertices_a_block || division(k).size() == 1) break;
    vertices = run_in(division(k), vertices, visit);
    least = 0;
  }
  counts_.by_one_thread += vertices.size();
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (k % visits_between_looks == 0) context_.check_cancelled();
    visit(vertices[k], tools_);
  }
}

std::vector<VertexIndex> BlockPass::run_in(const MeshBlocks& blocks, const std::vector<VertexIndex>& vertices,
                                           const Visit& visit) {
  const unsigned threads = thread_count(context_.threads);
  const std::vector<std::uint8_t> inner = blocks.find_inner(tools_.mesh, threads);
  std::vector<std::vector<VertexIndex>> of_block(blocks.size()), stopped(blocks.size());
  for (const VertexIndex v : vertices)
    if (inner[v]) of_block[blocks.block_of(v)].push_back(v);
  std::vector<BlockEdit> edits(blocks.size());
  std::vector<RefineStatistics> statistics(blocks.size());
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    edits[b].blocks = &blocks;
    edits[b].block = static_cast<MeshBlocks::Block>(b);
    tools_.mesh.open_block(edits[b], least_slots + of_block[b].size() / visits_a_slot);
  }
  std::optional<FaceClaims> claims;
  if (tools_.block_rules.is_checked) claims.emplace(tools_.mesh.n_slots());
  for (BlockEdit& edit : edits) edit.claims = claims ? &*claims : nullptr;
  for_each_task(blocks.size(), threads,
                [&](std::size_t b) { visit_block(edits[b], of_block[b], stopped[b], statistics[b], visit); });
  std::vector<std::uint8_t> is_left(tools_.mesh.n_vertices(), 0);
  std::size_t most = 0;
  for (std::size_t b = 0; b < blocks.size(); ++b) {
    tools_.mesh.close_block(edits[b]);
    add(tools_.statistics, statistics[b]);
    for (const VertexIndex v : stopped[b]) is_left[v] = 1;
    counts_.in_blocks += of_block[b].size();
    counts_.put_off += stopped[b].size();
    most = std::max(most, of_block[b].size());
  }
  counts_.critical += most;
  std::vector<VertexIndex> left;
  for (const VertexIndex v : vertices)
    if (!inner[v] || is_left[v]) left.push_back(v);
  return left;
}

void BlockPass::note_counts(std::string_view name) const {
  const std::size_t all = counts_.in_blocks - counts_.put_off + counts_.by_one_thread;
  context_.note(LogLevel::debug, std::string(name) + ": " + std::to_string(all) + " vertices visited, " +
                                     std::to_string(counts_.put_off) + " of them again, " +
                                     std::to_string(counts_.by_one_thread) + " by one thread, " +
                                     std::to_string(counts_.critical) + " in the largest blocks");
}

void BlockPass::visit_block(BlockEdit& block, const std::vector<VertexIndex>& vertices,
                            std::vector<VertexIndex>& stopped, RefineStatistics& statistics, const Visit& visit) {
  Workspace& scratch = scratch_.local();
  Toolbox own(tools_.mesh, tools_.guard, tools_.lengths.field(), statistics);
  own.bad_cells_may_spread = tools_.bad_cells_may_spread;
  own.borders_stay = tools_.borders_stay;
  own.points_in_thin_gaps = tools_.points_in_thin_gaps;
  own.block_rules = tools_.block_rules;
  own.block = &block;
  std::swap(own.work, scratch);
  for (std::size_t k = 0; k < vertices.size(); ++k) {
    if (k % visits_between_looks == 0) context_.check_cancelled();
    block.was_stopped = false;
    visit(vertices[k], own);
    if (block.was_stopped) stopped.push_back(vertices[k]);
  }
  std::swap(own.work, scratch);
}

}  // namespace geomesh::remesh
