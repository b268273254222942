// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/exodus/netcdf_writer.hpp"

#include <netcdf.h>

#include <algorithm>
#include <numeric>

namespace geomesh::geomodel {

void NetcdfWriter::add_ints(const std::string& name, const std::string& dimension, std::vector<int> values) {
  add_ints(name, dimension.empty() ? std::vector<std::string>{} : std::vector{dimension},
           [values = std::move(values)](const Put& put) { return put(0, values.size(), values.data()); });
}

void NetcdfWriter::add_ints(const std::string& name, std::vector<std::string> dimensions,
                            std::function<bool(const Put&)> write) {
  variables_.push_back({name, Type::integer, std::move(dimensions), {}, std::move(write)});
}

void NetcdfWriter::add_doubles(const std::string& name, std::vector<std::string> dimensions,
                               std::function<std::vector<double>()> values) {
  variables_.push_back({name, Type::real, std::move(dimensions), {}, [values = std::move(values)](const Put& put) {
                          const std::vector<double> all = values();
                          return put(0, all.size(), all.data());
                        }});
}

void NetcdfWriter::add_texts(const std::string& name, const std::string& dimension, std::vector<std::string> texts) {
  for (std::string& text : texts) text.resize(exodus_name_room, '\0');
  variables_.push_back({name, Type::text, {dimension, "len_name"}, {}, [texts = std::move(texts)](const Put& put) {
                          const std::string all = std::accumulate(texts.begin(), texts.end(), std::string());
                          return put(0, texts.size(), all.data());
                        }});
}

void NetcdfWriter::add_attribute(const std::string& name, const std::string& value) {
  variables_.back().attributes.emplace_back(name, value);
}

std::size_t NetcdfWriter::size_of(const std::string& dimension) const {
  for (const auto& [name, size] : dimensions_)
    if (name == dimension) return size;
  return 0;
}

bool NetcdfWriter::define(int file, std::vector<int>& ids) const {
  std::map<std::string, int> dimension_ids;
  bool good = true;
  for (const auto& [name, size] : dimensions_)
    good &= nc_def_dim(file, name.c_str(), size == 0 ? NC_UNLIMITED : size, &dimension_ids[name]) == NC_NOERR;
  for (const Variable& variable : variables_) {
    std::vector<int> own;
    for (const std::string& dimension : variable.dimensions) own.push_back(dimension_ids[dimension]);
    const nc_type type = variable.type == Type::text ? NC_CHAR : variable.type == Type::integer ? NC_INT : NC_DOUBLE;
    good &= nc_def_var(file, variable.name.c_str(), type, static_cast<int>(own.size()), own.data(),
                       &ids.emplace_back()) == NC_NOERR;
    for (const auto& [name, value] : variable.attributes)
      good &= nc_put_att_text(file, ids.back(), name.c_str(), value.size(), value.data()) == NC_NOERR;
  }
  for (const auto& [name, value] : floats_)
    good &= nc_put_att_float(file, NC_GLOBAL, name.c_str(), NC_FLOAT, 1, &value) == NC_NOERR;
  for (const auto& [name, value] : ints_)
    good &= nc_put_att_int(file, NC_GLOBAL, name.c_str(), NC_INT, 1, &value) == NC_NOERR;
  for (const auto& [name, value] : texts_)
    good &= nc_put_att_text(file, NC_GLOBAL, name.c_str(), value.size(), value.data()) == NC_NOERR;
  return good && nc_enddef(file) == NC_NOERR;
}

bool NetcdfWriter::put_all(int file, const std::vector<int>& ids) const {
  for (std::size_t v = 0; v < variables_.size(); ++v) {
    const Variable& variable = variables_[v];
    const Put put = [&](std::size_t first, std::size_t n, const void* data) {
      if (n == 0) return true;
      std::vector<std::size_t> start(variable.dimensions.size(), 0), count;
      for (const std::string& dimension : variable.dimensions) count.push_back(size_of(dimension));
      // Along the unlimited dimension (time), one whole step of the variable is written.
      const bool grows = !count.empty() && count[0] == 0;
      if (grows) count[0] = 1;
      if (!grows && !count.empty()) {
        start[0] = first;
        count[0] = n;
      }
      return nc_put_vara(file, ids[v], start.data(), count.data(), data) == NC_NOERR;
    };
    if (!variable.write(put)) return false;
  }
  return true;
}

bool NetcdfWriter::write(const std::filesystem::path& path) const {
  int file = -1, before = 0;
  if (nc_create(path.string().c_str(), NC_CLOBBER | NC_64BIT_OFFSET, &file) != NC_NOERR) return false;
  nc_set_fill(file, NC_NOFILL, &before);  // everything is written
  std::vector<int> ids;
  const bool good = define(file, ids) && put_all(file, ids);
  return nc_close(file) == NC_NOERR && good;
}

}  // namespace geomesh::geomodel
