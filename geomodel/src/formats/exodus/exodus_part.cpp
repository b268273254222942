// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/exodus/exodus_part.hpp"

#include <vtk_exodusII.h>

#include <algorithm>
#include <map>
#include <vector>

namespace geomesh::geomodel {

namespace {

bool is_solid(const CellBlock& block) { return dimension_of(block.shape) == 3; }
int64_t count(const std::vector<int>& list) { return static_cast<int64_t>(list.size()); }

/// Nodes and faces that the part has in common with one other.
struct Shared {
  std::vector<int> nodes, elements, sides;
};

class NemesisWriter {
 public:
  NemesisWriter(int file, const ExodusPart& part) : file_(file), all_(part), part_(part.part.part) {}

  int write(const ExodusSets& sets) {
    put_sizes_of_whole(sets);
    put_numbers_in_whole();
    share_nodes();
    share_faces();
    put_shared();
    return worst_;
  }

 private:
  void put(int status) { worst_ = std::min(worst_, status); }

  void put_sizes_of_whole(const ExodusSets& sets) {
    char kind[] = "p";  // a file for each processor
    put(ex_put_init_info(file_, all_.parts.n_parts(), 1, kind));
    std::vector<int> ids, sizes;
    for (const CellBlock& block : all_.whole.blocks)
      if (is_solid(block)) {
        ids.push_back(block.id);
        sizes.push_back(static_cast<int>(block.shape == CellShape::tetrahedron
                                             ? all_.parts.n_cells_of_region(block.members.front())
                                             : block.n_cells()));
      }
    put(ex_put_init_global(file_, static_cast<int64_t>(all_.parts.n_nodes_of_whole()),
                           static_cast<int64_t>(all_.parts.n_cells_of_whole()), count(ids),
                           static_cast<int64_t>(sets.nodes), static_cast<int64_t>(sets.sides)));
    put(ex_put_eb_info_global(file_, ids.data(), sizes.data()));
  }
  void put_numbers_in_whole() {
    std::vector<int> nodes, elements;
    for (const VertexIndex v : part_.nodes) nodes.push_back(static_cast<int>(all_.parts.node_number(v)) + 1);
    for (const CellBlock& block : all_.part.mesh.blocks)
      if (is_solid(block)) rows_.insert(rows_.end(), block.rows.begin(), block.rows.end());
    for (const std::size_t row : rows_) elements.push_back(static_cast<int>(all_.parts.cell_number(row)) + 1);
    put(ex_put_id_map(file_, EX_NODE_MAP, nodes.data()));
    put(ex_put_id_map(file_, EX_ELEM_MAP, elements.data()));
  }
  void share_nodes() {
    for (std::size_t i = 0; i < part_.nodes.size(); ++i) {
      const auto at = all_.parts.parts_at(part_.nodes[i]);
      for (const std::int32_t p : at)
        if (p != part_.number) shared_[p].nodes.push_back(static_cast<int>(i) + 1);
      (at.size() > 1 ? border_nodes_ : inner_nodes_).push_back(static_cast<int>(i) + 1);
    }
  }
  void share_faces() {
    const std::vector<BorderFace> faces = all_.parts.border_faces(part_.number);
    std::map<std::size_t, int> element_of;  // of the elements at the border, by row
    for (const BorderFace& face : faces) element_of[face.cell] = 0;
    for (std::size_t e = 0; e < rows_.size(); ++e) {
      const auto found = element_of.find(rows_[e]);
      if (found != element_of.end()) found->second = static_cast<int>(e) + 1;
      (found != element_of.end() ? border_elements_ : inner_elements_).push_back(static_cast<int>(e) + 1);
    }
    for (const BorderFace& face : faces) {
      Shared& with = shared_[face.other_part];
      with.elements.push_back(element_of[face.cell]);
      with.sides.push_back(exodus_side_opposite[face.opposite]);
    }
  }
  void put_shared() {
    std::vector<int> node_maps, node_counts, face_maps, face_counts;
    for (const auto& [p, with] : shared_) {
      node_maps.push_back(p);
      node_counts.push_back(static_cast<int>(with.nodes.size()));
      if (with.elements.empty()) continue;
      face_maps.push_back(p);
      face_counts.push_back(static_cast<int>(with.elements.size()));
    }
    const int own = part_.number;
    put(ex_put_loadbal_param(file_, count(inner_nodes_), count(border_nodes_), 0, count(inner_elements_),
                             count(border_elements_), count(node_maps), count(face_maps), own));
    put(ex_put_processor_node_maps(file_, inner_nodes_.data(), border_nodes_.data(), nullptr, own));
    put(ex_put_processor_elem_maps(file_, inner_elements_.data(), border_elements_.data(), own));
    if (shared_.empty()) return;
    put(ex_put_cmap_params(file_, node_maps.data(), node_counts.data(), face_maps.data(), face_counts.data(), own));
    for (auto& [p, with] : shared_) {
      std::vector<int> other(std::max(with.nodes.size(), with.elements.size()), p);
      put(ex_put_node_cmap(file_, p, with.nodes.data(), other.data(), own));
      if (!with.elements.empty())
        put(ex_put_elem_cmap(file_, p, with.elements.data(), with.sides.data(), other.data(), own));
    }
  }

  int file_, worst_ = 0;
  const ExodusPart& all_;
  const MeshPart& part_;
  std::vector<std::size_t> rows_;  // of the part's elements
  std::vector<int> inner_nodes_, border_nodes_, inner_elements_, border_elements_;
  std::map<int, Shared> shared_;  // by other part
};

}  // namespace

int put_exodus_part(int file, const ExodusPart& part, const ExodusSets& sets) {
  return NemesisWriter(file, part).write(sets);
}

}  // namespace geomesh::geomodel
