// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From the parts of a mesh to a lit, coloured scene with a camera and a legend.
#pragma once

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>

#include "mesh_parts.hpp"
#include "picture_options.hpp"

namespace geomesh::picture {

/// "5", "2.5": how often heights are drawn.
std::string scale_words(double scale);

/// How often heights are drawn where the command line does not say: as in the page.
double fitting_scale(const MeshFile& mesh);

/// Throws std::runtime_error where there is nothing of the kind asked for.
vtkSmartPointer<vtkRenderer> make_scene(const MeshFile& mesh, const PictureOptions& options);

/// Renders twice as large, halves, and writes the PNG.
void write_picture(vtkRenderer& scene, const PictureOptions& options);

}  // namespace geomesh::picture
