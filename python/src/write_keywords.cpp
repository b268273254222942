// SPDX-License-Identifier: GPL-3.0-or-later
#include "write_keywords.hpp"

#include <pybind11/stl.h>

#include <functional>
#include <map>

#include "geomesh/core/error.hpp"

namespace geomesh::python {
namespace {

namespace py = pybind11;
using namespace geomodel;

template <class T>
T choice(const std::string& key, const std::string& word, const std::vector<std::pair<std::string, T>>& known) {
  std::string words;
  for (const auto& [name, value] : known) {
    if (name == word) return value;
    words += (words.empty() ? "" : ", ") + name;
  }
  throw Error(ErrorKind::usage, key + ": '" + word + "' was given; one of " + words + " was expected");
}

unsigned count(const std::string& key, const py::handle& value, unsigned most) {
  const auto n = value.cast<long long>();
  if (n < 1 || n > static_cast<long long>(most))
    throw Error(ErrorKind::usage, key + ": a whole number from 1 to " + std::to_string(most) + " was expected");
  return static_cast<unsigned>(n);
}

/// Converts a dict of fault zones, such as {"F1": {"thickness": 20, "layers": 2}}, to the library's options.
std::vector<FaultZone> zones(const py::dict& given) {
  std::vector<FaultZone> list;
  for (const auto& [fault, keys] : given) {
    FaultZone zone{fault.cast<std::string>()};
    for (const auto& [key, value] : keys.cast<py::dict>()) {
      const auto name = key.cast<std::string>();
      if (name == "thickness")
        zone.thickness = value.cast<double>();
      else if (name == "layers")
        zone.layers = count("fault_zone: layers", value, most_zone_layers);
      else
        throw Error(ErrorKind::usage, "fault_zone: thickness and layers were expected, found '" + name + "'");
    }
    if (!(zone.thickness > 0))
      throw Error(ErrorKind::usage, "fault_zone: " + zone.fault + " needs a thickness above 0");
    list.push_back(std::move(zone));
  }
  return list;
}

/// Converts {"porosity": "poro.tif"} or {"porosity": {"file": ..., "on": "points", "unit": "1"}} to fields.
std::vector<FieldSpec> fields(const py::dict& given) {
  std::vector<FieldSpec> list;
  for (const auto& [name, value] : given) {
    FieldSpec field{name.cast<std::string>(), {}, FieldSpec::Place::cells, ""};
    if (!py::isinstance<py::dict>(value)) {
      field.file = py::str(value).cast<std::string>();
    } else {
      const auto keys = value.cast<py::dict>();
      if (!keys.contains("file")) throw Error(ErrorKind::usage, "fields: " + field.name + " needs a file");
      field.file = py::str(keys["file"]).cast<std::string>();
      if (keys.contains("unit")) field.unit = keys["unit"].cast<std::string>();
      if (keys.contains("on"))
        field.place =
            choice<FieldSpec::Place>("fields: on", keys["on"].cast<std::string>(),
                                     {{"cells", FieldSpec::Place::cells}, {"points", FieldSpec::Place::points}});
    }
    list.push_back(std::move(field));
  }
  return list;
}

std::vector<std::string> names(const py::handle& value) {
  if (py::isinstance<py::str>(value)) return {value.cast<std::string>()};
  return value.cast<std::vector<std::string>>();
}

using Set = std::function<void(WriteOptions&, const py::handle&)>;

const std::map<std::string, Set>& setters() {
  static const std::map<std::string, Set> all{
      {"groups",
       [](WriteOptions& o, const py::handle& v) {
         o.groups = choice<GroupChoice>(
             "groups", v.cast<std::string>(),
             {{"whole", GroupChoice::whole}, {"pieces", GroupChoice::pieces}, {"both", GroupChoice::both}});
       }},
      {"inner_faces", [](WriteOptions& o, const py::handle& v) { o.inner_faces = v.cast<bool>(); }},
      {"curves", [](WriteOptions& o, const py::handle& v) { o.curves = v.cast<bool>(); }},
      {"order",
       [](WriteOptions& o, const py::handle& v) {
         o.order = count("order", v, 2) == 2 ? ElementOrder::second : ElementOrder::first;
       }},
      {"region_array",
       [](WriteOptions& o, const py::handle& v) {
         o.region_array =
             choice<std::string>("region_array", v.cast<std::string>(),
                                 {{"region", "region"}, {"MaterialIDs", "MaterialIDs"}, {"attribute", "attribute"}});
       }},
      {"single_grid", [](WriteOptions& o, const py::handle& v) { o.single_grid = v.cast<bool>(); }},
      {"node_arrays", [](WriteOptions& o, const py::handle& v) { o.node_arrays = v.cast<bool>(); }},
      {"compression",
       [](WriteOptions& o, const py::handle& v) {
         o.compression = choice<Compression>(
             "compression", v.cast<std::string>(),
             {{"none", Compression::none}, {"fast", Compression::fast}, {"small", Compression::small}});
       }},
      {"split", [](WriteOptions& o, const py::handle& v) { o.split = names(v); }},
      {"cohesive", [](WriteOptions& o, const py::handle& v) { o.cohesive = v.cast<bool>(); }},
      {"fault_zone", [](WriteOptions& o, const py::handle& v) { o.fault_zones = zones(v.cast<py::dict>()); }},
      {"partitions",
       [](WriteOptions& o, const py::handle& v) { o.partitions = count("partitions", v, most_partitions); }},
      {"starter", [](WriteOptions& o, const py::handle& v) { o.starter = v.cast<bool>(); }},
      {"fields", [](WriteOptions& o, const py::handle& v) { o.fields = fields(v.cast<py::dict>()); }},
      {"fractures_only", [](WriteOptions& o, const py::handle& v) { o.fractures_only = v.cast<bool>(); }},
  };
  return all;
}

}  // namespace

WriteOptions write_options(const py::dict& keywords) {
  WriteOptions options;
  for (const auto& [key, value] : keywords) {
    const auto name = key.cast<std::string>();
    const auto found = setters().find(name);
    if (found == setters().end()) {
      std::string known;
      for (const auto& [word, set] : setters()) known += (known.empty() ? "" : ", ") + word;
      throw Error(ErrorKind::usage, "write: there is no option '" + name + "'; known are " + known);
    }
    try {
      found->second(options, value);
    } catch (const py::cast_error&) {
      throw Error(ErrorKind::usage,
                  "write: " + name + " has a value of another kind: " + py::repr(value).cast<std::string>());
    }
  }
  if (options.cohesive && options.split.empty())
    throw Error(ErrorKind::usage, "write: cohesive needs faults to split: split=[\"F1\"]");
  return options;
}

}  // namespace geomesh::python
