// SPDX-License-Identifier: MIT
#include "remesh/domain/walled_mesh.hpp"

#include <algorithm>
#include <limits>

#include "common/geometry.hpp"
#include "common/parallel.hpp"
#include "mesh/cavity.hpp"

namespace geomesh::remesh {

WalledMesh::WalledMesh(DomainMesh& mesh) : mesh_(mesh), cells_(mesh.mesh_) {
  GEOMESH_CHECK(!mesh.journal_.is_open && mesh.n_vertices() > 0);
  const Vec3 first = mesh.point(0);
  infinite_ = mesh.add_vertex(first, VertexKind::dead);
  records_.resize(mesh.n_vertices());
  for (VertexIndex v = 0; v < infinite_; ++v) {
    static_cast<Vec3&>(records_[v]) = mesh.point(v);
    records_[v].place = mesh.kind(v) <= VertexKind::curve ? 1 : 0;
  }
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  static_cast<Vec3&>(records_[infinite_]) = {none, none, none};
  for (CellIndex c = 0; c < cells_.n_slots(); ++c) cells_.flags(c) = 0;
  add_ghosts();
}

void WalledMesh::add_ghosts() {
  std::vector<FaceRef> faces;
  for (const CellIndex c : mesh_.live_cells())
    for (unsigned i = 0; i < 4; ++i)
      if (mesh_.tag(c, i).constrained()) faces.push_back({c, i});
  std::vector<FaceRef> opposite;
  opposite.reserve(faces.size());
  for (const FaceRef f : faces) opposite.push_back(cells_.mirror(f));
  ghosts_.reserve(faces.size());
  for (const FaceRef f : faces) {
    const Triangle t = face_of(cells_.vertices(f.cell()), f.face());
    const CellIndex g = cells_.add_cell({t[0], t[2], t[1], infinite_});
    cells_.flags(g) = ghost;
    cells_.link({g, 3}, f);
    ghosts_.push_back({g, mesh_.tag(f)});
  }
  mesh_.attributes_.grow_to(cells_.n_slots());
  for (std::size_t k = 0; k < faces.size(); ++k) {
    if (!opposite[k].valid()) continue;
    const auto at =
        std::lower_bound(faces.begin(), faces.end(), opposite[k], [](FaceRef a, FaceRef b) { return a.code < b.code; });
    GEOMESH_CHECK(at != faces.end() && *at == opposite[k]);
    ghosts_[k].opposite = ghosts_[static_cast<std::size_t>(at - faces.begin())].cell;
  }
}

void WalledMesh::close(unsigned threads) {
  DomainAttributes& attributes = mesh_.attributes_;
  attributes.grow_to(cells_.n_slots());
  for_each_index(cells_.n_slots(), thread_count(threads), [&](std::size_t k) {
    const auto c = static_cast<CellIndex>(k);
    if (!is_cell(c) || !(cells_.flags(c) & is_new)) return;
    attributes.tags[c] = {};
    attributes.shape[c] = mesh_.shape(cells_.vertices(c));
  });
  for (CellIndex c = 0; c < cells_.n_slots(); ++c) {
    if (is_cell(c) && (cells_.flags(c) & is_new))
      for (const VertexIndex v : cells_.vertices(c)) mesh_.cell_of_[v] = c, mesh_.changed_[v] = mesh_.clock_;
    if (!(cells_.flags(c) & ghost)) cells_.flags(c) = 0;
  }
  std::vector<FaceRef> faces;
  faces.reserve(ghosts_.size());
  for (const Ghost& g : ghosts_) {
    const FaceRef f = cells_.neighbor(g.cell, 3);
    attributes.tags[f.cell()][f.face()] = g.tag;
    faces.push_back(g.opposite == no_cell ? FaceRef{} : cells_.neighbor(g.opposite, 3));
  }
  for (std::size_t k = 0; k < ghosts_.size(); ++k) {
    const FaceRef f = cells_.neighbor(ghosts_[k].cell, 3);
    cells_.cells()[f.cell()].neighbors[f.face()] = faces[k];
  }
  for (const Ghost& g : ghosts_) {
    cells_.flags(g.cell) = 0;
    cells_.free_cell(g.cell);
  }
  ghosts_.clear();
}

std::optional<CellIndex> WalledMesh::locate(const Vec3& p, CellIndex start) const {
  // The walk to the cell that contains p varies the order in which it tries the faces of a cell, so that it cannot
  // cycle for long.
  unsigned turn = 0;
  const auto end = mesh_.walk(
      p, start, 1000, [&] { return turn++ & 3u; }, [&](FaceRef f) { return is_wall(f.cell(), f.face()); });
  return end.end == DomainMesh::Walk::End::found ? std::optional(end.cell) : std::nullopt;
}

std::optional<VertexIndex> WalledMesh::insert(const Vec3& p, CellIndex home, double spacing) {
  if (!grow(p, home) || !(nearest_ >= spacing * spacing)) {
    leave_cavity();
    return std::nullopt;
  }
  number_border();
  const bool is_refused = swallows();
  for (const VertexIndex v : numbered_) records_[v].local = PointRecord::no_local;
  if (is_refused) {
    leave_cavity();
    return std::nullopt;
  }
  const VertexIndex v = mesh_.add_vertex(p, VertexKind::inside);
  PointRecord& record = records_.emplace_back();
  static_cast<Vec3&>(record) = p;
  fill(v);
  return v;
}

/// Decides exactly the in-sphere tests that the floating-point filters of the kernel leave undecided.
struct WalledMesh::Host final : CavityHost {
  WalledMesh& walled;
  const Vec3& p;
  Host(WalledMesh& w, const Vec3& q) : walled(w), p(q) {}

