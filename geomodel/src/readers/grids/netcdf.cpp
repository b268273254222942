// SPDX-License-Identifier: GPL-3.0-or-later
// Interprets grids in netCDF (GMT, xarray, GDAL) and HDF5 files, whose numbers a module reads (netcdf_grids.hpp).
#include <algorithm>

#include "modules/module.hpp"
#include "readers/formats.hpp"
#include "readers/grids/netcdf_grids.hpp"
#include "readers/text/frame.hpp"
#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

const NetcdfGridModule& netcdf_module() {
  static const NetcdfGridModule& module = module_table_of<NetcdfGridModule>(
      {"geomesh-exodus.so", netcdf_grids_function, "netCDF and HDF5 grids are read with netCDF by", "geomesh-exodus",
       "libnetcdf-dev"});
  return module;
}

bool is_netcdf_file(const InputFile& file) {
  const std::string_view head = file.text().substr(0, 4);
  return head.size() == 4 && head.starts_with("CDF") && head[3] >= 1 && head[3] <= 5;
}

/// Returns whether the heights of a netCDF grid are depths. The attribute `positive` decides; without it, the
/// variable's standard name, long name or own name does.
bool is_depth(const NetcdfGrid& grid) {
  if (!grid.positive.empty()) return grid.positive == "down";
  const std::string own = grid.name.substr(grid.name.rfind('/') + 1);
  return to_lower(grid.z_name).starts_with("depth") || height_column(own).depth;
}

bool says_direction(const NetcdfGrid& grid) {
  const std::string name = to_lower(grid.z_name);
  return !grid.positive.empty() || is_depth(grid) || name.find("altitude") != std::string::npos ||
         name.find("elevation") != std::string::npos || name.find("height") != std::string::npos;
}

FileContents contents_of(const InputFile& file, const NetcdfGrid& grid) {
  FileContents contents;
  contents.frame.unit = grid.xy_unit;
  contents.frame.z_unit = grid.z_unit.empty() && !grid.geographic ? grid.xy_unit : grid.z_unit;
  if (grid.geographic && grid.z_unit.empty()) contents.frame.z_unit = "m";
  contents.frame.depth = is_depth(grid);
  contents.frame.z_named = says_direction(grid);
  contents.frame.crs = grid.system;
  contents.frame.geographic = grid.geographic;
  const std::vector<Vec3>& nodes = grid.lattice.nodes;
  GridSummary summary;
  summary.origin = {nodes.front().x, nodes.front().y};
  summary.cell_centred = grid.cell_centred;
  if (grid.regular) {
    const Vec3 step = nodes[1] - nodes[0], up = nodes[grid.lattice.n_columns] - nodes[0];
    summary.spacing = {std::abs(step.x) + std::abs(up.x), std::abs(step.y) + std::abs(up.y)};
  }
  add_lattice(file, grid.name, grid.lattice, summary, contents);
  convert_by_frame(file, contents);
  return contents;
}

/// Returns whether the values of a netCDF variable are lengths or travel times, and not temperatures or percentages.
bool is_height(const NetcdfGrid& grid) {
  return length_unit_in_metres(grid.z_unit).has_value() || is_time_unit(grid.z_unit);
}

void append(FileContents part, FileContents& all) {
  const auto move_to = [](auto& from, auto& to) { std::move(from.begin(), from.end(), std::back_inserter(to)); };
  if (all.surfaces.empty()) all.frame = part.frame;
  move_to(part.surfaces, all.surfaces);
  move_to(part.grids, all.grids);
  for (const std::string& note : part.notes)
    if (std::find(all.notes.begin(), all.notes.end(), note) == all.notes.end()) all.notes.push_back(note);
  move_to(part.warnings, all.warnings);
}

}  // namespace

bool is_netcdf(const InputFile& file) { return is_netcdf_file(file) || file.text().starts_with("\x89HDF\r\n\x1a\n"); }

FileContents read_netcdf(const InputFile& file) {
  NetcdfGrids found = netcdf_module().read(file.path);
  FileContents contents;
  contents.format = is_netcdf_file(file) ? "netCDF grid" : "netCDF-4 or HDF5 grid";
  for (const NetcdfGrid& grid : found.grids) {
    if (is_height(grid)) {
      append(contents_of(file, grid), contents);
    } else {
      found.others.push_back(grid.name + " (in " + grid.z_unit + ")");
    }
  }
  std::string others;
  for (const std::string& other : found.others) others += (others.empty() ? "" : ", ") + other;
  if (contents.surfaces.empty())
    file.fail(
        "holds no grid of heights: a variable over two axes was expected, with variables that give x and y along them "
        "(named as the axes, or x and y, easting and northing, lon and lat)" +
        (others.empty() ? std::string() : "; it holds " + others));
  if (!others.empty()) contents.notes.push_back("no grids of heights, and passed over: " + others);
  return contents;
}

}  // namespace geomesh::geomodel
