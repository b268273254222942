// SPDX-License-Identifier: GPL-3.0-or-later
// Reads grids and fields in netCDF and HDF5 files with the netCDF library: a part of the module geomesh-exodus. Axes
// are found according to the CF conventions (coordinate variables, or two-dimensional ones named by the attribute
// `coordinates`); if an HDF5 file names no axes, one-dimensional variables of the right length with a known name are
// used.
#include "readers/grids/netcdf_grids.hpp"

#include <netcdf.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <limits>
#include <map>
#include <optional>
#include <set>

#include "geomesh/core/error.hpp"
#include "level_sets/fields/netcdf_field.hpp"
#include "mesh_readers/netcdf/hdf5_groups.hpp"
#include "mesh_readers/netcdf/netcdf_header.hpp"

namespace geomesh::geomodel {
namespace {

enum class Axis { none, x, y };

/// One variable of the file.
struct Variable {
  int group = 0, id = 0;
  std::string name, path;  ///< name without and with its groups
  nc_type type = NC_NAT;
  std::vector<int> dimensions;
  std::vector<std::size_t> counts;

  /// Returns the rows of `dimensions` with more than one entry.
  std::vector<std::size_t> axes() const {
    std::vector<std::size_t> rows;
    for (std::size_t d = 0; d < counts.size(); ++d)
      if (counts[d] != 1) rows.push_back(d);
    return rows;
  }
  std::size_t size() const {
    std::size_t n = 1;
    for (const std::size_t c : counts) n *= c;
    return n;
  }
  bool is_number() const { return type >= NC_BYTE && type <= NC_UINT64 && type != NC_CHAR; }
};

std::string lower(std::string text) {
  for (char& c : text)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return text;
}

bool one_of(const std::string& word, std::initializer_list<const char*> words) {
  return std::any_of(words.begin(), words.end(), [&](const char* w) { return word == w; });
}

/// A netCDF or HDF5 file with all variables of all groups.
class File {
 public:
  explicit File(const std::filesystem::path& path) : path_(path), bytes_(std::filesystem::file_size(path)) {
    if (const std::string fault = netcdf_header_fault(path); !fault.empty()) refuse(fault);
    Hdf5Groups groups = check_hdf5_groups(path);
    if (!groups.fault.empty()) refuse(groups.fault);
    unwritten_ = std::move(groups.unwritten);
    if (nc_open(path.c_str(), NC_NOWRITE, &root_) != NC_NOERR)
      refuse(
          "the netCDF library cannot open it: it is damaged, or an HDF5 file of a kind that the library does not read");
    collect(root_, "");
  }
  ~File() {
    if (root_ >= 0) nc_close(root_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  const std::vector<Variable>& variables() const { return variables_; }
  int root() const { return root_; }

  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorKind::invalid_input, path_.string() + ": " + why);
  }

  std::string text(int group, int id, const char* attribute) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    constexpr std::size_t most_letters = 1 << 16;
    if (nc_inq_att(group, id, attribute, &type, &length) != NC_NOERR || length == 0 || length > most_letters) return "";
    if (type == NC_STRING) {
      std::vector<char*> texts(length, nullptr);
      if (nc_get_att_string(group, id, attribute, texts.data()) != NC_NOERR) return "";
      const std::string first = texts[0] ? texts[0] : "";
      nc_free_string(length, texts.data());
      return first;
    }
    if (type != NC_CHAR) return "";
    std::string value(length, '\0');
    if (nc_get_att_text(group, id, attribute, value.data()) != NC_NOERR) return "";
    return value.c_str();
  }
  std::string text(const Variable& v, const char* attribute) const { return text(v.group, v.id, attribute); }

  std::vector<double> numbers(int group, int id, const char* attribute) const {
    nc_type type = NC_NAT;
    std::size_t length = 0;
    constexpr std::size_t most_values = 100;
    if (nc_inq_att(group, id, attribute, &type, &length) != NC_NOERR || type == NC_CHAR || type == NC_STRING ||
        length > most_values)
      return {};
    std::vector<double> values(length);
    if (nc_get_att_double(group, id, attribute, values.data()) != NC_NOERR) return {};
    return values;
  }

  /// Returns whether the file reserves space for the variable but holds none of its values, in which case the library
  /// returns zeros or fill values.
  bool is_unwritten(const Variable& v) const { return unwritten_.count(v.path) > 0; }