  unsigned decide(const TetMesh::Cell& cell, unsigned undecided, const double*) override {
    unsigned conflict = 0;
    for (unsigned i = 0; i < 4; ++i) {
      const CellIndex n = cell.neighbors[i].cell();
      if (!(undecided >> i & 1u) || (walled.cells_.flags(n) & ghost)) continue;
      const auto [a, b, c, d] = walled.mesh_.places(walled.cells_.vertices(n));
      conflict |= (in_sphere(a, b, c, d, p) == Sign::positive ? 1u : 0u) << i;
    }
    return conflict;
  }
  void lend(CavityLists& lists) {
    lists.cells = walled.cavity_.data();
    lists.faces = walled.border_.data();
    lists.capacity = walled.cavity_.size();
  }
  void enlarge(CavityLists& lists) override {
    walled.cavity_.resize(2 * walled.cavity_.size());
    walled.border_.resize(walled.cavity_.size());
    lend(lists);
  }
};

/// Finds the cavity of p. Returns false if no cavity that contains the cell `home` is star-shaped about p.
bool WalledMesh::grow(const Vec3& p, CellIndex home) {
  Host host(*this, p);
  CavityLists lists;
  host.lend(lists);
  lists.n_cells = 1;
  cavity_[0] = home;
  cells_.flags(home) |= in_cavity;
  lane_kernels().grow({cells_.cells(), records_.data(), p, 0, {}}, cells_.cell_flags(), in_cavity, lists, host);
  n_cavity_ = lists.n_cells;
  n_border_ = lists.n_faces;
  nearest_ = lists.nearest;
  return sees_border(p) || shrink(p, home);
}

bool WalledMesh::sees(const Vec3& p, const std::array<VertexIndex, 3>& f) const {
  return orient3d(records_[f[0]], records_[f[1]], records_[f[2]], p) == Sign::positive;
}

bool WalledMesh::sees_border(const Vec3& p) const {
  return std::all_of(border_.begin(), border_.begin() + static_cast<std::ptrdiff_t>(n_border_),
                     [&](const CavityFace<3>& f) { return sees(p, f.vertices); });
}

/// Shrinks the cavity until it is star-shaped about p. Among cells that are not Delaunay it may not be so at first.
bool WalledMesh::shrink(const Vec3& p, CellIndex home) {
  const std::array bases{home};
  Cavity cavity(cells_, marks_, kept_, bases);
  for (std::size_t k = 1; k < n_cavity_; ++k) cavity.add(cavity_[k]);
  const bool is_left = cavity.shrink([&](FaceRef f) { return !is_wall(f.cell(), f.face()); },
                                     [](FaceRef) { return false; }, [&](FaceRef f) { return sees(p, mesh_.face(f)); });
  if (!is_left) return false;
  leave_cavity();
  n_cavity_ = kept_.size();
  std::copy(kept_.begin(), kept_.end(), cavity_.begin());
  for (const CellIndex c : kept_) cells_.flags(c) |= in_cavity;
  collect_border(p);
  return true;
}

/// Collects the border faces of the cavity and the squared distance from p to its nearest vertex.
void WalledMesh::collect_border(const Vec3& p) {
  n_border_ = 0;
  nearest_ = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < n_cavity_; ++k) {
    for (const VertexIndex v : cells_.vertices(cavity_[k]))
      nearest_ = std::min(nearest_, squared_distance(mesh_.point(v), p));
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef outer = cells_.neighbor(cavity_[k], i);
      if (cells_.flags(outer.cell()) & in_cavity) continue;
      if (n_border_ == border_.size()) border_.resize(2 * n_border_), cavity_.resize(2 * n_border_);
      border_[n_border_++] = {face_of(cells_.vertices(cavity_[k]), i), outer};
    }
  }
}

/// Numbers the vertices of the cavity's border. The caller must reset these numbers, which are stored in the records.
void WalledMesh::number_border() {
  numbered_.clear();
  number_.resize(border_.size());
  for (std::size_t k = 0; k < n_border_; ++k)
    for (unsigned j = 0; j < 3; ++j) {
      const VertexIndex v = border_[k].vertices[j];
      std::uint16_t& local = records_[v].local;
      if (local == PointRecord::no_local) {
        local = static_cast<std::uint16_t>(numbered_.size());
        numbered_.push_back(v);
      }
      number_[k][j] = local;
    }
}

