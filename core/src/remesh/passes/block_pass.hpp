// SPDX-License-Identifier: MIT
/// @file
/// Sweeps over vertices by blocks, on all cores, in place.
#pragma once

#include <tbb/enumerable_thread_specific.h>

#include <array>
#include <functional>
#include <optional>
#include <string_view>
#include <vector>

#include "geomesh/core/run_context.hpp"
#include "remesh/operations/operations.hpp"

namespace geomesh::remesh {

/// Visits vertices: those inside of blocks, on all cores. Then those that were between, or were put off, inside of
/// blocks that have other borders, twice, and what is left by one thread. Blocks depend on the mesh alone, and so does
/// what comes of the visits. Vertices may neither be made nor removed from the first visit to the last.
class BlockPass {
 public:
  /// Is called with a block's own tools: mesh, envelope, sizes, rules, statistics, scratch, but no sizes or facets kept
  /// by vertex.
  using Visit = std::function<void(VertexIndex, Toolbox&)>;

  /// Both must outlive this. Exceptions of visits end the pass.
  BlockPass(Toolbox& tools, const RunContext& context) : tools_(tools), context_(context) {}

  /// In the order given within a block. Fewer than `least` are visited by one thread, in the order given.
  void run(std::vector<VertexIndex> vertices, std::size_t least, const Visit& visit);

  /// How the visits of all runs were shared out.
  struct Counts {
    std::size_t in_blocks = 0;      ///< visits inside of blocks, by either division
    std::size_t put_off = 0;        ///< those of them that met a border, and were done again
    std::size_t by_one_thread = 0;  ///< what was left
    std::size_t critical = 0;       ///< visits of the largest block of each division
  };
  const Counts& counts() const { return counts_; }
  /// Notes them (debug), as of a pass with this name.
  void note_counts(std::string_view name) const;

 private:
  const MeshBlocks& division(unsigned k);
  /// Returns those that are left, in their order.
  std::vector<VertexIndex> run_in(const MeshBlocks& blocks, const std::vector<VertexIndex>& vertices,
                                  const Visit& visit);
  void visit_block(BlockEdit& block, const std::vector<VertexIndex>& vertices, std::vector<VertexIndex>& stopped,
                   RefineStatistics& statistics, const Visit& visit);

  Toolbox& tools_;
  const RunContext& context_;
  std::array<std::optional<MeshBlocks>, MeshBlocks::n_divisions> divisions_;
  tbb::enumerable_thread_specific<Workspace> scratch_;
  Counts counts_;
};

}  // namespace geomesh::remesh
