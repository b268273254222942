// SPDX-License-Identifier: GPL-3.0-or-later
#include "fields/fields.hpp"

#include <algorithm>
#include <array>
#include <functional>
#include <memory>
#include <string_view>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/readers.hpp"
#include "grid_sizes/size_grid.hpp"

namespace geomesh::geomodel {

namespace {

using Value = std::function<double(const Vec3&)>;

constexpr std::array<std::string_view, 6> endings_of_values{".csv", ".txt", ".xyz", ".vti", ".vtu", ".vtp"};

bool holds_values_in_space(const std::filesystem::path& file) {
  const std::string ending = file.extension().string();
  return std::find(endings_of_values.begin(), endings_of_values.end(), ending) != endings_of_values.end();
}

/// Reads a property from a grid file whose heights are the values of the property.
SizeGrid read_map_grid(const std::filesystem::path& file) {
  const FileContents contents = read_surface_file(file);
  if (contents.grids.size() != 1 || contents.surfaces.size() != 1)
    throw Error(ErrorKind::invalid_input,
                file.string() +
                    ": a field needs a file with one grid (GeoTIFF, Esri ASCII, Surfer, ZMAP ...) or with "
                    "values at points (.csv, .txt, .xyz, .vti, .vtu, .vtp)");
  std::vector<Vec3> places;
  std::vector<double> values;
  for (const Vec3& p : contents.surfaces.front().points) {
    places.push_back({p.x, p.y, 0});
    values.push_back(p.z);
  }
  if (places.empty()) throw Error(ErrorKind::invalid_input, file.string() + ": the grid holds no values");
  return SizeGrid(std::move(places), std::move(values));
}

Value read_field(const FieldSpec& field) {
  if (holds_values_in_space(field.file)) {
    const auto grid = std::make_shared<const SizeGrid>(read_value_grid(field.file, field.name));
    return [grid](const Vec3& p) { return grid->at(p); };
  }
  const auto grid = std::make_shared<const SizeGrid>(read_map_grid(field.file));
  return [grid](const Vec3& p) { return grid->at({p.x, p.y, 0}); };
}

template <class Array>
void put(std::vector<Array>& arrays, Array array) {
  const auto same = std::find_if(arrays.begin(), arrays.end(), [&](const Array& a) { return a.name == array.name; });
  if (same == arrays.end()) {
    arrays.push_back(std::move(array));
  } else {
    *same = std::move(array);
  }
}

}  // namespace

void add_fields(ModelMesh& mesh, const std::vector<FieldSpec>& fields) {
  for (const FieldSpec& field : fields) {
    const Value value = read_field(field);
    std::vector<double> values;
    if (field.place == FieldSpec::Place::cells) {
      for (const Tetrahedron& t : mesh.tetrahedra) {
        const Vec3 sum = mesh.points[t[0]] + mesh.points[t[1]] + mesh.points[t[2]] + mesh.points[t[3]];
        values.push_back(value(0.25 * sum + mesh.origin));
      }
      put(mesh.cell_arrays, CellArray{field.name, std::move(values), field.unit});
    } else {
      for (const Vec3& p : mesh.points) values.push_back(value(p + mesh.origin));
      for (const Vec3& p : mesh.midpoints.points) values.push_back(value(p + mesh.origin));
      put(mesh.point_arrays, PointArray{field.name, std::move(values), field.unit});
    }
  }
}

}  // namespace geomesh::geomodel
