// SPDX-License-Identifier: GPL-3.0-or-later
// OpenFOAM: a case folder NAME.foam with constant/polyMesh, text. Surfaces on the outer boundary are patches, inner
// ones face zones, regions cell zones. A face of a zone is flipped where its normal does not point from the lower
// region id to the higher. Followed: OpenFOAM user guide, "Mesh description".
#include <algorithm>

#include "formats/format_list.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "geomesh/geomodel/writers.hpp"
#include "solver_mesh/names.hpp"
#include "solver_mesh/sidecar.hpp"
#include "solver_mesh/solver_mesh.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

constexpr std::size_t no_label = SIZE_MAX;

struct FoamFace {
  Triangle vertices;  ///< its normal points out of the owner
  std::size_t owner, neighbour;
  std::size_t label = no_label;
  bool flipped = false;  ///< the surface's normal points to the owner
};

struct CellFace {
  Triangle sorted, vertices;
  std::size_t cell;
};

Triangle sorted(Triangle t) {
  std::sort(t.begin(), t.end());
  return t;
}

/// Every face of every cell, equal ones next to each other, the lower cell first.
std::vector<CellFace> faces_of_cells(const SolverMesh& mesh) {
  std::vector<CellFace> all;
  std::size_t cell = 0;
  for (const CellBlock& block : mesh.blocks) {
    if (block.shape != CellShape::tetrahedron) continue;
    for (std::size_t c = 0; c < block.n_cells(); ++c, ++cell)
      for (std::size_t i = 0; i < 4; ++i) {
        const auto v = [&](std::size_t k) { return block.nodes[4 * c + face_vertices[i][k]]; };
        const Triangle outward{v(0), v(2), v(1)};
        all.push_back({sorted(outward), outward, cell});
      }
  }
  std::sort(all.begin(), all.end(), [](const CellFace& a, const CellFace& b) {
    return a.sorted != b.sorted ? a.sorted < b.sorted : a.cell < b.cell;
  });
  return all;
}

/// Inner faces in OpenFOAM's order (owner, then neighbour), then those of the boundary by label and owner.
std::vector<FoamFace> foam_faces(const SolverMesh& mesh) {
  const std::vector<CellFace> all = faces_of_cells(mesh);
  std::vector<FoamFace> faces;
  std::vector<Triangle> keys;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const bool inner = i + 1 < all.size() && all[i + 1].sorted == all[i].sorted;
    faces.push_back({all[i].vertices, all[i].cell, inner ? all[i + 1].cell : no_cell});
    keys.push_back(all[i].sorted);
    if (inner) ++i;
  }
  for (std::size_t l = 0; l < mesh.labels.size(); ++l) {
    if (mesh.labels[l].dimension != 2) continue;
    for (const std::size_t b : mesh.labels[l].blocks) {
      const CellBlock& block = mesh.blocks[b];
      for (std::size_t c = 0; c < block.n_cells(); ++c) {
        const Triangle key = sorted({block.nodes[3 * c], block.nodes[3 * c + 1], block.nodes[3 * c + 2]});
        const auto found = std::lower_bound(keys.begin(), keys.end(), key);
        if (found == keys.end() || *found != key) continue;
        FoamFace& face = faces[static_cast<std::size_t>(found - keys.begin())];
        face.label = l;
        face.flipped = block.sides[c][1].solid == face.owner;
      }
    }
  }
  std::sort(faces.begin(), faces.end(), [](const FoamFace& a, const FoamFace& b) {
    const bool a_inner = a.neighbour != no_cell, b_inner = b.neighbour != no_cell;
    if (a_inner != b_inner) return a_inner;
    if (!a_inner && a.label != b.label) return a.label < b.label;
    if (a.owner != b.owner) return a.owner < b.owner;
    return a.neighbour != b.neighbour ? a.neighbour < b.neighbour : a.vertices < b.vertices;
  });
  return faces;
}

