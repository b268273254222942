// SPDX-License-Identifier: GPL-3.0-or-later
#include "output_flags.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/formats.hpp"

namespace geomesh::app {

namespace {

geomodel::FieldSpec field_of(const std::string& text, geomodel::FieldSpec::Place place) {
  const std::size_t at = text.find('=');
  if (at == 0 || at == std::string::npos || at + 1 == text.size())
    throw Error(ErrorKind::usage, "--field " + text + ": NAME=FILE was expected");
  return {text.substr(0, at), text.substr(at + 1), place, ""};
}

geomodel::FaultZone zone_of(const std::string& text) {
  const auto refuse = [&] {
    return Error(ErrorKind::usage, "--fault-zone " + text + ": SURFACE=THICKNESS or SURFACE=THICKNESS,LAYERS expected");
  };
  const std::size_t at = text.rfind('='), comma = text.find(',', at == std::string::npos ? 0 : at);
  if (at == 0 || at == std::string::npos) throw refuse();
  geomodel::FaultZone zone{text.substr(0, at)};
  char* end = nullptr;
  zone.thickness = std::strtod(text.c_str() + at + 1, &end);
  const bool whole = end == text.c_str() + std::min(comma, text.size());
  if (!whole || !(zone.thickness > 0) || !std::isfinite(zone.thickness)) throw refuse();
  if (comma != std::string::npos) {
    const unsigned long layers = std::strtoul(text.c_str() + comma + 1, &end, 10);
    if (*end != 0 || layers < 1 || layers > geomodel::most_zone_layers) throw refuse();
    zone.layers = static_cast<unsigned>(layers);
  }
  return zone;
}

}  // namespace

void OutputFlags::add_to(CLI::App& app) {
  app.add_option("--format", format_, "Format, where the extension does not say which (msh22, msh-binary, ogs ...)")
      ->check(CLI::IsMember(geomodel::mesh_formats()));
  app.add_option("--groups", groups_, "whole: a group for each surface and curve; pieces: by pairs of regions; both")
      ->check(CLI::IsMember({"whole", "pieces", "both"}))
      ->capture_default_str();
  app.add_flag("--no-inner-faces", no_inner_faces_, "Leave out faces between two regions");
  app.add_flag("--no-curves", no_curves_, "Leave out curves and named points");
  app.add_option("--order", order_, "Elements of first or second order; of convert the default is that of MESH")
      ->check(CLI::Range(1, 2));
  app.add_option("--region-array", region_array_, "VTU: name of the first cell array")
      ->check(CLI::IsMember({"region", "MaterialIDs", "attribute"}))
      ->capture_default_str();
  app.add_flag("--single-grid", single_grid_, "VTU: faces and curves as 2D and 1D cells of the one grid");
  app.add_flag("--node-arrays", node_arrays_, "VTU: each surface and curve as a point array of 0 and 1");
  app.add_option("--compression", compression_, "VTU: none, fast (zlib 1) or small (zlib 6)")
      ->check(CLI::IsMember({"none", "fast", "small"}))
      ->capture_default_str();
  app.add_option("--split", split_, "Double the nodes along this surface (may be given several times)")
      ->type_name("SURFACE")
      ->take_all()
      ->expected(1);
  app.add_option("--fault-zone", zones_,
                 "Volume elements between the two sides of this surface (may be given several times)")
      ->type_name("SURFACE=THICKNESS[,LAYERS]")
      ->take_all()
      ->expected(1);
  app.add_option("--partitions", partitions_, "Parts, a file for each: .pvtu, .e, .msh")
      ->check(CLI::Range(1u, geomodel::most_partitions))
      ->capture_default_str();
  app.add_flag("--starter", starter_, "A small input for the solver beside the mesh: .inp, .e, .xdmf, ogs");
  app.add_option("--field", fields_,
                 "Property onto the cells: NAME=FILE, a grid or points (may be given several times)")
      ->type_name("NAME=FILE")
      ->take_all()
      ->expected(1);
  app.add_option("--point-field", point_fields_, "The same onto the points")
      ->type_name("NAME=FILE")
      ->take_all()
      ->expected(1);
  app.add_flag("--fractures-only", fractures_only_, "Triangles of faults and fractures alone");
  app.add_flag("--cohesive", cohesive_, "Prisms of no thickness between the sides of split surfaces");
}

geomodel::WriteOptions OutputFlags::options() const {
  geomodel::WriteOptions options;
  options.groups = groups_ == "whole"    ? geomodel::GroupChoice::whole
                   : groups_ == "pieces" ? geomodel::GroupChoice::pieces
                                         : geomodel::GroupChoice::both;
  options.inner_faces = !no_inner_faces_;
  options.curves = !no_curves_;
  options.order = order_ == 2 ? geomodel::ElementOrder::second : geomodel::ElementOrder::first;
  options.region_array = region_array_;
  options.single_grid = single_grid_;
  options.node_arrays = node_arrays_;
  options.compression = compression_ == "none"   ? geomodel::Compression::none
                        : compression_ == "fast" ? geomodel::Compression::fast
                                                 : geomodel::Compression::small;
  options.split = split_;
  options.cohesive = cohesive_;
  for (const std::string& zone : zones_) options.fault_zones.push_back(zone_of(zone));
  options.partitions = partitions_;
  options.starter = starter_;
  options.fractures_only = fractures_only_;
  for (const std::string& field : fields_) options.fields.push_back(field_of(field, geomodel::FieldSpec::Place::cells));
  for (const std::string& field : point_fields_)
    options.fields.push_back(field_of(field, geomodel::FieldSpec::Place::points));
  return options;
}

std::string OutputFlags::format_of(const std::filesystem::path& output) const {
  if (output.extension() == ".pvtu" && partitions_ == 1)
    throw Error(ErrorKind::usage, "-o " + output.string() + ": a .pvtu is a mesh in parts; add --partitions N");
  return format_.empty() ? geomodel::format_name_of(output) : format_;
}

}  // namespace geomesh::app
