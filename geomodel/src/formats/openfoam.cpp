// SPDX-License-Identifier: GPL-3.0-or-later
// Writes a mesh for OpenFOAM: a case folder NAME.foam with constant/polyMesh, text. Surfaces on the outer boundary
// become patches, inner surfaces face zones, and regions cell zones. A face of a face zone is marked as flipped if its
// normal does not point from the lower region id to the higher. Source: OpenFOAM user guide, "Mesh description".
#include <algorithm>

#include "formats/format_list.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/face_sides.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::size_t no_label = SIZE_MAX;

struct FoamFace {
  Triangle vertices;  ///< corners of the face; its normal points out of the owner cell
  /// Rows of the two cells beside the face; `neighbour` is no_neighbour if the face is on the mesh boundary.
  std::size_t owner, neighbour;
  std::size_t label = no_label;
  bool flipped = false;  ///< whether the normal of the face's surface points to the owner cell
};

/// All faces in OpenFOAM's order: inner faces by owner, then by neighbour; boundary faces by label, then by owner.
/// Inner faces are computed whenever they are needed, because all of them would take twice the memory of the mesh.
class FoamFaces {
 public:
  explicit FoamFaces(const SolverMesh& mesh) : tetrahedra_(mesh.source->tetrahedra) {
    std::size_t n_cells = 0;
    for (const CellBlock& block : mesh.blocks)
      if (block.shape == CellShape::tetrahedron && !block.rows.empty()) {
        pieces_.emplace_back(block.rows);
        first_cells_.push_back(n_cells);
        n_cells += block.rows.size();
      }
    across_ = tetrahedra_across(tetrahedra_, pieces_);
    find_labels(mesh);
    for_each_face([&](const Tetrahedron& v, std::size_t cell, unsigned i) {
      if (across_[cell][i] == no_neighbour)
        boundary_.push_back({face(v, cell, i).label, static_cast<std::uint32_t>(4 * cell + i)});
      else
        n_inner_ += across_[cell][i] > cell;
    });
    std::sort(boundary_.begin(), boundary_.end(), [](const OuterFace& a, const OuterFace& b) {
      return a.label != b.label ? a.label < b.label : a.code < b.code;
    });
  }
  std::size_t n_inner() const { return n_inner_; }
  std::size_t size() const { return n_inner_ + boundary_.size(); }
  template <class F>
  void for_each_outer(F&& f) const {
    for (const OuterFace& outer : boundary_) {
      const std::size_t cell = outer.code / 4;
      const auto piece = std::upper_bound(first_cells_.begin(), first_cells_.end(), cell) - first_cells_.begin() - 1;
      const auto at = static_cast<std::size_t>(piece);
      f(face(tetrahedra_[pieces_[at][cell - first_cells_[at]]], cell, outer.code % 4));
    }
  }

  template <class F>
  void for_each_inner(F&& f) const {
    // Neighbours of one cell that have higher numbers than this cell, each with the number (0 to 3) of the common face.
    std::array<std::pair<std::uint32_t, unsigned>, 4> later;
    std::size_t n = 0;
    for_each_face([&](const Tetrahedron& v, std::size_t cell, unsigned i) {
      const std::uint32_t other = across_[cell][i];
      if (other != no_neighbour && other > cell) {
        std::size_t at = n++;
        for (; at > 0 && later[at - 1].first > other; --at) later[at] = later[at - 1];
        later[at] = {other, i};
      }
      if (i < 3) return;
      for (std::size_t k = 0; k < n; ++k) f(face(v, cell, later[k].second));
      n = 0;
    });
  }
  template <class F>
  void for_each(F&& f) const {
    for_each_inner(f);
    for_each_outer(f);
  }

 private:
  struct OuterFace {
    std::size_t label;
    std::uint32_t code;  ///< number of the face: four times the cell plus 0 to 3; meshes have fewer than 2^30 cells
  };
  struct Label {
    std::uint32_t code, label : 31, flipped : 1;
  };
  /// Calls `f(vertices of the cell, cell, face)` for each of the four faces of each tetrahedron.
  template <class F>
  void for_each_face(F&& f) const {
    std::size_t cell = 0;
    for (const TetrahedronRows& piece : pieces_)
      for (const VertexIndex t : piece) {
        for (unsigned i = 0; i < 4; ++i) f(tetrahedra_[t], cell, i);
        ++cell;
      }
  }
  void find_labels(const SolverMesh& mesh) {
    for (std::size_t l = 0; l < mesh.labels.size(); ++l) {
      if (mesh.labels[l].dimension != 2) continue;
      for (const std::size_t b : mesh.labels[l].blocks)
        for (const auto& [minus, plus] : mesh.blocks[b].sides) {
          const bool flipped = plus.solid != no_cell && (minus.solid == no_cell || plus.solid < minus.solid);
          const FaceSide& owner = flipped ? plus : minus;
          if (owner.solid != no_cell)
            labels_.push_back({4 * owner.solid + owner.opposite, static_cast<std::uint32_t>(l), flipped});
        }
    }
    std::sort(labels_.begin(), labels_.end(), [](const Label& a, const Label& b) { return a.code < b.code; });
  }
  FoamFace face(const Tetrahedron& v, std::size_t cell, unsigned i) const {
    const auto& corner = face_vertices[i];
    const std::uint32_t other = across_[cell][i];
    FoamFace made{{v[corner[0]], v[corner[2]], v[corner[1]]}, cell, other};
    const auto code = static_cast<std::uint32_t>(4 * cell + i);
    const auto found = std::lower_bound(labels_.begin(), labels_.end(), code,
                                        [](const Label& a, std::uint32_t c) { return a.code < c; });
    if (found != labels_.end() && found->code == code) {
      made.label = found->label;
      made.flipped = found->flipped != 0;
    }
    return made;
  }

