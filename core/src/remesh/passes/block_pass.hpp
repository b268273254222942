// SPDX-License-Identifier: MIT
/// @file
/// Concurrent sweeps over vertices, block by block.
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

/// Visits the vertices inside blocks concurrently. Vertices between blocks, and vertices whose visit was postponed,
/// follow in two other divisions into blocks; one thread visits the rest. Blocks depend only on the mesh, and so does
/// the result. Vertices must neither be created nor removed between the first and the last visit.
class BlockPass {
 public:
  /// The function called for each vertex. The tools passed to it are those of the block: they share the mesh, the
  /// envelope, the sizes and the rules with other blocks, but have no caches by vertex.
  using Visit = std::function<void(VertexIndex, Toolbox&)>;

  /// Both arguments must outlive this object. An exception of a visit ends the pass.
  BlockPass(Toolbox& tools, const RunContext& context) : tools_(tools), context_(context) {}

  /// Visits vertices, within each block in the given order. If they are fewer than `least`, one thread visits all in
  /// order.
  void run(std::vector<VertexIndex> vertices, std::size_t least, const Visit& visit);

  /// Numbers of visits in all runs, by the way in which they were made.
  struct Counts {
    std::size_t in_blocks = 0;      ///< visits inside blocks, in all divisions
    std::size_t put_off = 0;        ///< visits that reached another block's cells and were repeated later
    std::size_t by_one_thread = 0;  ///< visits of the remaining vertices
    std::size_t critical = 0;       ///< visits of the largest block of each division
  };
  const Counts& counts() const { return counts_; }
  /// Logs the numbers of visits under the name of a pass (debug level).
  void note_counts(std::string_view name) const;

 private:
  const MeshBlocks& division(unsigned k);
  /// Visits vertices inside blocks. Returns the vertices that still have to be visited, in order.
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
