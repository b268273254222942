// SPDX-License-Identifier: GPL-3.0-or-later
// Writes Medit files, for remeshers such as mmg and refine: NAME.mesh (text, version 2) with NAME.sol, or NAME.meshb
// (binary, version 3) with NAME.solb. References are region, surface and curve ids; names are in a JSON file beside the
// mesh. The solution is a size at each node, the mean length of its edges, so that a remesher keeps the sizes that the
// mesh has. Source: "The Gamma Mesh Format" (libMeshb 7), and the reader of meshio.
#include <cmath>

#include "formats/codes/each_cell.hpp"
#include "formats/format_list.hpp"
#include "geomesh/core/simplex_mesh.hpp"
#include "solver_mesh/sidecar.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// Medit's keywords by dimension, with their numbers in libMeshb.
struct Keyword {
  const char* name;
  std::int32_t code;
};
constexpr Keyword vertices{"Vertices", 4}, corners{"Corners", 13}, sol_at_vertices{"SolAtVertices", 62};
constexpr std::array<Keyword, 4> cells_of_dimension{{{"", 0}, {"Edges", 5}, {"Triangles", 6}, {"Tetrahedra", 8}}};

/// The text form of a Medit file: the numbers of a row are separated by blanks.
class TextForm {
 public:
  explicit TextForm(OutputText& out) : out_(out) { out_ << "MeshVersionFormatted 2\nDimension 3\n"; }
  void begin(const Keyword& keyword, std::size_t n, std::size_t) { out_ << "\n" << keyword.name << "\n" << n << "\n"; }
  void sol_types() { out_ << "1 1\n"; }
  void real(double value) { put(value); }
  void integer(std::int32_t value) { put(value); }
  void end_row() {
    out_ << "\n";
    is_first_ = true;
  }
  void finish() { out_ << "\nEnd\n"; }

 private:
  template <class T>
  void put(T value) {
    if (!is_first_) out_ << " ";
    out_ << value;
    is_first_ = false;
  }
  OutputText& out_;
  bool is_first_ = true;
};

/// The binary form of a Medit file, version 3: doubles, 32-bit numbers, and 64-bit positions of the next keyword.
class BinaryForm {
 public:
  explicit BinaryForm(OutputText& out) : out_(out) {
    constexpr std::int32_t one = 1, version = 3, dimension_code = 3, dimension = 3;
    out_.raw(one).raw(version).raw(dimension_code);
    at_ = 2 * sizeof one + head_bytes;
    out_.raw(static_cast<std::int64_t>(at_)).raw(dimension);
  }
  void begin(const Keyword& keyword, std::size_t n, std::size_t row_bytes) {
    at_ += head_bytes + n * row_bytes + (keyword.code == sol_at_vertices.code ? 2 * sizeof(std::int32_t) : 0);
    out_.raw(keyword.code).raw(static_cast<std::int64_t>(at_)).raw(static_cast<std::int32_t>(n));
  }
  void sol_types() { out_.raw(std::int32_t{1}).raw(std::int32_t{1}); }
  void real(double value) { out_.raw(value); }
  void integer(std::int32_t value) { out_.raw(value); }
  void end_row() {}
  void finish() {
    constexpr std::int32_t end_code = 54;
    out_.raw(end_code).raw(std::int64_t{0});
  }

 private:
  /// Bytes before the data of a keyword in a binary Medit file: its code, the next keyword's position, and a count.
  static constexpr std::size_t head_bytes = 2 * sizeof(std::int32_t) + sizeof(std::int64_t);
  OutputText& out_;
  std::size_t at_ = 0;
};

std::int32_t number_of(VertexIndex v) { return static_cast<std::int32_t>(v + 1); }

