// SPDX-License-Identifier: GPL-3.0-or-later
// Abaqus / CalculiX input: nodes, C3D4 elements by region, node sets, surfaces on element faces.
#include <algorithm>
#include <array>
#include <charconv>
#include <cstdlib>
#include <map>

#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "writers/sidecar.hpp"
#include "writers/solver_groups.hpp"
#include "writers/text_buffer.hpp"

namespace geomesh::geomodel {

namespace {

/// Side of a C3D4 by the vertex it is opposite to: S1 = 1-2-3, S2 = 1-4-2, S3 = 2-4-3, S4 = 3-4-1.
constexpr int side_opposite[] = {3, 4, 2, 1};

/// CalculiX reads the first 20 characters of a number. 17 digits with sign and point fit; where small or huge
/// magnitudes need an exponent too, the last digits give way to it.
std::string text_of_20(double value) {
  char buffer[400];
  std::string text(buffer, std::to_chars(buffer, buffer + sizeof buffer, value).ptr);
  for (int precision = 16; text.size() > 20; --precision) {
    text.assign(buffer, std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::fixed, precision).ptr);
    const double read = std::strtod(text.c_str(), nullptr);
    if (text.size() <= 20 && read == value) break;
    text.assign(buffer,
                std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::scientific, precision).ptr);
  }
  return text;
}

struct ElementSide {
  std::size_t element;
  int side;
};
/// Per face: on the minus and on the plus side (element counted from 1; 0 where outside).
std::vector<std::array<ElementSide, 2>> element_sides(const ModelMesh& mesh) {
  struct Use {
    Triangle vertices;
    bool is_face, even;
    std::size_t row;
    int side;
  };
  std::vector<Use> uses;
  const auto add = [&](Triangle t, bool is_face, std::size_t row, int side) {
    bool even = true;
    for (std::size_t pass = 0; pass < 2; ++pass)
      for (std::size_t i = 0; i < 2; ++i)
        if (t[i] > t[i + 1]) {
          std::swap(t[i], t[i + 1]);
          even = !even;
        }
    uses.push_back({t, is_face, even, row, side});
  };
  for (std::size_t f = 0; f < mesh.faces.size(); ++f) add(mesh.faces[f].vertices, true, f, 0);
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    for (std::size_t i = 0; i < 4; ++i) {
      const Tetrahedron& v = mesh.tetrahedra[t];
      add({v[face_vertices[i][0]], v[face_vertices[i][1]], v[face_vertices[i][2]]}, false, t + 1, side_opposite[i]);
    }
  std::stable_sort(uses.begin(), uses.end(), [](const Use& a, const Use& b) {
    return a.vertices != b.vertices ? a.vertices < b.vertices : a.is_face > b.is_face;
  });
  std::vector<std::array<ElementSide, 2>> sides(mesh.faces.size());
  const Use* face = nullptr;
  for (const Use& use : uses) {
    if (use.is_face) {
      face = &use;
    } else if (face && face->vertices == use.vertices) {
      sides[face->row][use.even == face->even ? 1 : 0] = {use.row,
                                                          use.side};  // a tetrahedron's own face normal points inwards
    }
  }
  return sides;
}

/// Writes sets, eight entries a line, and remembers them for the sidecar.
class InputDeck {
 public:
  TextBuffer text;
  std::vector<SidecarGroup> sidecar;

  std::string name(const std::string& full_name) { return names_.give(full_name); }

  void add_node_set(const std::string& full_name, const std::vector<VertexIndex>& rows, int dimension,
                    std::int32_t member) {
    if (rows.empty()) return;
    const std::string name = names_.give(full_name);
    text << "*NSET, NSET=" << name << "\n";
    for (std::size_t i = 0; i < rows.size(); ++i)
      text << rows[i] + 1 << (i % 8 == 7 || i + 1 == rows.size() ? "\n" : ", ");
    sidecar.push_back({"nset", dimension, 0, name, full_name, {member}});
  }
  void add_surface(const std::string& full_name, const std::vector<ElementSide>& sides, std::int32_t member) {
    if (sides.empty()) return;
    const std::string name = names_.give(full_name);
    text << "*SURFACE, NAME=" << name << ", TYPE=ELEMENT\n";
    for (const ElementSide& s : sides) text << s.element << ", S" << s.side << "\n";
    sidecar.push_back({"surface", 2, 0, name, full_name, {member}});
  }

 private:
  SolverNames names_;
};

void sort_unique(std::vector<VertexIndex>& rows) {
  std::sort(rows.begin(), rows.end());
  rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
}

