// SPDX-License-Identifier: MIT
#include "remesh/lengths/relative_lengths.hpp"

#include "common/parallel.hpp"

namespace geomesh::remesh {

void RelativeLengths::evaluate(unsigned threads) {
  const std::size_t n = mesh_.n_vertices();
  if (sizes_.size() < n) sizes_.resize(n + n / 16 + 1, -1);
  for_each_index(n, asks_caller() ? 1 : thread_count(threads), [&](std::size_t i) {
    const auto v = static_cast<VertexIndex>(i);
    if (sizes_[v] < 0 && mesh_.kind(v) != VertexKind::dead) sizes_[v] = evaluated(v);
  });
}

void RelativeLengths::set_size(VertexIndex v, double size) {
  if (v >= sizes_.size()) sizes_.resize(mesh_.n_vertices() + mesh_.n_vertices() / 4 + 1, -1);
  sizes_[v] = size;
}

std::vector<double> RelativeLengths::known_from(VertexIndex first) {
  std::vector<double> known;
  for (VertexIndex v = first; v < mesh_.n_vertices(); ++v) known.push_back(size_at(v));
  return known;
}

void RelativeLengths::add_known(VertexIndex first, std::span<const double> known) {
  for (const double size : known) set_size(first++, size);
}

}  // namespace geomesh::remesh
