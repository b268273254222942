// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/exodus/exodus_fields.hpp"

#include <vtk_exodusII.h>

#include <algorithm>
#include <limits>
#include <string>
#include <vector>

#include "solver_mesh/names.hpp"

namespace geomesh::geomodel {

namespace {

template <class Array>
int put_names(int file, ex_entity_type kind, const std::vector<Array>& arrays) {
  SolverNames given(name_limit_exodus);
  std::vector<std::string> names;
  for (const Array& array : arrays) names.push_back(given.give(array.name));
  std::vector<char*> texts;
  for (std::string& name : names) texts.push_back(name.data());
  const int status = ex_put_variable_param(file, kind, static_cast<int>(arrays.size()));
  return std::min(status, ex_put_variable_names(file, kind, static_cast<int>(arrays.size()), texts.data()));
}

int put_cell_array(int file, const SolverMesh& mesh, int number, const CellArray& array) {
  int worst = 0;
  for (const CellBlock& block : mesh.blocks) {
    if (dimension_of(block.shape) != 3 || block.n_cells() == 0) continue;
    std::vector<double> values;
    for (const std::size_t row : block.rows) values.push_back(array.values[row]);
    values.resize(block.n_cells(), std::numeric_limits<double>::quiet_NaN());
    worst = std::min(worst, ex_put_var(file, 1, EX_ELEM_BLOCK, number, block.id, static_cast<int64_t>(values.size()),
                                       values.data()));
  }
  return worst;
}

}  // namespace

int put_exodus_fields(int file, const SolverMesh& mesh) {
  const ModelMesh& model = *mesh.source;
  if (model.cell_arrays.empty() && model.point_arrays.empty()) return 0;
  int worst = 0;
  if (!model.cell_arrays.empty()) worst = std::min(worst, put_names(file, EX_ELEM_BLOCK, model.cell_arrays));
  if (!model.point_arrays.empty()) worst = std::min(worst, put_names(file, EX_NODAL, model.point_arrays));
  const double time = 0;
  worst = std::min(worst, ex_put_time(file, 1, &time));
  for (std::size_t i = 0; i < model.cell_arrays.size(); ++i)
    worst = std::min(worst, put_cell_array(file, mesh, static_cast<int>(i + 1), model.cell_arrays[i]));
  for (std::size_t i = 0; i < model.point_arrays.size(); ++i) {
    std::vector<double> values;
    for (std::size_t v = 0; v < mesh.n_nodes(); ++v)
      values.push_back(model.point_arrays[i].values[mesh.rows.empty() ? v : mesh.rows[v]]);
    worst = std::min(worst, ex_put_var(file, 1, EX_NODAL, static_cast<int>(i + 1), 1,
                                       static_cast<int64_t>(values.size()), values.data()));
  }
  return worst;
}

}  // namespace geomesh::geomodel