  /// Returns all numbers of the variable. Throws if these and the numbers read before exceed what measured heights in a
  /// file of this size can be: constants compress a thousand to one, so a small file could otherwise fill all memory.
  std::vector<double> values(const Variable& v) const {
    constexpr std::size_t most_of_any = 4'000'000, most_a_byte = 4;
    if (v.size() > std::max(most_of_any, most_a_byte * bytes_) - n_read_) refuse(too_many(v));
    n_read_ += v.size();
    std::vector<double> values(v.size());
    const std::vector<std::size_t> start(v.counts.size(), 0);
    const int status = nc_get_vara_double(v.group, v.id, start.data(), v.counts.data(), values.data());
    if (status != NC_NOERR && status != NC_ERANGE) refuse("its variable " + v.path + " cannot be read: it is damaged");
    return values;
  }

 private:
  std::string too_many(const Variable& v) const {
    std::string shape;
    for (const std::size_t count : v.counts) shape += (shape.empty() ? "" : " by ") + std::to_string(count);
    return "its variable " + v.path + " of " + shape + " numbers is too large for a file of " + std::to_string(bytes_) +
           " bytes (" + std::to_string(n_read_) +
           " numbers were read before it): it is damaged, or holds constants; write the part and the variables that "
           "the "
           "model needs into a file of their own, or every n-th node";
  }

  void collect(int group, const std::string& above) {
    int n = 0;
    if (nc_inq_nvars(group, &n) == NC_NOERR)
      for (int id = 0; id < n; ++id)
        if (auto v = variable(group, id)) {
          v->path = above + v->name;
          variables_.push_back(std::move(*v));
        }
    if (nc_inq_grps(group, &n, nullptr) != NC_NOERR || n <= 0) return;
    std::vector<int> groups(static_cast<std::size_t>(n));
    if (nc_inq_grps(group, &n, groups.data()) != NC_NOERR) return;
    for (const int inner : groups) {
      char name[NC_MAX_NAME + 1] = {};
      if (nc_inq_grpname(inner, name) == NC_NOERR) collect(inner, above + name + "/");
    }
  }

  static std::optional<Variable> variable(int group, int id) {
    Variable v;
    v.group = group;
    v.id = id;
    char name[NC_MAX_NAME + 1] = {};
    int n = 0;
    if (nc_inq_varname(group, id, name) != NC_NOERR || nc_inq_vartype(group, id, &v.type) != NC_NOERR ||
        nc_inq_varndims(group, id, &n) != NC_NOERR || n < 0 || n > NC_MAX_VAR_DIMS)
      return std::nullopt;
    v.name = name;
    v.dimensions.resize(static_cast<std::size_t>(n));
    if (n > 0 && nc_inq_vardimid(group, id, v.dimensions.data()) != NC_NOERR) return std::nullopt;
    std::size_t all = 1;
    for (const int d : v.dimensions) {
      std::size_t length = 0;
      if (nc_inq_dimlen(group, d, &length) != NC_NOERR) return std::nullopt;
      if (length != 0 && all > (std::size_t{1} << 40) / length) return std::nullopt;  // no file holds so many
      all *= length;
      v.counts.push_back(length);
    }
    return v;
  }

