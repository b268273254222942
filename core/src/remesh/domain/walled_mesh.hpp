// SPDX-License-Identifier: MIT
/// @file
/// Fast insertion of many points into the interior of a DomainMesh.
#pragma once

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "common/epoch_marks.hpp"
#include "delaunay/kernels/lane_kernels.hpp"
#include "remesh/domain/domain_mesh.hpp"

namespace geomesh::remesh {

/// Most cells that insertion creates are soon replaced by further insertions, so only their vertices, neighbours and
/// components are written at once. Shapes, tags and the cells of vertices are written at the end.
///
/// As long as this object is open, each constrained face is a wall: behind it is a ghost cell, which belongs to that
/// side of the face alone. Cavities end at ghosts, so the kernels of the Delaunay base can grow them. All ghosts share
/// one vertex without a position, which remains in the mesh as a removed vertex.
class WalledMesh {
 public:
  /// Opens the mesh, which must outlive this object and must not be used for anything else but its points and
  /// components until `close` is called. No trial may be running. O(n).
  explicit WalledMesh(DomainMesh& mesh);
  WalledMesh(const WalledMesh&) = delete;
  WalledMesh& operator=(const WalledMesh&) = delete;
  /// Restores the mesh with all of its attributes. Must be called once, unless an exception is under way. O(n).
  void close(unsigned threads);

  CellIndex n_slots() const { return cells_.n_slots(); }
  std::size_t n_cells() const { return cells_.n_live() - ghosts_.size(); }
  /// Returns whether the slot has a cell that is no ghost.
  bool is_cell(CellIndex c) const { return cells_.is_live(c) && !(cells_.flags(c) & ghost); }
  const Tetrahedron& vertices(CellIndex c) const { return cells_.vertices(c); }
  bool is_wall(CellIndex c, unsigned face) const { return cells_.flags(beyond(c, face)) & ghost; }
  /// Returns the cell on the other side of a face that is not constrained.
  CellIndex beyond(CellIndex c, unsigned face) const { return cells_.neighbor_cell(c, face); }
  /// Returns a two-bit number that the caller stores for the cell; 0 for new cells. May be set concurrently by cell.
  unsigned note(CellIndex c) const { return cells_.flags(c) >> note_shift & 3u; }
  void set_note(CellIndex c, unsigned note) {
    std::uint8_t& flags = cells_.flags(c);
    flags = static_cast<std::uint8_t>((flags & ~(3u << note_shift)) | note << note_shift);
  }

  /// Finds the cell that contains p by a walk from `start`. Returns nothing if it meets a constrained face or is long.
  std::optional<CellIndex> locate(const Vec3& p, CellIndex start) const;
  /// Inserts p, which is in the cell `home`, by a constrained Delaunay cavity (Bowyer 1981, Watson 1981), reduced until
  /// p sees its whole border. Returns nothing if a vertex of the cavity is nearer than `spacing`, or if a vertex or an
  /// edge of a curve would be inside the cavity. All decisions about the mesh are exact.
  std::optional<VertexIndex> insert(const Vec3& p, CellIndex home, double spacing);
  /// Returns the vertices of the link of the vertex that was inserted last.
  std::span<const VertexIndex> link() const { return numbered_; }

 private:
  static constexpr std::uint8_t in_cavity = 1, ghost = 2, is_new = 4;
  static constexpr unsigned note_shift = 3;
  static constexpr unsigned table_side = 64;  ///< number of border vertices above which cells are linked by sorting

  /// A ghost cell, the tag of the constrained face next to it, and the ghost on the other side of this face, if any.
  struct Ghost {
    CellIndex cell;
    FaceTag tag;
    CellIndex opposite = no_cell;
  };
  struct Host;

  void add_ghosts();
  bool grow(const Vec3& p, CellIndex home);
  bool sees(const Vec3& p, const std::array<VertexIndex, 3>& face) const;
  bool sees_border(const Vec3& p) const;
  bool shrink(const Vec3& p, CellIndex home);
  void collect_border(const Vec3& p);
  void number_border();
  bool swallows() const;
  bool is_on_border(VertexIndex a, VertexIndex b) const;
  void fill(VertexIndex v);
  bool is_across(const TetMesh::Cell& cell, unsigned j, FaceRef across) const;
  void connect_by_table();
  void connect_by_sorting();
  void leave_cavity();

  DomainMesh& mesh_;
  TetMesh& cells_;
  VertexIndex infinite_;
  std::vector<PointRecord> records_;  ///< data of each vertex; the member `place` is 1 if the vertex is on a curve
  std::vector<Ghost> ghosts_;

  // Cells and border faces of the cavity: only the first n_cavity_ and n_border_ entries of these equally long lists.
  std::vector<CellIndex> cavity_ = std::vector<CellIndex>(256);
  std::vector<CavityFace<3>> border_ = std::vector<CavityFace<3>>(256);
  std::size_t n_cavity_ = 0, n_border_ = 0;
  double nearest_ = 0;  ///< squared distance from the new point to the nearest vertex of the cavity
  std::vector<VertexIndex> numbered_;
  std::vector<std::array<std::uint16_t, 3>> number_;  ///< vertices of each border face, as numbers within the cavity
  std::array<FaceRef, std::size_t{table_side} * table_side> table_;
  EpochMarks marks_;
  std::vector<CellIndex> kept_;
};

}  // namespace geomesh::remesh
