// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh picture`: draws a mesh by the program geomesh-picture beside this one, on a virtual display if necessary.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "options.hpp"

namespace geomesh::app {

/// Returns the drawing program's exit status. Throws Error{usage} if that program or a display is missing, and the
/// errors of the readers if the mesh is damaged.
int draw_picture(const PictureCommand& command, const RunContext& context);

}  // namespace geomesh::app
