// SPDX-License-Identifier: MIT
#include "remesh/domain/domain_mesh.hpp"

#include <algorithm>
#include <atomic>
#include <string>

#include "common/parallel.hpp"
#include "geomesh/core/validate.hpp"

namespace geomesh::remesh {

VertexIndex DomainMesh::add_vertex(const Vec3& p, VertexKind kind, Index support) {
  points_.push_back(p);
  kinds_.push_back(kind);
  supports_.push_back(support);
  cell_of_.push_back(no_cell);
  changed_.push_back(0);
  return static_cast<VertexIndex>(points_.size() - 1);
}

void DomainMesh::reserve(std::size_t n_vertices, std::size_t n_cells) {
  points_.reserve(n_vertices);
  kinds_.reserve(n_vertices);
  supports_.reserve(n_vertices);
  cell_of_.reserve(n_vertices);
  changed_.reserve(n_vertices);
  mesh_.reserve(n_cells);
  attributes_.reserve(n_cells);
}

CellIndex DomainMesh::add_cell(const Tetrahedron& vertices, Index component, double shape) {
  const CellIndex c = mesh_.add_cell(vertices);
  if (journal_.is_open) journal_.note_added(c);
  attributes_.grow_to(c + std::size_t{1});
  set_cell(c, {vertices, component, {}, shape}, clock_);
  return c;
}

/// Sets all data of a cell except its neighbours.
void DomainMesh::set_cell(CellIndex c, const NewCell& cell, std::uint64_t time) {
  attributes_.component[c] = cell.component;
  attributes_.tags[c] = cell.tags;
  for (VertexIndex v : cell.vertices) {
    note_vertex(v);
    cell_of_[v] = c;
  }
  set_shape(c, cell.shape > 0 ? cell.shape : shape(cell.vertices), time);
}

void DomainMesh::refresh_shape(CellIndex c) { set_shape(c, shape(mesh_.vertices(c))); }

void DomainMesh::set_shape(CellIndex c, double shape) { set_shape(c, shape, clock_); }

void DomainMesh::set_shape(CellIndex c, double shape, std::uint64_t time) {
  if (journal_.is_open) {
    note_cell(c);
    for (const VertexIndex v : mesh_.vertices(c)) note_vertex(v);
  }
  attributes_.shape[c] = shape;
  // Times of change are written atomically, because vertices smoothed concurrently may have fixed neighbours in common.
  for (const VertexIndex v : mesh_.vertices(c)) std::atomic_ref(changed_[v]).store(time, std::memory_order_relaxed);
}

void DomainMesh::link_cells() {
  std::vector<OpenFace> faces;
  faces.reserve(4 * mesh_.n_live());
  for (const CellIndex c : live_cells())
    for (unsigned i = 0; i < 4; ++i) faces.push_back({face_key(mesh_.vertices(c), i), FaceRef(c, i)});
  link_faces(std::move(faces));
}

void DomainMesh::link_faces(std::vector<OpenFace> faces) {
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t i = 0; i + 1 < faces.size(); ++i) {
    if (faces[i].first != faces[i + 1].first) continue;
    GEOMESH_CHECK(i + 2 == faces.size() || faces[i].first != faces[i + 2].first);
    mesh_.link(faces[i].second, faces[i + 1].second);
  }
}

void DomainMesh::replace(std::span<const CellIndex> removed, std::span<const NewCell> added,
                         std::vector<CellIndex>& created) {
  const auto make = [&](std::size_t k) {
    // `created` may be the same array as `removed`, so it is cleared only after `removed` has been read.
    if (k == 0) created.clear();
    const CellIndex c = add_cell(added[k].vertices, added[k].component, added[k].shape);
    attributes_.tags[c] = added[k].tags;
    created.push_back(c);
    return c;
  };
  const auto note_removal = [&](CellIndex c) {
    note_cell(c);
    if (journal_.is_open) journal_.note_freed(c);
  };
  if (added.empty()) created.clear();
  exchange(
      removed, added.size(), make, [&](CellIndex c) { note_cell(c); }, note_removal);
}