/// One element set for each region, and for each group of regions.
void add_regions(const ModelMesh& mesh, InputDeck& deck) {
  std::vector<std::string> names;
  std::vector<std::vector<std::size_t>> elements(mesh.regions.size());
  for (std::size_t t = 0; t < mesh.tetrahedra.size(); ++t)
    elements[static_cast<std::size_t>(mesh.tet_region[t] - 1)].push_back(t);
  for (std::size_t r = 0; r < mesh.regions.size(); ++r) {
    const std::string name = deck.name(mesh.regions[r].name);
    names.push_back(name);
    deck.text << "*ELEMENT, TYPE=C3D4, ELSET=" << name << "\n";
    for (std::size_t t : elements[r]) {
      deck.text << t + 1;
      for (VertexIndex v : mesh.tetrahedra[t]) deck.text << ", " << v + 1;
      deck.text << "\n";
    }
    deck.sidecar.push_back({"elset", 3, 0, name, mesh.regions[r].name, {mesh.regions[r].id}});
  }
  for (const RegionGroup& group : mesh.groups) {
    if (group.regions.empty()) continue;
    deck.text << "*ELSET, ELSET=" << deck.name(group.name) << "\n";
    for (std::int32_t id : group.regions) deck.text << names[static_cast<std::size_t>(id - 1)] << "\n";
  }
}

/// One surface more for each region whose elements lie at it, where there are several: a box side by unit, a side of a
/// fault by block.
void add_surface_by_region(const ModelMesh& mesh, const std::string& full_name, const std::vector<ElementSide>& sides,
                           std::int32_t member, InputDeck& deck) {
  std::map<std::int32_t, std::vector<ElementSide>> of_region;
  for (const ElementSide& side : sides) of_region[mesh.tet_region[side.element - 1]].push_back(side);
  if (of_region.size() < 2) return;
  for (const auto& [region, part] : of_region)
    deck.add_surface(full_name + "/" + mesh.regions[static_cast<std::size_t>(region - 1)].name, part, member);
}

void add_surfaces(const ModelMesh& mesh, InputDeck& deck) {
  const auto sides = element_sides(mesh);
  std::map<std::int32_t, std::vector<std::size_t>> faces_of;
  for (std::size_t f = 0; f < mesh.faces.size(); ++f)
    for (std::int32_t id : mesh.surface_sets[static_cast<std::size_t>(mesh.faces[f].surface_set)])
      faces_of[id].push_back(f);
  for (const NamedSurface& surface : mesh.surfaces) {
    std::vector<VertexIndex> nodes;
    std::vector<ElementSide> minus, plus;
    for (std::size_t f : faces_of[surface.id]) {
      nodes.insert(nodes.end(), mesh.faces[f].vertices.begin(), mesh.faces[f].vertices.end());
      if (sides[f][0].element != 0) minus.push_back(sides[f][0]);
      if (sides[f][1].element != 0) plus.push_back(sides[f][1]);
    }
    sort_unique(nodes);
    deck.add_node_set(surface.name, nodes, 2, surface.id);
    deck.add_surface(surface.name + (plus.empty() ? ".faces" : ".minus"), minus, surface.id);
    deck.add_surface(surface.name + ".plus", plus, surface.id);
    add_surface_by_region(mesh, surface.name + (plus.empty() ? "" : ".minus"), minus, surface.id, deck);
    add_surface_by_region(mesh, surface.name + ".plus", plus, surface.id, deck);
  }
}

}  // namespace

void write_abaqus_inp(const ModelMesh& mesh, const std::filesystem::path& file) {
  InputDeck deck;
  deck.text << "*HEADING\n" << mesh.name << "\n*NODE\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3& p = mesh.points[v];
    deck.text << v + 1 << ", " << text_of_20(p.x) << ", " << text_of_20(p.y) << ", " << text_of_20(p.z) << "\n";
  }
  add_regions(mesh, deck);
  add_surfaces(mesh, deck);
  std::map<std::int32_t, std::vector<VertexIndex>> curve_nodes;
  for (const auto& e : mesh.curve_edges) {
    curve_nodes[e.curve].push_back(e.a);
    curve_nodes[e.curve].push_back(e.b);
  }
  for (const NamedCurve& curve : mesh.curves) {
    sort_unique(curve_nodes[curve.id]);
    deck.add_node_set(curve.name, curve_nodes[curve.id], 1, curve.id);
  }
  for (const auto& p : mesh.marked_points) deck.add_node_set(p.name, {p.v}, 0, p.id);
  write_text_file(file, deck.text.text());
  write_sidecar(mesh, deck.sidecar, file);
}

}  // namespace geomesh::geomodel
