// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Builds a lit, coloured scene with a camera and a legend from the parts of a mesh.
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "mesh_parts.hpp"
#include "picture_options.hpp"

namespace geomesh::picture {

/// Returns the factor of vertical exaggeration as text, such as "5" or "2.5".
std::string scale_words(double scale);

/// Returns the vertical exaggeration that is used if the command line gives none, the same as on the HTML page.
double fitting_scale(const MeshFile& mesh);

/// Builds the scene of a view. Throws std::runtime_error if the mesh has nothing of the requested kind.
vtkSmartPointer<vtkRenderer> make_scene(const MeshFile& mesh, const PictureOptions& options);

/// Renders the picture at twice its size, scales it down by half, and writes it as PNG.
void write_picture(vtkRenderer& scene, const PictureOptions& options);

}  // namespace geomesh::picture
