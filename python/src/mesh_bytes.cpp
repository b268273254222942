// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_bytes.hpp"

#include <concepts>
#include <cstring>
#include <type_traits>

#include "geomesh/core/error.hpp"

namespace geomesh::python {
namespace {

using namespace geomodel;

template <class T, class Plain>
concept Like = std::same_as<std::remove_const_t<T>, Plain>;

// Lists the members of each type once, for encoding and decoding: `archive(...)` writes constants, reads into others.
template <class A, Like<Region> T>
void visit(A& archive, T& r) {
  archive(r.id, r.name, r.inside, r.n_tetrahedra, r.volume, r.unit, r.volume_of_input);
}
template <class A, Like<RegionAttribute> T>
void visit(A& archive, T& a) {
  archive(a.name, a.by_region);
}
template <class A, Like<CellArray> T>
void visit(A& archive, T& a) {
  archive(a.name, a.values, a.unit);
}
template <class A, Like<geomodel::PointArray> T>
void visit(A& archive, T& a) {
  archive(a.name, a.values, a.unit);
}
template <class A, Like<RegionGroup> T>
void visit(A& archive, T& g) {
  archive(g.name, g.regions);
}
template <class A, Like<NamedSurface> T>
void visit(A& archive, T& s) {
  archive(s.id, s.name, s.kind, s.area);
}
template <class A, Like<NamedCurve> T>
void visit(A& archive, T& c) {
  archive(c.id, c.name, c.kind, c.length);
}
template <class A, Like<ModelMesh::MarkedPoint> T>
void visit(A& archive, T& p) {
  archive(p.v, p.id, p.name);
}
template <class A, Like<CohesiveLayer> T>
void visit(A& archive, T& l) {
  archive(l.id, l.name);
}
template <class A, Like<NodeSet> T>
void visit(A& archive, T& s) {
  archive(s.id, s.name, s.nodes);
}
template <class A, Like<CurvedEdge> T>
void visit(A& archive, T& e) {
  archive(e.a, e.b, e.middle, e.values);
}
template <class A, Like<Midpoints> T>
void visit(A& archive, T& m) {
  archive(m.points, m.of_tetrahedron, m.of_face, m.of_curve_edge);
}
template <class A, Like<ModelMesh> T>
void visit(A& archive, T& m) {
  archive(m.name, m.points, m.point_kind, m.input_vertex, m.tetrahedra, m.tet_region, m.faces, m.surface_sets);
  archive(m.curve_edges, m.marked_points, m.regions, m.attributes, m.cell_arrays, m.point_arrays, m.groups, m.surfaces);
  archive(m.curves, m.node_sets, m.prisms, m.cohesive_layers, m.midpoints, m.curved_edges, m.before_zones, m.origin);
  archive(m.unit);
}
template <class A, Like<std::filesystem::path> T>
void visit(A& archive, T& path) {
  if constexpr (std::is_const_v<T>) {
    const std::string text = path.string();
    archive(text);
  } else {
    std::string text;
    archive(text);
    path = text;
  }
}
template <class A, Like<JobResult> T>
void visit(A& archive, T& r) {
  archive(r.files, r.warnings, r.summary, r.details, r.mesh, r.report_json);
}

class Writer {
 public:
  template <class... T>
  void operator()(const T&... values) {
    (put(values), ...);
  }
  std::string take() { return std::move(bytes_); }

 private:
  void raw(const void* data, std::size_t n) { bytes_.append(static_cast<const char*>(data), n); }
  template <class T>
  void put(const T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      raw(&value, sizeof value);
    else
      visit(*this, value);
  }
  void put(const std::string& text) {
    put(text.size());
    raw(text.data(), text.size());
  }
  template <class T>
  void put(const std::vector<T>& list) {
    put(list.size());
    if constexpr (std::is_trivially_copyable_v<T>) {
      if (!list.empty()) raw(list.data(), list.size() * sizeof(T));
    } else {
      for (const T& value : list) put(value);
    }
  }
  std::string bytes_;
};

class Reader {
 public:
  explicit Reader(std::string_view bytes) : rest_(bytes) {}
  template <class... T>
  void operator()(T&... values) {
    (get(values), ...);
  }
  bool is_at_end() const { return rest_.empty(); }

 private:
  [[noreturn]] static void refuse() {
    throw Error(ErrorKind::usage, "the pickled mesh is damaged: bytes are missing; pickle it again");
  }
  void raw(void* data, std::size_t n) {
    if (n > rest_.size()) refuse();
    std::memcpy(data, rest_.data(), n);
    rest_.remove_prefix(n);
  }
  template <class T>
  void get(T& value) {
    if constexpr (std::is_trivially_copyable_v<T>)
      raw(&value, sizeof value);
    else
      visit(*this, value);
  }
  /// Reads a count of items that take at least a byte each; data are damaged if it exceeds the number of bytes.
  std::size_t count() {
    std::size_t n = 0;
    get(n);
    if (n > rest_.size()) refuse();
    return n;
  }
  void get(std::string& text) {
    text.resize(count());
    raw(text.data(), text.size());
  }
  template <class T>
  void get(std::vector<T>& list) {
    list.resize(count());
    if constexpr (std::is_trivially_copyable_v<T>) {
      if (!list.empty()) raw(list.data(), list.size() * sizeof(T));
    } else {
      for (T& value : list) get(value);
    }
  }
  std::string_view rest_;
};

/// Mark at the beginning of the bytes of an encoded mesh. It must be changed whenever the encoded members change;
/// together with the version it shows whether the bytes can be read.
const std::string mark = std::string("geomesh mesh 1, ") + GEOMESH_VERSION;

}  // namespace

std::string bytes_of(const JobResult& result) {
  Writer writer;
  writer(mark, result);
  return writer.take();
}

JobResult result_of(std::string_view bytes) {
  Reader reader(bytes);
  std::string found;
  reader(found);
  if (found != mark)
    throw Error(ErrorKind::usage, "the mesh was pickled by another version of geomesh ('" + found + "', this is '" +
                                      mark + "'); keep meshes in files such as .vtu, which every version reads");
  JobResult result;
  reader(result);
  if (!reader.is_at_end()) throw Error(ErrorKind::usage, "the pickled mesh is damaged: there are bytes behind its end");
  return result;
}

}  // namespace geomesh::python
