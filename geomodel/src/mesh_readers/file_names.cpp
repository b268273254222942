// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/file_names.hpp"

#include <fstream>

#include "common/foreign_json.hpp"

namespace geomesh::geomodel {

FileNames read_file_names(const std::filesystem::path& mesh_file) {
  std::ifstream in(mesh_file.string() + ".json");
  const nlohmann::json root = parse_foreign_json(in);
  if (root.is_discarded() || !root.is_object() || !root.contains("mesh")) return {};
  if (root.at("mesh") != mesh_file.filename().string()) return {};
  FileNames names;
  const auto read = [&](const char* key, std::vector<FullName>& list) {
    if (!root.contains(key)) return;
    for (const auto& entry : root.at(key))
      list.push_back({entry.at("name"), entry.value("kind", ""), entry.at("groups"),
                      entry.value("attributes", std::map<std::string, double>{})});
  };
  try {
    read("regions", names.regions);
    read("surfaces", names.surfaces);
    read("curves", names.curves);
    read("points", names.points);
    read("node_sets", names.node_sets);
    names.unit = root.value("unit", "");
    if (const auto origin = root.find("origin"); origin != root.end())
      names.origin = Vec3{origin->at(0), origin->at(1), origin->at(2)};
    for (const auto& field : root.value("fields", nlohmann::json::array()))
      names.field_units[field.at("name")] = field.value("unit", "");
    for (const auto& region : root.value("regions", nlohmann::json::array()))
      names.region_ids[region.at("id")] = region.at("name");
    for (const auto& group : root.value("region_groups", nlohmann::json::array()))
      names.region_groups[group.at("name")] = group.at("regions").get<std::vector<std::int32_t>>();
  } catch (const nlohmann::json::exception&) {
    return {};
  }
  return names;
}

}  // namespace geomesh::geomodel
