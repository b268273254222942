// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What the readers of VTK's files have in common: files read with guards, and arrays by their names.
#pragma once

#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkObject.h>
#include <vtkPointSet.h>

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "readers/vtk/vtk_parse.hpp"
#include "readers/vtk/vtk_xml_guard.hpp"

namespace geomesh::geomodel::checking {

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& why);
void require_readable(const std::filesystem::path& path);
/// Up to the appended data, which are not text.
std::string text_of(const std::filesystem::path& path);

/// Keeps VTK from composing its error messages while alive: it prints them. The one for broken cell data of a file
/// without point data dereferences a null pointer (vtkXMLDataReader::ReadPieceData, up to 9.1 at least). A read that
/// failed leaves no points.
class QuietVtk {
 public:
  QuietVtk() : before_(vtkObject::GetGlobalWarningDisplay()) { vtkObject::SetGlobalWarningDisplay(0); }
  ~QuietVtk() { vtkObject::SetGlobalWarningDisplay(before_); }
  QuietVtk(const QuietVtk&) = delete;
  QuietVtk& operator=(const QuietVtk&) = delete;

 private:
  int before_;
};

inline constexpr const char* sizes_lie = "sizes in it are not those of what follows: it is damaged";

/// A mesh holds points; a model may have no curve, and another tool's mesh no face.
enum class May { not_be_empty, be_empty };

/// Runs the reader; refuses where it left nothing.
template <class Reader>
void update(Reader& reader, const std::filesystem::path& path, May may = May::not_be_empty) {
  const QuietVtk quiet;
  reader.SetFileName(path.string().c_str());
  if (!survives_sizes([&] { reader.Update(); })) refuse(path, sizes_lie);
  const bool failed = reader.GetErrorCode() != 0 || !reader.GetOutput();
  if (failed || (may == May::not_be_empty && reader.GetOutput()->GetNumberOfPoints() == 0))
    refuse(path, "VTK finds no points in it: it is empty, truncated or damaged");
}

template <class Reader>
void read_xml(Reader& reader, const std::filesystem::path& path, May may = May::not_be_empty) {
  require_readable(path);
  if (!reader.CanReadFile(path.string().c_str()))
    refuse(path, "is not a VTK XML file of the kind that its extension says");
  const std::string text = text_of(path), fault = fault_of_vtk_elements(text, std::filesystem::file_size(path));
  if (!fault.empty()) refuse(path, fault);
  const bool says_none = text.find("NumberOfPoints=\"0\"") != std::string::npos;  // a read that failed leaves none too
  update(reader, path, says_none ? may : May::not_be_empty);
}

std::vector<Vec3> points_of(vtkPointSet& data, bool& single_precision);
std::vector<std::int32_t> integers_of(vtkDataArray& array);
std::vector<std::int32_t> integers_of(vtkFieldData& data, const char* name);
/// Names by id: the field array `region:chalk` holds the id of the region chalk. Files of geomesh 0.1 have the pair of
/// arrays <what>_ids and <what>_names instead.
std::map<std::int32_t, std::string> names_of(vtkFieldData& field, const std::string& what);
/// Points of a cell, refused where the file names a point that it does not hold.
std::vector<VertexIndex> cell_points(vtkCellArray& cells, vtkIdType cell, std::size_t n_points,
                                     const std::filesystem::path& path);
/// The ids in arrays whose names begin so, in the order of the file.
std::vector<std::int32_t> ids_in_order(vtkFieldData& field, const std::string& prefix);
std::vector<std::string> texts_of(vtkFieldData& field, const char* name);
/// Lists one after the other, cut at the offsets.
std::vector<std::vector<std::int32_t>> lists_of(vtkFieldData& field, const char* offsets_name, const char* ids_name,
                                                const std::filesystem::path& path);

}  // namespace geomesh::geomodel::checking
