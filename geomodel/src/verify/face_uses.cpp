// SPDX-License-Identifier: GPL-3.0-or-later
#include "verify/face_uses.hpp"

#include <algorithm>
#include <utility>

#include "common/chunks.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::size_t uses_a_block = 30000;

FaceUse make_use(Triangle t, Index row, bool is_listed) {
  bool even = true;
  for (const auto& [i, j] : {std::pair{0u, 1u}, std::pair{1u, 2u}, std::pair{0u, 1u}})
    if (t[i] > t[j]) {
      std::swap(t[i], t[j]);
      even = !even;
    }
  return FaceUse(t, row, is_listed, even);
}

/// Calls visit(use) for the faces of some elements of the mesh: those with numbers in [begin, end), where tetrahedra
/// are numbered first, then constrained faces.
template <class Visit>
void for_each_use(const ModelMesh& mesh, std::size_t begin, std::size_t end, const Visit& visit) {
  const std::size_t n_tetrahedra = mesh.tetrahedra.size();
  for (std::size_t row = begin; row < end; ++row) {
    if (row >= n_tetrahedra) {
      visit(make_use(mesh.faces[row - n_tetrahedra].vertices, static_cast<Index>(row - n_tetrahedra), true));
      continue;
    }
    const Tetrahedron& v = mesh.tetrahedra[row];
    for (const auto& f : face_vertices) visit(make_use({v[f[0]], v[f[1]], v[f[2]]}, static_cast<Index>(row), false));
  }
}

/// Sorts faces by their smallest vertex with a counting sort, then the few dozen faces of each vertex.
void sort_block(std::span<FaceUse> uses) {
  if (uses.empty()) return;
  const auto by_vertex = [](const FaceUse& p, const FaceUse& q) { return p.least_vertex() < q.least_vertex(); };
  const auto [least, greatest] = std::minmax_element(uses.begin(), uses.end(), by_vertex);
  const VertexIndex first = least->least_vertex();
  std::vector<std::uint32_t> end(greatest->least_vertex() - first + std::size_t{2},
                                 0);  // for each vertex, the number of faces with a smaller first vertex
  for (const FaceUse& use : uses) ++end[use.least_vertex() - first + 1];
  for (std::size_t v = 1; v < end.size(); ++v) end[v] += end[v - 1];
  std::vector<FaceUse> sorted(uses.size());
  for (const FaceUse& use : uses) sorted[end[use.least_vertex() - first]++] = use;
  std::uint32_t begin = 0;
  for (std::size_t v = 0; v + 1 < end.size(); begin = end[v++])
    std::sort(sorted.begin() + begin, sorted.begin() + end[v]);
  std::copy(sorted.begin(), sorted.end(), uses.begin());
}

}  // namespace

FaceUses::FaceUses(const ModelMesh& mesh, unsigned threads) {
  const std::size_t n_rows = mesh.tetrahedra.size() + mesh.faces.size();
  const std::size_t n_uses = 4 * mesh.tetrahedra.size() + mesh.faces.size();
  const std::size_t n_blocks = n_uses / uses_a_block + 1;
  const std::size_t n_vertices = std::max<std::size_t>(mesh.points.size(), 1);
  const auto block_of = [&](const FaceUse& use) { return use.least_vertex() * n_blocks / n_vertices; };

  // Counts for each chunk of elements the faces in each block. The counts determine the position to which each face is
  // then written.
  const Chunks chunks(n_rows);
  std::vector<std::vector<std::size_t>> place(chunks.size(), std::vector<std::size_t>(n_blocks, 0));
  chunks.for_each(threads, [&](std::size_t k, std::size_t begin, std::size_t end) {
    for_each_use(mesh, begin, end, [&](const FaceUse& use) { ++place[k][block_of(use)]; });
  });
  begin_.resize(n_blocks + 1);
  std::size_t total = 0;
  for (std::size_t b = 0; b < n_blocks; ++b) {
    begin_[b] = total;
    for (auto& row : place) total += std::exchange(row[b], total);
  }
  begin_[n_blocks] = total;
  uses_.grow_to(total);
  chunks.for_each(threads, [&](std::size_t k, std::size_t begin, std::size_t end) {
    for_each_use(mesh, begin, end, [&](const FaceUse& use) { uses_[place[k][block_of(use)]++] = use; });
  });
  for_each_task(n_blocks, threads, [&](std::size_t b) {
    sort_block({uses_.data() + begin_[b], begin_[b + 1] - begin_[b]});
  });
}

}  // namespace geomesh::geomodel
