// SPDX-License-Identifier: MIT
#include "plc_reader.hpp"

#include <algorithm>
#include <cstring>
#include <fstream>
#include <map>
#include <sstream>
#include <stdexcept>

namespace geomesh::test {

namespace {

struct LexicographicLess {
  bool operator()(const Vec3& a, const Vec3& b) const {
    return a.x != b.x ? a.x < b.x : a.y != b.y ? a.y < b.y : a.z < b.z;
  }
};

class Builder {
 public:
  VertexIndex vertex(const Vec3& p) {
    const auto [it, is_new] = rows_.try_emplace(p, static_cast<VertexIndex>(plc.points.size()));
    if (is_new) plc.points.push_back(p);
    return it->second;
  }
  void triangle(VertexIndex a, VertexIndex b, VertexIndex c) {
    if (a != b && b != c && c != a) plc.add_triangle({a, b, c});
  }
  void polygon(const std::vector<VertexIndex>& v) {
    for (std::size_t i = 1; i + 1 < v.size(); ++i) triangle(v[0], v[i], v[i + 1]);
  }
  PiecewiseLinearComplex plc;

 private:
  std::map<Vec3, VertexIndex, LexicographicLess> rows_;
};

PiecewiseLinearComplex read_off(std::istream& in) {
  std::string word;
  std::size_t n_vertices = 0, n_faces = 0, n_edges = 0;
  in >> word >> n_vertices >> n_faces >> n_edges;
  Builder b;
  std::vector<VertexIndex> rows;
  for (std::size_t i = 0; i < n_vertices; ++i) {
    Vec3 p;
    in >> p.x >> p.y >> p.z;
    rows.push_back(b.vertex(p));
  }
  for (std::size_t i = 0; i < n_faces; ++i) {
    std::size_t n = 0;
    in >> n;
    std::vector<VertexIndex> v(n);
    for (auto& x : v) {
      in >> x;
      x = rows.at(x);
    }
    in.ignore(10000, '\n');
    b.polygon(v);
  }
  return b.plc;
}

PiecewiseLinearComplex read_obj(std::istream& in) {
  Builder b;
  std::vector<VertexIndex> rows;
  for (std::string line; std::getline(in, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vec3 p;
      words >> p.x >> p.y >> p.z;
      rows.push_back(b.vertex(p));
    } else if (kind == "f") {
      std::vector<VertexIndex> v;
      for (std::string corner; words >> corner;) v.push_back(rows.at(static_cast<std::size_t>(std::stol(corner)) - 1));
      b.polygon(v);
    }
  }
  return b.plc;
}

PiecewiseLinearComplex read_stl(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  std::string data((std::istreambuf_iterator<char>(in)), {});
  Builder b;
  std::uint32_t n = 0;
  if (data.size() >= 84) std::memcpy(&n, data.data() + 80, 4);
  if (data.size() == 84 + 50 * static_cast<std::size_t>(n)) {
    for (std::uint32_t i = 0; i < n; ++i) {
      float f[12];
      std::memcpy(f, data.data() + 84 + 50 * static_cast<std::size_t>(i), sizeof f);
      b.triangle(b.vertex({f[3], f[4], f[5]}), b.vertex({f[6], f[7], f[8]}), b.vertex({f[9], f[10], f[11]}));
    }
    return b.plc;
  }
  std::istringstream words(data);
  std::vector<VertexIndex> corners;
  for (std::string word; words >> word;) {
    if (word != "vertex") continue;
    Vec3 p;
    words >> p.x >> p.y >> p.z;
    corners.push_back(b.vertex(p));
    if (corners.size() < 3) continue;
    b.triangle(corners[0], corners[1], corners[2]);
    corners.clear();
  }
  return b.plc;
}

PiecewiseLinearComplex read_ply(std::istream& in) {
  std::size_t n_vertices = 0, n_faces = 0, n_properties = 0;
  bool in_vertex = false;
  for (std::string line; std::getline(in, line) && line.rfind("end_header", 0) != 0;) {
    std::istringstream words(line);
    std::string a, kind;
    words >> a >> kind;
    if (a == "format" && kind != "ascii") throw std::runtime_error("binary PLY is not read in tests");
    if (a == "element") {
      in_vertex = kind == "vertex";
      words >> (in_vertex ? n_vertices : n_faces);
    }
    if (a == "property" && in_vertex) ++n_properties;
  }
  Builder b;
  std::vector<VertexIndex> rows;
  for (std::size_t i = 0; i < n_vertices; ++i) {
    std::vector<double> v(n_properties);
    for (double& x : v) in >> x;
    rows.push_back(b.vertex({v[0], v[1], v[2]}));
  }
  for (std::size_t i = 0; i < n_faces; ++i) {
    std::size_t n = 0;
    in >> n;
    std::vector<VertexIndex> v(n);
    for (auto& x : v) {
      in >> x;
      x = rows.at(x);
    }
    in.ignore(10000, '\n');
    b.polygon(v);
  }
  return b.plc;
}

/// Lines without comments and blanks.
class PolyLines {
 public:
  explicit PolyLines(std::istream& in) : in_(in) {}
  std::istringstream next() {
    for (std::string line; std::getline(in_, line);) {
      line = line.substr(0, line.find('#'));
      if (line.find_first_not_of(" \t\r") != std::string::npos) return std::istringstream(line);
    }
    return {};
  }

