// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/fields/read_field.hpp"

#include <cmath>
#include <string>

#include "level_sets/fields/place_words.hpp"
#include "readers/text/input_file.hpp"
#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {
namespace {

/// Returns the array of a VTK file that the project names; if it names none, the only scalar array. Null if there is
/// none.
const VtkColumn* array_of(const VtkTable& data, const std::string& name) {
  const VtkColumn* found = nullptr;
  for (const VtkColumn& column : data.columns) {
    if (column.is_text() || column.n_components != 1) continue;
    if (!name.empty() && name == column.name) return &column;
    if (!name.empty()) continue;
    if (found) return nullptr;
    found = &column;
  }
  return found;
}

std::string names_of(const VtkTable& data) {
  std::string names;
  for (const VtkColumn& column : data.columns) names += (names.empty() ? "" : ", ") + column.name;
  return names.empty() ? "none" : names;
}

[[noreturn]] void refuse_array(const InputFile& file, const LevelSetSpec& spec, const std::string& names) {
  if (spec.array.empty())
    file.fail("holds no array or several (" + names + "); name the one that is meant with 'array' in the entry");
  file.fail("has no array \"" + spec.array + "\" of one number each; it holds " + names);
}

/// Returns the grid of the points of a VTK image, which are stored row by row along x, then y, then z.
GridField::Lattice lattice_of(const InputFile& file, const std::vector<Vec3>& points) {
  GridField::Lattice lattice;
  if (points.empty()) return lattice;
  const Vec3 first = points.front(), last = points.back();
  std::size_t step = 1;
  // A grid has as many nodes along an axis as points are passed until the first point's coordinate recurs.
  for (std::size_t a = 0; a < 3; ++a) {
    std::size_t n = 1;
    while (n * step < points.size() && points[n * step][a] != first[a]) ++n;
    lattice.n[a] = n;
    lattice.origin[a] = first[a];
    lattice.spacing[a] = n > 1 ? (last[a] - first[a]) / static_cast<double>(n - 1) : 0;
    step *= n;
  }
  for (std::size_t a = 0, stride = 1; a < 3; stride *= lattice.n[a], ++a) {
    if (lattice.n[a] < 2) continue;
    const Vec3 along = points[stride] - first;
    for (std::size_t b = 0; b < 3; ++b)
      if (b != a && along[b] != 0) file.fail("its grid is turned (Direction); a grid along the axes was expected");
  }
  if (step != points.size()) file.fail("its grid is in several pieces; one piece was expected");
  return lattice;
}

/// Reads an image from a .vti file. If values belong to cells, the centres of the cells become the nodes of the grid.
GridField::Lattice read_vti(const InputFile& file, const LevelSetSpec& spec) {
  const VtkData image = read_vtk_xml_data(file);
  if (image.kind != VtkData::Kind::image) file.fail("holds no grid (ImageData), which was expected of a .vti");
  const VtkColumn* const at_points = array_of(image.point_data, spec.array);
  const VtkColumn* const at_cells = at_points ? nullptr : array_of(image.cell_data, spec.array);
  if (!at_points && !at_cells)
    refuse_array(file, spec, names_of(image.point_data) + " at points, " + names_of(image.cell_data) + " in cells");
  GridField::Lattice lattice = lattice_of(file, image.points);
  if (at_cells)
    for (std::size_t a = 0; a < 3; ++a) {
      lattice.origin[a] += 0.5 * lattice.spacing[a];
      lattice.n[a] = lattice.n[a] > 0 ? lattice.n[a] - 1 : 0;
    }
  lattice.nodes = (at_points ? at_points : at_cells)->numbers();
  return lattice;
}

TetrahedralField read_vtu(const InputFile& file, const LevelSetSpec& spec) {
  const VtkData grid = read_vtk_xml_data(file);
  const VtkColumn* const array = array_of(grid.point_data, spec.array);
  if (!array) refuse_array(file, spec, names_of(grid.point_data) + " at points");
  TetrahedralField field;
  field.values = array->numbers();
  field.points = grid.points;
  for (std::size_t c = 0; c < grid.cells.size(); ++c) {
    const std::uint8_t type = grid.cells.types[c];
    if (type == vtk_cell::triangle || type == vtk_cell::line || type == vtk_cell::vertex) continue;  // beside the cells
    if (type != vtk_cell::tetrahedron)
      file.fail("cell " + std::to_string(c) + " (from 0) is no tetrahedron; a field on tetrahedra was expected");
    const auto corners = grid.cells.of(c);
    field.cells.push_back({corners[0], corners[1], corners[2], corners[3]});
  }
  if (field.cells.empty()) file.fail("holds no tetrahedra");
  if (field.values.size() != field.points.size())
    file.fail("it holds another number of values than it has points: it is damaged");
  for (std::size_t i = 0; i < field.points.size(); ++i)
    if (!std::isfinite(field.values[i]))
      file.fail("the value of point " + std::to_string(i) + " (from 0) at " + place_words(field.points[i]) +
                " is not finite; give the field a value everywhere");
  return field;
}

bool is_netcdf_or_hdf5(const InputFile& file) {
  const std::string_view text = file.text();
  return text.starts_with("CDF\1") || text.starts_with("CDF\2") || text.starts_with("CDF\5") ||
         text.starts_with("\x89HDF\r\n\x1a\n");
}

void check_lattice(const InputFile& file, const GridField::Lattice& lattice) {
  for (std::size_t a = 0; a < 3; ++a) {
    if (lattice.n[a] < 2) file.fail("its grid has fewer than two nodes along an axis");
    if (!(lattice.spacing[a] > 0)) file.fail("the spacing of its grid is not above zero");
  }
  if (lattice.nodes.size() != lattice.n[0] * lattice.n[1] * lattice.n[2])
    file.fail("it holds another number of values than its grid has nodes: it is damaged");
  for (std::size_t i = 0; i < lattice.nodes.size(); ++i) {
    if (std::isfinite(lattice.nodes[i])) continue;
    const std::size_t ix = i % lattice.n[0], iy = i / lattice.n[0] % lattice.n[1], iz = i / lattice.n[0] / lattice.n[1];
    const Vec3 place{lattice.origin.x + lattice.spacing.x * static_cast<double>(ix),
                     lattice.origin.y + lattice.spacing.y * static_cast<double>(iy),
                     lattice.origin.z + lattice.spacing.z * static_cast<double>(iz)};
    file.fail("the value of node (" + std::to_string(ix) + ", " + std::to_string(iy) + ", " + std::to_string(iz) +
              ") (from 0) at " + place_words(place) + " is not finite; give the field a value everywhere");
  }
}

}  // namespace

FieldOfFile read_field_file(const LevelSetSpec& spec) {
  const InputFile file = load_input_file(spec.file);
  if (file.extension() == ".vtu") return read_vtu(file, spec);
  GridField::Lattice lattice;
  if (file.extension() == ".vti") {
    lattice = read_vti(file, spec);
  } else if (file.extension() == ".npy") {
    lattice = read_npy(spec);
  } else if (is_netcdf_or_hdf5(file)) {
    lattice = read_netcdf_lattice(spec);
  } else {
    file.fail(
        "is no field that is read; a grid (.vti, .npy, netCDF) or tetrahedra (.vtu) with a value at each point were "
        "expected");
  }
  check_lattice(file, lattice);
  return lattice;
}

}  // namespace geomesh::geomodel
