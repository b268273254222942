// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a picture is to show, from the command line of geomesh-picture.
#pragma once

#include <filesystem>
#include <string>

namespace geomesh::picture {

enum class View {
  regions,   ///< the whole, coloured by region
  cut,       ///< without the quarter that is nearest to the camera: plane walls
  elements,  ///< the same with whole elements: walls as the tetrahedra have them
  exploded,  ///< units moved apart along the vertical
  surfaces,  ///< horizons, faults and bodies with the edges of their faces; sides of the box left out
  quality,   ///< whole elements, coloured by the smallest dihedral angle
};

struct PictureOptions {
  std::filesystem::path mesh;  ///< .vtu; NAME.faces.vtp and NAME.curves.vtp beside it are used where they are
  std::filesystem::path output;
  View view = View::cut;
  int width = 1200, height = 900;
  double azimuth = 215;   ///< degrees clockwise from north (y): where the camera stands
  double elevation = 25;  ///< degrees above the horizon
  double zoom = 1;
  double scale_z = 0;  ///< 0: chosen by the shape of the model
  bool edges = true;
  bool legend = true;
};

/// Ends the program where help was asked for or an option is wrong.
PictureOptions parse_picture_options(int argc, char** argv);

}  // namespace geomesh::picture
