// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/hdf5_writer.hpp"

#include "geomesh/geomodel/writers.hpp"
#include "writers/room_on_disk.hpp"

namespace geomesh::geomodel {

template <class T>
T Hdf5Writer::require(T status) const {
  if (status < 0) refuse_to_write(file_);
  return status;
}

Hdf5Writer::Hdf5Writer(const std::filesystem::path& temporary, const std::filesystem::path& file, std::size_t payload,
                       std::size_t n_sets)
    : file_(file) {
  constexpr std::size_t most_bytes_of_structure = 1 << 15, most_bytes_of_set = 1 << 11;
  require_room(temporary, file, payload + most_bytes_of_structure + n_sets * most_bytes_of_set);
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  id_ = require(H5Fcreate(temporary.string().c_str(), H5F_ACC_TRUNC, H5P_DEFAULT, H5P_DEFAULT));
}

Hdf5Writer::~Hdf5Writer() {
  if (id_ >= 0) H5Fclose(id_);
}

void Hdf5Writer::put(const std::string& name, hid_t type, const void* data, std::size_t n, std::size_t width) {
  put_pieces(name, type, n, width, [&](const WriteRows& write) {
    if (n > 0) write(type, data, n);
  });
}

void Hdf5Writer::put_pieces(const std::string& name, hid_t type, std::size_t n, std::size_t width,
                            const std::function<void(const WriteRows&)>& give) {
  const std::array<hsize_t, 2> sizes{n, width};
  const int rank = width == 1 ? 1 : 2;
  const hid_t space = require(H5Screate_simple(rank, sizes.data(), nullptr));
  // Data sets are created without times, so that the bytes of the file do not depend on when it is written.
  const hid_t no_times = require(H5Pcreate(H5P_DATASET_CREATE));
  require(H5Pset_obj_track_times(no_times, false));
  const hid_t set = require(H5Dcreate2(id_, name.c_str(), type, space, H5P_DEFAULT, no_times, H5P_DEFAULT));
  require(H5Pclose(no_times));
  hsize_t first = 0;
  give([&](hid_t in_memory, const void* data, std::size_t n_rows) {
    const std::array<hsize_t, 2> start{first, 0}, count{n_rows, width};
    require(H5Sselect_hyperslab(space, H5S_SELECT_SET, start.data(), nullptr, count.data(), nullptr));
    const hid_t piece = require(H5Screate_simple(rank, count.data(), nullptr));
    require(H5Dwrite(set, in_memory, piece, space, H5P_DEFAULT, data));
    require(H5Sclose(piece));
    first += n_rows;
  });
  require(H5Dclose(set));
  require(H5Sclose(space));
}

void Hdf5Writer::group(const std::string& name) {
  require(H5Gclose(require(H5Gcreate2(id_, name.c_str(), H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT))));
}

void Hdf5Writer::attribute(const std::string& group, const char* name, const std::string& text) {
  const hid_t type = require(H5Tcopy(H5T_C_S1));
  require(H5Tset_size(type, text.size()));
  require(H5Tset_strpad(type, H5T_STR_NULLPAD));
  const hid_t space = require(H5Screate(H5S_SCALAR));
  const hid_t made =
      require(H5Acreate_by_name(id_, group.c_str(), name, type, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  require(H5Awrite(made, type, text.data()));
  require(H5Aclose(made));
  require(H5Sclose(space));
  require(H5Tclose(type));
}

void Hdf5Writer::attribute(const std::string& group, const char* name, const std::vector<std::int64_t>& numbers) {
  const hsize_t size = numbers.size();
  const hid_t space = require(H5Screate_simple(1, &size, nullptr));
  const hid_t made = require(
      H5Acreate_by_name(id_, group.c_str(), name, H5T_NATIVE_INT64, space, H5P_DEFAULT, H5P_DEFAULT, H5P_DEFAULT));
  require(H5Awrite(made, H5T_NATIVE_INT64, numbers.data()));
  require(H5Aclose(made));
  require(H5Sclose(space));
}

void Hdf5Writer::close() {
  const herr_t status = H5Fclose(id_);
  id_ = -1;
  require(status);
}

}  // namespace geomesh::geomodel