/// Returns whether a vertex, or an edge of a curve, is inside the cavity.
bool WalledMesh::swallows() const {
  for (std::size_t k = 0; k < n_cavity_; ++k) {
    const Tetrahedron& t = cells_.vertices(cavity_[k]);
    unsigned n_on_curves = 0;
    for (const VertexIndex v : t) {
      if (records_[v].local == PointRecord::no_local) return true;
      n_on_curves += records_[v].place;
    }
    if (n_on_curves < 2) continue;
    for (const auto& e : edge_vertices)
      if (mesh_.curve_of(t[e[0]], t[e[1]]) != no_index && !is_on_border(t[e[0]], t[e[1]])) return true;
  }
  return false;
}

bool WalledMesh::is_on_border(VertexIndex a, VertexIndex b) const {
  return std::any_of(border_.begin(), border_.begin() + static_cast<std::ptrdiff_t>(n_border_),
                     [&](const CavityFace<3>& f) {
                       return std::ranges::count(f.vertices, a) > 0 && std::ranges::count(f.vertices, b) > 0;
                     });
}

void WalledMesh::fill(VertexIndex v) {
  DomainAttributes& attributes = mesh_.attributes_;
  const Index component = attributes.component[cavity_[0]];
  for (std::size_t k = n_border_; k < n_cavity_; ++k) {
    cells_.flags(cavity_[k]) = 0;
    cells_.free_cell(cavity_[k]);
  }
  for (std::size_t k = n_cavity_; k < n_border_; ++k) cavity_[k] = cells_.add_cell({v, v, v, v});
  attributes.component.grow_to(cells_.n_slots());
  TetMesh::Cell* cells = cells_.cells();
  for (std::size_t k = 0; k < n_border_; ++k) {
    const auto& [f, outer] = border_[k];
    const CellIndex c = cavity_[k];
    cells[c] = {{f[0], f[1], f[2], v}, {FaceRef{}, FaceRef{}, FaceRef{}, outer}};
    cells[outer.cell()].neighbors[outer.face()] = FaceRef(c, 3);
    cells_.flags(c) = is_new;
    attributes.component[c] = component;
  }
  if (numbered_.size() <= table_side)
    connect_by_table();
  else
    connect_by_sorting();
}

/// Returns whether `across` is the same face as face j of `cell` (the inserted vertex and an edge of the cavity's
/// border), seen from another new cell.
bool WalledMesh::is_across(const TetMesh::Cell& cell, unsigned j, FaceRef across) const {
  if (!across.valid() || across.cell() >= cells_.n_slots()) return false;
  const Tetrahedron& t = cells_.vertices(across.cell());
  const unsigned i = across.face();
  return i < 3 && t[3] == cell.vertices[3] && t[(i + 1) % 3] == cell.vertices[(j + 2) % 3] &&
         t[(i + 2) % 3] == cell.vertices[(j + 1) % 3];
}

/// Connects the cells of the star with each other. A square table maps each directed edge of the border to its cell;
/// each entry is written before it is read, so the table is never cleared.
void WalledMesh::connect_by_table() {
  const auto at = [&](unsigned a, unsigned b) -> FaceRef& { return table_[std::size_t{a} * table_side + b]; };
  for (std::size_t k = 0; k < n_border_; ++k) {
    const auto n = number_[k];
    for (unsigned j = 0; j < 3; ++j) at(n[(j + 1) % 3], n[(j + 2) % 3]) = FaceRef(cavity_[k], j);
  }
  for (std::size_t k = 0; k < n_border_; ++k) {
    const auto n = number_[k];
    TetMesh::Cell& cell = cells_.cells()[cavity_[k]];
    for (unsigned j = 0; j < 3; ++j) {
      const FaceRef across = at(n[(j + 2) % 3], n[(j + 1) % 3]);
      GEOMESH_CHECK(is_across(cell, j, across));
      cell.neighbors[j] = across;
    }
  }
}

void WalledMesh::connect_by_sorting() {
  std::vector<std::pair<std::array<VertexIndex, 2>, FaceRef>> faces;
  for (std::size_t k = 0; k < n_border_; ++k)
    for (unsigned j = 0; j < 3; ++j) {
      const auto& f = border_[k].vertices;
      faces.push_back({sorted(std::array{f[(j + 1) % 3], f[(j + 2) % 3]}), FaceRef(cavity_[k], j)});
    }
  std::sort(faces.begin(), faces.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  for (std::size_t k = 0; k < faces.size(); k += 2) {
    GEOMESH_CHECK(k + 1 < faces.size() && faces[k].first == faces[k + 1].first);
    cells_.link(faces[k].second, faces[k + 1].second);
  }
}

void WalledMesh::leave_cavity() {
  for (std::size_t k = 0; k < n_cavity_; ++k) cells_.flags(cavity_[k]) &= static_cast<std::uint8_t>(~in_cavity);
}

}  // namespace geomesh::remesh
