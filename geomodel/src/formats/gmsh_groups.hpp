// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Code shared by both versions of Gmsh's format: shapes, groups, and numbers as text or binary data.
#pragma once

#include <cstdint>
#include <vector>

#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/text_file.hpp"

namespace geomesh::geomodel {

enum class Encoding { text, binary };

/// Writes the numbers of a section of a Gmsh file: in text separated by blanks, in binary as in memory (little endian).
class GmshNumbers {
 public:
  GmshNumbers(OutputText& out, Encoding encoding) : out_(out), binary_(encoding == Encoding::binary) {}
  void integer(std::int32_t value) { put(value); }
  void size(std::size_t value) { put(static_cast<std::uint64_t>(value)); }
  void real(double value) { put(value); }
  void real(const Vec3& p) {
    real(p.x);
    real(p.y);
    real(p.z);
  }
  /// Ends a line in Gmsh text files; writes nothing in binary files.
  void line() {
    if (!binary_) out_ << "\n";
    at_start_ = true;
  }

 private:
  template <class T>
  void put(T value) {
    if (binary_) {
      out_.raw(value);
      return;
    }
    if (!at_start_) out_ << " ";
    at_start_ = false;
    out_ << value;
  }
  OutputText& out_;
  bool binary_, at_start_ = true;
};

struct GmshPhysical {
  int dimension;
  std::int32_t tag;
  std::string name;
};

/// The physical groups of a Gmsh file. `of_block` lists the tags of the groups of each block of cells: one tag, unless
/// both whole groups and pieces are requested.
struct GmshGroups {
  std::vector<GmshPhysical> physicals;
  std::vector<std::vector<std::int32_t>> of_block;
  std::vector<SidecarGroup> sidecar;
};
GmshGroups gmsh_groups(const SolverMesh& mesh, const WriteOptions& options);

int gmsh_type(const SolverMesh& mesh, CellShape shape);
/// Returns node `i` of a cell in Gmsh's order: compared with VTK's, a tetrahedron's last two midpoints are exchanged.
std::size_t gmsh_node(const CellBlock& block, std::size_t i);

/// Writes the arrays of a mesh: cell arrays as $ElementData (with NaN for elements that are not tetrahedra, because a
/// widely used reader expects a value for each) and point arrays as $NodeData. `blocks` are rows in the order of the
/// file, repeated as often as their cells are written; elements are numbered from 1.
void write_gmsh_fields(OutputText& out, Encoding encoding, const SolverMesh& mesh,
                       const std::vector<std::size_t>& blocks);

/// Writes the sections of a Gmsh file before its nodes, which are text in every version.
void write_gmsh_head(OutputText& out, const char* version, Encoding encoding, const GmshGroups& groups);

}  // namespace geomesh::geomodel
