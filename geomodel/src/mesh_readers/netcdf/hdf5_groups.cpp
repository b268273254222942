// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/netcdf/hdf5_groups.hpp"

#define H5_USE_110_API  // in interface 1.10, which all later HDF5 libraries have, objects have addresses, not tokens
#include <hdf5.h>

#include <fstream>
#include <string_view>
#include <utility>
#include <vector>

namespace geomesh::geomodel {
namespace {

constexpr std::size_t deepest =
    // Limit on the depth of nested HDF5 groups, which suffices for data sets. HDF5's own calls are nested as deep.
    16;

class Walk {
 public:
  Walk(hid_t file, std::uintmax_t bytes) : bytes_(bytes) { visit(file, "/"); }

  Hdf5Groups found;

 private:
  /// Visits one link of an HDF5 group. Returns 1 to end the walk if the file is refused.
  static herr_t visit_link(hid_t group, const char* name, const H5L_info_t*, void* walk) {
    return static_cast<Walk*>(walk)->visit(group, name) ? 0 : 1;
  }

  bool visit(hid_t above, const char* name) {
    H5O_info_t info{};
    if (H5Oget_info_by_name(above, name, &info, H5P_DEFAULT) < 0) return true;  // leads nowhere
    if (info.type == H5O_TYPE_DATASET) return visit_array(above, name);
    if (info.type != H5O_TYPE_GROUP) return true;
    return visit_group(above, name, info.addr);
  }

  bool visit_array(hid_t above, const char* name) {
    const hid_t array = H5Dopen2(above, name, H5P_DEFAULT);
    if (array < 0) return true;
    const hid_t space = H5Dget_space(array);
    if (H5Sget_simple_extent_npoints(space) > 0 && H5Dget_storage_size(array) == 0)
      found.unwritten.insert(path() + name);
    H5Sclose(space);
    H5Dclose(array);
    return true;
  }

  bool visit_group(hid_t above, const char* name, haddr_t address) {
    const std::string here = above_.empty() ? "/" : "/" + path() + name;
    for (const auto& [group, its_address] : above_)
      if (its_address == address)
        return refuse("its group " + here + " is a link back to the group /" + group +
                      ": groups in circles cannot be read; delete the link");
    if (above_.size() > deepest)
      return refuse("its group " + here + " lies more than " + std::to_string(deepest) +
                    " groups deep: copy the arrays into a file with fewer groups");
    // Fewest bytes of a link and its group in an HDF5 file in which each group has one link. A file with more links
    // than this allows is refused, because the library reads a group again along each link that leads to it, so that
    // nested double links multiply.
    constexpr std::uintmax_t least_bytes = 64;
    if (++n_visits_ > bytes_ / least_bytes)
      return refuse("its groups are linked to each other so often that reading them would not end, at " + here +
                    ": delete links that lead to the same group");
    const hid_t group = H5Gopen2(above, name, H5P_DEFAULT);
    if (group < 0) return true;
    above_.emplace_back(above_.empty() ? "" : path() + name, address);
    hsize_t next = 0;
    const herr_t ended = H5Literate(group, H5_INDEX_NAME, H5_ITER_NATIVE, &next, visit_link, this);
    above_.pop_back();
    H5Gclose(group);
    return ended <= 0;
  }

  bool refuse(const std::string& why) {
    found.fault = why;
    return false;
  }
  /// Returns the path of the HDF5 group that is being read, with a slash at its end; "" for the root group.
  std::string path() const { return above_.size() < 2 ? "" : above_.back().first + "/"; }

  /// Names and addresses of the HDF5 groups from the root to the group that is being read.
  std::vector<std::pair<std::string, haddr_t>> above_;
  std::uintmax_t bytes_, n_visits_ = 0;
};

}  // namespace

Hdf5Groups check_hdf5_groups(const std::filesystem::path& path) {
  constexpr std::string_view magic = "\x89HDF\r\n\x1a\n";
  std::string head(magic.size(), '\0');
  if (!std::ifstream(path, std::ios::binary).read(head.data(), static_cast<std::streamsize>(head.size()))) return {};
  if (head != magic) return {};
  H5E_auto2_t print = nullptr;
  void* to = nullptr;
  H5Eget_auto2(H5E_DEFAULT, &print, &to);
  // HDF5 prints no errors; the netCDF library reports files that cannot be opened
  H5Eset_auto2(H5E_DEFAULT, nullptr, nullptr);
  Hdf5Groups found;
  if (const hid_t file = H5Fopen(path.string().c_str(), H5F_ACC_RDONLY, H5P_DEFAULT); file >= 0) {
    found = Walk(file, std::filesystem::file_size(path)).found;
    H5Fclose(file);
  }
  H5Eset_auto2(H5E_DEFAULT, print, to);
  return found;
}

}  // namespace geomesh::geomodel
