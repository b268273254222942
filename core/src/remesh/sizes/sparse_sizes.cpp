// SPDX-License-Identifier: MIT
// Sizes of a mesh that is sparse inside. Declared in remesh/sizes/sizes.hpp.
#include <algorithm>

#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// For each vertex on a surface or curve, the smallest size that its components require; negative for other vertices.
class LeastSizes {
 public:
  LeastSizes(const DomainMesh& mesh, const SizeField& asked)
      : mesh_(mesh), asked_(asked), least_(mesh.n_vertices(), -1) {}

  void ask(VertexIndex v, Index component) {
    const double size = asked_.at(mesh_.point(v), component);
    if (least_[v] < 0 || size < least_[v]) least_[v] = size;
  }
  void add_to(std::vector<SizeSource>& sources, double growth) const {
    for (VertexIndex v = 0; v < least_.size(); ++v)
      if (least_[v] > 0) sources.push_back({mesh_.point(v), least_[v], 0, growth});
  }

 private:
  const DomainMesh& mesh_;
  const SizeField& asked_;
  std::vector<double> least_;
};

}  // namespace

SizeField sparse_sizes(const DomainMesh& mesh, const SizeField& asked, const RefineOptions& options) {
  LeastSizes least(mesh, asked);
  for (const CellIndex c : mesh.live_cells())
    for (unsigned i = 0; i < 4; ++i)
      if (mesh.tag(c, i).constrained())
        for (const VertexIndex v : mesh.face(c, i)) least.ask(v, mesh.component(c));
  for (const auto& edge : mesh.curve_edges())
    for (const VertexIndex v : edge) least.ask(v, mesh.component(mesh.incident_cell(v)));
  const SizeField most = asked.times(options.sparse_ratio);
  std::vector<SizeSource> sources = most.sources();
  least.add_to(sources, options.sparse_growth);
  return SizeField(std::move(sources), most.limits());
}

}  // namespace geomesh::remesh