  const std::vector<Tetrahedron>& tetrahedra_;
  std::vector<TetrahedronRows> pieces_;
  std::vector<std::size_t> first_cells_;  // by piece
  std::vector<Neighbours> across_;
  std::vector<Label> labels_;  // surfaces of those mesh faces that lie on one, sorted by face number
  std::vector<OuterFace> boundary_;
  std::size_t n_inner_ = 0;
};

class FoamCase {
 public:
  FoamCase(const SolverMesh& mesh, std::filesystem::path folder)
      : mesh_(mesh), folder_(std::move(folder)), faces_(mesh) {
    SolverNames names(name_limit_plain);
    for (const CellGroup& label : mesh.labels) names_.push_back(names.give(label.full_name));
    unnamed_ = names.give("outer_boundary");
  }

  std::vector<std::filesystem::path> write(const ModelMesh& model) {
    const std::filesystem::path above = folder_.parent_path();
    if (!above.empty() && !std::filesystem::is_directory(above)) refuse_to_write(folder_);
    std::error_code mesh_failed, system_failed;
    std::filesystem::create_directories(folder_ / "constant" / "polyMesh", mesh_failed);
    std::filesystem::create_directories(folder_ / "system", system_failed);
    if (mesh_failed || system_failed) refuse_to_write(folder_);
    write_list("points", "vectorField", mesh_.n_nodes(), [&](OutputText& out) {
      for (std::size_t v = 0; v < mesh_.n_nodes(); ++v) out << "(" << mesh_.node(v) << ")\n";
    });
    write_list("faces", "faceList", faces_.size(), [&](OutputText& out) {
      faces_.for_each([&](const FoamFace& f) {
        out << "3(" << f.vertices[0] << " " << f.vertices[1] << " " << f.vertices[2] << ")\n";
      });
    });
    write_list("owner", "labelList", faces_.size(),
               [&](OutputText& out) { faces_.for_each([&](const FoamFace& f) { out << f.owner << "\n"; }); });
    write_list("neighbour", "labelList", faces_.n_inner(),
               [&](OutputText& out) { faces_.for_each_inner([&](const FoamFace& f) { out << f.neighbour << "\n"; }); });
    write_boundary();
    write_cell_zones();
    write_face_zones();
    write_control();
    written_.add(write_sidecar(model, sidecar_, folder_ / "mesh"));
    return written_.keep();
  }

