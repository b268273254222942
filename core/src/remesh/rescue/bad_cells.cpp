// SPDX-License-Identifier: MIT
#include "remesh/rescue/bad_cells.hpp"

#include <algorithm>
#include <array>

#include "common/parallel.hpp"

namespace geomesh::remesh {

BadCell bad_cell(const DomainMesh& mesh, CellIndex c) { return {mesh.shape_of(c), c, mesh.vertices(c)}; }

std::size_t count_below(const DomainMesh& mesh, double limit) {
  std::size_t n = 0;
  for (const CellIndex c : mesh.live_cells()) n += mesh.shape_of(c) < limit;
  return n;
}

/// Finds the percentile by counting cells by class of shape, then sorting only the class that contains it.
double shape_at_percentile(const DomainMesh& mesh, double share, unsigned threads) {
  constexpr std::size_t chunk = 65536, n_classes = 1024;
  using Counts = std::array<std::size_t, n_classes>;
  const auto class_of = [](double shape) {
    return shape > 0 ? static_cast<std::size_t>(std::min(shape, 1.0) * static_cast<double>(n_classes - 1)) : 0;
  };
  std::vector<Counts> counts((mesh.n_slots() + chunk - 1) / chunk, Counts{});
  const auto for_each_shape = [&](std::size_t k, const auto& visit) {
    const auto end = static_cast<CellIndex>(std::min<std::size_t>(mesh.n_slots(), (k + 1) * chunk));
    for (auto c = static_cast<CellIndex>(k * chunk); c < end; ++c)
      if (mesh.is_live(c)) visit(mesh.shape_of(c));
  };
  for_each_task(counts.size(), thread_count(threads),
                [&](std::size_t k) { for_each_shape(k, [&](double shape) { ++counts[k][class_of(shape)]; }); });
  auto place = static_cast<std::size_t>(share * static_cast<double>(mesh.n_cells()));
  std::size_t wanted = 0;
  for (;; ++wanted) {
    std::size_t n = 0;
    for (const Counts& of_chunk : counts) n += of_chunk.at(wanted);
    if (place < n) break;
    place -= n;
  }
  std::vector<double> shapes;
  for (std::size_t k = 0; k < counts.size(); ++k)
    if (counts[k].at(wanted) > 0)
      for_each_shape(k, [&](double shape) {
        if (class_of(shape) == wanted) shapes.push_back(shape);
      });
  const auto at = shapes.begin() + static_cast<std::ptrdiff_t>(place);
  std::nth_element(shapes.begin(), at, shapes.end());
  return *at;
}

std::vector<BadCell> cells_below(const DomainMesh& mesh, double limit) {
  std::vector<BadCell> bad;
  for (const CellIndex c : mesh.live_cells())
    if (mesh.shape_of(c) < limit) bad.push_back(bad_cell(mesh, c));
  std::sort(bad.begin(), bad.end(), [](const BadCell& a, const BadCell& b) {
    return a.shape != b.shape ? a.shape < b.shape : a.cell < b.cell;
  });
  return bad;
}

std::vector<BadCell> cells_below_by_class(const DomainMesh& mesh, double limit, unsigned n_classes) {
  std::vector<std::vector<BadCell>> classes(n_classes);
  for (const CellIndex c : mesh.live_cells()) {
    const double shape = mesh.shape_of(c);
    if (!(shape < limit)) continue;
    const double place = std::max(shape / limit, 0.0) * n_classes;
    classes[std::min(static_cast<unsigned>(place), n_classes - 1)].push_back(bad_cell(mesh, c));
  }
  std::vector<BadCell> bad;
  for (const std::vector<BadCell>& of_class : classes) bad.insert(bad.end(), of_class.begin(), of_class.end());
  return bad;
}

bool is_left(const DomainMesh& mesh, const BadCell& b) {
  return mesh.is_live(b.cell) && mesh.vertices(b.cell) == b.vertices;
}

}  // namespace geomesh::remesh
