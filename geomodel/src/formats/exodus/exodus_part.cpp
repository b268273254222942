// SPDX-License-Identifier: GPL-3.0-or-later
#include "formats/exodus/exodus_part.hpp"

#include <algorithm>
#include <map>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace geomesh::geomodel {

namespace {

bool is_solid(const CellBlock& block) { return dimension_of(block.shape) == 3; }
/// Nodes and faces that one part of a mesh shares with one other part.
struct Shared {
  std::vector<int> nodes, elements, sides;
};

class NemesisWriter {
 public:
  NemesisWriter(NetcdfWriter& file, const ExodusPart& part) : file_(file), all_(part), part_(part.part.part) {}

  void add(const ExodusSets& sets) {
    number_elements();
    share_nodes();
    share_faces();
    add_sizes_of_whole(sets);
    add_numbers_in_whole();
    add_loads();
    add_shared();
  }

 private:
  /// Numbers the elements of an Exodus part in the order of its blocks.
  void number_elements() {
    for (const CellBlock& block : all_.part.mesh.blocks)
      if (is_solid(block)) rows_.insert(rows_.end(), block.rows.begin(), block.rows.end());
  }
  void add_sizes_of_whole(const ExodusSets& sets) {
    std::vector<int> ids, sizes;
    for (const CellBlock& block : all_.whole.blocks)
      if (is_solid(block)) {
        ids.push_back(block.id);
        sizes.push_back(static_cast<int>(block.shape == CellShape::tetrahedron
                                             ? all_.parts.n_cells_of_region(block.members.front())
                                             : block.n_cells()));
      }
    file_.add_dimension("num_processors", static_cast<std::size_t>(all_.parts.n_parts()));
    file_.add_dimension("num_procs_file", 1);
    file_.add_dimension("num_nodes_global", all_.parts.n_nodes_of_whole());
    file_.add_dimension("num_elems_global", all_.parts.n_cells_of_whole());
    file_.add_dimension("num_el_blk_global", ids.size());
    file_.add_ints("nem_ftype", "", {0});  // file type 0 of the Nemesis format: one file for each processor
    file_.add_ints("el_blk_ids_global", "num_el_blk_global", ids);
    file_.add_ints("el_blk_cnt_global", "num_el_blk_global", sizes);
    for (const auto& [kind, entry, n] : {std::tuple{"ns", "node", sets.nodes}, {"ss", "side", sets.sides}}) {
      if (n == 0) continue;
      const std::string name = kind, dimension = "num_" + name + "_global";
      file_.add_dimension(dimension, n);
      for (const std::string& what :
           {name + "_ids_global", name + "_" + entry + "_cnt_global", name + "_df_cnt_global"})
        file_.add_ints(what, dimension, std::vector<int>(n, 0));
    }
  }
  void add_numbers_in_whole() {
    std::vector<int> nodes, elements;
    for (const VertexIndex v : part_.nodes) nodes.push_back(static_cast<int>(all_.parts.node_number(v)) + 1);
    for (const std::size_t row : rows_) elements.push_back(static_cast<int>(all_.parts.cell_number(row)) + 1);
    file_.add_ints("node_num_map", "num_nodes", std::move(nodes));
    file_.add_ints("elem_num_map", "num_elem", std::move(elements));
  }
  void add_list(const std::string& name, const std::string& dimension, std::vector<int> list) {
    if (!list.empty()) file_.add_ints(name, dimension, std::move(list));
  }
  /// Adds a mesh part's lists of inner and border nodes and elements. It has no external nodes in Nemesis' sense.
  void add_loads() {
    for (const auto& [name, list] : {std::pair{"num_int_elem", &inner_elements_},
                                     {"num_bor_elem", &border_elements_},
                                     {"num_int_node", &inner_nodes_},
                                     {"num_bor_node", &border_nodes_}})
      if (!list->empty()) file_.add_dimension(name, list->size());
    for (const auto& [name, is_there] : {std::pair{"int_n_stat", !inner_nodes_.empty()},
                                         {"bor_n_stat", !border_nodes_.empty()},
                                         {"ext_n_stat", false},
                                         {"int_e_stat", !inner_elements_.empty()},
                                         {"bor_e_stat", !border_elements_.empty()}})
      file_.add_ints(name, "num_procs_file", {is_there ? 1 : 0});
    add_list("elem_mapi", "num_int_elem", inner_elements_);
    add_list("elem_mapb", "num_bor_elem", border_elements_);
    add_list("node_mapi", "num_int_node", inner_nodes_);
    add_list("node_mapb", "num_bor_node", border_nodes_);
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
    std::map<std::size_t, int> element_of;  // element number of each tetrahedron at the border of the part, by its row
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
  /// Lists of nodes or faces shared with other mesh parts, one list for each other part, and the end of each list.
  struct Lists {
    std::vector<int> parts, ends, first, second, other;
    void add(int part, const std::vector<int>& own, const std::vector<int>& sides) {
      if (own.empty()) return;
      parts.push_back(part);
      first.insert(first.end(), own.begin(), own.end());
      second.insert(second.end(), sides.begin(), sides.end());
      other.resize(first.size(), part);
      ends.push_back(static_cast<int>(first.size()));
    }
  };
  void add_lists(const std::string& kind, const Lists& lists) {
    if (lists.parts.empty()) return;
    const std::string by_part = "num_" + kind + "_cmaps", by_entry = kind + "cnt_cmap", name = kind + "_comm_";
    file_.add_dimension(by_part, lists.parts.size());
    file_.add_dimension(by_entry, lists.first.size());
    file_.add_ints(name + "ids", by_part, lists.parts);
    file_.add_ints(name + "stat", by_part, std::vector<int>(lists.parts.size(), 1));
    file_.add_ints(name + "data_idx", by_part, lists.ends);
    file_.add_ints(name + kind + "ids", by_entry, lists.first);
    file_.add_ints(name + "proc", by_entry, lists.other);
    if (!lists.second.empty()) file_.add_ints(name + "sids", by_entry, lists.second);
  }
  void add_shared() {
    Lists nodes, elements;
    for (const auto& [p, with] : shared_) {
      nodes.add(p, with.nodes, {});
      elements.add(p, with.elements, with.sides);
    }
    add_lists("n", nodes);
    add_lists("e", elements);
    file_.add_global("nemesis_file_version", 2.6f);
    file_.add_global("nemesis_api_version", 8.11f);
  }

  NetcdfWriter& file_;
  const ExodusPart& all_;
  const MeshPart& part_;
  std::vector<std::size_t> rows_;  // rows, in the whole mesh, of the elements in this Exodus part
  std::vector<int> inner_nodes_, border_nodes_, inner_elements_, border_elements_;
  std::map<int, Shared> shared_;  // by other part
};

}  // namespace

void add_exodus_part(NetcdfWriter& file, const ExodusPart& part, const ExodusSets& sets) {
  NemesisWriter(file, part).add(sets);
}

}  // namespace geomesh::geomodel
