// SPDX-License-Identifier: MIT
#include "delaunay/flip_insertion.hpp"

#include <algorithm>

namespace geomesh {
namespace {

TetMesh::CellVertices substituted(TetMesh::CellVertices v, VertexIndex from, VertexIndex to) {
  std::replace(v.begin(), v.end(), from, to);
  return v;
}

}  // namespace

bool FlipInsertion::positive(const CellVertices& v) {
  if (has_infinite(v)) return true;
  return space_.orientation(space_.record(v[0]), space_.record(v[1]), space_.record(v[2]), space_.record(v[3])) ==
         Sign::positive;
}

bool FlipInsertion::all_positive() {
  return std::all_of(new_.begin(), new_.end(), [&](const CellVertices& v) { return positive(v); });
}

/// Replaces the cells listed in old_ by those in new_, which fill the same polyhedron.
void FlipInsertion::replace() {
  for (const CellIndex c : old_) flags_[c] |= cavity_flag;
  pairing_.begin(4 * (old_.size() + new_.size()));
  for (const CellIndex c : old_)
    for (unsigned i = 0; i < 4; ++i) {
      const FaceRef outer = cells_[c].neighbors[i];
      if (!(flags_[outer.cell()] & cavity_flag)) pairing_.await_outer(face_key(cells_[c].vertices, i), outer, false);
    }
  for (const CellIndex c : old_) {
    cells_[c].vertices[0] = no_vertex;
    flags_[c] = 0;
    slots_.give_back(c);
  }
  make_room(new_.size());
  made_.clear();
  for (const CellVertices& v : new_) {
    const CellIndex c = slots_.take();
    made_.push_back(c);
    cells_[c].vertices = v;
    flags_[c] = has_infinite(v) ? ghost_flag : 0;
    for (unsigned i = 0; i < 4; ++i)
      if (const auto* met = pairing_.meet(face_key(v, i), FaceRef(c, i))) mesh_.link(FaceRef(c, i), met->face);
  }
  GEOMESH_CHECK(pairing_.n_outer_waiting() == 0 && pairing_.n_added_waiting() == 0);
  hint_ = made_.back();
}

/// Collects the cells whose closure contains p: one cell, the two cells at a face, or all cells around an edge. If p is
/// outside the hull, collects the ghost of the face beyond which it lies.
void FlipInsertion::collect_holders(CellIndex c, const Vec3& p) {
  old_.assign(1, c);
  if (flags_[c] & ghost_flag) return;
  std::vector<unsigned> on;
  for (unsigned i = 0; i < 4; ++i)
    if (space_.side(cells_[c].vertices, i, p) == Sign::zero) on.push_back(i);
  GEOMESH_CHECK(on.size() <= 2);
  if (on.size() == 1) old_.push_back(cells_[c].neighbors[on[0]].cell());
  if (on.size() < 2) return;
  // Turns around the edge on which p lies: leaves each cell through that face at the edge by which it was not entered.
  FaceRef next = cells_[c].neighbors[on[0]];
  VertexIndex pivot = cells_[c].vertices[on[1]];
  while (next.cell() != c) {
    old_.push_back(next.cell());
    const CellIndex at = next.cell();
    const VertexIndex apex = cells_[at].vertices[next.face()];
    next = cells_[at].neighbors[index_of(at, pivot)];
    pivot = apex;
  }
}

InsertionOutcome FlipInsertion::split_only(VertexIndex v) {
  const Vec3& p = space_.record(v);
  const CellIndex c = walk(p);
  twin_ = equal_vertex(cells_[c].vertices, p);
  if (twin_ != no_vertex) {
    hint_ = c;
    return InsertionOutcome::duplicate;
  }
  collect_holders(c, p);
  for (const CellIndex o : old_) flags_[o] |= cavity_flag;
  new_.clear();
  for (const CellIndex o : old_)
    for (unsigned i = 0; i < 4; ++i) {
      if (flags_[cells_[o].neighbors[i].cell()] & cavity_flag) continue;
      CellVertices t = cells_[o].vertices;
      t[i] = v;
      new_.push_back(t);
    }
  for (const CellIndex o : old_) flags_[o] &= static_cast<std::uint8_t>(~cavity_flag);
  replace();
  return InsertionOutcome::inserted;
}

InsertionOutcome FlipInsertion::insert(VertexIndex v, double cluster_distance) {
  if (cluster_distance > 0) {
    const CellIndex c = hint_ = walk(space_.record(v));
    for (const VertexIndex u : cells_[c].vertices) {
      if (u == infinite_ || space_.squared_distance(u, space_.record(v)) >= cluster_distance * cluster_distance)
        continue;
      twin_ = equal_vertex(cells_[c].vertices, space_.record(v));
      return twin_ != no_vertex ? InsertionOutcome::duplicate : InsertionOutcome::too_near;
    }
  }
  const InsertionOutcome outcome = split_only(v);
  if (outcome == InsertionOutcome::inserted) flip_link(v);
  return outcome;
}

void FlipInsertion::flip_link(VertexIndex v) {
  queue_.clear();
  for (const CellIndex c : made_) queue_.push_back({c, cells_[c].vertices, index_of(c, v)});
  const std::size_t left = flip_queue(v);
  stuck_ += left;
  GEOMESH_CHECK(left == 0);
}

std::size_t FlipInsertion::flip_all() {
  queue_.clear();
  for (const CellIndex c : slots_.unused(mesh_.n_slots())) cells_[c].vertices[0] = no_vertex;
  for (CellIndex c = 0; c < mesh_.n_slots(); ++c)
    if (mesh_.is_live(c))
      for (unsigned i = 0; i < 4; ++i)
        if (cells_[c].neighbors[i].cell() > c) queue_.push_back({c, cells_[c].vertices, i});
  return stuck_ = flip_queue(no_vertex);
}

/// Flips queued faces until none can be flipped. Returns how many of the remaining ones are not locally Delaunay. When
/// v is inserted, only link faces, which are opposite v, may be flipped: flips within the star would get stuck.
std::size_t FlipInsertion::flip_queue(VertexIndex v) {
  std::vector<Candidate> waiting;
  for (bool progress = true; progress;) {
    progress = false;
    while (!queue_.empty()) {
      const Candidate q = queue_.back();
      queue_.pop_back();
      if (!is_current(q) || locally_delaunay(FaceRef(q.cell, q.face))) continue;
      if (!try_flip(FaceRef(q.cell, q.face))) {
        waiting.push_back(q);
        continue;
      }
      progress = true;
      ++flips_;
      for (const CellIndex c : made_)
        for (unsigned i = 0; i < 4; ++i)
          if (v == no_vertex || cells_[c].vertices[i] == v) queue_.push_back({c, cells_[c].vertices, i});
    }
    if (progress) queue_.swap(waiting);
  }
  std::size_t stuck = 0;
  for (const Candidate& q : waiting) stuck += is_current(q) && !locally_delaunay(FaceRef(q.cell, q.face));
  return stuck;
}

/// Returns whether face f is locally Delaunay: the apex on one side is not in conflict with the cell on the other. The
/// test is symmetric and uses a finite apex.
bool FlipInsertion::locally_delaunay(FaceRef f) {
  FaceRef outer = cells_[f.cell()].neighbors[f.face()];
  if (cells_[f.cell()].vertices[f.face()] == infinite_) std::swap(f, outer);
  const VertexIndex v = cells_[f.cell()].vertices[f.face()];
  if (v == infinite_) return true;
  const CellVertices& w = cells_[outer.cell()].vertices;
  return !(has_infinite(w) ? space_.ghost_conflict(w, space_.record(v)) : space_.finite_conflict(w, space_.record(v)));
}

bool FlipInsertion::flip_face(FaceRef f) {
  const CellIndex other = cells_[f.cell()].neighbors[f.face()].cell();
  return !((flags_[f.cell()] | flags_[other]) & ghost_flag) && try_flip(f);
}

bool FlipInsertion::try_flip(FaceRef f) {
  const FaceRef outer = cells_[f.cell()].neighbors[f.face()];
  return try_3_to_2(f, outer) || try_2_to_3(f, outer) || try_4_to_4(f, outer);
}

// Notation of the flips: v and d are the apexes of the two cells at face (a, b, c). Replacing one of a, b and c by d in
// the cell of v gives a cell on the new edge (v, d) with correct orientation.

/// Flips three cells around edge (a, b), those of v and d and one with the vertices v, d, a and b, into two.
bool FlipInsertion::try_3_to_2(FaceRef f, FaceRef outer) {
  const CellVertices w = cells_[f.cell()].vertices;
  const VertexIndex d = cells_[outer.cell()].vertices[outer.face()];
  for (unsigned k = 0; k < 4; ++k) {
    if (k == f.face()) continue;
    const CellIndex third = cells_[f.cell()].neighbors[k].cell();
    if (third != cells_[outer.cell()].neighbors[index_of(outer.cell(), w[k])].cell()) continue;
    if (third == f.cell() || third == outer.cell()) continue;
    old_ = {f.cell(), outer.cell(), third};
    new_.clear();
    for (unsigned j = 0; j < 4; ++j)
      if (j != k && j != f.face()) new_.push_back(substituted(w, w[j], d));
    if (!all_positive()) continue;
    replace();
    return true;
  }
  return false;
}

/// Returns whether a and b are connected by an edge. c is one of the cells at a.
bool FlipInsertion::adjacent(CellIndex c, VertexIndex a, VertexIndex b) {
  std::vector<CellIndex> star{c};
  bool found = false;
  flags_[c] |= cavity_flag;
  for (std::size_t k = 0; k < star.size(); ++k)
    for (unsigned i = 0; i < 4; ++i) {
      const CellVertices& v = cells_[star[k]].vertices;
      if (v[i] == b) found = true;
      const CellIndex n = cells_[star[k]].neighbors[i].cell();
      if (v[i] == a || (flags_[n] & cavity_flag)) continue;
      flags_[n] |= cavity_flag;
      star.push_back(n);
    }
  for (const CellIndex s : star) flags_[s] &= static_cast<std::uint8_t>(~cavity_flag);
  return found;
}

bool FlipInsertion::try_2_to_3(FaceRef f, FaceRef outer) {
  const CellVertices w = cells_[f.cell()].vertices;
  const VertexIndex d = cells_[outer.cell()].vertices[outer.face()];
  old_ = {f.cell(), outer.cell()};
  new_.clear();
  for (unsigned j = 0; j < 4; ++j)
    if (j != f.face()) new_.push_back(substituted(w, w[j], d));
  if (!all_positive()) return false;
  // Orientations of cells with the infinite vertex do not show whether the new edge of the flip exists already.
  const bool infinite = has_infinite(w) || d == infinite_;
  if (infinite && adjacent(f.cell(), w[f.face()], d)) return false;
  replace();
  return true;
}

/// Flips the four cells around edge (a, b) if v, a, d and b are coplanar and the other two cells have a common vertex.
bool FlipInsertion::try_4_to_4(FaceRef f, FaceRef outer) {
  const CellVertices w = cells_[f.cell()].vertices;
  const VertexIndex v = w[f.face()], d = cells_[outer.cell()].vertices[outer.face()];
  for (unsigned k = 0; k < 4; ++k) {
    if (k == f.face()) continue;
    const CellVertices flat = substituted(w, w[k], d);
    if (has_infinite(flat) || space_.orientation(space_.record(flat[0]), space_.record(flat[1]), space_.record(flat[2]),
                                                 space_.record(flat[3])) != Sign::zero)
      continue;
    const FaceRef side = cells_[f.cell()].neighbors[k];
    const FaceRef outer_side = cells_[outer.cell()].neighbors[index_of(outer.cell(), w[k])];
    if (side.cell() == outer_side.cell()) continue;
    if (cells_[side.cell()].vertices[side.face()] != cells_[outer_side.cell()].vertices[outer_side.face()]) continue;
    if (cells_[side.cell()].neighbors[index_of(side.cell(), v)].cell() != outer_side.cell()) continue;
    old_ = {f.cell(), outer.cell(), side.cell(), outer_side.cell()};
    new_.clear();
    for (unsigned j = 0; j < 4; ++j) {
      if (j == k || j == f.face()) continue;
      new_.push_back(substituted(w, w[j], d));
      new_.push_back(substituted(cells_[side.cell()].vertices, w[j], d));
    }
    if (!all_positive()) continue;
    replace();
    return true;
  }
  return false;
}

}  // namespace geomesh
