// SPDX-License-Identifier: MIT
/// @file
/// Blocks of a mesh that threads change concurrently, in place, with the same result whatever the number of threads.
///
/// Each vertex belongs to one block, determined by its position alone. A cell belongs to a block if all four of its
/// vertices do; cells in no block are frozen while blocks are processed. Operations that reach a frozen cell are put
/// off until blocks have other borders (as cavities in Marot, Pellerin and Remacle 2019, "One machine, one minute,
/// three billion tetrahedra").
///
/// Invariants while blocks are processed:
///   1. an operation exchanges cells of its own block alone, for cells with the same vertices, which belong to the same
///      block;
///   2. a vertex is moved or removed by its block alone, and only if all cells at it belong to the block;
///   3. no frozen cell changes, except for the neighbour entries and tags of faces whose three vertices are of one
///      block: beyond these are cells of that block, and the block alone writes them;
///   4. no array of the mesh changes its length: each block has a stock of free slots, and makes no vertices;
///   5. each block has a clock of its own, which continues that of the mesh. The times of a vertex are those of its
///      block.
/// Therefore a walk around a vertex or an edge of a block reads nothing that another block writes: each face that it
/// crosses has a vertex of the block, so its three vertices cannot all be of another block. Code that reads a cell
/// beyond the face opposite to its vertex checks first which block that cell belongs to.
///
/// Operations that reach a frozen cell, or find no free slot, are noted in BlockEdit::was_stopped, and done later by
/// other blocks or by one thread.
#pragma once

#include <atomic>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "mesh/face_pairing.hpp"
#include "remesh/domain/mesh_elements.hpp"

namespace geomesh::remesh {

class DomainMesh;

#ifdef GEOMESH_EXPENSIVE_CHECKS
inline constexpr bool checks_by_default = true;
#else
inline constexpr bool checks_by_default = false;
#endif

/// Assigns each vertex of a mesh to a block.
class MeshBlocks {
 public:
  using Block = std::uint16_t;
  static constexpr unsigned n_divisions = 3;

  /// Rules by which a mesh is divided into blocks.
  struct Rules {
    std::size_t vertices_a_block = 4096;  ///< least average number of vertices of a block; there are at most 64 blocks
    /// Passes over fewer vertices than this are run by one thread, because blocks gain little in small meshes.
    std::size_t least_inside = 50'000, least_on_surfaces = 60'000;
    bool is_checked = checks_by_default;  ///< whether to check that each face is written by its own block only
  };

  /// Bisects the vertices along the longest side of their box, recursively. Division 0 cuts at the median; the other
  /// divisions cut elsewhere, so that their blocks have different borders. O(n log n / threads).
  MeshBlocks(const DomainMesh& mesh, unsigned division, const Rules& rules, unsigned threads);

  std::size_t size() const { return n_blocks_; }
  Block block_of(VertexIndex v) const { return block_[v]; }
  bool has(Block block, const Tetrahedron& t) const {
    return block_[t[0]] == block && block_[t[1]] == block && block_[t[2]] == block && block_[t[3]] == block;
  }
  /// Returns, for each vertex, whether all cells at the vertex belong to its block. O(cells / threads).
  std::vector<std::uint8_t> find_inner(const DomainMesh& mesh, unsigned threads) const;

 private:
  std::vector<Block> block_;  // by vertex
  std::size_t n_blocks_ = 1;
};

/// Records which block has written which face of which cell. This checks invariants 1 and 3 of mesh_blocks.hpp.
class FaceClaims {
 public:
  explicit FaceClaims(std::size_t n_slots) : owner_(std::make_unique<std::atomic<std::uint16_t>[]>(4 * n_slots)) {}
  /// Records that the block has written the face. Throws InternalError if another block has written the same face.
  void claim(FaceRef f, MeshBlocks::Block block);

 private:
  // For each face, one more than the number of the block that has written it, or 0 if none has.
  std::unique_ptr<std::atomic<std::uint16_t>[]> owner_;
};

/// The state with which a thread changes the cells of one block: free cell slots and a clock.
struct BlockEdit {
  const MeshBlocks* blocks = nullptr;
  MeshBlocks::Block block = 0;
  std::vector<CellIndex> free;  ///< slots
  std::uint64_t clock = 0;
  /// Whether an operation was postponed because it needed cells of other blocks or more free slots.
  bool was_stopped = false;
  FaceClaims* claims = nullptr;
  FacePairing<FaceTag> pairing;

  /// Returns whether the block may replace the removed cells by `n_added` new ones. If not, sets was_stopped.
  bool may_exchange(const DomainMesh& mesh, std::span<const CellIndex> removed, std::size_t n_added);
  /// Returns whether all of the cells belong to the block. If not, sets was_stopped.
  bool owns(const DomainMesh& mesh, std::span<const CellIndex> cells);
};

}  // namespace geomesh::remesh
