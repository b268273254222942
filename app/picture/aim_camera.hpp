// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Where the camera stands, and what it sees of the scene.
#pragma once

#include <vtkRenderer.h>

#include <array>

#include "picture_options.hpp"

namespace geomesh::picture {

/// The direction from the model to the camera, in the map.
std::array<double, 2> towards_camera(const PictureOptions& options);

/// Makes what is in the scene fill the picture but for a margin and the scale of colours below. The legend takes a
/// share of the picture's width at the left.
void aim_camera(vtkRenderer& scene, const PictureOptions& options, double legend_share);

}  // namespace geomesh::picture
