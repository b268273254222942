// SPDX-License-Identifier: GPL-3.0-or-later
#include <sys/resource.h>
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <map>
#include <set>
#include <sstream>
#include <tuple>

#include "geomesh/core/tetrahedralize.hpp"
#include "quality_runs.hpp"
#include "test_places.hpp"

namespace geomesh::bench {
namespace {

double children_cpu() {
  rusage u{};
  getrusage(RUSAGE_CHILDREN, &u);
  return static_cast<double>(u.ru_utime.tv_sec + u.ru_stime.tv_sec) +
         1e-6 * static_cast<double>(u.ru_utime.tv_usec + u.ru_stime.tv_usec);
}

/// Runs the command with its output in STEM.log; what went wrong, in words.
std::string run(const std::string& command, const std::string& stem, double limit_s, double& cpu_s) {
  const double before = children_cpu();
  const std::string limited = "ulimit -t " + std::to_string(static_cast<long>(limit_s)) + "; exec " + command;
  const int status = std::system(("timeout -s KILL " + std::to_string(static_cast<long>(10 * limit_s)) + " sh -c '" +
                                  limited + "' > " + stem + ".log 2>&1")
                                     .c_str());
  cpu_s = children_cpu() - before;
  const int code = WIFEXITED(status) ? WEXITSTATUS(status) : 128;
  if (cpu_s >= 0.95 * limit_s) return "exceeds " + std::to_string(static_cast<long>(limit_s)) + " s";
  if (code == 0) return "";
  return code > 128 ? "dies of signal " + std::to_string(code - 128) : "status " + std::to_string(code);
}

bool log_has(const std::string& stem, const std::string& words) {
  std::ifstream log(stem + ".log");
  std::ostringstream text;
  text << log.rdbuf();
  return text.str().find(words) != std::string::npos;
}

struct PlainMesh {
  std::vector<Vec3> points;
  std::vector<Tetrahedron> cells;
};

void measure_into(Row& row, PlainMesh mesh) {
  for (Tetrahedron& t : mesh.cells) {
    const auto& p = mesh.points;
    if (dot(cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]), p[t[3]] - p[t[0]]) < 0) std::swap(t[2], t[3]);
  }
  const ShapeStatistics s = measure_shapes(mesh.points, mesh.cells);
  row.tetrahedra = s.n_tetrahedra;
  row.shapes = shapes_of(s);
}

/// A facet's marker is its row, so that TetGen merges none. A polygon with holes goes out in triangles under its one
/// marker.
void write_poly(const PiecewiseLinearComplex& plc, const std::string& path) {
  const bool has_holes = plc.loop_offsets.size() - 1 > plc.n_facets();
  const ConstrainedTetrahedralization mesh = has_holes ? tetrahedralize(plc) : ConstrainedTetrahedralization{};
  std::vector<Vec3> points = plc.points;
  std::map<VertexIndex, VertexIndex> added;  // points of `mesh` that are not in the PLC
  std::vector<std::pair<Index, std::vector<std::vector<VertexIndex>>>> facets;  // marker, polygons and inner segments
  const auto row_of = [&](VertexIndex v) {
    if (mesh.input_vertex[v] != no_vertex) return mesh.input_vertex[v];
    const auto [it, is_new] = added.try_emplace(v, static_cast<VertexIndex>(points.size()));
    if (is_new) points.push_back(mesh.points[v]);
    return it->second;
  };
  std::vector<std::vector<std::vector<VertexIndex>>> inner(plc.n_facets());
  for (const auto& s : plc.facet_segments) inner[s.facet].push_back({s.a, s.b});
  for (Index f = 0; f < plc.n_facets(); ++f) {
    if (plc.n_loops(f) > 1) continue;
    inner[f].emplace(inner[f].begin(), plc.outer_loop(f).begin(), plc.outer_loop(f).end());
    facets.push_back({f, std::move(inner[f])});
  }
  for (const auto& face : mesh.faces)
    if (plc.n_loops(face.facet) > 1)
      facets.push_back({face.facet, {{row_of(face.vertices[0]), row_of(face.vertices[1]), row_of(face.vertices[2])}}});
  std::ofstream out(path);
  out.precision(17);
  out << points.size() << " 3 0 0\n";
  for (std::size_t v = 0; v < points.size(); ++v)
    out << v << ' ' << points[v].x << ' ' << points[v].y << ' ' << points[v].z << '\n';
  out << facets.size() << " 1\n";
  for (const auto& [facet, polygons] : facets) {
    out << polygons.size() << " 0 " << facet + 1 << '\n';
    for (const auto& vertices : polygons) {
      out << vertices.size();
      for (const VertexIndex v : vertices) out << ' ' << v;
      out << '\n';
    }
  }
  out << "0\n0\n";
}

