// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/exodus/exodus_fields.hpp"

#include <limits>
#include <string>
#include <vector>

#include "solver_mesh/names.hpp"

namespace geomesh::geomodel {

namespace {

template <class Array>
std::vector<std::string> add_names(NetcdfWriter& file, const std::string& kind, const std::vector<Array>& arrays) {
  SolverNames given(name_limit_exodus);
  std::vector<std::string> names;
  for (const Array& array : arrays) names.push_back(given.give(array.name));
  if (!names.empty()) file.add_texts("name_" + kind + "_var", "num_" + kind + "_var", names);
  return names;
}

void add_cell_array(NetcdfWriter& file, const SolverMesh& mesh, std::size_t number, const CellArray& array) {
  int n_blocks = 0;
  for (const CellBlock& block : mesh.blocks) {
    if (dimension_of(block.shape) != 3) continue;
    ++n_blocks;
    if (block.n_cells() == 0) continue;
    const std::string own = std::to_string(n_blocks);
    file.add_doubles("vals_elem_var" + std::to_string(number) + "eb" + own, {"time_step", "num_el_in_blk" + own},
                     [&block, &array] {
                       std::vector<double> values;
                       for (const std::size_t row : block.rows) values.push_back(array.values[row]);
                       values.resize(block.n_cells(), std::numeric_limits<double>::quiet_NaN());
                       return values;
                     });
  }
}

void add_point_array(NetcdfWriter& file, const SolverMesh& mesh, std::size_t number, const PointArray& array) {
  file.add_doubles("vals_nod_var" + std::to_string(number), {"time_step", "num_nodes"}, [&mesh, &array] {
    std::vector<double> values;
    for (std::size_t v = 0; v < mesh.n_nodes(); ++v)
      values.push_back(array.values[mesh.rows.empty() ? v : mesh.rows[v]]);
    return values;
  });
}

}  // namespace

std::vector<std::string> add_exodus_fields(NetcdfWriter& file, const SolverMesh& mesh) {
  const ModelMesh& model = *mesh.source;
  if (!model.cell_arrays.empty()) file.add_dimension("num_elem_var", model.cell_arrays.size());
  if (!model.point_arrays.empty()) file.add_dimension("num_nod_var", model.point_arrays.size());
  std::vector<std::string> names = add_names(file, "elem", model.cell_arrays);
  const std::vector<std::string> of_points = add_names(file, "nod", model.point_arrays);
  names.insert(names.end(), of_points.begin(), of_points.end());
  for (std::size_t i = 0; i < model.point_arrays.size(); ++i) add_point_array(file, mesh, i + 1, model.point_arrays[i]);
  for (std::size_t i = 0; i < model.cell_arrays.size(); ++i) add_cell_array(file, mesh, i + 1, model.cell_arrays[i]);
  return names;
}

}  // namespace geomesh::geomodel
