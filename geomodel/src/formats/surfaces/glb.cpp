// SPDX-License-Identifier: GPL-3.0-or-later
// Writes the surfaces as glTF 2.0 (binary, .glb), for viewers, presentations and headsets: a glTF node for each
// surface, divided into parts by the regions on both sides. Parts on the boundary of the mesh have the colour of the
// region behind them. glTF has y upwards and single precision, so the root node rotates the model, and coordinates are
// relative to the centre of the model, which is stored in `extras` of the scene. Source: Khronos, "glTF 2.0
// Specification".
#include <cmath>
#include <nlohmann/json.hpp>

#include "formats/format_list.hpp"
#include "formats/surfaces/face_nodes.hpp"
#include "geomesh/geomodel/palette.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

namespace {

using nlohmann::ordered_json;

// Constants of glTF, which have the values of OpenGL.
constexpr int float_type = 5126, unsigned_type = 5125, vertex_buffer = 34962, index_buffer = 34963;

class Scene {
 public:
  explicit Scene(const SolverMesh& mesh) : mesh_(mesh), nodes_(face_nodes(mesh)) {
    for (const VertexIndex v : nodes_.rows) box_.add(mesh.node(v));
    if (!nodes_.rows.empty()) centre_ = 0.5 * (box_.min + box_.max);
    add_materials();
    add_surfaces();
    finish();
  }

  void write(OutputText& out) const {
    std::string json = json_.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    json.append((4 - json.size() % 4) % 4, ' ');  // glTF chunks have a length that is a multiple of four bytes
    constexpr std::uint32_t magic = 0x46546C67, version = 2, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;
    constexpr std::size_t header = 12, chunk_header = 8;
    const std::size_t binary = position_bytes() + 4 * indices_.size();
    const auto size = [](std::size_t n) { return static_cast<std::uint32_t>(n); };
    out.raw(magic).raw(version).raw(size(header + 2 * chunk_header + json.size() + binary));
    out.raw(size(json.size())).raw(json_chunk) << json;
    out.raw(size(binary)).raw(binary_chunk);
    for (const VertexIndex v : nodes_.rows)
      for (std::size_t k = 0; k < 3; ++k) out.raw(coordinate(v, k));
    for (const std::uint32_t i : indices_) out.raw(i);
  }
  const std::vector<SidecarGroup>& sidecar() const { return sidecar_; }

 private:
  float coordinate(VertexIndex v, std::size_t k) const { return static_cast<float>(mesh_.node(v)[k] - centre_[k]); }
  std::size_t position_bytes() const { return 3 * sizeof(float) * nodes_.rows.size(); }

