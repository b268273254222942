// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Position and view of the camera.
#pragma once

#include <vtkRenderer.h>

#include <array>

#include "picture_options.hpp"

namespace geomesh::picture {

/// Returns the horizontal direction from the model to the camera.
std::array<double, 2> towards_camera(const PictureOptions& options);

/// Fits the scene into the picture, with a margin and room for the scale of colours below. The legend takes a share of
/// the picture's width at the left.
void aim_camera(vtkRenderer& scene, const PictureOptions& options, double legend_share);

}  // namespace geomesh::picture
