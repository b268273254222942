// SPDX-License-Identifier: MIT
// Functions of DomainMesh by which threads change blocks of its cells concurrently.
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

void DomainMesh::open_block(BlockEdit& block, std::size_t n) {
  block.clock = clock_;
  block.free.reserve(2 * n);
  for (std::size_t k = 0; k < n; ++k) {
    const CellIndex c = mesh_.add_cell({no_vertex, no_vertex, no_vertex, no_vertex});
    if (c == attributes_.component.size()) {
      attributes_.grow_to(c + std::size_t{1});
      attributes_.component[c] = no_index;
      attributes_.tags[c] = {};
      attributes_.shape[c] = 0;
    }
    block.free.push_back(c);
  }
  std::reverse(block.free.begin(), block.free.end());  // free slots are used from the end of the list
}

void DomainMesh::close_block(BlockEdit& block) {
  clock_ = std::max(clock_, block.clock);
  for (const CellIndex c : block.free) mesh_.free_cell(c);
  block.free.clear();
}

void DomainMesh::replace(std::span<const CellIndex> removed, std::span<const NewCell> added,
                         std::vector<CellIndex>& created, BlockEdit& block) {
  GEOMESH_CHECK(!journal_.is_open);
  const auto claim = [&](CellIndex c) {
    for (unsigned i = 0; i < 4; ++i) {
      block.claims->claim({c, i}, block.block);
      if (const FaceRef outer = mesh_.neighbor(c, i); outer.valid()) block.claims->claim(outer, block.block);
    }
  };
  const auto free = [&](CellIndex c) {
    mesh_.cells()[c].vertices[0] = no_vertex;
    block.free.push_back(c);
  };
  const auto make = [&](std::size_t k) {
    // `created` may be the same array as `removed`, so it is cleared only after `removed` has been read.
    if (k == 0) created.clear();
    const CellIndex c = block.free.back();
    block.free.pop_back();
    mesh_.cells()[c] = {added[k].vertices, {}};
    mesh_.flags(c) = 0;
    set_cell(c, added[k], block.clock);
    created.push_back(c);
    return c;
  };
  if (block.claims) std::for_each(removed.begin(), removed.end(), claim);
  if (added.empty()) created.clear();
  exchange_by(
      block.pairing, removed, added.size(), make, [](CellIndex) {}, free);
  if (block.claims) std::for_each(created.begin(), created.end(), claim);
}

}  // namespace geomesh::remesh
