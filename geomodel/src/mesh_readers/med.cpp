// SPDX-License-Identifier: GPL-3.0-or-later
// Reads MED with libmedc (built only if it is available): simplices of first and second order, groups of cells and
// nodes.
#include <med.h>

#include <fstream>

#include "geomesh/core/error.hpp"
#include "mesh_readers/mesh_readers.hpp"

namespace geomesh::geomodel {
namespace {

struct MedShape {
  med_geometry_type type;
  int dimension;
  std::size_t n_nodes;
};
constexpr MedShape shapes[] = {{MED_POINT1, 0, 1}, {MED_SEG2, 1, 2},   {MED_SEG3, 1, 3},    {MED_TRIA3, 2, 3},
                               {MED_TRIA6, 2, 6},  {MED_TETRA4, 3, 4}, {MED_TETRA10, 3, 10}};
constexpr med_geometry_type other_solids[] = {MED_PYRA5,   MED_PENTA6, MED_HEXA8, MED_PYRA13,
                                              MED_PENTA15, MED_HEXA20, MED_HEXA27};
/// Positions of the corners of a MED tetrahedron in VTK's order.
constexpr std::size_t tetrahedron_corner[4] = {0, 2, 1, 3};
/// Positions of the midpoints of a MED tetrahedron in VTK's order.
constexpr std::size_t tetrahedron_middle[6] = {6, 5, 4, 7, 9, 8};

class MedReader {
 public:
  explicit MedReader(const std::filesystem::path& path) : path_(path) {
    if (!std::ifstream(path)) throw Error(ErrorKind::usage, path.string() + ": cannot be opened");
    med_bool is_hdf = MED_FALSE, is_med = MED_FALSE;
    if (MEDfileCompatibility(path.string().c_str(), &is_hdf, &is_med) < 0 || !is_hdf || !is_med)
      refuse("it is no MED file of a version that is read here");
    budget_.grow(static_cast<std::size_t>(std::filesystem::file_size(path)));
    id_ = MEDfileOpen(path.string().c_str(), MED_ACC_RDONLY);
    if (id_ < 0) refuse("libmedc cannot open it: it is damaged");
  }
  ~MedReader() { MEDfileClose(id_); }
  MedReader(const MedReader&) = delete;
  MedReader& operator=(const MedReader&) = delete;