  std::filesystem::path path_;
  std::size_t bytes_;
  mutable std::size_t n_read_ = 0;  ///< how many numbers were read, over all variables
  int root_ = -1;
  std::vector<Variable> variables_;
  std::set<std::string> unwritten_;
};

/// Determines from attributes and name along which axis the values of a variable are.
Axis axis_of(const File& file, const Variable& v) {
  const std::string axis = lower(file.text(v, "axis")), standard = lower(file.text(v, "standard_name"));
  const std::string unit = lower(file.text(v, "units")), name = lower(v.name);
  if (axis == "x" || standard == "projection_x_coordinate" || standard == "longitude" ||
      one_of(unit, {"degrees_east", "degree_east", "degrees_e"}))
    return Axis::x;
  if (axis == "y" || standard == "projection_y_coordinate" || standard == "latitude" ||
      one_of(unit, {"degrees_north", "degree_north", "degrees_n"}))
    return Axis::y;
  if (one_of(name, {"x", "lon", "long", "longitude", "easting", "eastings", "east", "xs", "x_utm", "nav_lon"}))
    return Axis::x;
  if (one_of(name, {"y", "lat", "latitude", "northing", "northings", "north", "ys", "y_utm", "nav_lat"}))
    return Axis::y;
  return Axis::none;
}

bool is_geographic(const File& file, const Variable& v) {
  const std::string unit = lower(file.text(v, "units")), name = lower(v.name),
                    standard = lower(file.text(v, "standard_name"));
  return unit.starts_with("degree") || standard == "longitude" || standard == "latitude" ||
         one_of(name, {"lon", "long", "longitude", "nav_lon"});
}

/// The variables that give x and y of a grid's nodes: along its columns and rows, or for every node.
struct Places {
  const Variable *x = nullptr, *y = nullptr;
  std::size_t along_x = 0, along_y = 0;  ///< rows of the grid's `counts`; unused if given for every node
  bool over_both = false;
};

/// Returns the system that a well-known text describes: the EPSG code of its last AUTHORITY["EPSG","25832"] or
/// ID["EPSG",25832], which belongs to the whole system and not to a part of it; the name if there is no such code.
std::string system_of_text(const std::string& text) {
  const std::size_t end = text.rfind("\"EPSG\",");
  if (end != std::string::npos && text.size() - end < 24) {
    std::string code;
    for (const char c : text.substr(end + 7))
      if (c >= '0' && c <= '9') code += c;
    if (!code.empty()) return "epsg:" + code;
  }
  const std::size_t open = text.find("[\""), close = open == std::string::npos ? open : text.find('"', open + 2);
  return close == std::string::npos ? "" : text.substr(open + 2, close - open - 2);
}

/// Returns whether the number can be a code: EPSG uses up to six digits, and a damaged value may not be a number.
bool is_code(double number) { return number >= 1 && number < 1e6; }

/// Returns the EPSG code, or the name, of the system that is described by the variable named in the attribute
/// `grid_mapping`.
std::string system_of(const File& file, const Variable& v) {
  const std::string mapping = file.text(v, "grid_mapping");
  if (mapping.empty()) return "";
  for (const Variable& m : file.variables()) {
    if (m.name != mapping) continue;
    std::string code = lower(file.text(m, "epsg_code"));
    if (code.empty())
      if (const auto number = file.numbers(m.group, m.id, "epsg_code"); !number.empty() && is_code(number[0]))
        code = std::to_string(static_cast<long long>(number[0]));
    if (!code.empty()) return code.starts_with("epsg:") ? code : "epsg:" + code;
    for (const char* key : {"crs_wkt", "spatial_ref"})
      if (const std::string system = system_of_text(file.text(m, key)); !system.empty()) return system;
  }
  return "";
}

bool has_equal_steps(const std::vector<double>& places) {
  const auto n = static_cast<double>(places.size() - 1);
  const double step = (places.back() - places.front()) / n;
  constexpr double rounding = 1e-4;  // share of a step: coordinates may be in single precision
  for (std::size_t i = 0; i < places.size(); ++i)
    if (std::abs(places[i] - places.front() - static_cast<double>(i) * step) > rounding * std::abs(step)) return false;
  return true;
}

std::vector<double> heights_of(const File& file, const Variable& v) {
  std::vector<double> heights = file.values(v);
  std::vector<double> none = file.numbers(v.group, v.id, "_FillValue");
  for (const double value : file.numbers(v.group, v.id, "missing_value")) none.push_back(value);
  const auto scale = file.numbers(v.group, v.id, "scale_factor"), offset = file.numbers(v.group, v.id, "add_offset");
  for (double& h : heights) {
    const bool is_none = !std::isfinite(h) || std::find(none.begin(), none.end(), h) != none.end();
    h = is_none ? std::numeric_limits<double>::quiet_NaN()
                : h * (scale.empty() ? 1 : scale[0]) + (offset.empty() ? 0 : offset[0]);
  }
  return heights;
}

class GridFinder {
 public:
  explicit GridFinder(const File& file) : file_(file) {}

  NetcdfGrids find() const {
    NetcdfGrids found;
    for (const Variable& v : file_.variables()) {
      const std::size_t n_axes = v.axes().size();
      if (!v.is_number() || n_axes < 2 || v.size() == 0) continue;
      if (file_.is_unwritten(v)) {
        found.others.push_back(v.path + " (no value of it was ever written)");
      } else if (n_axes > 2) {
        found.others.push_back(v.path + " (" + std::to_string(n_axes) + " axes)");
      } else if (axis_of(file_, v) != Axis::none) {
        continue;  // coordinates of other grids
      } else if (const auto places = places_of(v)) {
        found.grids.push_back(grid(v, *places));
      } else {
        found.others.push_back(v.path + " (no variables give x and y along its axes)");
      }
    }
    return found;
  }

