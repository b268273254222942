// SPDX-License-Identifier: GPL-3.0-or-later
// Reads DXF in text form: 3DFACE, polyface and polygon meshes (POLYLINE with VERTEX), LINE, POLYLINE, LWPOLYLINE,
// POINT, and blocks of these (INSERT). Each layer becomes one surface. Ignored entities are reported. $INSUNITS is
// reported but not applied, because templates contain arbitrary values.
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>

#include "readers/cad/dxf_content.hpp"
#include "readers/formats.hpp"
#include "readers/text/text.hpp"
#include "readers/triangles/merge_points.hpp"
#include "readers/triangles/polygon.hpp"

namespace geomesh::geomodel {
namespace {

struct Pair {
  int code = -1;
  std::string_view value;
  std::size_t line = 0;
};

struct Entity {
  std::string_view name;
  std::size_t line = 0;
  std::vector<Pair> pairs;
};

class PairReader {
 public:
  explicit PairReader(const InputFile& file) : lines_(file) {}
  /// Reads the next pair of group code and value of a DXF file. Returns false if the file ends between two pairs.
  bool next(Pair& pair) {
    if (!lines_.next()) return false;
    const auto code = to_integer(trim(lines_.line()));
    if (!code || *code < -10 || *code > 1100)
      lines_.fail("expected a group code of DXF, found " + in_quotes(lines_.line()));
    pair.code = static_cast<int>(*code);
    if (!lines_.next())
      lines_.fail("the file ends where the value of group " + std::to_string(pair.code) + " was expected (truncated)");
    pair.value = trim(lines_.line());
    pair.line = lines_.number();
    return true;
  }
  const LineReader& lines() const { return lines_; }

 private:
  LineReader lines_;
};

class DxfReader {
 public:
  explicit DxfReader(const InputFile& file) : file_(file), pairs_(file) {}

  FileContents read() {
    Pair pair;
    std::string_view section;
    bool section_named = true, ended = false;
    while (!ended && pairs_.next(pair)) {
      if (pair.code == 999) continue;
      if (!section_named && pair.code == 2) {
        section = pair.value;
        section_named = true;
      } else if (pair.code == 0) {
        finish_entity();
        if (pair.value == "SECTION") section_named = false;
        if (pair.value == "ENDSEC") section = {};
        ended = pair.value == "EOF";
        in_entity_ = (section == "ENTITIES" || section == "BLOCKS") && pair.value != "SECTION";
        entity_ = {pair.value, pair.line, {}};
      } else if (in_entity_) {
        entity_.pairs.push_back(pair);
      } else if (section == "HEADER") {
        header_pair(pair);
      }
    }
    if (!ended) file_.fail("the file ends without EOF (truncated)");
    if (polyline_open_) file_.fail("a POLYLINE has no SEQEND (truncated)");
    return finish();
  }

 private:
  void header_pair(const Pair& pair) {
    if (pair.code == 9) variable_ = pair.value;
    if (pair.code == 70 && variable_ == "$INSUNITS") units_ = static_cast<int>(to_integer(pair.value).value_or(0));
  }

  double number(const Pair& pair) const {
    const auto value = to_double(pair.value);
    if (!value || !std::isfinite(*value))
      file_.fail(pair.line, "expected a finite coordinate, found " + in_quotes(pair.value));
    return *value;
  }
  double real(int code, double without) const {
    for (const Pair& p : entity_.pairs)
      if (p.code == code) return number(p);
    return without;
  }
  std::string name_of_block() const {
    for (const Pair& p : entity_.pairs)
      if (p.code == 2) return std::string(p.value);
    return "";
  }
  std::int64_t integer(int code, std::int64_t without) const {
    for (const Pair& p : entity_.pairs)
      if (p.code == code) return to_integer(p.value).value_or(without);
    return without;
  }
  std::string layer() const {
    for (const Pair& p : entity_.pairs)
      if (p.code == 8 && !p.value.empty()) return std::string(p.value);
    return "0";
  }
  /// Returns the point in the DXF groups 10 + k, 20 + k, 30 + k; z is 0 if it is not given.
  Vec3 point(int k) const {
    Vec3 p;
    bool has_x = false, has_y = false;
    for (const Pair& pair : entity_.pairs) {
      if (pair.code == 10 + k) p.x = number(pair), has_x = true;
      if (pair.code == 20 + k) p.y = number(pair), has_y = true;
      if (pair.code == 30 + k) p.z = number(pair);
    }
    if (!has_x || !has_y)
      file_.fail(entity_.line, std::string(entity_.name) + " lacks coordinates (groups " + std::to_string(10 + k) +
                                   " and " + std::to_string(20 + k) + ")");
    return p;
  }

