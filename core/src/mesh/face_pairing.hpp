// SPDX-License-Identifier: MIT
/// @file
/// Matches equal faces of a set of cells, so that new cells are linked with the cells around them and with each other.
#pragma once

#include <bit>
#include <vector>

#include "common/hash.hpp"
#include "geomesh/core/simplex_mesh.hpp"

namespace geomesh {

/// The vertices of a face in ascending order, packed so that comparing is cheap.
struct FaceKey {
  std::uint64_t low_and_middle = 0;
  VertexIndex high = 0;
  friend constexpr auto operator<=>(const FaceKey&, const FaceKey&) = default;
};

/// Returns the hash key of the face of a tetrahedron opposite its vertex i.
inline FaceKey face_key(const Tetrahedron& t, unsigned i) {
  const VertexIndex a = t[face_vertices[i][0]], b = t[face_vertices[i][1]], c = t[face_vertices[i][2]];
  const VertexIndex less = a < b ? a : b, more = a < b ? b : a;
  const VertexIndex low = less < c ? less : c, high = more < c ? c : more, rest = more < c ? more : c;
  const VertexIndex middle = less < rest ? rest : less;
  return {std::uint64_t{low} << 32 | middle, high};
}

/// Faces and their marks wait in this table for the face of a new cell that equals them. It is an open-addressing hash
/// table that is reused from one exchange to the next without being cleared. O(1) for each face.
template <class Mark>
class FacePairing {
 public:
  enum class Role : std::uint8_t {
    outer,   ///< face of a cell next to the replaced ones, or of no cell on the outside of the mesh
    inner,   ///< face between two removed cells; its mark waits for an equal new face
    added,   ///< face of a new cell for which no equal face has been found yet
    linked,  ///< face whose cell has been linked with the cell across it
  };
  struct Entry {
    FaceKey key;
    FaceRef face;
    Mark mark{};
    Role role = Role::inner;
    std::uint32_t epoch = 0;
  };

  /// Empties the table, and makes room for the at most `n_faces` faces of one exchange of cells.
  void begin(std::size_t n_faces) {
    const std::size_t size = std::bit_ceil(n_faces + 1);
    if (entries_.size() < size) entries_.assign(size, Entry{}), epoch_ = 0;
    if (++epoch_ == 0) {
      for (Entry& e : entries_) e.epoch = 0;
      epoch_ = 1;
    }
    mask_ = size - 1;
    n_outer_ = n_added_ = 0;
  }
  void await_outer(const FaceKey& key, FaceRef face, const Mark& mark) {
    Entry& e = at(key);
    GEOMESH_CHECK(e.epoch != epoch_);
    e = {key, face, mark, Role::outer, epoch_};
    n_outer_ += face.valid();
  }
  void await_inner(const FaceKey& key, const Mark& mark) {
    Entry& e = at(key);
    if (e.epoch != epoch_) e = {key, {}, mark, Role::inner, epoch_};
  }
  /// Adds a face of a new cell. If an equal face waits in the table, marks it as linked and returns it. Otherwise
  /// returns null, and the new face waits.
  const Entry* meet(const FaceKey& key, FaceRef face) {
    Entry& e = at(key);
    if (e.epoch != epoch_ || e.role == Role::inner) {
      e = {key, face, e.epoch == epoch_ ? e.mark : Mark{}, Role::added, epoch_};
      ++n_added_;
      return nullptr;
    }
    GEOMESH_CHECK(e.role != Role::linked);
    if (e.role == Role::added)
      --n_added_;
    else
      n_outer_ -= e.face.valid();
    met_ = e;
    e.role = Role::linked;
    return &met_;
  }
  /// Numbers of faces of kept cells (outer) and of new cells (added) for which no equal face has been found yet.
  std::size_t n_outer_waiting() const { return n_outer_; }
  std::size_t n_added_waiting() const { return n_added_; }

 private:
  Entry& at(const FaceKey& key) {
    std::size_t i = hash_of(std::array{key.low_and_middle, std::uint64_t{key.high}}) & mask_;
    while (entries_[i].epoch == epoch_ && entries_[i].key != key) i = (i + 1) & mask_;
    return entries_[i];
  }

  std::vector<Entry> entries_;  ///< hash table; entries of earlier exchanges (other epochs) count as free
  std::size_t mask_ = 0, n_outer_ = 0, n_added_ = 0;
  std::uint32_t epoch_ = 0;
  Entry met_;
};

}  // namespace geomesh
