// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/vtk_parse.hpp"

#include <vtkLogger.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkOutputWindow.h>

#include <algorithm>

#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

/// Takes VTK's complaints, which would else go to the terminal, as long as it stands.
class MessageWindow : public vtkOutputWindow {
 public:
  static MessageWindow* New();
  vtkTypeMacro(MessageWindow, vtkOutputWindow) void DisplayText(const char* text) override {
    if (text && messages.empty()) messages = text;
  }
  std::string messages;
};
vtkStandardNewMacro(MessageWindow)

}  // namespace

struct VtkMessages::Scope {
  vtkSmartPointer<vtkOutputWindow> before;
  vtkNew<MessageWindow> window;
};

VtkMessages::VtkMessages() : scope_(new Scope{vtkOutputWindow::GetInstance(), {}}) {
  vtkLogger::SetStderrVerbosity(vtkLogger::VERBOSITY_OFF);
  vtkOutputWindow::SetInstance(scope_->window);
}

VtkMessages::~VtkMessages() { vtkOutputWindow::SetInstance(scope_->before); }

/// The first telling line of a VTK message, whose own first line names a source file.
std::string VtkMessages::first_reason() const {
  std::string_view rest = scope_->window->messages;
  if (rest.empty()) return {};
  while (!rest.empty()) {
    const std::size_t end = std::min(rest.find('\n'), rest.size());
    const std::string_view line = trim(rest.substr(0, end));
    rest.remove_prefix(std::min(end + 1, rest.size()));
    if (line.empty() || line.starts_with("ERROR: In") || line.starts_with("Warning: In") ||
        line.starts_with("Generic Warning: In"))
      continue;
    const std::size_t colon = line.find("): ");
    return std::string(colon == std::string_view::npos ? line : line.substr(colon + 3));
  }
  return "no reason given";
}

}  // namespace geomesh::geomodel