void DomainMesh::remove_vertex(VertexIndex v) {
  note_vertex(v);
  kinds_[v] = VertexKind::dead;
  supports_[v] = no_index;
  cell_of_[v] = no_cell;
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

void DomainMesh::begin_trial() { journal_.open(n_vertices(), n_slots(), clock_); }

void DomainMesh::undo_trial() {
  points_.resize(journal_.n_vertices);
  kinds_.resize(points_.size());
  supports_.resize(points_.size());
  cell_of_.resize(points_.size());
  changed_.resize(points_.size());
  for (const SavedVertex& s : journal_.vertices) {
    points_[s.vertex] = s.point;
    kinds_[s.vertex] = s.kind;
    supports_[s.vertex] = s.support;
    cell_of_[s.vertex] = s.incident;
    changed_[s.vertex] = s.changed;
  }
  for (auto event = journal_.slots.rbegin(); event != journal_.slots.rend(); ++event)
    if (event->what == SlotEvent::What::freed)
      mesh_.take_back_freed(event->cell);
    else if (event->what == SlotEvent::What::reused)
      mesh_.free_cell(event->cell);
    else
      mesh_.drop_slots_from(event->cell);
  attributes_.truncate(mesh_.n_slots());
  for (const SavedCell& s : journal_.cells) {
    mesh_.cells()[s.cell] = s.links;
    attributes_.component[s.cell] = s.component;
    attributes_.tags[s.cell] = s.tags;
    attributes_.shape[s.cell] = s.shape;
  }
  for (auto curve = journal_.curves.rbegin(); curve != journal_.curves.rend(); ++curve)
    if (curve->curve == no_index)
      curves_.erase({curve->a, curve->b});
    else
      curves_.insert({curve->a, curve->b}, curve->curve);
  clock_ = journal_.clock;
  journal_.is_open = false;
}

namespace {

std::string describe(const char* what, CellIndex c) { return std::string(what) + " (cell " + std::to_string(c) + ")"; }

}  // namespace

std::string DomainMesh::validate(unsigned threads) const {
  std::array<std::string, 2> found;
  for_each_task(found.size(), thread_count(threads), [&](std::size_t k) {
    const auto faults = k == 0 ? validate_topology(mesh_, 1, Outside::open) : validate_geometry(mesh_, points_, 1);
    if (!faults.empty())
      found.at(k) = describe(faults[0].what.c_str(), faults[0].cell);
    else if (k == 0)
      found[0] = validate_domain();
  });
  for (const std::string& fault : found)
    if (!fault.empty()) return fault;
  return {};
}

/// Checks the invariants of DomainMesh beyond valid topology and geometry.
std::string DomainMesh::validate_domain() const {
  std::vector<std::array<VertexIndex, 2>> edges;
  for (const CellIndex c : live_cells()) {
    const Tetrahedron& t = mesh_.vertices(c);
    for (unsigned i = 0; i < 4; ++i) {
      if (kinds_[t[i]] == VertexKind::dead) return describe("a removed vertex is in a cell", c);
      const FaceRef n = mesh_.neighbor(c, i);
      if (!n.valid()) {
        if (!tag(c, i).constrained()) return describe("an outer face is not tagged", c);
        continue;
      }
      if (tag(c, i).opposite() != tag(n.cell(), n.face())) return describe("a face's two tags disagree", c);
      if (!tag(c, i).constrained() && component(c) != component(n.cell()))
        return describe("components leak through a face", c);
    }
    for (const auto& e : edge_vertices)  // only corners and vertices of the kind `curve` are on curves
      if (kinds_[t[e[0]]] <= VertexKind::curve && kinds_[t[e[1]]] <= VertexKind::curve)
        edges.push_back(sorted(std::array{t[e[0]], t[e[1]]}));
  }
  std::sort(edges.begin(), edges.end());
  for (const auto& e : curve_edges())
    if (!std::binary_search(edges.begin(), edges.end(), e)) return "a curve edge is not in the mesh";
  for (VertexIndex v = 0; v < points_.size(); ++v)
    if (kinds_[v] != VertexKind::dead &&
        (cell_of_[v] == no_cell || !mesh_.is_live(cell_of_[v]) || !mesh_.has_vertex(cell_of_[v], v)))
      return "an incident cell does not have its vertex " + std::to_string(v);
  return {};
}

}  // namespace geomesh::remesh
