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
  /// The function called for each visited vertex. It receives the Toolbox of the vertex's block, which shares the mesh,
  /// the envelope, the sizes and the rules with those of other blocks, but has no caches by vertex.
  using Visit = std::function<void(VertexIndex, Toolbox&)>;

  /// `tools` and `context` must outlive this object. An exception from the function called for a vertex ends the pass.
  BlockPass(Toolbox& tools, const RunContext& context) : tools_(tools), context_(context) {}

  /// Visits vertices, within each block in the given order. If there are fewer than `least`, one thread visits all.
  void run(std::vector<VertexIndex> vertices, std::size_t least, const Visit& visit);

  /// Numbers of vertices visited in all calls of `run`: concurrently in blocks of vertices, or by one thread.
  struct Counts {
    std::size_t in_blocks = 0;      ///< vertices visited concurrently, inside blocks of vertices
    std::size_t put_off = 0;        ///< vertices visited again, because the visit needed cells of another block
    std::size_t by_one_thread = 0;  ///< vertices left to be visited by one thread
    std::size_t critical = 0;       ///< vertices in the largest block of each division into blocks
  };
  const Counts& counts() const { return counts_; }
  /// Logs the numbers of visited vertices under the name of a pass (debug level).
  void note_counts(std::string_view name) const;

 private:
  const MeshBlocks& division(unsigned k);
  /// Visits the vertices inside blocks concurrently. Returns the others, and those whose visit needs a repetition.
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