  /// Adds the materials of the glTF file: regions by id, then surfaces in the order of their labels.
  void add_materials() {
    Palette units(Palette::Of::units);
    for (const Region& region : mesh_.source->regions) add_material(region.name, units.colour_of(region.name));
  }
  std::size_t add_material(const std::string& name, const Colour& c) {
    ordered_json& list = json_["materials"];
    list.push_back(
        {{"name", name},
         {"doubleSided", true},
         {"pbrMetallicRoughness",
          {{"baseColorFactor", {c[0], c[1], c[2], 1.0}}, {"metallicFactor", 0.0}, {"roughnessFactor", 0.9}}}});
    return list.size() - 1;
  }
  std::size_t add_accessor(std::size_t first, std::size_t n) {
    json_["accessors"].push_back({{"bufferView", 1},
                                  {"byteOffset", 4 * first},
                                  {"componentType", unsigned_type},
                                  {"count", n},
                                  {"type", "SCALAR"}});
    return json_["accessors"].size() - 1;
  }
  void add_positions() {
    std::array<float, 3> low, high;
    low.fill(std::numeric_limits<float>::infinity());
    high.fill(-std::numeric_limits<float>::infinity());
    for (const VertexIndex v : nodes_.rows)
      for (std::size_t k = 0; k < 3; ++k) {
        low[k] = std::min(low[k], coordinate(v, k));
        high[k] = std::max(high[k], coordinate(v, k));
      }
    json_["accessors"].push_back({{"bufferView", 0},
                                  {"componentType", float_type},
                                  {"count", nodes_.rows.size()},
                                  {"type", "VEC3"},
                                  {"min", low},
                                  {"max", high}});
  }
  void add_surfaces() {
    json_["nodes"].push_back({{"name", mesh_.source->name}});  // the root
    if (nodes_.rows.empty()) return;
    add_positions();
    SolverNames names(name_limit_plain);
    for (const CellGroup& label : mesh_.labels)
      if (label.dimension == 2) add_surface(label, names.give(label.full_name));
  }
  void add_surface(const CellGroup& label, const std::string& name) {
    std::size_t own = SIZE_MAX;  // material of the parts of the glTF surface that are inside the mesh
    ordered_json parts = ordered_json::array();
    for (const std::size_t b : label.blocks) {
      const CellBlock& block = mesh_.blocks[b];
      const std::size_t first = indices_.size();
      for (const VertexIndex v : block.nodes) indices_.push_back(nodes_.number_of[v]);
      const bool is_boundary = block.region_plus == 0 && block.region_minus != 0;
      if (!is_boundary && own == SIZE_MAX) own = add_material(name, surface_colours_.colour_of(name));
      parts.push_back({{"attributes", {{"POSITION", 0}}},
                       {"indices", add_accessor(first, block.nodes.size())},
                       {"material", is_boundary ? static_cast<std::size_t>(block.region_minus - 1) : own},
                       {"extras", {{"name", block.full_name}}}});
    }
    json_["meshes"].push_back({{"name", name}, {"primitives", std::move(parts)}});
    json_["nodes"].push_back({{"name", name}, {"mesh", json_["meshes"].size() - 1}});
    sidecar_.push_back({"node", 2, 0, name, label.full_name, label.members});
  }
  void finish() {
    json_["asset"] = {{"version", "2.0"}, {"generator", "geomesh"}};
    ordered_json& root = json_["nodes"][0];
    root["matrix"] = {1, 0, 0, 0, 0, 0, -1, 0, 0, 1, 0, 0, 0, 0, 0, 1};  // rotation from z upwards to y upwards
    for (std::size_t i = 1; i < json_["nodes"].size(); ++i) root["children"].push_back(i);
    json_["scenes"] = ordered_json::array(
        {{{"name", mesh_.source->name},
          {"nodes", {0}},
          {"extras", {{"centre", {centre_.x, centre_.y, centre_.z}}, {"unit", mesh_.source->unit}}}}});
    json_["scene"] = 0;
    if (nodes_.rows.empty()) return;
    json_["bufferViews"] = {
        {{"buffer", 0}, {"byteOffset", 0}, {"byteLength", position_bytes()}, {"target", vertex_buffer}},
        {{"buffer", 0},
         {"byteOffset", position_bytes()},
         {"byteLength", 4 * indices_.size()},
         {"target", index_buffer}}};
    json_["buffers"] = ordered_json::array({{{"byteLength", position_bytes() + 4 * indices_.size()}}});
  }

  const SolverMesh& mesh_;
  FaceNodes nodes_;
  Palette surface_colours_{Palette::Of::surfaces};
  Box3 box_;
  Vec3 centre_{0, 0, 0};
  std::vector<std::uint32_t> indices_;
  ordered_json json_;
  std::vector<SidecarGroup> sidecar_;
};

std::vector<std::filesystem::path> write_glb(const ModelMesh& model, const WriteOptions& options,
                                             const std::filesystem::path& stem) {
  const SolverMesh mesh = make_solver_mesh(model, with_one_number(options));
  const Scene scene(mesh);
  const std::filesystem::path file = stem.string() + ".glb";
  write_output_text(file, [&](OutputText& out) { scene.write(out); });
  return {file, write_sidecar(model, scene.sidecar(), file)};
}

}  // namespace

Format glb_format() { return {"glb", {".glb"}, "glTF of the surfaces", {.triangles_alone = true}, write_glb, nullptr}; }

}  // namespace geomesh::geomodel
