// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/vtk/vtk_arrays.hpp"

#include <limits>
#include <string_view>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel::checking {
namespace {

std::int32_t nearest_id(double value) {
  using Limits = std::numeric_limits<std::int32_t>;
  return value > Limits::min() && value <= Limits::max() ? static_cast<std::int32_t>(value) : Limits::min();
}

}  // namespace

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorKind::invalid_input, path.string() + ": " + why);
}

VtkData read_vtk_file(const std::filesystem::path& path, VtkData::Kind kind, May may) {
  const InputFile file = load_input_file(path);
  const bool is_legacy = is_vtk_legacy(file);
  if (!is_legacy && file.text().substr(0, 2048).find("<VTKFile") == std::string_view::npos)
    refuse(path, "does not begin as a VTK file");
  VtkData data = is_legacy ? read_vtk_legacy_data(file) : read_vtk_xml_data(file);
  if (data.kind != kind)
    refuse(path, std::string("is no VTK file of the kind that its extension says: it holds ") +
                     (data.kind == VtkData::Kind::poly   ? "PolyData"
                      : data.kind == VtkData::Kind::grid ? "an UnstructuredGrid"
                                                         : "ImageData"));
  if (may == May::not_be_empty && data.points.empty()) refuse(path, "holds no points: it is empty");
  return data;
}

std::vector<std::int32_t> integers_of(const VtkColumn& column) {
  std::vector<std::int32_t> values(column.n_tuples);
  for (std::size_t i = 0; i < values.size(); ++i) values[i] = nearest_id(column.number(i, 0));
  return values;
}

std::vector<std::int32_t> integers_of(const VtkTable& table, const char* name) {
  const VtkColumn* const column = table.numbers(name);
  return column ? integers_of(*column) : std::vector<std::int32_t>{};
}

std::map<std::int32_t, std::string> names_of(const VtkTable& field, const std::string& what) {
  std::map<std::int32_t, std::string> names;
  const std::string prefix = what + ":";
  for (const VtkColumn& column : field.columns) {
    if (column.is_text() || !column.name.starts_with(prefix)) continue;
    for (const std::int32_t id : integers_of(column)) names.emplace(id, column.name.substr(prefix.size()));
  }
  const std::vector<std::string> texts = texts_of(field, (what + "_names").c_str());
  const std::vector<std::int32_t> ids = integers_of(field, (what + "_ids").c_str());
  for (std::size_t i = 0; i < ids.size() && i < texts.size(); ++i) names.emplace(ids[i], texts[i]);
  return names;
}

std::vector<std::int32_t> ids_in_order(const VtkTable& field, const std::string& prefix) {
  std::vector<std::int32_t> ids;
  for (const VtkColumn& column : field.columns) {
    if (column.is_text() || !column.name.starts_with(prefix)) continue;
    for (const std::int32_t id : integers_of(column)) ids.push_back(id);
  }
  return ids;
}

std::vector<std::string> texts_of(const VtkTable& field, const char* name) {
  const VtkColumn* const column = field.texts(name);
  return column ? column->texts : std::vector<std::string>{};
}

std::vector<std::vector<std::int32_t>> lists_of(const VtkTable& field, const char* offsets_name, const char* ids_name,
                                                const std::filesystem::path& path) {
  std::vector<std::vector<std::int32_t>> lists;
  const auto offsets = integers_of(field, offsets_name), ids = integers_of(field, ids_name);
  for (std::size_t i = 0; i + 1 < offsets.size(); ++i) {
    if (offsets[i] < 0 || offsets[i + 1] < offsets[i] || static_cast<std::size_t>(offsets[i + 1]) > ids.size())
      refuse(path, std::string(offsets_name) + " and " + ids_name + " do not fit each other");
    lists.emplace_back(ids.begin() + offsets[i], ids.begin() + offsets[i + 1]);
  }
  return lists;
}

}  // namespace geomesh::geomodel::checking