  void add_triangle(const std::string& layer, const Vec3& a, const Vec3& b, const Vec3& c) {
    if (a == b || b == c || a == c) return;
    std::vector<Vec3>& corners = target_->corners[layer];
    corners.insert(corners.end(), {a, b, c});
  }
  void add_quadrilateral(const std::string& layer, const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
    add_triangle(layer, a, b, c);
    add_triangle(layer, a, c, d);
  }
  void add_line(const std::string& layer, std::vector<Vec3> points, bool closed) {
    if (closed && points.size() > 2) points.push_back(points.front());
    points.erase(std::unique(points.begin(), points.end()), points.end());
    if (points.size() < 2) return;
    target_->lines.emplace_back(layer, std::move(points));
  }

  void finish_entity() {
    if (!in_entity_) return;
    const std::string_view name = entity_.name;
    if (polyline_open_ && name != "VERTEX" && name != "SEQEND")
      file_.fail(entity_.line, "expected VERTEX or SEQEND within a POLYLINE, found " + in_quotes(name));
    if (name == "3DFACE") {
      const bool has_fourth = integer(13, -1) != -1 || std::any_of(entity_.pairs.begin(), entity_.pairs.end(),
                                                                   [](const Pair& p) { return p.code == 13; });
      const Vec3 c = point(2);
      add_quadrilateral(layer(), point(0), point(1), c, has_fourth ? point(3) : c);
    } else if (name == "LINE") {
      add_line(layer(), {point(0), point(1)}, false);
    } else if (name == "LWPOLYLINE") {
      light_polyline();
    } else if (name == "POINT") {
      target_->points[layer()].push_back(point(0));
    } else if (name == "POLYLINE") {
      open_polyline();
    } else if (name == "VERTEX") {
      vertex();
    } else if (name == "SEQEND") {
      if (polyline_open_) close_polyline();
    } else if (name == "INSERT") {
      insert();
    } else if (name == "BLOCK") {
      DxfBlock& block = blocks_[name_of_block()];
      block.base = {real(10, 0), real(20, 0), real(30, 0)};
      target_ = &block.content;
    } else if (name == "ENDBLK") {
      target_ = &content_;
    } else if (name != "ENDSEC" && name != "SECTION") {
      ++target_->passed_over[std::string(name)];
    }
  }

  void insert() {
    DxfInsert insert{name_of_block(),
                     layer(),
                     entity_.line,
                     point(0),
                     {real(41, 1), real(42, 1), real(43, 1)},
                     real(50, 0) * std::numbers::pi / 180};
    insert.n_columns = std::max<std::int64_t>(1, integer(70, 1));
    insert.n_rows = std::max<std::int64_t>(1, integer(71, 1));
    insert.column_step = real(44, 0);
    insert.row_step = real(45, 0);
    const bool is_upright = real(210, 0) == 0 && real(220, 0) == 0 && real(230, 1) > 0;
    if (!is_upright) {
      ++target_->passed_over["INSERT turned out of the plane"];
    } else {
      target_->inserts.push_back(std::move(insert));
    }
  }

  void light_polyline() {
    std::vector<Vec3> points;
    double z = 0;
    for (const Pair& p : entity_.pairs) {
      if (p.code == 38) z = number(p);
      if (p.code == 10) points.push_back({number(p), 0, 0});
      if (p.code == 20 && !points.empty()) points.back().y = number(p);
    }
    for (Vec3& p : points) p.z = z;
    add_line(layer(), std::move(points), (integer(70, 0) & 1) != 0);
  }

  void open_polyline() {
    polyline_open_ = true;
    flags_ = integer(70, 0);
    m_ = integer(71, 0);
    n_ = integer(72, 0);
    polyline_layer_ = layer();
    polyline_line_ = entity_.line;
    vertices_.clear();
    faces_.clear();
  }

  void vertex() {
    if (!polyline_open_) file_.fail(entity_.line, "a VERTEX stands outside a POLYLINE");
    const std::int64_t flags = integer(70, 0);
    if ((flags_ & 64) && (flags & 128) && !(flags & 64)) {
      faces_.push_back({integer(71, 0), integer(72, 0), integer(73, 0), integer(74, 0)});
    } else {
      vertices_.push_back(point(0));
    }
  }

  const Vec3& face_corner(std::int64_t index) const {
    const auto i = index < 0 ? 0 - static_cast<std::uint64_t>(index) : static_cast<std::uint64_t>(index);
    if (i == 0 || i > vertices_.size()) {
      file_.fail(polyline_line_, "a face of this POLYLINE names vertex " + std::to_string(index) + ", but there are " +
                                     std::to_string(vertices_.size()));
    }
    return vertices_[i - 1];
  }

