// SPDX-License-Identifier: GPL-3.0-or-later
// Gmsh's element types: simplices are read, other elements are passed over, and solids among them are counted.
#include <catch2/catch.hpp>
#include <fstream>

#include "geomesh/core/error.hpp"
#include "mesh_readers/mesh_readers.hpp"
#include "scratch.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;

namespace {

/// From the manual of Gmsh 4, section "MSH file format": number, dimension, nodes.
struct Type {
  int number, dimension, n_nodes;
  bool is_simplex;
};
constexpr Type types[] = {{1, 1, 2, true},    {2, 2, 3, true},    {3, 2, 4, false},  {4, 3, 4, true},
                          {5, 3, 8, false},   {6, 3, 6, false},   {7, 3, 5, false},  {8, 1, 3, true},
                          {9, 2, 6, true},    {10, 2, 9, false},  {11, 3, 10, true}, {12, 3, 27, false},
                          {13, 3, 18, false}, {14, 3, 14, false}, {15, 0, 1, true},  {16, 2, 8, false},
                          {17, 3, 20, false}, {18, 3, 15, false}, {19, 3, 13, false}};

/// 30 nodes, a tetrahedron, an element of the type on the nodes from 2 on, and another tetrahedron.
std::filesystem::path file_with(const Type& type) {
  const auto file = scratch_folder() / "types.msh";
  std::ofstream out(file);
  out << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n30\n";
  for (int i = 1; i <= 30; ++i) out << i << ' ' << i << ' ' << i * i << ' ' << i * i * i << '\n';
  out << "$EndNodes\n$Elements\n3\n1 4 2 7 7 1 2 3 4\n2 " << type.number << " 2 8 8";
  for (int i = 0; i < type.n_nodes; ++i) out << ' ' << 2 + i;
  out << "\n3 4 2 9 9 5 6 7 8\n$EndElements\n";
  return file;
}

}  // namespace

TEST_CASE("Gmsh's element types are those of its manual", "[readers]") {
  for (const Type& type : types) {
    INFO("type " << type.number);
    const RawMesh mesh = read_gmsh_mesh(file_with(type));
    std::array<std::size_t, 4> due{0, 0, 0, 2};
    if (type.is_simplex) ++due[static_cast<std::size_t>(type.dimension)];
    for (std::size_t d = 0; d < 4; ++d) CHECK(mesh.cells[d].size() == due[d]);
    CHECK(mesh.n_other_solids == (!type.is_simplex && type.dimension == 3 ? 1 : 0));
    CHECK(mesh.points.size() == 30);
    const auto& last = mesh.cells[3].corners;
    CHECK(std::vector<VertexIndex>(last.end() - 4, last.end()) == std::vector<VertexIndex>{4, 5, 6, 7});
    CHECK(mesh.second_order == (type.number == 11));
  }
}

TEST_CASE("an element type of Gmsh that is not known is refused by its number", "[readers]") {
  CHECK_THROWS_WITH(read_gmsh_mesh(file_with({93, 3, 5, false})), Catch::Contains("type 93"));
}
