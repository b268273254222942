// SPDX-License-Identifier: GPL-3.0-or-later
// NAME.vtu: tetrahedra of named regions.
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkCellType.h>
#include <vtkPointData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "geomesh/geomodel/writers.hpp"
#include "writers/vtk_arrays.hpp"

namespace geomesh::geomodel {

void write_vtu(const ModelMesh& mesh, const std::filesystem::path& file) {
  vtkSmartPointer<vtkUnstructuredGrid> grid = vtkSmartPointer<vtkUnstructuredGrid>::New();
  grid->SetPoints(vtk_points(mesh.points));
  vtkSmartPointer<vtkCellArray> cells = vtkSmartPointer<vtkCellArray>::New();
  cells->AllocateExact(static_cast<vtkIdType>(mesh.tetrahedra.size()),
                       static_cast<vtkIdType>(4 * mesh.tetrahedra.size()));
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const vtkIdType v[4] = {t[0], t[1], t[2], t[3]};
    cells->InsertNextCell(4, v);
  }
  grid->SetCells(VTK_TETRA, cells);
  grid->GetCellData()->AddArray(
      int_array("region", mesh.tet_region.size(), [&](std::size_t i) { return mesh.tet_region[i]; }));
  grid->GetCellData()->SetActiveScalars("region");
  for (const RegionAttribute& attribute : mesh.attributes) {
    const auto value = [&](std::size_t i) {
      return attribute.by_region[static_cast<std::size_t>(mesh.tet_region[i] - 1)];
    };
    grid->GetCellData()->AddArray(double_array(attribute.name, mesh.tet_region.size(), value));
  }
  for (const CellArray& array : mesh.cell_arrays)
    grid->GetCellData()->AddArray(
        double_array(array.name, array.values.size(), [&](std::size_t i) { return array.values[i]; }));
  grid->GetPointData()->AddArray(
      int_array("kind", mesh.point_kind.size(), [&](std::size_t i) { return mesh.point_kind[i]; }));
  grid->GetPointData()->AddArray(
      int_array("input_vertex", mesh.input_vertex.size(), [&](std::size_t i) { return mesh.input_vertex[i]; }));
  add_region_names(mesh, *grid->GetFieldData());
  add_groups(mesh, *grid->GetFieldData());
  add_origin(mesh, *grid->GetFieldData());
  vtkSmartPointer<vtkXMLUnstructuredGridWriter> writer = vtkSmartPointer<vtkXMLUnstructuredGridWriter>::New();
  write_vtk_xml(*writer, *grid, file);
}

}  // namespace geomesh::geomodel
