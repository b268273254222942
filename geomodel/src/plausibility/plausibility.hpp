// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Doubts about the inputs of a project, before anything is built: data that cannot be what they are taken for.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "coordinates/project_inputs.hpp"
#include "geomesh/geomodel/project.hpp"

namespace geomesh::geomodel {

/// One doubt: what is odd, about which inputs, how sure it is, and which key mends it. Causes are told once, with all
/// the inputs that they concern.
struct Finding {
  enum class Sureness {
    certain,   ///< no model can come of it: the run ends
    probable,  ///< a warning
    possible,  ///< a note: it may be meant
  };
  Sureness sureness = Sureness::probable;
  std::string cause;                ///< "outside", "open body", ...: one word or two, for programs
  std::vector<std::string> inputs;  ///< surfaces or wells
  std::string text;                 ///< for a person: what, where
  std::string remedy;               ///< what the user can do, with the key
};

/// All doubts, the most certain first, then in the order of the surfaces. `volume`: bounds of the model in the frame of
/// the inputs; nothing where the project has no box. Cost: near-linear in the points and triangles.
std::vector<Finding> find_doubts(const Project& project, const ProjectInputs& inputs,
                                 const std::optional<Box3>& volume);

/// "top, base lie outside the box ...; REMEDY".
std::string to_text(const Finding& finding);

/// Throws Error{invalid_input} with all certain findings where there are any.
void refuse_nonsense(const std::vector<Finding>& findings);

}  // namespace geomesh::geomodel