 private:
  std::optional<Places> places_of(const Variable& v) const {
    if (const auto both = places_over_both(v)) return both;
    const std::vector<std::size_t> axes = v.axes();
    const Variable *rows = along(v, axes[0], Axis::y), *columns = along(v, axes[1], Axis::x);
    if (!rows && !columns) {  // x varies along the rows
      rows = along(v, axes[0], Axis::x), columns = along(v, axes[1], Axis::y);
    }
    if (!rows || !columns || rows == columns) return std::nullopt;
    const bool swapped = axis_of(file_, *rows) == Axis::x || axis_of(file_, *columns) == Axis::y;
    if (swapped) return Places{rows, columns, axes[0], axes[1], false};
    return Places{columns, rows, axes[1], axes[0], false};
  }

  /// Returns the variable along an axis of `v`: the one with the dimension's name, else one in the same group with as
  /// many values whose name identifies it as `expected`.
  const Variable* along(const Variable& v, std::size_t axis, Axis expected) const {
    char name[NC_MAX_NAME + 1] = {};
    const std::size_t n = v.counts[axis];
    if (nc_inq_dimname(v.group, v.dimensions[axis], name) == NC_NOERR)
      for (const Variable& c : file_.variables())
        if (c.name == name && c.counts.size() == 1 && c.dimensions[0] == v.dimensions[axis] && c.is_number()) return &c;
    const Variable* found = nullptr;
    for (const Variable& c : file_.variables()) {
      if (c.group != v.group || !c.is_number() || c.axes().size() != 1 || c.size() != n) continue;
      if (axis_of(file_, c) == expected && !found) found = &c;
    }
    return found;
  }

  std::optional<Places> places_over_both(const Variable& v) const {
    const std::string listed = std::string(1, ' ').append(file_.text(v, "coordinates")).append(1, ' ');
    Places places{nullptr, nullptr, 0, 0, true};
    for (const Variable& c : file_.variables()) {
      if (&c == &v || !c.is_number() || c.counts != v.counts) continue;
      const bool is_named = listed.find(std::string(1, ' ').append(c.name).append(1, ' ')) != std::string::npos;
      const Axis axis = axis_of(file_, c);
      if (axis == Axis::none || (!is_named && c.group != v.group)) continue;
      (axis == Axis::x ? places.x : places.y) = &c;
    }
    return places.x && places.y ? std::optional(places) : std::nullopt;
  }

  NetcdfGrid grid(const Variable& v, const Places& places) const {
    NetcdfGrid g;
    g.name = v.path;
    const std::string standard = file_.text(v, "standard_name"), full = file_.text(v, "long_name");
    g.z_name = !standard.empty() ? standard : !full.empty() ? full : v.name;
    g.z_unit = file_.text(v, "units");
    g.positive = lower(file_.text(v, "positive"));
    g.geographic = is_geographic(file_, *places.x);
    if (!g.geographic) g.xy_unit = file_.text(*places.x, "units");
    g.system = system_of(file_, v);
    const auto registration = file_.numbers(file_.root(), NC_GLOBAL, "node_offset");
    g.cell_centred = !registration.empty() && registration[0] == 1;
    fill(v, places, g);
    return g;
  }

  void fill(const Variable& v, const Places& places, NetcdfGrid& g) const {
    const std::vector<std::size_t> axes = v.axes();
    g.lattice.n_rows = v.counts[axes[0]];
    g.lattice.n_columns = v.counts[axes[1]];
    const std::vector<double> heights = heights_of(file_, v), x = file_.values(*places.x), y = file_.values(*places.y);
    g.lattice.nodes.reserve(heights.size());
    for (std::size_t j = 0; j < g.lattice.n_rows; ++j)
      for (std::size_t i = 0; i < g.lattice.n_columns; ++i) {
        const std::size_t node = j * g.lattice.n_columns + i;
        const auto row_of = [&](std::size_t axis) { return places.over_both ? node : axis == axes[0] ? j : i; };
        const Vec3 p{x[row_of(places.along_x)], y[row_of(places.along_y)], heights[node]};
        if (!std::isfinite(p.x) || !std::isfinite(p.y))
          file_.refuse("a place along the axes of " + v.path + " is no number");
        g.lattice.nodes.push_back(p);
      }
    g.regular = !places.over_both && has_equal_steps(x) && has_equal_steps(y);
  }

  const File& file_;
};

/// Finds variables with three dimensions.
class FieldFinder {
 public:
  explicit FieldFinder(const File& file) : file_(file) {}

  NetcdfField find(const std::string& wanted) const {
    NetcdfField field;
    const Variable* chosen = nullptr;
    std::size_t n_named = 0;
    for (const Variable& v : file_.variables()) {
      if (!v.is_number() || v.axes().size() != 3 || v.size() == 0) continue;
      field.names.push_back(v.path + (file_.is_unwritten(v) ? " (no value of it was ever written)" : ""));
      if (file_.is_unwritten(v) || !(wanted.empty() || wanted == v.path || wanted == v.name)) continue;
      chosen = &v;
      ++n_named;
    }
    if (n_named == 1) fill(*chosen, field);
    return field;
  }