PlainMesh read_tetgen(const std::string& stem) {
  PlainMesh mesh;
  std::size_t n = 0;
  long skip = 0, attributes = 0, markers = 0;
  std::ifstream nodes(stem + ".1.node"), elements(stem + ".1.ele");
  for (nodes >> n >> skip >> attributes >> markers; nodes && mesh.points.size() < n;) {
    Vec3 p;
    nodes >> skip >> p.x >> p.y >> p.z;
    for (long k = 0; k < attributes + markers; ++k) nodes >> skip;
    mesh.points.push_back(p);
  }
  n = 0;
  for (elements >> n >> skip >> attributes; elements && mesh.cells.size() < n;) {
    Tetrahedron t{};
    elements >> skip >> t[0] >> t[1] >> t[2] >> t[3];
    for (long k = 0; k < attributes; ++k) elements >> skip;
    mesh.cells.push_back(t);
  }
  return mesh;
}

/// A part of a surface between two components (no_index: outside), in triangles.
using PartKey = std::tuple<Index, Index, Index>;  ///< provenance, component, component; the lesser first

std::map<PartKey, std::vector<Triangle>> surface_parts(const QualityModel& model,
                                                       const ConstrainedTetrahedralization& mesh) {
  std::map<PartKey, std::vector<Triangle>> parts;
  for (const auto& face : mesh.faces) {
    const auto component = [&](Index t) { return t == no_index ? no_index : mesh.component[t]; };
    const Index a = component(face.tetrahedron_below), b = component(face.tetrahedron_above);
    parts[{model.plc.facet_provenance[face.facet], std::min(a, b), std::max(a, b)}].push_back(face.vertices);
  }
  return parts;
}

/// STEM.surface.msh (format 2.2: nodes, and triangles by part) and STEM.geo.
void write_gmsh(const QualityModel& model, const std::string& stem) {
  const ConstrainedTetrahedralization mesh = tetrahedralize(model.plc);
  const auto parts = surface_parts(model, mesh);
  std::map<VertexIndex, std::size_t> node;
  std::size_t n_triangles = 0;
  for (const auto& [key, triangles] : parts) {
    n_triangles += triangles.size();
    for (const Triangle& t : triangles)
      for (const VertexIndex v : t) node.try_emplace(v, node.size() + 1);
  }
  std::ofstream msh(stem + ".surface.msh"), geo(stem + ".geo");
  msh.precision(17);
  msh << "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n" << node.size() << '\n';
  for (const auto& [v, id] : node)
    msh << id << ' ' << mesh.points[v].x << ' ' << mesh.points[v].y << ' ' << mesh.points[v].z << '\n';
  msh << "$EndNodes\n$Elements\n" << n_triangles << '\n';
  std::map<Index, std::vector<std::size_t>> bounding, embedded;
  std::size_t part = 0, element = 0;
  for (const auto& [key, triangles] : parts) {
    const auto [provenance, a, b] = key;
    ++part;
    for (const Triangle& t : triangles)
      msh << ++element << " 2 2 0 " << part << ' ' << node[t[0]] << ' ' << node[t[1]] << ' ' << node[t[2]] << '\n';
    if (a == b) {
      embedded[a].push_back(part);
      continue;
    }
    for (const Index c : {a, b})
      if (c != no_index) bounding[c].push_back(part);
  }
  msh << "$EndElements\n";
  geo << "Mesh.SaveAll = 1;\nMerge \"" << stem << ".surface.msh\";\n";
  const auto list = [](const std::vector<std::size_t>& parts_of) {
    std::string text;
    for (const std::size_t p : parts_of) text += (text.empty() ? "" : ", ") + std::to_string(p);
    return text;
  };
  for (const auto& [c, parts_of] : bounding)
    geo << "Surface Loop(" << c + 1 << ") = {" << list(parts_of) << "};\nVolume(" << c + 1 << ") = {" << c + 1
        << "};\n";
  for (const auto& [c, parts_of] : embedded) geo << "Surface {" << list(parts_of) << "} In Volume {" << c + 1 << "};\n";
}

