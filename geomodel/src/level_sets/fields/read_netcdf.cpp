// SPDX-License-Identifier: GPL-3.0-or-later
// Reads scalar fields from netCDF and HDF5 files, declared in level_sets/fields/read_field.hpp.
#include "level_sets/fields/netcdf_field.hpp"
#include "level_sets/fields/read_field.hpp"
#include "modules/module.hpp"
#include "readers/text/input_file.hpp"

namespace geomesh::geomodel {

GridField::Lattice read_netcdf_lattice(const LevelSetSpec& spec) {
  const InputFile file = load_input_file(spec.file);
  const NetcdfFieldModule& module = module_table_of<NetcdfFieldModule>(
      {"geomesh-exodus.so", netcdf_fields_function, "netCDF and HDF5 fields are read with netCDF by", "geomesh-exodus",
       "libnetcdf-dev"});
  NetcdfField field = module.read(file.path, spec.array);
  if (field.name.empty()) {
    std::string names;
    for (const std::string& other : field.names) names += (names.empty() ? "" : ", ") + other;
    if (names.empty()) file.fail("holds no variable over three axes, which was expected of a field");
    if (spec.array.empty())
      file.fail("holds several variables over three axes (" + names +
                "); name the one that is meant with 'array' in the entry");
    file.fail("has no variable \"" + spec.array + "\" over three axes; it holds " + names);
  }
  GridField::Lattice lattice;
  for (std::size_t a = 0; a < 3; ++a) {
    const std::vector<double>& at = field.axes[a];
    lattice.n[a] = at.size();
    lattice.origin[a] = at.front();
    lattice.spacing[a] = (at.back() - at.front()) / static_cast<double>(at.size() - 1);
  }
  lattice.nodes = std::move(field.values);
  return lattice;
}

}  // namespace geomesh::geomodel
