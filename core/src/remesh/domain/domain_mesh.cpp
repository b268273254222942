// SPDX-License-Identifier: MIT
#include "remesh/domain/domain_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <string>

#include "common/epoch_marks.hpp"
#include "common/hash.hpp"
#include "geomesh/core/predicates.hpp"
#include "quality/measure/shape.hpp"

namespace geomesh::remesh {

VertexIndex DomainMesh::add_vertex(const Vec3& p, VertexKind kind, Index support) {
  points_.push_back(p);
  kinds_.push_back(kind);
  supports_.push_back(support);
  incident_.push_back(no_cell);
  changed_.push_back(0);
  return static_cast<VertexIndex>(points_.size() - 1);
}

void DomainMesh::reserve(std::size_t n_vertices, std::size_t n_cells) {
  points_.reserve(n_vertices);
  kinds_.reserve(n_vertices);
  supports_.reserve(n_vertices);
  incident_.reserve(n_vertices);
  changed_.reserve(n_vertices);
  mesh_.reserve(n_cells);
  component_.reserve(n_cells);
  tags_.reserve(n_cells);
  shape_.reserve(n_cells);
}

CellIndex DomainMesh::add_cell(const Tetrahedron& vertices, Index component, double shape) {
  const CellIndex c = mesh_.add_cell(vertices);
  if (journal_.is_open()) journal_.note_added(c);
  if (c == component_.size()) {
    component_.push_back(component);
    tags_.emplace_back();
    shape_.push_back(0);
  } else {
    component_[c] = component;
    tags_[c] = {};
  }
  for (VertexIndex v : vertices) {
    note_vertex(v);
    incident_[v] = c;
  }
  if (shape > 0)
    set_shape(c, shape);
  else
    refresh_shape(c);
  return c;
}

void DomainMesh::refresh_shape(CellIndex c) {
  const Tetrahedron& t = mesh_.vertices(c);
  set_shape(c, shape(points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]));
}

void DomainMesh::set_shape(CellIndex c, double shape) {
  if (journal_.is_open()) {
    note_cell(c);
    for (const VertexIndex v : mesh_.vertices(c)) note_vertex(v);
  }
  shape_[c] = shape;
  // Blocks that are smoothed at once may share vertices that do not move.
  for (const VertexIndex v : mesh_.vertices(c)) std::atomic_ref(changed_[v]).store(clock_, std::memory_order_relaxed);
}

DomainMesh::FaceKey DomainMesh::face_key(const Tetrahedron& t, unsigned i) {
  const VertexIndex a = t[face_vertices[i][0]], b = t[face_vertices[i][1]], c = t[face_vertices[i][2]];
  const VertexIndex less = std::min(a, b), more = std::max(a, b), low = std::min(less, c), high = std::max(more, c);
  const VertexIndex middle = std::max(less, std::min(more, c));
  return {std::uint64_t{low} << 32 | middle, high};
}

void DomainMesh::link_cells() {
  std::vector<FaceRecord> records;
  records.reserve(4 * mesh_.n_live());
  for (CellIndex c = 0; c < mesh_.n_slots(); ++c)
    if (mesh_.is_live(c))
      for (unsigned i = 0; i < 4; ++i) records.push_back({face_key(mesh_.vertices(c), i), FaceRef(c, i), {}, false});
  pair_faces(records);
}

void DomainMesh::collect_border(std::span<const CellIndex> removed, std::vector<FaceRecord>& records) const {
  // Looking a neighbour up among few cells costs less than sorting a face that is inside the region.
  constexpr std::size_t few = 24;
  for (CellIndex c : removed)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef n = mesh_.neighbor(c, i);
      if (n.valid() && removed.size() <= few && std::find(removed.begin(), removed.end(), n.cell()) != removed.end())
        continue;
      records.push_back({face_key(mesh_.vertices(c), i), n, tags_[c][i], true});
    }
}

void DomainMesh::settle(const FaceGroup& group) {
  // Two outer records: a face inside the removed region. One: on its border, to be met by exactly one new face.
  if (group.n_outer == 1 && group.n_added == 1) {
    const FaceRecord &outer = *group.outer, &added = *group.added[0];
    FaceTag& own = tags_[added.face.cell()][added.face.face()];
    if (outer.tag.constrained())
      own = outer.tag;
    else if (own.constrained())  // a surface that the operation has moved to the border
      tags_[outer.face.cell()][outer.face.face()] = own.opposite();
    if (outer.face.valid()) mesh_.link(added.face, outer.face);
  } else if (group.n_added == 2 && group.n_outer != 1) {
    mesh_.link(group.added[0]->face, group.added[1]->face);
  } else if (group.n_added == 1 && group.n_outer == 0) {
    // A new face on the outside of the model: it carries the tag that its cell was given.
  } else {
    GEOMESH_CHECK(group.n_added == 0 && (group.n_outer == 2 || (group.n_outer == 1 && !group.outer->face.valid())));
  }
}

void DomainMesh::FaceGroup::take(const FaceRecord& record) {
  if (record.outer) {
    outer = &record;
    ++n_outer;
  } else {
    GEOMESH_CHECK(n_added < 2);
    added[n_added++] = &record;
  }
}

