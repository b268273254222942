// SPDX-License-Identifier: GPL-3.0-or-later
#include "picture_options.hpp"

#include <CLI/CLI.hpp>
#include <map>

#include "../help_format.hpp"

namespace geomesh::picture {

PictureOptions parse_picture_options(int argc, char** argv) {
  PictureOptions o;
  CLI::App options("Draw a mesh into a PNG file.", "geomesh picture");
  std::string mesh, output, size = "1200x900";
  const std::map<std::string, View> views{{"regions", View::regions},   {"cut", View::cut},
                                          {"elements", View::elements}, {"exploded", View::exploded},
                                          {"surfaces", View::surfaces}, {"quality", View::quality}};
  bool no_edges = false, no_legend = false;
  options.add_option("MESH", mesh, "A mesh (.vtu); of a project the mesh is made first")->required();
  options.add_option("-o", output, "The picture (.png)")->required()->type_name("NAME.png");
  options.add_option("--view", o.view, "regions, cut (default), elements, exploded, surfaces, quality")
      ->transform(CLI::CheckedTransformer(views));
  options.add_option("--size", size, "Width and height in pixels, as 1200x900")->capture_default_str();
  options.add_option("--azimuth", o.azimuth, "Where the camera stands: degrees clockwise from north")
      ->capture_default_str();
  options.add_option("--elevation", o.elevation, "Degrees of the camera above the horizon")
      ->check(CLI::Range(-89.0, 89.0))
      ->capture_default_str();
  options.add_option("--zoom", o.zoom, "2: twice as large")->check(CLI::Range(0.1, 100.0))->capture_default_str();
  options
      .add_option("--scale-z", o.scale_z,
                  "Vertical exaggeration (default: enough to distinguish the layers of a flat model)")
      ->check(CLI::Range(0.001, 1000.0));
  options.add_flag("--no-edges", no_edges, "Without the edges of elements");
  options.add_flag("--no-legend", no_legend, "Without names and colours");
  app::use_plain_help(options);
  try {
    options.parse(argc, argv);
    if (std::sscanf(size.c_str(), "%dx%d", &o.width, &o.height) != 2 || o.width < 50 || o.height < 50 ||
        o.width > 8000 || o.height > 8000)
      throw CLI::ValidationError("--size", "WIDTHxHEIGHT with 50 to 8000 pixels each was expected");
    if (!std::filesystem::is_regular_file(mesh)) throw CLI::ValidationError("MESH", "no such file: " + mesh);
  } catch (const CLI::ParseError& error) {
    const int status = options.exit(error);
    std::exit(status == 0 ? 0 : 2);
  }
  o.mesh = mesh;
  o.output = output;
  o.edges = !no_edges;
  o.legend = !no_legend;
  return o;
}

}  // namespace geomesh::picture