  void close_polyline() {
    polyline_open_ = false;
    if (flags_ & 64) {
      for (const auto& f : faces_) {
        if (f[2] == 0) continue;  // an edge
        const Vec3& c = face_corner(f[2]);
        add_quadrilateral(polyline_layer_, face_corner(f[0]), face_corner(f[1]), c, f[3] == 0 ? c : face_corner(f[3]));
      }
    } else if (flags_ & 16) {
      close_mesh();
    } else {
      add_line(polyline_layer_, vertices_, (flags_ & 1) != 0);
    }
  }

  /// Converts a DXF polygon mesh of M rows of N vertices to triangles. Flags 1 and 32 close it along M or N.
  void close_mesh() {
    const auto size = static_cast<std::int64_t>(vertices_.size());
    if (m_ < 2 || n_ < 2 || m_ > size || n_ > size || m_ * n_ != size) {
      file_.fail(polyline_line_, "a mesh of " + std::to_string(m_) + " by " + std::to_string(n_) + " vertices has " +
                                     std::to_string(size) + " of them");
    }
    const std::int64_t m_cells = flags_ & 1 ? m_ : m_ - 1, n_cells = flags_ & 32 ? n_ : n_ - 1;
    const auto at = [&](std::int64_t i, std::int64_t j) {
      return vertices_[static_cast<std::size_t>((i % m_) * n_ + j % n_)];
    };
    for (std::int64_t i = 0; i < m_cells; ++i)
      for (std::int64_t j = 0; j < n_cells; ++j)
        add_quadrilateral(polyline_layer_, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
  }

  FileContents finish() {
    insert_blocks(file_, content_, blocks_);
    FileContents contents;
    contents.format = "DXF";
    for (const auto& [name, corners] : content_.corners) {
      if (corners.empty()) continue;
      TriangulatedSurface surface;
      surface.name = name;
      surface.file = file_.shown();
      const std::vector<VertexIndex> row = merge_equal_points(corners, surface.points);
      for (std::size_t i = 0; i + 2 < row.size(); i += 3) surface.triangles.push_back({row[i], row[i + 1], row[i + 2]});
      contents.surfaces.push_back(std::move(surface));
    }
    std::map<std::string, std::size_t> n_lines;
    for (auto& [layer, points] : content_.lines)
      contents.polylines.push_back({layer + "__" + std::to_string(++n_lines[layer]), file_.shown(), std::move(points)});
    for (auto& [name, points] : content_.points)
      contents.point_sets.push_back({name, file_.shown(), std::move(points)});
    if (contents.surfaces.empty() && contents.polylines.empty() && contents.point_sets.empty()) {
      file_.fail("the surface is empty: no 3DFACE, mesh, line or point stands in the section ENTITIES");
    }
    for (const auto& [name, n] : content_.passed_over)
      contents.warnings.push_back(std::to_string(n) + " " + name + " passed over");
    static constexpr const char* unit_names[] = {"",       "inches",    "feet", "miles", "millimetres", "centimetres",
                                                 "metres", "kilometres"};
    if (units_ > 0 && units_ < 8) {
      contents.notes.push_back(std::string("$INSUNITS says ") + unit_names[units_] +
                               "; it is not applied, as templates fill it in at random: give `unit` in the project "
                               "where coordinates are not metres");
    }
    return contents;
  }

  const InputFile& file_;
  PairReader pairs_;
  Entity entity_;
  bool in_entity_ = false, polyline_open_ = false;
  std::int64_t flags_ = 0, m_ = 0, n_ = 0;
  std::string polyline_layer_;
  std::size_t polyline_line_ = 0;
  std::vector<Vec3> vertices_;
  std::vector<std::array<std::int64_t, 4>> faces_;
  DxfContent content_;  ///< of ENTITIES
  std::map<std::string, DxfBlock> blocks_;
  DxfContent* target_ = &content_;
  std::string_view variable_;
  int units_ = 0;
};

}  // namespace

bool is_dxf(const InputFile& file) {
  if (file.text().starts_with("AutoCAD Binary DXF")) return true;
  LineReader lines(file);
  for (int n = 0; n < 200 && lines.next(); n += 2) {
    const std::string_view code = trim(lines.line());
    if (!lines.next()) return false;
    if (code == "999") continue;
    return code == "0" && trim(lines.line()) == "SECTION";
  }
  return false;
}

FileContents read_dxf(const InputFile& file) {
  if (file.text().starts_with("AutoCAD Binary DXF"))
    file.fail("a binary DXF file is not read; save it as text (ASCII) DXF");
  return DxfReader(file).read();
}

}  // namespace geomesh::geomodel
