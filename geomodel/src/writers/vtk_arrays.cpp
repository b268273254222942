// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtk_arrays.hpp"

#include <vtkPoints.h>
#include <vtkZLibDataCompressor.h>

#include <fstream>

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

void write_vtk_xml(vtkXMLWriter& writer, vtkDataSet& data, const std::filesystem::path& file) {
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    if (!std::ofstream(temporary)) refuse_to_write(file);  // before VTK prints its own lines about it
    vtkSmartPointer<vtkZLibDataCompressor> compressor = vtkSmartPointer<vtkZLibDataCompressor>::New();
    writer.SetInputDataObject(&data);
    writer.SetFileName(temporary.c_str());
    writer.SetDataModeToAppended();
    writer.EncodeAppendedDataOff();
    writer.SetCompressor(compressor);
    writer.SetHeaderTypeToUInt64();
    writer.SetByteOrderToLittleEndian();
    if (writer.Write() == 0 || writer.GetErrorCode() != 0) refuse_to_write(file);
  });
}

}  // namespace geomesh::geomodel