 private:
  static void head(OutputText& out, const std::string& name, const char* type, const char* place) {
    out << "FoamFile\n{\n    version 2.0;\n    format ascii;\n    class " << type << ";\n    location \"" << place
        << "\";\n    object " << name << ";\n}\n\n";
  }
  template <class F>
  void write_file(const std::string& name, const char* type, F&& compose) {
    const std::filesystem::path file = folder_ / "constant" / "polyMesh" / name;
    write_output_text(file, [&](OutputText& out) {
      head(out, name, type, "constant/polyMesh");
      compose(out);
    });
    written_.add(file);
  }
  template <class F>
  void write_list(const std::string& name, const char* type, std::size_t n, F&& entries) {
    write_file(name, type, [&](OutputText& out) {
      out << n << "\n(\n";
      entries(out);
      out << ")\n";
    });
  }
  void note_group(const char* type, std::size_t label) {
    const CellGroup& group = mesh_.labels[label];
    sidecar_.push_back({type, group.dimension, 0, names_[label], group.full_name, group.members});
  }
  void write_boundary() {
    struct Patch {
      std::size_t label, first, n;
    };
    std::vector<Patch> patches;
    std::size_t row = faces_.n_inner();
    faces_.for_each_outer([&](const FoamFace& face) {
      if (patches.empty() || patches.back().label != face.label) patches.push_back({face.label, row, 0});
      ++patches.back().n;
      ++row;
    });
    write_file("boundary", "polyBoundaryMesh", [&](OutputText& out) {
      out << patches.size() << "\n(\n";
      for (const Patch& patch : patches)
        out << "    " << (patch.label == no_label ? unnamed_ : names_[patch.label])
            << "\n    {\n        type patch;\n        nFaces " << patch.n << ";\n        startFace " << patch.first
            << ";\n    }\n";
      out << ")\n";
    });
    for (const Patch& patch : patches)
      if (patch.label != no_label) note_group("patch", patch.label);
  }
  void write_cell_zones() {
    std::vector<std::size_t> regions, first;  // for each region: its row in mesh_.labels, and its first cell's number
    std::size_t cell = 0;
    for (std::size_t l = 0; l < mesh_.labels.size(); ++l) {
      if (mesh_.labels[l].dimension != 3) continue;
      regions.push_back(l);
      first.push_back(cell);
      for (const std::size_t b : mesh_.labels[l].blocks) cell += mesh_.blocks[b].n_cells();
    }
    first.push_back(cell);
    write_file("cellZones", "regIOobject", [&](OutputText& out) {
      out << regions.size() << "\n(\n";
      for (std::size_t r = 0; r < regions.size(); ++r) {
        out << names_[regions[r]] << "\n{\n    type cellZone;\n    cellLabels List<label>\n"
            << first[r + 1] - first[r] << "\n(\n";
        for (std::size_t c = first[r]; c < first[r + 1]; ++c) out << c << "\n";
        out << ");\n}\n";
      }
      out << ")\n";
    });
    for (const std::size_t l : regions) note_group("cellZone", l);
  }
  void write_face_zones() {
    struct ZoneFace {
      std::size_t row;
      bool flipped;
    };
    std::vector<std::vector<ZoneFace>> rows(mesh_.labels.size());
    std::size_t row = 0;
    faces_.for_each_inner([&](const FoamFace& face) {
      if (face.label != no_label) rows[face.label].push_back({row, face.flipped});
      ++row;
    });
    const auto n = std::count_if(rows.begin(), rows.end(), [](const auto& r) { return !r.empty(); });
    write_file("faceZones", "regIOobject", [&](OutputText& out) {
      out << n << "\n(\n";
      for (std::size_t l = 0; l < rows.size(); ++l) {
        if (rows[l].empty()) continue;
        out << names_[l] << "\n{\n    type faceZone;\n    faceLabels List<label>\n" << rows[l].size() << "\n(\n";
        for (const ZoneFace& f : rows[l]) out << f.row << "\n";
        out << ");\n    flipMap List<bool>\n" << rows[l].size() << "\n(\n";
        for (const ZoneFace& f : rows[l]) out << (f.flipped ? 1 : 0) << "\n";
        out << ");\n}\n";
      }
      out << ")\n";
    });
    for (std::size_t l = 0; l < rows.size(); ++l)
      if (!rows[l].empty()) note_group("faceZone", l);
  }
  /// Writes the control files without which no OpenFOAM tool opens the case, unless they exist already.
  void write_control() {
    const std::pair<const char*, const char*> files[] = {
        {"controlDict",
         "application none;\nstartFrom startTime;\nstartTime 0;\nstopAt endTime;\nendTime 1;\ndeltaT 1;\n"
         "writeControl timeStep;\nwriteInterval 1;\n"},
        {"fvSchemes", "ddtSchemes {}\ngradSchemes {}\ndivSchemes {}\nlaplacianSchemes {}\n"},
        {"fvSolution", ""}};
    for (const auto& [name, content] : files) {
      const std::filesystem::path file = folder_ / "system" / name;
      if (std::filesystem::exists(file)) continue;
      write_output_text(file, [&, &name = name, &content = content](OutputText& out) {
        head(out, name, "dictionary", "system");
        out << content;
      });
      written_.add(file);
    }
  }

  const SolverMesh& mesh_;
  std::filesystem::path folder_;
  FoamFaces faces_;
  std::vector<std::string> names_;  // by label
  std::string unnamed_;
  std::vector<SidecarGroup> sidecar_;
  WrittenFiles written_;
};

std::vector<std::filesystem::path> write_openfoam(const ModelMesh& model, const WriteOptions& options,
                                                  const std::filesystem::path& stem) {
  WriteOptions one_label = options;
  one_label.curves = false;
  // An OpenFOAM face is in only one patch.
  if (one_label.groups == GroupChoice::both) one_label.groups = GroupChoice::whole;
  const SolverMesh mesh = make_solver_mesh(model, one_label, TetrahedronNodes::by_rows);
  return FoamCase(mesh, stem.string() + ".foam").write(model);
}

}  // namespace

Format openfoam_format() { return {"openfoam", {".foam"}, "OpenFOAM polyMesh", {}, write_openfoam, nullptr}; }

}  // namespace geomesh::geomodel