/// STEM.surface: what netgen_peer.py reads. Volumes count from 1.
void write_netgen(const QualityModel& model, const std::string& stem) {
  const ConstrainedTetrahedralization mesh = tetrahedralize(model.plc);
  std::map<VertexIndex, std::size_t> row;
  for (const auto& face : mesh.faces)
    for (const VertexIndex v : face.vertices) row.try_emplace(v, 0);
  std::ofstream out(stem + ".surface");
  out.precision(17);
  out << row.size() << ' ' << mesh.faces.size() << '\n';
  std::size_t n = 0;
  for (auto& [v, id] : row) {
    id = n++;
    out << mesh.points[v].x << ' ' << mesh.points[v].y << ' ' << mesh.points[v].z << '\n';
  }
  const auto volume = [&](Index t) { return t == no_index ? 0 : mesh.component[t] + 1; };
  for (const auto& face : mesh.faces) {
    for (const VertexIndex v : face.vertices) out << row[v] << ' ';
    out << volume(face.tetrahedron_below) << ' ' << volume(face.tetrahedron_above) << '\n';
  }
}

PlainMesh read_gmsh(const std::string& path) {
  PlainMesh mesh;
  std::map<long, VertexIndex> row;
  std::ifstream in(path);
  std::string word;
  std::size_t n = 0;
  while (in >> word) {
    if (word == "$Nodes")
      for (in >> n; in && n > 0; --n) {
        long id = 0;
        Vec3 p;
        in >> id >> p.x >> p.y >> p.z;
        row[id] = static_cast<VertexIndex>(mesh.points.size());
        mesh.points.push_back(p);
      }
    if (word == "$Elements")
      for (in >> n; in && n > 0; --n) {
        long id = 0, type = 0, tags = 0;
        for (in >> id >> type >> tags; tags > 0; --tags) in >> id;
        const std::size_t corners = type == 4 ? 4 : type == 2 ? 3 : type == 1 ? 2 : 1;
        Tetrahedron t{};
        for (std::size_t k = 0; k < corners; ++k) in >> id, t[k] = row[id];
        if (type == 4) mesh.cells.push_back(t);
      }
  }
  return mesh;
}

}  // namespace

Row run_tetgen(const QualityModel& model, const std::string& stem, double limit_s) {
  write_poly(model.plc, stem + ".poly");
  for (const char* end : {".1.node", ".1.ele"}) std::remove((stem + end).c_str());
  Row row{"tetgen -pq1.414", 0, {}, 0};
  const std::string failure = run("tetgen -pq1.414 " + stem + ".poly", stem, limit_s, row.cpu_s);
  if (!failure.empty()) row.tool += ": " + failure;
  measure_into(row, read_tetgen(stem));
  return row;
}

Row run_netgen(const QualityModel& model, const std::string& stem, double limit_s) {
  write_netgen(model, stem);
  for (const char* end : {".1.node", ".1.ele"}) std::remove((stem + end).c_str());
  Row row{"netgen", 0, {}, 0};
  const std::string script = std::string(GEOMESH_SOURCE_DIR) + "/tests/bench/netgen_peer.py ";
  const std::string failure = run("/usr/bin/python3 " + script + stem, stem, limit_s, row.cpu_s);
  if (!failure.empty()) row.tool += log_has(stem, "No module named") ? ": not installed" : ": " + failure;
  measure_into(row, read_tetgen(stem));
  return row;
}

Row run_gmsh(const QualityModel& model, const std::string& stem, double limit_s) {
  write_gmsh(model, stem);
  std::remove((stem + ".msh").c_str());
  Row row{"gmsh -optimize_netgen", 0, {}, 0};
  const std::string failure =
      run("gmsh -3 -optimize_netgen -format msh2 " + stem + ".geo -o " + stem + ".msh", stem, limit_s, row.cpu_s);
  const bool without_netgen = log_has(stem, "Netgen optimizer is not compiled in");
  if (without_netgen) row.tool = "gmsh -optimize (Netgen not compiled in)";
  measure_into(row, read_gmsh(stem + ".msh"));
  const char* const refusal = "Could not recover boundary mesh";
  if (row.tetrahedra == 0)
    row.tool += std::string(": ") + (log_has(stem, refusal) ? refusal
                                     : failure.empty()      ? "no tetrahedra"
                                                            : failure.c_str());
  return row;
}

}  // namespace geomesh::bench
