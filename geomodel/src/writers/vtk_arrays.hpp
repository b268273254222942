// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Shared by what is written for looking at through VTK: arrays and settings under which the same mesh gives the same
/// bytes.
#pragma once

#include <vtkDataSet.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkSmartPointer.h>
#include <vtkStringArray.h>
#include <vtkXMLWriter.h>

#include <filesystem>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"

namespace geomesh::geomodel {

/// Float64 points.
vtkSmartPointer<vtkPoints> vtk_points(const std::vector<Vec3>& points);

/// Int32 array of `n` values.
template <class F>
vtkSmartPointer<vtkIntArray> int_array(const char* name, std::size_t n, F&& value) {
  auto array = vtkSmartPointer<vtkIntArray>::New();
  array->SetName(name);
  array->SetNumberOfTuples(static_cast<vtkIdType>(n));
  for (std::size_t i = 0; i < n; ++i) array->SetValue(static_cast<vtkIdType>(i), static_cast<int>(value(i)));
  return array;
}

/// Float64 array of `n` values.
template <class F>
vtkSmartPointer<vtkDoubleArray> double_array(const std::string& name, std::size_t n, F&& value) {
  auto array = vtkSmartPointer<vtkDoubleArray>::New();
  array->SetName(name.c_str());
  array->SetNumberOfTuples(static_cast<vtkIdType>(n));
  for (std::size_t i = 0; i < n; ++i) array->SetValue(static_cast<vtkIdType>(i), value(i));
  return array;
}

template <class F>
vtkSmartPointer<vtkStringArray> string_array(const char* name, std::size_t n, F&& value) {
  auto array = vtkSmartPointer<vtkStringArray>::New();
  array->SetName(name);
  array->SetNumberOfValues(static_cast<vtkIdType>(n));
  for (std::size_t i = 0; i < n; ++i) array->SetValue(static_cast<vtkIdType>(i), value(i));
  return array;
}

/// Appended raw data, zlib, 64-bit headers. Throws Error{usage} where the file cannot be written.
void write_vtk_xml(vtkXMLWriter& writer, vtkDataSet& data, const std::filesystem::path& file);

}  // namespace geomesh::geomodel
