// SPDX-License-Identifier: GPL-3.0-or-later
// Writes VTKHDF (built only if HDF5 is available): the arrays of NAME.vtu in one HDF5 file, NAME.vtkhdf, with names of
// regions as field data. Source: "VTKHDF File Format", version 1.0, of the VTK documentation.
#include <algorithm>
#include <map>

#include "formats/modules/format_module.hpp"
#include "formats/vtk/vtu_grid.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/hdf5_writer.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::size_t values_at_once = std::size_t{1} << 18;

hid_t type_of(const VtkArray& array) {
  const std::string_view type = array.type;
  if (type == "Float64") return H5T_NATIVE_DOUBLE;
  if (type == "UInt8") return H5T_NATIVE_UINT8;
  if (type == "Int64") return H5T_NATIVE_INT64;
  return type == "UInt64" ? H5T_NATIVE_UINT64 : H5T_NATIVE_INT32;
}

/// Replaces slashes in the name of an array, because HDF5 treats a slash as a separator of groups.
std::string set_name(std::string name) {
  std::replace(name.begin(), name.end(), '/', '_');
  return name;
}

class GridFile {
 public:
  GridFile(Hdf5Writer& h5, const VtkDocument& document) : h5_(h5), document_(document) {}

  void write(const VtuLayout& layout) {
    h5_.group("VTKHDF");
    h5_.attribute("VTKHDF", "Version", std::vector<std::int64_t>{1, 0});
    h5_.attribute("VTKHDF", "Type", std::string("UnstructuredGrid"));
    put_count("NumberOfPoints", layout.n_nodes());
    put_count("NumberOfCells", layout.n_cells());
    put_count("NumberOfConnectivityIds", layout.n_entries());
    for (const VtkSection& section : document_.sections) {
      if (section.tag == "Points") put("VTKHDF/Points", section.arrays.front(), H5T_NATIVE_DOUBLE, {});
      if (section.tag == "Cells") put_cells(section);
      if (section.tag == "PointData" || section.tag == "CellData") put_data(section);
    }
    put_fields();
    h5_.close();
  }

 private:
  void put_count(const char* name, std::size_t n) {
    const auto count = static_cast<std::int64_t>(n);
    h5_.put(std::string("VTKHDF/") + name, H5T_NATIVE_INT64, &count, 1, 1);
  }
  /// Writes an array to the VTKHDF file. The integers in `before` are written ahead of the array's values.
  void put(const std::string& name, const VtkArray& array, hid_t type, const std::vector<std::int64_t>& before) {
    const auto width = static_cast<std::size_t>(array.components);
    h5_.put_pieces(name, type, array.n_values / width + before.size(), width, [&](const auto& give) {
      if (!before.empty()) give(H5T_NATIVE_INT64, before.data(), before.size());
      std::vector<std::byte> bytes;
      const std::size_t step = values_at_once * width;
      for (std::size_t first = 0; first < array.n_values; first += step) {
        const std::size_t last = std::min(array.n_values, first + step);
        bytes.resize((last - first) * array.value_size);
        array.fill(first, last, bytes.data());
        give(type_of(array), bytes.data(), (last - first) / width);
      }
    });
  }
  /// Writes the cells of a VTKHDF file. Their offsets begin with 0, so there is one more offset than there are cells.
  void put_cells(const VtkSection& section) {
    for (const VtkArray& array : section.arrays) {
      if (array.name == "connectivity") put("VTKHDF/Connectivity", array, H5T_NATIVE_INT64, {});
      if (array.name == "offsets") put("VTKHDF/Offsets", array, H5T_NATIVE_INT64, {0});
      if (array.name == "types") put("VTKHDF/Types", array, H5T_NATIVE_UINT8, {});
    }
  }
  void put_data(const VtkSection& section) {
    const std::string group = "VTKHDF/" + section.tag;
    h5_.group(group);
    for (const VtkArray& array : section.arrays) put(group + "/" + set_name(array.name), array, type_of(array), {});
  }
  /// Writes the field data of a VTK file. Values of fields with the same name are concatenated.
  void put_fields() {
    h5_.group("VTKHDF/FieldData");
    std::map<std::string, std::vector<std::int32_t>> values;
    for (const VtkField& field : document_.fields) {
      std::vector<std::int32_t>& own = values[set_name(field.name)];
      own.insert(own.end(), field.values.begin(), field.values.end());
    }
    for (const auto& [name, numbers] : values)
      h5_.put("VTKHDF/FieldData/" + name, H5T_NATIVE_INT32, numbers.data(), numbers.size(), 1);
    if (!document_.origin.empty())
      h5_.put("VTKHDF/FieldData/origin", H5T_NATIVE_DOUBLE, document_.origin.data(), document_.origin.size(), 1);
  }

  Hdf5Writer& h5_;
  const VtkDocument& document_;
};

/// Returns the number of bytes of all arrays of the VTKHDF file (with indices as 64-bit numbers), and their number.
std::pair<std::size_t, std::size_t> payload_of(const VtkDocument& document) {
  std::size_t bytes = 0, n = document.fields.size() + 1;
  for (const VtkSection& section : document.sections)
    for (const VtkArray& array : section.arrays) bytes += array.n_values * sizeof(double), ++n;
  for (const VtkField& field : document.fields) bytes += field.values.size() * sizeof(std::int32_t);
  return {bytes, n};
}

std::vector<std::filesystem::path> write(const ModelMesh& mesh, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  const VtuLayout layout(mesh, options);
  const VtkDocument document = vtu_document(mesh, options, layout);
  const std::filesystem::path file = stem.string() + ".vtkhdf";
  write_complete_or_absent(file, [&](const std::filesystem::path& temporary) {
    const auto [bytes, n_sets] = payload_of(document);
    Hdf5Writer h5(temporary, file, bytes, n_sets);
    GridFile(h5, document).write(layout);
  });
  std::vector<SidecarGroup> sidecar;
  for (const Region& region : mesh.regions)
    sidecar.push_back({"cells", 3, region.id, region.name, region.name, {region.id}});
  for (const CohesiveLayer& layer : mesh.cohesive_layers)
    sidecar.push_back({"cells", 3, layer.id, layer.name, layer.name, {layer.id}});
  if (options.single_grid) {
    for (const NamedSurface& surface : mesh.surfaces)
      sidecar.push_back({"cells", 2, surface.id, surface.name, surface.name, {surface.id}});
    for (const NamedCurve& curve : mesh.curves)
      sidecar.push_back({"cells", 1, curve.id, curve.name, curve.name, {curve.id}});
  }
  return {file, write_sidecar(mesh, sidecar, file)};
}

}  // namespace

}  // namespace geomesh::geomodel

GEOMESH_FORMAT_MODULE(geomesh::geomodel::write, nullptr, nullptr)
