// SPDX-License-Identifier: GPL-3.0-or-later
// Finds mesh formats by name or by extension in the table (geomesh/geomodel/formats.hpp).
#include <algorithm>

#include "fault_zones/fault_zones.hpp"
#include "fields/fields.hpp"
#include "formats/format_list.hpp"
#include "formats/fractures_alone.hpp"
#include "geomesh/core/error.hpp"
#include "mesh_readers/exodus_parts.hpp"
#include "solver_mesh/corners/solver_splits.hpp"
#include "solver_mesh/second_order.hpp"
#include "solver_mesh/split_faults.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

const std::vector<Format>& formats() {
  static const std::vector<Format> all = [] {
    std::vector<Format> made;
    for (const auto make : listed_formats) made.push_back(make());
    return made;
  }();
  return all;
}

const Format* format_of_name(const std::string& name) {
  for (const Format& format : formats())
    if (format.name == name) return &format;
  return nullptr;
}

const Format* format_of_extension(const std::string& extension) {
  for (const Format& format : formats())
    if (std::find(format.extensions.begin(), format.extensions.end(), extension) != format.extensions.end())
      return &format;
  return nullptr;
}

const Format* format_of_file(const std::filesystem::path& file) {
  const auto parts = exodus_part_files(file);
  return format_of_extension((parts ? parts->whole : file).extension().string());
}

std::string format_name_of(const std::filesystem::path& output) {
  const std::string extension = output.extension().string();
  if (extension == ".html") return "html";
  if (const Format* const format = format_of_extension(extension)) return format->name;
  std::string known;
  for (const std::string& e : known_extensions()) known += (known.empty() ? "" : ", ") + e;
  throw Error(ErrorKind::usage, "-o " + output.string() + ": unknown extension; known are " + known);
}

std::vector<std::string> mesh_formats() {
  std::vector<std::string> names;
  for (const Format& format : formats()) names.push_back(format.name);
  return names;
}

std::vector<std::string> known_formats() {
  std::vector<std::string> names = mesh_formats();
  names.emplace_back("html");
  return names;
}

std::vector<std::string> known_extensions() {
  std::vector<std::string> all;
  for (const Format& format : formats())
    for (const std::string& extension : format.extensions)
      if (std::find(all.begin(), all.end(), extension) == all.end()) all.push_back(extension);
  all.emplace_back(".html");
  return all;
}

namespace {

std::vector<std::filesystem::path> write_all(const ModelMesh& mesh, const Format& format, const WriteOptions& options,
                                             const std::filesystem::path& stem) {
  WrittenFiles written;
  written.add(format.write(mesh, options, stem));
  if (options.starter && format.starter && options.partitions == 1) written.add(format.starter(mesh, stem));
  return written.keep();
}

void refuse_partitions(const Format& format, const WriteOptions& options) {
  if (!format.holds.partitions)
    throw Error(ErrorKind::usage, "the format " + format.name + " is not written in parts here; leave out partitions");
  if (options.cohesive)
    throw Error(ErrorKind::usage, "cohesive prisms are not written in parts; leave out partitions or cohesive: true");
  if (options.single_grid)
    throw Error(ErrorKind::usage,
                "one grid for all cells is not written in parts; leave out partitions or single_grid");
}

}  // namespace

std::vector<std::filesystem::path> write_format(const ModelMesh& mesh, const std::string& name,
                                                const std::filesystem::path& stem, const WriteOptions& options) {
  const Format* const format = format_of_name(name);
  if (!format) {
    std::string known;
    for (const std::string& f : mesh_formats()) known += (known.empty() ? "" : ", ") + f;
    throw Error(ErrorKind::usage, "output format '" + name + "' is not known; known are " + known);
  }
  const bool second = options.order == ElementOrder::second;
  if (second && !format->holds.second_order)
    throw Error(ErrorKind::usage, "the format " + name + " holds no elements of second order here; leave out order: 2");
  if (options.cohesive && !format->holds.prisms)
    throw Error(ErrorKind::usage, "the format " + name + " holds no cohesive prisms here; leave out cohesive: true");
  if (second && options.cohesive)
    throw Error(ErrorKind::usage, "cohesive prisms are of first order; leave out order: 2 or cohesive: true");
  if (!options.split.empty() && solver_splits_faults(name))
    throw Error(ErrorKind::usage,
                "the format " + name + " holds no split faults: its solver splits them; leave out split");
  if (options.partitions > 1) refuse_partitions(*format, options);
  if (const std::string reason = against_fractures_alone(*format, options); options.fractures_only && !reason.empty())
    throw Error(ErrorKind::usage, reason);
  for (const FaultZone& zone : options.fault_zones)
    if (std::find(options.split.begin(), options.split.end(), zone.fault) != options.split.end())
      throw Error(ErrorKind::usage, "fault_zone: " + zone.fault + " is to be split too; give one of the two");
  if (options.split.empty() && options.fault_zones.empty() && !second && options.fields.empty())
    return write_all(options.fractures_only ? fractures_alone(mesh) : mesh, *format, options, stem);
  ModelMesh changed = options.fault_zones.empty() ? mesh : open_fault_zones(mesh, options.fault_zones);
  if (!options.split.empty()) changed = split_along(changed, options.split, options.cohesive);
  add_fields(changed, options.fields);
  if (second) add_midpoints(changed);
  if (options.fractures_only) changed = fractures_alone(changed);
  return write_all(changed, *format, options, stem);
}

}  // namespace geomesh::geomodel