  RawMesh read() {
    mesh_.format = "MED";
    read_name();
    read_families();
    read_nodes();
    for (const MedShape& shape : shapes) read_cells(shape);
    for (const med_geometry_type type : other_solids) mesh_.n_other_solids += count(type);
    for (auto& [key, set] : sets_) mesh_.sets.push_back(std::move(set));
    return std::move(mesh_);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorKind::invalid_input, path_.string() + ": " + why);
  }
  void require(med_err status) const {
    if (status < 0) refuse("libmedc cannot read it: it is damaged");
  }
  void read_name() {
    if (MEDnMesh(id_) < 1) refuse("holds no mesh");
    char name[MED_NAME_SIZE + 1] = "", description[MED_COMMENT_SIZE + 1] = "", unit[MED_SNAME_SIZE + 1] = "";
    char axes[3 * MED_SNAME_SIZE + 1] = "", axis_units[3 * MED_SNAME_SIZE + 1] = "";
    med_int space = 0, dimension = 0, n_steps = 0;
    med_mesh_type type{};
    med_sorting_type sorting{};
    med_axis_type axis{};
    require(MEDmeshInfo(id_, 1, name, &space, &dimension, &type, description, unit, &sorting, &n_steps, &axis, axes,
                        axis_units));
    if (space != 3 || type != MED_UNSTRUCTURED_MESH) refuse("its mesh is not unstructured in space");
    name_ = name;
  }
  void read_families() {
    const med_int n = MEDnFamily(id_, name_.c_str());
    for (int f = 1; f <= n; ++f) {
      const med_int n_groups = MEDnFamilyGroup(id_, name_.c_str(), f);
      if (n_groups < 0) refuse("libmedc cannot read it: it is damaged");
      char family[MED_NAME_SIZE + 1] = "";
      med_int number = 0;
      std::string groups(static_cast<std::size_t>(n_groups) * MED_LNAME_SIZE + 1, '\0');
      require(MEDfamilyInfo(id_, name_.c_str(), f, family, &number, groups.data()));
      for (med_int g = 0; g < n_groups; ++g) {
        std::string name = groups.substr(static_cast<std::size_t>(g) * MED_LNAME_SIZE, MED_LNAME_SIZE).c_str();
        name.erase(name.find_last_not_of(' ') + 1);
        groups_of_[number].push_back(name);
      }
    }
  }
  std::size_t count(med_geometry_type type) const {
    med_bool changed = MED_FALSE, moved = MED_FALSE;
    const med_entity_type entity = type == MED_NONE ? MED_NODE : MED_CELL;
    const med_int n = MEDmeshnEntity(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, entity, type,
                                     type == MED_NONE ? MED_COORDINATE : MED_CONNECTIVITY, MED_NODAL, &changed, &moved);
    // A MED file is damaged if it declares more numbers than it can contain even when compressed (deflate: 1032 to 1).
    if (n > 0 && static_cast<std::uintmax_t>(n) / 1032 > std::filesystem::file_size(path_))
      refuse("sizes in it are not those of what follows: it is damaged");
    return n < 0 ? 0 : static_cast<std::size_t>(n);
  }
  std::vector<med_int> families(med_entity_type entity, med_geometry_type type, std::size_t n) const {
    std::vector<med_int> numbers(n, 0);  // if a MED file has no family numbers, all items are in family 0
    if (MEDmeshEntityFamilyNumberRd(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, entity, type, numbers.data()) < 0)
      numbers.assign(n, 0);
    return numbers;
  }
  void add_to_groups(med_int family, int dimension, std::size_t row) {
    const auto groups = groups_of_.find(family);
    if (groups == groups_of_.end()) return;
    if (!budget_.take(groups->second.size())) refuse(SetBudget::message);
    for (const std::string& name : groups->second) {
      RawSet& set = sets_[{dimension, name}];
      set.name = name;
      set.dimension = dimension;
      set.rows.push_back(row);
    }
  }
  void read_nodes() {
    const std::size_t n = count(MED_NONE);
    if (n >= no_vertex) refuse("holds more points than 32 bits can count");
    std::vector<med_float> xyz(3 * n);
    if (n > 0)
      require(MEDmeshNodeCoordinateRd(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, MED_FULL_INTERLACE, xyz.data()));
    for (std::size_t i = 0; i < n; ++i) mesh_.points.push_back({xyz[3 * i], xyz[3 * i + 1], xyz[3 * i + 2]});
    const std::vector<med_int> family = families(MED_NODE, MED_NONE, n);
    for (std::size_t i = 0; i < n; ++i) add_to_groups(family[i], -1, i);
  }
  void read_cells(const MedShape& shape) {
    const std::size_t n = count(shape.type);
    if (n == 0) return;
    std::vector<med_int> nodes(n * shape.n_nodes);
    require(MEDmeshElementConnectivityRd(id_, name_.c_str(), MED_NO_DT, MED_NO_IT, MED_CELL, shape.type, MED_NODAL,
                                         MED_FULL_INTERLACE, nodes.data()));
    const std::vector<med_int> family = families(MED_CELL, shape.type, n);
    RawCells& cells = mesh_.cells[static_cast<std::size_t>(shape.dimension)];
    mesh_.second_order |= shape.type == MED_TETRA10;
    for (std::size_t c = 0; c < n; ++c) {
      const auto node = [&](std::size_t i) {
        const med_int v = nodes[c * shape.n_nodes + i];
        if (v < 1 || static_cast<std::size_t>(v) > mesh_.points.size())
          refuse("node " + std::to_string(v) + " is not there");
        return static_cast<VertexIndex>(v - 1);
      };
      for (std::size_t i = 0; i < cells.n_corners; ++i)
        cells.corners.push_back(node(shape.dimension == 3 ? tetrahedron_corner[i] : i));
      if (shape.type == MED_TETRA10)
        for (const std::size_t i : tetrahedron_middle) mesh_.midpoints.push_back(node(i));
      if (shape.dimension == 3) mesh_.numbers.push_back(mesh_.numbers.size());
      add_to_groups(family[c], shape.dimension, cells.size() - 1);
    }
  }

  std::filesystem::path path_;
  med_idt id_ = -1;
  SetBudget budget_{0};
  std::string name_;
  RawMesh mesh_;
  std::map<med_int, std::vector<std::string>> groups_of_;
  std::map<std::pair<int, std::string>, RawSet> sets_;
};

}  // namespace

RawMesh read_med_mesh(const std::filesystem::path& file) { return MedReader(file).read(); }

}  // namespace geomesh::geomodel
