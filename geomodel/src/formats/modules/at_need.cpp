// SPDX-License-Identifier: GPL-3.0-or-later
// Formats whose libraries depend on dozens of other libraries. Modules (modules/module.hpp), which are loaded only when
// needed, write and read them.
#include "formats/format_list.hpp"
#include "formats/given_part.hpp"
#include "formats/modules/format_module.hpp"
#include "starters/starters.hpp"

namespace geomesh::geomodel {
namespace {

const FormatModule& exodus() {
  static const FormatModule& module = module_table_of<FormatModule>({"geomesh-exodus.so", format_module_function,
                                                                     "Exodus files are written and read with netCDF by",
                                                                     "geomesh-exodus", "libnetcdf-dev"});
  return module;
}
const FormatModule& med() {
  static const FormatModule& module =
      module_table_of<FormatModule>({"geomesh-med.so", format_module_function,
                                     "MED files are written and read with libmedc by", "geomesh-med", "libmedc-dev"});
  return module;
}
const FormatModule& xdmf() {
  static const FormatModule& module =
      module_table_of<FormatModule>({"geomesh-xdmf.so", format_module_function, "XDMF files are written with HDF5 by",
                                     "geomesh-xdmf", "libhdf5-dev"});
  return module;
}
const FormatModule& seissol() {
  static const FormatModule& module =
      module_table_of<FormatModule>({"geomesh-seissol.so", format_module_function,
                                     "SeisSol's files are written with HDF5 by", "geomesh-seissol", "libhdf5-dev"});
  return module;
}
const FormatModule& vtkhdf() {
  static const FormatModule& module =
      module_table_of<FormatModule>({"geomesh-vtkhdf.so", format_module_function,
                                     "VTKHDF files are written with HDF5 by", "geomesh-vtkhdf", "libhdf5-dev"});
  return module;
}

template <const FormatModule& (*module)()>
std::vector<std::filesystem::path> write(const ModelMesh& mesh, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  return module().write(mesh, options, stem);
}
template <const FormatModule& (*module)()>
RawMesh read(const std::filesystem::path& file) {
  return module().read(file);
}

}  // namespace

std::vector<std::filesystem::path> write_exodus_part(const ModelMesh& mesh, const MeshParts& parts,
                                                     const WriteOptions& options, const std::filesystem::path& stem) {
  return exodus().write_part(mesh, parts, options, stem);
}

Format exodus_format() {
  return {"exodus",
          {".e", ".exo", ".ex2", ".exii"},
          "Exodus II",
          {.second_order = true, .prisms = true, .curves = true, .overlapping = true, .partitions = true},
          write<exodus>,
          read<exodus>,
          write_pylith_starter};
}

Format med_format() {
  return {"med",
          {".med"},
          "MED (Code_Aster, SALOME)",
          {.second_order = true, .prisms = true, .curves = true, .overlapping = true},
          write<med>,
          read<med>};
}

Format xdmf_format() {
  return {"xdmf",
          {".xdmf"},
          "XDMF and HDF5 (dolfinx)",
          {.second_order = true, .curves = true, .names = false, .triangles_alone = true},
          write<xdmf>,
          nullptr,
          write_dolfinx_starter};
}

Format seissol_format() { return {"seissol", {".puml"}, "SeisSol (PUML)", {.names = false}, write<seissol>, nullptr}; }

Format vtkhdf_format() {
  return {"vtkhdf",      {".vtkhdf"}, "VTKHDF (ParaView 5.10 and on)", {.second_order = true, .prisms = true},
          write<vtkhdf>, nullptr};
}

}  // namespace geomesh::geomodel
