// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Finds implausible inputs of a project before anything is built: data that cannot be what they are declared to be.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coordinates/project_inputs.hpp"
#include "geomesh/geomodel/project.hpp"

namespace geomesh::geomodel {

/// One doubt about the inputs: what is odd, which inputs it concerns, how certain it is, and which key corrects it.
/// Each cause is reported once, with all inputs that it concerns.
struct Finding {
  enum class Sureness {
    certain,   ///< the input is certainly wrong and no model is possible, so the run ends
    probable,  ///< a warning
    possible,  ///< the input is odd, but may be meant so: a note
  };
  Sureness sureness = Sureness::probable;
  std::string cause;                ///< cause in one or two words for programs: "outside", "open body", ...
  std::vector<std::string> inputs;  ///< surfaces or wells
  std::string text;                 ///< text for the user: what is odd in the inputs, and where
  std::string remedy;               ///< remedy for the user, with the key of the project file
};

/// Returns all doubts about the inputs, the most certain first, then in the order of the surfaces. `volume` is the
/// bounding box of the model in the frame of the inputs; nothing if the project has no box. The cost is nearly linear
/// in the number of points and triangles.
std::vector<Finding> find_doubts(const Project& project, const ProjectInputs& inputs,
                                 const std::optional<Box3>& volume);

/// Formats a finding as "top, base lie outside the box ...; REMEDY".
std::string to_text(const Finding& finding);

/// Throws Error{invalid_input} with all findings that are certain; returns if there are none.
void refuse_nonsense(const std::vector<Finding>& findings);

}  // namespace geomesh::geomodel