/// Writes Medit nodes. Named points get their ids as references, and are marked corners because remeshers keep those.
template <class Form>
void write_nodes(Form& form, const SolverMesh& mesh) {
  std::vector<std::int32_t> reference(mesh.n_nodes(), 0);
  std::vector<VertexIndex> named;
  for_each_cell(mesh, 0, [&](const CellGroup& label, const CellBlock&, std::size_t, auto nodes) {
    if (reference[nodes[0]] == 0) named.push_back(nodes[0]);
    reference[nodes[0]] = label.id;
  });
  form.begin(vertices, mesh.n_nodes(), 3 * sizeof(double) + sizeof(std::int32_t));
  for (std::size_t v = 0; v < mesh.n_nodes(); ++v) {
    for (std::size_t k = 0; k < 3; ++k) form.real(mesh.node(v)[k]);
    form.integer(reference[v]);
    form.end_row();
  }
  if (named.empty()) return;
  form.begin(corners, named.size(), sizeof(std::int32_t));
  for (const VertexIndex v : named) {
    form.integer(number_of(v));
    form.end_row();
  }
}

template <class Form>
void write_mesh(OutputText& out, const SolverMesh& mesh) {
  Form form(out);
  write_nodes(form, mesh);
  for (const int dimension : {3, 2, 1}) {
    if (mesh.count(dimension) == 0) continue;
    form.begin(cells_of_dimension[static_cast<std::size_t>(dimension)], mesh.count(dimension),
               (static_cast<std::size_t>(dimension) + 2) * sizeof(std::int32_t));
    for_each_cell(mesh, dimension, [&](const CellGroup& label, const CellBlock&, std::size_t, auto nodes) {
      for (const VertexIndex v : nodes) form.integer(number_of(v));
      form.integer(label.id);
      form.end_row();
    });
  }
  form.finish();
}

/// Returns the mean length of the edges at each node. An edge counts once for each tetrahedron that has it.
std::vector<double> mean_lengths(const ModelMesh& mesh) {
  std::vector<double> sum(mesh.points.size(), 0);
  std::vector<std::size_t> n(mesh.points.size(), 0);
  for (const Tetrahedron& t : mesh.tetrahedra)
    for (const auto& [i, j] : edge_vertices) {
      const Vec3 edge = mesh.points[t[i]] - mesh.points[t[j]];
      const double length = std::sqrt(dot(edge, edge));
      for (const VertexIndex v : {t[i], t[j]}) sum[v] += length, ++n[v];
    }
  for (std::size_t v = 0; v < sum.size(); ++v) sum[v] /= static_cast<double>(n[v]);
  return sum;
}

template <class Form>
void write_sizes(OutputText& out, const std::vector<double>& sizes) {
  Form form(out);
  form.begin(sol_at_vertices, sizes.size(), sizeof(double));
  form.sol_types();
  for (const double size : sizes) {
    form.real(size);
    form.end_row();
  }
  form.finish();
}

template <class Form>
std::vector<std::filesystem::path> write_files(const ModelMesh& model, const WriteOptions& options,
                                               const std::filesystem::path& file,
                                               const std::filesystem::path& solution) {
  const SolverMesh mesh = make_solver_mesh(model, with_one_number(options));
  WrittenFiles written;
  write_output_text(file, [&](OutputText& out) { write_mesh<Form>(out, mesh); });
  written.add(file);
  write_output_text(solution, [&](OutputText& out) { write_sizes<Form>(out, mean_lengths(model)); });
  written.add(solution);
  std::vector<SidecarGroup> sidecar;
  for (const CellGroup& label : mesh.labels)
    sidecar.push_back({"reference", label.dimension, label.id, label.full_name, label.full_name, label.members});
  written.add(write_sidecar(model, sidecar, file));
  return written.keep();
}

std::vector<std::filesystem::path> write_text(const ModelMesh& model, const WriteOptions& options,
                                              const std::filesystem::path& stem) {
  return write_files<TextForm>(model, options, stem.string() + ".mesh", stem.string() + ".sol");
}

std::vector<std::filesystem::path> write_binary(const ModelMesh& model, const WriteOptions& options,
                                                const std::filesystem::path& stem) {
  return write_files<BinaryForm>(model, options, stem.string() + ".meshb", stem.string() + ".solb");
}

}  // namespace

Format medit_format() {
  return {"medit", {".mesh"}, "Medit (mmg, refine)", {.curves = true, .names = false}, write_text, nullptr};
}

Format medit_binary_format() {
  return {"medit-binary", {".meshb"}, "Medit, binary", {.curves = true, .names = false}, write_binary, nullptr};
}

}  // namespace geomesh::geomodel