 private:
  std::istream& in_;
};

void read_poly_facet(PolyLines& lines, PiecewiseLinearComplex& plc, const std::map<long, VertexIndex>& rows) {
  std::size_t n_polygons = 0, n_holes = 0;
  auto header = lines.next();
  header >> n_polygons >> n_holes;
  std::vector<std::vector<VertexIndex>> loops;
  std::vector<std::array<VertexIndex, 2>> segments;
  for (std::size_t p = 0; p < n_polygons; ++p) {
    auto line = lines.next();
    std::size_t n = 0;
    line >> n;
    std::vector<VertexIndex> loop;
    for (long id = 0; loop.size() < n;) {
      while (!(line >> id)) line = lines.next();
      loop.push_back(rows.at(id));
    }
    if (n == 2) {
      segments.push_back({loop[0], loop[1]});
    } else {
      loops.push_back(loop);
    }
  }
  for (std::size_t h = 0; h < n_holes; ++h) lines.next();
  if (loops.size() > 1 && n_holes != loops.size() - 1)
    throw std::runtime_error("inner loops that are no holes are not read in tests");
  const Index facet = plc.add_polygon(loops);
  for (const auto& s : segments) plc.facet_segments.push_back({facet, s[0], s[1]});
}

PiecewiseLinearComplex read_poly(std::istream& in) {
  PolyLines lines(in);
  PiecewiseLinearComplex plc;
  std::map<long, VertexIndex> rows;
  std::size_t n_points = 0, n_facets = 0, n_holes = 0, n_regions = 0;
  lines.next() >> n_points;
  for (std::size_t i = 0; i < n_points; ++i) {
    long id = 0;
    Vec3 p;
    lines.next() >> id >> p.x >> p.y >> p.z;
    rows[id] = static_cast<VertexIndex>(plc.points.size());
    plc.points.push_back(p);
  }
  lines.next() >> n_facets;
  for (std::size_t i = 0; i < n_facets; ++i) read_poly_facet(lines, plc, rows);
  lines.next() >> n_holes;
  for (std::size_t i = 0; i < n_holes; ++i) {
    long id = 0;
    PiecewiseLinearComplex::Seed seed;
    lines.next() >> id >> seed.point.x >> seed.point.y >> seed.point.z;
    plc.hole_seeds.push_back(seed);
  }
  lines.next() >> n_regions;
  for (std::size_t i = 0; i < n_regions; ++i) {
    long id = 0;
    double attribute = 0;
    PiecewiseLinearComplex::Seed seed;
    lines.next() >> id >> seed.point.x >> seed.point.y >> seed.point.z >> attribute;
    seed.id = static_cast<Index>(attribute);
    plc.region_seeds.push_back(seed);
  }
  return plc;
}

}  // namespace

PiecewiseLinearComplex read_plc(const std::string& path) {
  std::string extension = path.substr(path.rfind('.') + 1);
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](char c) { return static_cast<char>(std::tolower(c)); });
  std::ifstream in(path);
  if (!in) throw std::runtime_error("cannot open " + path);
  if (extension == "off") return read_off(in);
  if (extension == "obj") return read_obj(in);
  if (extension == "stl") return read_stl(path);
  if (extension == "ply") return read_ply(in);
  if (extension == "poly") return read_poly(in);
  throw std::runtime_error("no test reader for " + path);
}

}  // namespace geomesh::test
