// SPDX-License-Identifier: GPL-3.0-or-later
#include "writers/vtk_names.hpp"

#include <algorithm>
#include <array>

namespace geomesh::geomodel {

namespace {

constexpr std::array<std::string_view, 4> curve_kinds{"intersection", "border", "fault_tip", "well"};

std::int32_t number_of_kind(const std::string& kind) {
  return static_cast<std::int32_t>(std::find(curve_kinds.begin(), curve_kinds.end(), kind) - curve_kinds.begin());
}

}  // namespace

void add_region_fields(const ModelMesh& mesh, std::vector<VtkField>& fields) {
  for (const Region& region : mesh.regions) fields.push_back({"region:" + region.name, {region.id}});
  for (const CohesiveLayer& layer : mesh.cohesive_layers) fields.push_back({"layer:" + layer.name, {layer.id}});
  for (const RegionGroup& group : mesh.groups) fields.push_back({"group:" + group.name, group.regions});
}

void add_surface_fields(const ModelMesh& mesh, std::vector<VtkField>& fields) {
  VtkField kinds{"surface_kinds", {}}, offsets{"surface_set_offsets", {0}}, ids{"surface_set_ids", {}};
  for (const NamedSurface& surface : mesh.surfaces) {
    fields.push_back({"surface:" + surface.name, {surface.id}});
    kinds.values.push_back(static_cast<std::int32_t>(surface.kind));
  }
  for (const auto& set : mesh.surface_sets) {
    ids.values.insert(ids.values.end(), set.begin(), set.end());
    offsets.values.push_back(static_cast<std::int32_t>(ids.values.size()));
  }
  for (VtkField* field : {&kinds, &offsets, &ids}) fields.push_back(std::move(*field));
}

void add_curve_fields(const ModelMesh& mesh, std::vector<VtkField>& fields) {
  VtkField kinds{"curve_kinds", {}};
  for (const NamedCurve& curve : mesh.curves) {
    fields.push_back({"curve:" + curve.name, {curve.id}});
    kinds.values.push_back(number_of_kind(curve.kind));
  }
  for (const auto& point : mesh.marked_points) fields.push_back({"point:" + point.name, {point.id}});
  fields.push_back(std::move(kinds));
}

std::vector<double> origin_of(const ModelMesh& mesh) {
  if (mesh.origin == Vec3{0, 0, 0}) return {};
  return {mesh.origin.x, mesh.origin.y, mesh.origin.z};
}

}  // namespace geomesh::geomodel
