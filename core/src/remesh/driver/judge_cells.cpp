// SPDX-License-Identifier: MIT
#include "remesh/driver/judge_cells.hpp"

#include <memory>
#include <numeric>

#include "quality/causes.hpp"
#include "remesh/domain/domain_io.hpp"
#include "remesh/sizes/sizes.hpp"

namespace geomesh::remesh {

namespace {

/// Number of layers of cells that are exported around the examined cells. They contain all faces at the vertices of the
/// examined cells, and most gaps between surfaces.
constexpr unsigned rings = 2;

class Judge {
 public:
  Judge(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input, const RefineOptions& options,
        const RefineResult& result)
      : input_(input) {
    judging_.asked = &result.asked;
    judging_.tolerance = size_tolerance(options);
    judging_.tolerance_share = options.tolerance_share;
    judging_.facet_patch = result.kept_patch;
    creases_ = find_creases(plc, judging_);
  }

  std::vector<CellIndex> find(const DomainMesh& mesh) const {
    std::vector<CellIndex> cells, free;
    std::vector<Index> bad;
    for (const CellIndex c : mesh.live_cells()) {
      if (is_bad(mesh, c)) bad.push_back(static_cast<Index>(cells.size()));
      cells.push_back(c);
    }
    if (bad.empty()) return {};  // Most meshes have no bad cells and need not be exported.
    const ConstrainedTetrahedralization exported = export_domain(mesh, input_);
    for (const Index row : unforced_bad_elements(exported, judging_, creases_, bad)) free.push_back(cells[row]);
    return free;
  }

  std::vector<CellIndex> find_since(const DomainMesh& mesh, std::uint64_t tick) {
    std::vector<CellIndex> bad;
    for (const CellIndex c : mesh.live_cells())
      if (changed_since(mesh, mesh.vertices(c), tick) && is_bad(mesh, c)) bad.push_back(c);
    return bad.empty() ? bad : find_among(mesh, bad);
  }

  std::vector<CellIndex> find_among(const DomainMesh& mesh, std::span<const CellIndex> cells) {
    std::vector<CellIndex> bad;
    const ConstrainedTetrahedralization about = export_about(mesh, cells, rings, input_, scratch_);
    std::vector<Index> judged(cells.size());
    std::iota(judged.begin(), judged.end(), Index{0});
    for (const Index row : unforced_bad_elements(about, judging_, creases_, judged)) bad.push_back(cells[row]);
    return bad;
  }

 private:
  bool is_bad(const DomainMesh& mesh, CellIndex cell) const {
    const auto [a, b, c, d] = mesh.places(mesh.vertices(cell));
    return angle_if_bad(a, b, c, d, judging_.bad_angle).has_value();
  }

  const ConstrainedTetrahedralization& input_;
  QualityOptions judging_;
  InputCreases creases_;
  ExportScratch scratch_;
};

}  // namespace

FreeCellJudge free_cell_judge(const PiecewiseLinearComplex& plc, const ConstrainedTetrahedralization& input,
                              const RefineOptions& options, const RefineResult& result) {
  const auto judge = std::make_shared<Judge>(plc, input, options, result);
  return {[judge](const DomainMesh& mesh) { return judge->find(mesh); },
          [judge](const DomainMesh& mesh, std::uint64_t tick) { return judge->find_since(mesh, tick); },
          [judge](const DomainMesh& mesh, std::span<const CellIndex> cells) { return judge->find_among(mesh, cells); }};
}

}  // namespace geomesh::remesh
