// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The contents of a picture, from the command line of geomesh-picture.
#pragma once

#include <filesystem>
#include <string>

namespace geomesh::picture {

enum class View {
  regions,   ///< the whole model, coloured by region
  cut,       ///< the model without the quarter nearest to the camera, cut along planes
  elements,  ///< the model without the quarter nearest to the camera, cut along whole elements
  exploded,  ///< rock units drawn with vertical gaps between them
  surfaces,  ///< horizons, faults and bodies with the edges of their faces, without sides of the box
  quality,   ///< whole elements, coloured by the smallest dihedral angle
};

struct PictureOptions {
  std::filesystem::path mesh;  ///< a .vtu file; NAME.faces.vtp and NAME.curves.vtp beside it are used if they exist
  std::filesystem::path output;
  View view = View::cut;
  int width = 1200, height = 900;
  double azimuth = 215;   ///< direction to the camera in degrees clockwise from north (y)
  double elevation = 25;  ///< height of the camera in degrees above the horizon
  double zoom = 1;
  double scale_z = 0;  ///< vertical exaggeration; 0: chosen from the shape of the model
  bool edges = true;
  bool legend = true;
};

/// Parses the command line. Ends the program if help was requested or an option is wrong.
PictureOptions parse_picture_options(int argc, char** argv);

}  // namespace geomesh::picture