 private:
  /// Returns the one-dimensional variable with the coordinates along a dimension: the one with the dimension's name,
  /// else the only one in the same group with as many values.
  const Variable* along(const Variable& v, std::size_t axis) const {
    char name[NC_MAX_NAME + 1] = {};
    const bool has_name = nc_inq_dimname(v.group, v.dimensions[axis], name) == NC_NOERR;
    const Variable* found = nullptr;
    std::size_t n_found = 0;
    for (const Variable& c : file_.variables()) {
      if (!c.is_number() || c.axes().size() != 1 || c.size() != v.counts[axis]) continue;
      if (has_name && c.name == name && c.dimensions.size() == 1 && c.dimensions[0] == v.dimensions[axis]) return &c;
      if (c.group != v.group) continue;
      found = &c;
      ++n_found;
    }
    return n_found == 1 ? found : nullptr;
  }

  void fill(const Variable& v, NetcdfField& field) const {
    const std::vector<std::size_t> rows = v.axes();
    std::array<const Variable*, 3> places{};
    for (std::size_t k = 0; k < 3; ++k) {
      places[k] = along(v, rows[k]);
      if (!places[k])
        file_.refuse("no variable gives the places along axis " + std::to_string(k + 1) + " of " + v.path);
    }
    constexpr std::size_t none = 3;
    std::array<std::size_t, 3> of{none, none, none};  // which axes of the variable are x, y and z
    for (std::size_t k = 0; k < 3; ++k)
      if (const Axis axis = axis_of(file_, *places[k]); axis != Axis::none) of[axis == Axis::x ? 0 : 1] = k;
    if (of[0] == none || of[1] == none || places[0] == places[1] || places[1] == places[2] || places[0] == places[2])
      file_.refuse("the axes of " + v.path + " are " + places[0]->name + ", " + places[1]->name + ", " +
                   places[2]->name + ", of which one must be known as x and one as y");
    of[2] = 3 - of[0] - of[1];
    field.name = v.path;
    std::array<bool, 3> falls{};
    for (std::size_t a = 0; a < 3; ++a) {
      std::vector<double>& at = field.axes[a] = file_.values(*places[of[a]]);
      falls[a] = at.front() > at.back();
      if (falls[a]) std::reverse(at.begin(), at.end());
      if (!(at.front() < at.back()) || !has_equal_steps(at))
        file_.refuse("the places along " + places[of[a]]->name + " of " + v.path + " are not in equal steps");
    }
    const std::vector<double> values = heights_of(file_, v);
    std::array<std::size_t, 3> stride{};  // strides of x, y and z in the file, whose last axis varies fastest
    for (std::size_t a = 0; a < 3; ++a) {
      stride[a] = 1;
      for (std::size_t k = of[a] + 1; k < 3; ++k) stride[a] *= v.counts[rows[k]];
    }
    const auto n = [&](std::size_t a) { return field.axes[a].size(); };
    const auto row = [&](std::size_t a, std::size_t i) { return stride[a] * (falls[a] ? n(a) - 1 - i : i); };
    field.values.reserve(values.size());
    for (std::size_t k = 0; k < n(2); ++k)
      for (std::size_t j = 0; j < n(1); ++j)
        for (std::size_t i = 0; i < n(0); ++i) field.values.push_back(values[row(0, i) + row(1, j) + row(2, k)]);
  }

  const File& file_;
};

NetcdfField read_field(const std::filesystem::path& path, const std::string& name) {
  const File file(path);
  return FieldFinder(file).find(name);
}

NetcdfGrids read_grids(const std::filesystem::path& path) {
  const File file(path);
  return GridFinder(file).find();
}

}  // namespace

}  // namespace geomesh::geomodel

extern "C" __attribute__((visibility("default"))) const geomesh::geomodel::NetcdfGridModule* geomesh_netcdf_grids() {
  static constexpr geomesh::geomodel::NetcdfGridModule module{GEOMESH_MODULE_VERSION, geomesh::geomodel::read_grids};
  return &module;
}

extern "C" __attribute__((visibility("default"))) const geomesh::geomodel::NetcdfFieldModule* geomesh_netcdf_fields() {
  static constexpr geomesh::geomodel::NetcdfFieldModule module{GEOMESH_MODULE_VERSION, geomesh::geomodel::read_field};
  return &module;
}
