// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtk_arrays.hpp"

#include <vtkDoubleArray.h>
#include <vtkPoints.h>
#include <vtkZLibDataCompressor.h>

#include <fstream>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/writers.hpp"

namespace geomesh::geomodel {

vtkSmartPointer<vtkPoints> vtk_points(const std::vector<Vec3>& points) {
  auto result = vtkSmartPointer<vtkPoints>::New();
  result->SetDataTypeToDouble();
  result->SetNumberOfPoints(static_cast<vtkIdType>(points.size()));
  for (std::size_t i = 0; i < points.size(); ++i)
    result->SetPoint(static_cast<vtkIdType>(i), points[i].x, points[i].y, points[i].z);
  return result;
}

void add_region_names(const ModelMesh& mesh, vtkFieldData& field) {
  const std::size_t n = mesh.regions.size();
  field.AddArray(int_array("region_ids", n, [&](std::size_t i) { return mesh.regions[i].id; }));
  field.AddArray(string_array("region_names", n, [&](std::size_t i) { return mesh.regions[i].name; }));
}

void add_groups(const ModelMesh& mesh, vtkFieldData& field) {
  if (mesh.groups.empty()) return;
  std::vector<std::size_t> offsets{0};
  std::vector<std::int32_t> ids;
  for (const RegionGroup& group : mesh.groups) {
    ids.insert(ids.end(), group.regions.begin(), group.regions.end());
    offsets.push_back(ids.size());
  }
  field.AddArray(string_array("group_names", mesh.groups.size(), [&](std::size_t i) { return mesh.groups[i].name; }));
  field.AddArray(int_array("group_offsets", offsets.size(), [&](std::size_t i) { return offsets[i]; }));
  field.AddArray(int_array("group_region_ids", ids.size(), [&](std::size_t i) { return ids[i]; }));
}

void add_surface_names(const ModelMesh& mesh, vtkFieldData& field) {
  const std::size_t n = mesh.surfaces.size();
  field.AddArray(int_array("surface_ids", n, [&](std::size_t i) { return mesh.surfaces[i].id; }));
  field.AddArray(string_array("surface_names", n, [&](std::size_t i) { return mesh.surfaces[i].name; }));
  field.AddArray(
      string_array("surface_kinds", n, [&](std::size_t i) { return std::string(to_string(mesh.surfaces[i].kind)); }));
}

void add_origin(const ModelMesh& mesh, vtkFieldData& field) {
  if (mesh.origin == Vec3{0, 0, 0}) return;
  auto origin = vtkSmartPointer<vtkDoubleArray>::New();
  origin->SetName("origin");
  origin->SetNumberOfComponents(3);
  origin->InsertNextTuple3(mesh.origin.x, mesh.origin.y, mesh.origin.z);
  field.AddArray(origin);
}

void write_vtk_xml(vtkXMLWriter& writer, vtkDataSet& data, const std::filesystem::path& file) {
  const auto refuse = [&] {
    throw Error(ErrorKind::usage, "cannot write " + file.string() + ": is the folder there, writable and not full?");
  };
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    if (!std::ofstream(temporary)) refuse();  // before VTK prints its own lines about it
    vtkSmartPointer<vtkZLibDataCompressor> compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
    writer.SetInputDataObject(&data);
    writer.SetFileName(temporary.c_str());
    writer.SetDataModeToAppended();
    writer.EncodeAppendedDataOff();
    writer.SetCompressor(compressor);
    writer.SetHeaderTypeToUInt64();
    writer.SetByteOrderToLittleEndian();
    if (writer.Write() == 0 || writer.GetErrorCode() != 0) refuse();
  });
}

}  // namespace geomesh::geomodel