void DomainMesh::pair_faces(std::vector<FaceRecord>& records) {
  std::sort(records.begin(), records.end(), [](const FaceRecord& a, const FaceRecord& b) { return a.key < b.key; });
  for (std::size_t i = 0; i < records.size();) {
    FaceGroup group;
    for (const FaceKey key = records[i].key; i < records.size() && records[i].key == key; ++i) group.take(records[i]);
    settle(group);
  }
}

void DomainMesh::pair_few_faces(std::span<const FaceRecord> records) {
  std::size_t size = 64;
  while (size < 2 * records.size()) size *= 2;
  if (slots_.size() < size) slots_.resize(size);
  used_slots_.clear();
  for (const FaceRecord& record : records) {
    std::size_t at = hash_of(std::array{record.key.low_and_middle, std::uint64_t{record.key.high}}) >> 32;
    for (at &= size - 1; !slots_[at].is_empty() && !(slots_[at].key() == record.key);) at = (at + 1) & (size - 1);
    if (slots_[at].is_empty()) used_slots_.push_back(at);
    slots_[at].take(record);
  }
  for (const std::size_t at : used_slots_) {
    settle(slots_[at]);
    slots_[at] = {};
  }
}

void DomainMesh::replace(std::span<const CellIndex> removed, std::span<const NewCell> added,
                         std::vector<CellIndex>& created) {
  records_.clear();
  collect_border(removed, records_);
  if (journal_.is_open()) note_replacement(removed);
  for (CellIndex c : removed) mesh_.free_cell(c);
  created.clear();
  for (const NewCell& n : added) {
    const CellIndex c = add_cell(n.vertices, n.component, n.shape);
    tags_[c] = n.tags;
    created.push_back(c);
    for (unsigned i = 0; i < 4; ++i) records_.push_back({face_key(n.vertices, i), FaceRef(c, i), {}, false});
  }
  pair_few_faces(records_);
}

void DomainMesh::remove_vertex(VertexIndex v) {
  note_vertex(v);
  kinds_[v] = VertexKind::dead;
  supports_[v] = no_index;
  incident_[v] = no_cell;
}

void DomainMesh::star(VertexIndex v, EpochMarks& marks, std::vector<CellIndex>& cells) const {
  cells.clear();
  marks.begin(mesh_.n_slots());
  cells.push_back(incident_[v]);
  marks.mark(incident_[v]);
  for (std::size_t k = 0; k < cells.size(); ++k) {
    const CellIndex c = cells[k];
    for (unsigned i = 0; i < 4; ++i) {
      if (mesh_.vertex(c, i) == v) continue;
      const FaceRef n = mesh_.neighbor(c, i);
      if (!n.valid() || marks.marked(n.cell())) continue;
      marks.mark(n.cell());
      cells.push_back(n.cell());
    }
  }
}

std::size_t DomainMesh::n_patches() const {
  Index n = 0;
  for (Index p : facet_patch_)
    if (p != no_index) n = std::max(n, p + 1);
  return n;
}

Index DomainMesh::add_curve_class(CurveClass c) {
  curve_classes_.push_back(std::move(c));
  return static_cast<Index>(curve_classes_.size() - 1);
}

namespace {

std::string describe(const char* what, CellIndex c) { return std::string(what) + " (cell " + std::to_string(c) + ")"; }

}  // namespace

std::string DomainMesh::validate() const {
  std::vector<std::array<VertexIndex, 2>> edges;
  for (CellIndex c = 0; c < mesh_.n_slots(); ++c) {
    if (!mesh_.is_live(c)) continue;
    const Tetrahedron& t = mesh_.vertices(c);
    if (orient3d(points_[t[0]], points_[t[1]], points_[t[2]], points_[t[3]]) != Sign::positive)
      return describe("a cell is not positive", c);
    for (unsigned i = 0; i < 4; ++i) {
      if (kinds_[t[i]] == VertexKind::dead) return describe("a removed vertex is in a cell", c);
      const FaceRef f(c, i), n = mesh_.mirror(f);
      if (!n.valid()) {
        if (!tags_[c][i].constrained()) return describe("an outer face is not tagged", c);
        continue;
      }
      if (!mesh_.is_live(n.cell()) || mesh_.mirror(n) != f) return describe("neighbour links are not mutual", c);
      if (face_key(t, i) != face_key(mesh_.vertices(n.cell()), n.face()))
        return describe("neighbours disagree on their face", c);
      if (tags_[c][i].opposite() != tags_[n.cell()][n.face()]) return describe("a face's two tags disagree", c);
      if (!tags_[c][i].constrained() && component_[c] != component_[n.cell()])
        return describe("components leak through a face", c);
    }
    for (const auto& e : edge_vertices)  // no others can be on curves
      if (kinds_[t[e[0]]] <= VertexKind::curve && kinds_[t[e[1]]] <= VertexKind::curve)
        edges.push_back({std::min(t[e[0]], t[e[1]]), std::max(t[e[0]], t[e[1]])});
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& e : curve_edges())
    if (!std::binary_search(edges.begin(), edges.end(), e)) return "a curve edge is not in the mesh";
  for (VertexIndex v = 0; v < points_.size(); ++v)
    if (kinds_[v] != VertexKind::dead &&
        (incident_[v] == no_cell || !mesh_.is_live(incident_[v]) || !mesh_.has_vertex(incident_[v], v)))
      return "an incident cell does not have its vertex " + std::to_string(v);
  return {};
}

}  // namespace geomesh::remesh
