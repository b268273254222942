// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/vtk/vtk_arrays.hpp"

#include <vtkAbstractArray.h>
#include <vtkPoints.h>
#include <vtkStringArray.h>

#include <fstream>
#include <limits>
#include <string_view>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel::checking {
namespace {

/// What is no 32-bit number (an array of floats may hold anything) becomes the least one, which no id is.
std::int32_t nearest_id(double value) {
  using Limits = std::numeric_limits<std::int32_t>;
  return value > Limits::min() && value <= Limits::max() ? static_cast<std::int32_t>(value) : Limits::min();
}

}  // namespace

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why) {
  throw Error(ErrorKind::invalid_input, path.string() + ": " + why);
}

void require_readable(const std::filesystem::path& path) {
  if (!std::ifstream(path)) throw Error(ErrorKind::usage, path.string() + ": cannot be opened");
}

std::string text_of(const std::filesystem::path& path) {
  constexpr std::string_view last = "<AppendedData";
  std::ifstream in(path, std::ios::binary);
  std::string text;
  for (char block[1 << 16]; in.read(block, sizeof block) || in.gcount() > 0;) {
    const std::size_t seen = text.size() < last.size() ? 0 : text.size() - last.size();
    text.append(block, static_cast<std::size_t>(in.gcount()));
    if (const std::size_t at = text.find(last, seen); at != std::string::npos) return text.substr(0, at);
  }
  return text;
}

std::vector<Vec3> points_of(vtkPointSet& data, bool& single_precision) {
  std::vector<Vec3> points(static_cast<std::size_t>(data.GetNumberOfPoints()));
  for (std::size_t i = 0; i < points.size(); ++i) {
    double p[3];
    data.GetPoint(static_cast<vtkIdType>(i), p);
    points[i] = {p[0], p[1], p[2]};
  }
  single_precision = data.GetPoints() && data.GetPoints()->GetDataType() == VTK_FLOAT;
  return points;
}

std::vector<std::int32_t> integers_of(vtkDataArray& array) {
  std::vector<std::int32_t> values(static_cast<std::size_t>(array.GetNumberOfTuples()));
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = nearest_id(array.GetComponent(static_cast<vtkIdType>(i), 0));
  return values;
}

std::vector<std::int32_t> integers_of(vtkFieldData& data, const char* name) {
  vtkDataArray* array = data.GetArray(name);
  return array ? integers_of(*array) : std::vector<std::int32_t>{};
}

std::map<std::int32_t, std::string> names_of(vtkFieldData& field, const std::string& what) {
  std::map<std::int32_t, std::string> names;
  const std::string prefix = what + ":";
  for (int i = 0; i < field.GetNumberOfArrays(); ++i) {
    const char* const name = field.GetArrayName(i);
    vtkDataArray* const array = field.GetArray(i);
    if (!name || !array || std::string_view(name).substr(0, prefix.size()) != prefix) continue;
    for (const std::int32_t id : integers_of(*array)) names.emplace(id, name + prefix.size());
  }
  auto* texts = vtkStringArray::SafeDownCast(field.GetAbstractArray((what + "_names").c_str()));
  const std::vector<std::int32_t> ids = integers_of(field, (what + "_ids").c_str());
  if (texts)
    for (std::size_t i = 0; i < ids.size() && i < static_cast<std::size_t>(texts->GetNumberOfValues()); ++i)
      names.emplace(ids[i], texts->GetValue(static_cast<vtkIdType>(i)));
  return names;
}

std::vector<VertexIndex> cell_points(vtkCellArray& cells, vtkIdType cell, std::size_t n_points,
                                     const std::filesystem::path& path) {
  vtkIdType n = 0;
  const vtkIdType* ids = nullptr;
  cells.GetCellAtId(cell, n, ids);
  std::vector<VertexIndex> result;
  for (vtkIdType i = 0; i < n; ++i) {
    if (ids[i] < 0 || static_cast<std::size_t>(ids[i]) >= n_points)
      refuse(path, "cell " + std::to_string(cell) + " names point " + std::to_string(ids[i]) + " of " +
                       std::to_string(n_points));
    result.push_back(static_cast<VertexIndex>(ids[i]));
  }
  return result;
}

std::vector<std::int32_t> ids_in_order(vtkFieldData& field, const std::string& prefix) {
  std::vector<std::int32_t> ids;
  for (int i = 0; i < field.GetNumberOfArrays(); ++i) {
    const char* const name = field.GetArrayName(i);
    vtkDataArray* const array = field.GetArray(i);
    if (!name || !array || !std::string_view(name).starts_with(prefix)) continue;
    for (const std::int32_t id : integers_of(*array)) ids.push_back(id);
  }
  return ids;
}

std::vector<std::string> texts_of(vtkFieldData& field, const char* name) {
  std::vector<std::string> texts;
  auto* array = vtkStringArray::SafeDownCast(field.GetAbstractArray(name));
  for (vtkIdType i = 0; array && i < array->GetNumberOfValues(); ++i) texts.push_back(array->GetValue(i));
  return texts;
}

std::vector<std::vector<std::int32_t>> lists_of(vtkFieldData& field, const char* offsets_name, const char* ids_name,
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
