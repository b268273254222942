// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/netcdf/netcdf_reader.hpp"

#include <netcdf.h>

#include <fstream>

#include "geomesh/core/error.hpp"
#include "mesh_readers/netcdf/hdf5_groups.hpp"
#include "mesh_readers/netcdf/netcdf_header.hpp"

namespace geomesh::geomodel {

NetcdfReader::NetcdfReader(const std::filesystem::path& path) : path_(path) {
  if (!std::ifstream(path)) throw Error(ErrorKind::usage, path.string() + ": cannot be opened");
  if (const std::string fault = netcdf_header_fault(path); !fault.empty()) refuse(fault);
  if (const std::string fault = check_hdf5_groups(path).fault; !fault.empty()) refuse(fault);
  if (nc_open(path.string().c_str(), NC_NOWRITE, &file_) != NC_NOERR)
    refuse("it is no Exodus file (netCDF), or damaged");
}

NetcdfReader::~NetcdfReader() {
  if (file_ >= 0) nc_close(file_);
}

void NetcdfReader::refuse(const std::string& why) const {
  throw Error(ErrorKind::invalid_input, path_.string() + ": " + why);
}

bool NetcdfReader::has(const std::string& variable) const {
  int id = 0;
  return nc_inq_varid(file_, variable.c_str(), &id) == NC_NOERR;
}

std::size_t NetcdfReader::dimension(const std::string& name) const {
  // Largest ratio of deflate compression. A netCDF file that is shorter than its numbers divided by this is damaged.
  constexpr std::size_t most_packed = 1032;
  int id = 0;
  std::size_t n = 0;
  if (nc_inq_dimid(file_, name.c_str(), &id) != NC_NOERR || nc_inq_dimlen(file_, id, &n) != NC_NOERR) return 0;
  if (n / most_packed > std::filesystem::file_size(path_))
    refuse("sizes in it are not those of what follows: it is damaged");
  return n;
}

bool NetcdfReader::is_single_precision(const std::string& variable) const {
  int id = 0;
  nc_type type = NC_DOUBLE;
  return nc_inq_varid(file_, variable.c_str(), &id) == NC_NOERR && nc_inq_vartype(file_, id, &type) == NC_NOERR &&
         type == NC_FLOAT;
}

NetcdfReader::Range NetcdfReader::range(const std::string& variable, std::size_t n) const {
  Range range{0, {}, {}};
  int n_dimensions = 0, ids[NC_MAX_VAR_DIMS], unlimited = -1;
  if (nc_inq_varid(file_, variable.c_str(), &range.id) != NC_NOERR ||
      nc_inq_varndims(file_, range.id, &n_dimensions) != NC_NOERR || n_dimensions > NC_MAX_VAR_DIMS ||
      nc_inq_vardimid(file_, range.id, ids) != NC_NOERR)
    refuse("it has no variable " + variable + ": it is damaged");
  nc_inq_dimid(file_, "time_step", &unlimited);
  std::size_t all = 1;
  for (int d = 0; d < n_dimensions; ++d) {
    std::size_t size = 0;
    if (nc_inq_dimlen(file_, ids[d], &size) != NC_NOERR) refuse("it is damaged");
    if (ids[d] == unlimited) size = 1;
    range.start.push_back(0);
    range.count.push_back(size);
    if (size != 0 && all > SIZE_MAX / size) refuse("it is damaged");
    all *= size;
  }
  if (all != n)
    refuse("its variable " + variable + " holds " + std::to_string(all) + " numbers where " + std::to_string(n) +
           " were expected: it is damaged");
  return range;
}

std::vector<double> NetcdfReader::doubles(const std::string& variable, std::size_t n) const {
  std::vector<double> values(n);
  if (n == 0) return values;
  const Range all = range(variable, n);
  if (nc_get_vara_double(file_, all.id, all.start.data(), all.count.data(), values.data()) != NC_NOERR)
    refuse("its variable " + variable + " cannot be read: it is damaged");
  return values;
}

std::vector<std::int64_t> NetcdfReader::integers(const std::string& variable, std::size_t n) const {
  std::vector<long long> values(n);
  if (n == 0) return {};
  const Range all = range(variable, n);
  if (nc_get_vara_longlong(file_, all.id, all.start.data(), all.count.data(), values.data()) != NC_NOERR)
    refuse("its variable " + variable + " cannot be read: it is damaged");
  return {values.begin(), values.end()};
}

std::vector<std::string> NetcdfReader::texts(const std::string& variable, std::size_t n) const {
  std::vector<std::string> texts(n);
  int id = 0, dimensions[2], n_dimensions = 0;
  std::size_t rows = 0, length = 0;
  nc_type type = NC_NAT;
  constexpr std::size_t most_letters = 1 << 16;
  if (n == 0 || nc_inq_varid(file_, variable.c_str(), &id) != NC_NOERR ||
      nc_inq_vartype(file_, id, &type) != NC_NOERR || type != NC_CHAR ||
      nc_inq_varndims(file_, id, &n_dimensions) != NC_NOERR || n_dimensions != 2 ||
      nc_inq_vardimid(file_, id, dimensions) != NC_NOERR || nc_inq_dimlen(file_, dimensions[0], &rows) != NC_NOERR ||
      nc_inq_dimlen(file_, dimensions[1], &length) != NC_NOERR || rows < n || length > most_letters)
    return texts;
  for (std::size_t row = 0; row < n; ++row) {
    std::string text(length, '\0');
    const std::size_t start[2] = {row, 0}, count[2] = {1, length};
    if (nc_get_vara_text(file_, id, start, count, text.data()) != NC_NOERR)
      refuse("its variable " + variable + " cannot be read: it is damaged");
    texts[row] = text.c_str();
    texts[row].erase(texts[row].find_last_not_of(' ') + 1);
  }
  return texts;
}

std::string NetcdfReader::attribute(const std::string& variable, const std::string& name) const {
  int id = 0;
  std::size_t length = 0;
  nc_type type = NC_NAT;
  constexpr std::size_t most_letters = 1 << 10;
  if (nc_inq_varid(file_, variable.c_str(), &id) != NC_NOERR ||
      nc_inq_att(file_, id, name.c_str(), &type, &length) != NC_NOERR || type != NC_CHAR || length > most_letters)
    return "";
  std::string text(length, '\0');
  if (nc_get_att_text(file_, id, name.c_str(), text.data()) != NC_NOERR) return "";
  return text.c_str();
}

}  // namespace geomesh::geomodel
