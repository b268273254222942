// SPDX-License-Identifier: GPL-3.0-or-later
#include "level_sets/fields/read_field.hpp"

#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkImageData.h>
#include <vtkMatrix3x3.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <string>

#include "level_sets/fields/place_words.hpp"
#include "readers/text/input_file.hpp"
#include "readers/vtk/vtk_parse.hpp"

namespace geomesh::geomodel {
namespace {

/// The array of the entry; without a name, the only one of one number each. Null where there is none.
vtkDataArray* array_of(vtkDataSetAttributes& data, const std::string& name) {
  vtkDataArray* found = nullptr;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i) {
    vtkDataArray* const array = data.GetArray(i);
    if (!array || array->GetNumberOfComponents() != 1) continue;
    if (!name.empty() && array->GetName() && name == array->GetName()) return array;
    if (!name.empty()) continue;
    if (found) return nullptr;
    found = array;
  }
  return found;
}

std::string names_of(vtkDataSetAttributes& data) {
  std::string names;
  for (int i = 0; i < data.GetNumberOfArrays(); ++i)
    if (const vtkDataArray* array = data.GetArray(i); array && data.GetArrayName(i))
      names += (names.empty() ? "" : ", ") + std::string(data.GetArrayName(i));
  return names.empty() ? "none" : names;
}

[[noreturn]] void refuse_array(const InputFile& file, const LevelSetSpec& spec, const std::string& names) {
  if (spec.array.empty())
    file.fail("holds no array or several (" + names + "); name the one that is meant with 'array' in the entry");
  file.fail("has no array \"" + spec.array + "\" of one number each; it holds " + names);
}

std::vector<double> numbers(vtkDataArray& array) {
  std::vector<double> values;
  for (vtkIdType i = 0; i < array.GetNumberOfTuples(); ++i) values.push_back(array.GetComponent(i, 0));
  return values;
}

/// Values of cells stand at the centres of the cells, which are then the nodes.
GridField::Lattice read_vti(const InputFile& file, const LevelSetSpec& spec) {
  const auto image = parse_vtk<vtkXMLImageDataReader, vtkImageData>(file);
  if (!image->GetDirectionMatrix()->IsIdentity())
    file.fail("its grid is turned (Direction); a grid along the axes was expected");
  vtkDataArray* at_points = array_of(*image->GetPointData(), spec.array);
  vtkDataArray* at_cells = at_points ? nullptr : array_of(*image->GetCellData(), spec.array);
  if (!at_points && !at_cells)
    refuse_array(file, spec,
                 names_of(*image->GetPointData()) + " at points, " + names_of(*image->GetCellData()) + " in cells");
  GridField::Lattice lattice;
  double origin[3], spacing[3];
  int extent[6];
  image->GetOrigin(origin);
  image->GetSpacing(spacing);
  image->GetExtent(extent);
  for (std::size_t a = 0; a < 3; ++a) {
    lattice.spacing[a] = spacing[a];
    lattice.origin[a] = origin[a] + spacing[a] * (extent[2 * a] + (at_cells ? 0.5 : 0));
    const int n = extent[2 * a + 1] - extent[2 * a] + (at_cells ? 0 : 1);
    lattice.n[a] = n > 0 ? static_cast<std::size_t>(n) : 0;
  }
  lattice.nodes = numbers(at_points ? *at_points : *at_cells);
  return lattice;
}

TetrahedralField read_vtu(const InputFile& file, const LevelSetSpec& spec) {
  const auto grid = parse_vtk<vtkXMLUnstructuredGridReader, vtkUnstructuredGrid>(file);
  vtkDataArray* const array = array_of(*grid->GetPointData(), spec.array);
  if (!array) refuse_array(file, spec, names_of(*grid->GetPointData()) + " at points");
  TetrahedralField field;
  field.values = numbers(*array);
  for (vtkIdType i = 0; i < grid->GetNumberOfPoints(); ++i) {
    double p[3];
    grid->GetPoint(i, p);
    field.points.push_back({p[0], p[1], p[2]});
  }
  vtkNew<vtkIdList> ids;
  for (vtkIdType c = 0; c < grid->GetNumberOfCells(); ++c) {
    const int type = grid->GetCellType(c);
    if (type == VTK_TRIANGLE || type == VTK_LINE || type == VTK_VERTEX) continue;  // faces beside the cells
    if (type != VTK_TETRA)
      file.fail("cell " + std::to_string(c) + " (from 0) is no tetrahedron; a field on tetrahedra was expected");
    grid->GetCellPoints(c, ids);
    Tetrahedron t;
    for (std::size_t i = 0; i < 4; ++i) t[i] = static_cast<VertexIndex>(ids->GetId(static_cast<vtkIdType>(i)));
    field.cells.push_back(t);
  }
  if (field.cells.empty()) file.fail("holds no tetrahedra");
  for (std::size_t i = 0; i < field.points.size(); ++i)
    if (!std::isfinite(field.values[i]))
      file.fail("the value of point " + std::to_string(i) + " (from 0) at " + place_words(field.points[i]) +
                " is not finite; give the field a value everywhere");
  return field;
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
  } else {
    file.fail(
        "is no field that is read; a grid (.vti, .npy) or tetrahedra (.vtu) with a value at each point were "
        "expected");
  }
  check_lattice(file, lattice);
  return lattice;
}

}  // namespace geomesh::geomodel
