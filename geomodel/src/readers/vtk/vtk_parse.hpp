// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// VTK's XML readers on a file in memory, with their complaints made ours.
#pragma once

#include <vtkNew.h>
#include <vtkSmartPointer.h>

#include <memory>
#include <optional>
#include <string>

#include "readers/text/input_file.hpp"
#include "readers/vtk/vtk_xml_guard.hpp"

namespace geomesh::geomodel {

/// Takes VTK's complaints, which would else go to the terminal, as long as it stands.
class VtkMessages {
 public:
  VtkMessages();
  ~VtkMessages();
  VtkMessages(const VtkMessages&) = delete;
  VtkMessages& operator=(const VtkMessages&) = delete;
  /// The first telling line of the first complaint, whose own first line names a source file; empty where there was
  /// none.
  std::string first_reason() const;

 private:
  struct Scope;
  std::unique_ptr<Scope> scope_;
};

/// The file is parsed from memory, so that a lying size in it meets the bytes that are there.
template <class Reader, class Data>
vtkSmartPointer<Data> parse_vtk(const InputFile& file) {
  if (const std::string fault = fault_of_vtk_elements(file.text(), file.bytes.size()); !fault.empty()) file.fail(fault);
  const VtkMessages messages;
  vtkNew<Reader> reader;
  reader->ReadFromInputStringOn();
  const std::optional<std::string> whole = with_point_data(file.text());
  reader->SetInputString(whole ? *whole : file.bytes);
  if (!survives_sizes([&] { reader->Update(); })) file.fail("sizes in it are not those of what follows: it is damaged");
  if (const std::string reason = messages.first_reason(); !reason.empty()) file.fail("VTK cannot read it: " + reason);
  return reader->GetOutput();
}

}  // namespace geomesh::geomodel