class FoamCase {
 public:
  FoamCase(const SolverMesh& mesh, std::filesystem::path folder)
      : mesh_(mesh), folder_(std::move(folder)), faces_(foam_faces(mesh)) {
    n_inner_ = static_cast<std::size_t>(
        std::count_if(faces_.begin(), faces_.end(), [](const FoamFace& f) { return f.neighbour != no_cell; }));
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
    write_list("points", "vectorField", mesh_.n_nodes(),
               [&](OutputText& out, std::size_t v) { out << "(" << mesh_.node(v) << ")"; });
    write_list("faces", "faceList", faces_.size(), [&](OutputText& out, std::size_t f) {
      const Triangle& v = faces_[f].vertices;
      out << "3(" << v[0] << " " << v[1] << " " << v[2] << ")";
    });
    write_list("owner", "labelList", faces_.size(), [&](OutputText& out, std::size_t f) { out << faces_[f].owner; });
    write_list("neighbour", "labelList", n_inner_, [&](OutputText& out, std::size_t f) { out << faces_[f].neighbour; });
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
  void write_list(const std::string& name, const char* type, std::size_t n, F&& entry) {
    write_file(name, type, [&](OutputText& out) {
      out << n << "\n(\n";
      for (std::size_t i = 0; i < n; ++i) {
        entry(out, i);
        out << "\n";
      }
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
    for (std::size_t f = n_inner_; f < faces_.size(); ++f) {
      if (patches.empty() || patches.back().label != faces_[f].label) patches.push_back({faces_[f].label, f, 0});
      ++patches.back().n;
    }
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
    std::vector<std::size_t> regions, first;  // labels, with the number of their first cell
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
    std::vector<std::vector<std::size_t>> rows(mesh_.labels.size());
    for (std::size_t f = 0; f < n_inner_; ++f)
      if (faces_[f].label != no_label) rows[faces_[f].label].push_back(f);
    const auto n = std::count_if(rows.begin(), rows.end(), [](const auto& r) { return !r.empty(); });
    write_file("faceZones", "regIOobject", [&](OutputText& out) {
      out << n << "\n(\n";
      for (std::size_t l = 0; l < rows.size(); ++l) {
        if (rows[l].empty()) continue;
        out << names_[l] << "\n{\n    type faceZone;\n    faceLabels List<label>\n" << rows[l].size() << "\n(\n";
        for (const std::size_t f : rows[l]) out << f << "\n";
        out << ");\n    flipMap List<bool>\n" << rows[l].size() << "\n(\n";
        for (const std::size_t f : rows[l]) out << (faces_[f].flipped ? 1 : 0) << "\n";
        out << ");\n}\n";
      }
      out << ")\n";
    });
    for (std::size_t l = 0; l < rows.size(); ++l)
      if (!rows[l].empty()) note_group("faceZone", l);
  }
  /// Without them no tool of OpenFOAM opens the case. Those of a case that is there already stay.
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
      write_output_text(file, [&](OutputText& out) {
        head(out, name, "dictionary", "system");
        out << content;
      });
      written_.add(file);
    }
  }

  const SolverMesh& mesh_;
  std::filesystem::path folder_;
  std::vector<FoamFace> faces_;
  std::size_t n_inner_ = 0;
  std::vector<std::string> names_;  // by label
  std::string unnamed_;
  std::vector<SidecarGroup> sidecar_;
  WrittenFiles written_;
};

std::vector<std::filesystem::path> write(const ModelMesh& model, const WriteOptions& options,
                                         const std::filesystem::path& stem) {
  WriteOptions one_label = options;
  one_label.curves = false;
  if (one_label.groups == GroupChoice::both) one_label.groups = GroupChoice::whole;  // a face is in one patch
  const SolverMesh mesh = make_solver_mesh(model, one_label);
  return FoamCase(mesh, stem.string() + ".foam").write(model);
}

}  // namespace

Format openfoam_format() { return {"openfoam", {".foam"}, "OpenFOAM polyMesh", {}, write, nullptr}; }

}  // namespace geomesh::geomodel
