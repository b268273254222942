// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/gocad/gocad_objects.hpp"

#include <algorithm>

#include "readers/text/units.hpp"

namespace geomesh::geomodel {
namespace {

/// Parses one GOCAD object. Each line begins with a keyword; unknown ones (properties, drawing styles) are ignored.
class ObjectParser {
 public:
  ObjectParser(LineReader& lines, std::string_view kind) : lines_(lines), ids_(lines.file().size() / 4 + 1024) {
    object_.kind = kind;
    object_.line = lines.number();
  }

  GocadObject parse() {
    while (lines_.next()) {
      Tokens tokens(lines_.line());
      const std::string_view keyword = tokens.next();
      if (keyword == "END") {
        finish();
        return std::move(object_);
      }
      if (keyword == "GOCAD")
        lines_.fail("a new object begins before the END of '" + object_.name + "' (line " + at_line() + ")");
      if (!keyword.empty() && keyword.front() != '#') line(keyword, tokens);
    }
    lines_.fail("the file ends within the object '" + object_.name + "' (begun on line " + at_line() +
                "): its END is missing, the file is truncated");
  }

 private:
  std::string at_line() const { return std::to_string(object_.line); }

  void line(std::string_view keyword, Tokens& tokens) {
    if (keyword == "VRTX" || keyword == "PVRTX" || keyword == "TRGL") {
      geometry_line(keyword, tokens);
    } else if (keyword == "HEADER" || keyword.starts_with("HEADER{")) {
      header();
    } else if (keyword == "PROPERTIES") {
      while (!tokens.at_end()) object_.properties.emplace_back(tokens.next_quoted());
    } else if (keyword == "GOCAD_ORIGINAL_COORDINATE_SYSTEM") {
      coordinate_system();
    } else if (keyword == "PROPERTY_CLASS_HEADER" || lines_.line().find('{') != std::string_view::npos) {
      skip_block();
    } else {
      geometry_line(keyword, tokens);
    }
  }

  void geometry_line(std::string_view keyword, Tokens& tokens) {
    if (object_.kind == "TSurf") {
      surface_line(keyword, tokens);
    } else if (object_.kind == "PLine") {
      polyline_line(keyword, tokens);
    } else if (object_.kind == "VSet") {
      if (keyword == "VRTX" || keyword == "PVRTX") vertex(tokens);
    } else if (object_.kind == "Well") {
      well_line(keyword, tokens);
    } else if (object_.kind == "Model3d") {
      model_line(keyword, tokens);
    }
  }

  void header() {
    std::string_view text = lines_.line();
    const std::size_t open = text.find('{');
    text = open == std::string_view::npos ? std::string_view{} : text.substr(open + 1);
    bool opened = open != std::string_view::npos;
    for (;;) {
      const std::size_t close = text.find('}');
      header_entry(text.substr(0, close));
      if (close != std::string_view::npos) return;
      if (!lines_.next()) lines_.fail("the file ends within HEADER { ... } (truncated)");
      text = lines_.line();
      if (!opened && !trim(text).empty()) {
        if (trim(text).front() != '{') lines_.fail("expected '{' behind HEADER");
        opened = true;
        text = text.substr(text.find('{') + 1);
      }
    }
  }

  void header_entry(std::string_view text) {
    text = trim(text);
    const std::size_t colon = text.find(':');
    if (colon == std::string_view::npos || trim(text.substr(0, colon)) != "name") return;
    Tokens value(text.substr(colon + 1));
    const std::string_view whole = value.rest();
    object_.name = whole.starts_with('"') ? value.next_quoted() : whole;
  }

  void skip_block() {
    const std::size_t first = lines_.number();
    while (lines_.line().find('}') == std::string_view::npos) {
      if (!lines_.next()) lines_.fail("the file ends within the block { ... } begun on line " + std::to_string(first));
    }
  }

  void coordinate_system() {
    GocadFrame& frame = object_.frame;
    frame.given = true;
    const std::size_t first = lines_.number();
    while (lines_.next()) {
      Tokens tokens(lines_.line());
      const std::string_view key = tokens.next();
      if (key == "END_ORIGINAL_COORDINATE_SYSTEM") return;
      if (key == "NAME") frame.name = tokens.next_quoted();
      if (key == "PROJECTION") frame.projection = tokens.next_quoted();
      if (key == "DATUM") frame.datum = tokens.next_quoted();
      if (key == "AXIS_UNIT") axis_units(tokens);
      if (key == "ZPOSITIVE") z_positive(tokens.next_quoted());
    }
    lines_.fail("the coordinate system begun on line " + std::to_string(first) +
                " has no END_ORIGINAL_COORDINATE_SYSTEM (truncated)");
  }

  void axis_units(Tokens& tokens) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::string_view unit = tokens.next_quoted();
      if (unit.empty()) return;
      object_.frame.unit[i] = unit;
      object_.frame.scale[i] = length_unit_in_metres(lines_, unit);
    }
  }

  void z_positive(std::string_view value) {
    if (equals_ignoring_case(value, "Depth")) {
      object_.frame.depth = true;
    } else if (!equals_ignoring_case(value, "Elevation")) {
      lines_.fail("ZPOSITIVE is " + in_quotes(value) + "; Elevation or Depth was expected");
    }
  }

  std::int64_t id(Tokens& tokens, const char* what) const {
    const std::string_view token = tokens.next();
    const auto value = to_integer(token);
    if (!value)
      lines_.fail(token.empty() ? std::string("the line ends where ") + what + " was expected"
                                : std::string("expected ") + what + ", found " + in_quotes(token));
    return *value;
  }

  VertexIndex known(Tokens& tokens, const char* what) const {
    const std::int64_t i = id(tokens, what);
    const VertexIndex row = ids_.find(i);
    if (row == no_vertex) lines_.fail("vertex " + std::to_string(i) + " is used but not defined above this line");
    return row;
  }

  void vertex(Tokens& tokens) {
    const std::string_view token = tokens.next();
    const auto i = to_integer(token);
    if (!i) lines_.fail("expected the id of a vertex, found " + in_quotes(token));
    define(*i, static_cast<VertexIndex>(object_.points.size()));
    object_.points.push_back(object_.frame.to_metres(read_point(lines_, tokens, token)));
  }

  /// Defines a point id. Ids may restart in another TFACE or ILINE, but a repetition in the same one is an error.
  void define(std::int64_t i, VertexIndex row) {
    const VertexIndex old = ids_.find(i);
    if (old != no_vertex && old >= part_first_point_) lines_.fail("vertex " + std::to_string(i) + " is defined twice");
    ids_.set(i, row);
  }

  void atom(Tokens& tokens) {
    const std::int64_t i = id(tokens, "the id of an atom");
    const VertexIndex row = known(tokens, "the vertex that an atom refers to");
    ids_.set(i, row);
  }

  void surface_line(std::string_view keyword, Tokens& tokens) {
    if (keyword == "VRTX" || keyword == "PVRTX") {
      vertex(tokens);
    } else if (keyword == "TRGL") {
      Triangle t;
      for (VertexIndex& v : t) v = known(tokens, "the id of a triangle's vertex");
      if (object_.frame.depth) std::swap(t[1], t[2]);
      if (object_.part_first.empty()) object_.part_first.push_back(0);
      object_.triangles.push_back(t);
    } else if (keyword == "ATOM" || keyword == "PATOM") {
      atom(tokens);
    } else if (keyword == "TFACE") {
      object_.part_first.push_back(static_cast<Index>(object_.triangles.size()));
      part_first_point_ = static_cast<VertexIndex>(object_.points.size());
    }
  }

  void polyline_line(std::string_view keyword, Tokens& tokens) {
    if (keyword == "VRTX" || keyword == "PVRTX") {
      vertex(tokens);
    } else if (keyword == "ATOM" || keyword == "PATOM") {
      atom(tokens);
    } else if (keyword == "ILINE") {
      part_first_point_ = static_cast<VertexIndex>(object_.points.size());
      object_.lines.emplace_back();
    } else if (keyword == "SEG") {
      const VertexIndex a = known(tokens, "the id of a segment's vertex");
      const VertexIndex b = known(tokens, "the id of a segment's vertex");
      if (object_.lines.empty()) object_.lines.emplace_back();
      if (!object_.lines.back().empty() && object_.lines.back().back() != a) object_.lines.emplace_back();
      if (object_.lines.back().empty()) object_.lines.back().push_back(a);
      object_.lines.back().push_back(b);
    }
  }

  void well_line(std::string_view keyword, Tokens& tokens) {
    const GocadFrame& f = object_.frame;
    if (keyword == "WREF") {
      reference_ = read_point(lines_, tokens, "WREF");
      object_.path.assign(1, f.to_metres(reference_));
    } else if (keyword == "PATH") {
      double v[4];
      static constexpr const char* what[4] = {"the measured depth", "Z", "dX", "dY"};
      for (std::size_t i = 0; i < 4; ++i) v[i] = finite_number(lines_, tokens.next(), what[i]);
      if (object_.path.empty()) lines_.fail("PATH stands before WREF");
      add_station(f.to_metres({reference_.x + v[2], reference_.y + v[3], v[1]}));
    } else if (keyword == "VRTX") {
      add_station(f.to_metres(read_point(lines_, tokens, "of the path")));
    } else if (keyword == "MRKR") {
      const std::string name(tokens.next_quoted());
      tokens.next();
      object_.markers.emplace_back(name, finite_number(lines_, tokens.next(), "the marker's measured depth"));
    }
  }

  void add_station(const Vec3& p) {
    if (object_.path.empty() || object_.path.back() != p) object_.path.push_back(p);
  }

  void model_line(std::string_view keyword, Tokens& tokens) {
    if (keyword == "TFACE") {
      GocadKeyFace face{id(tokens, "the id of a TFACE"),
                        std::string(tokens.next_quoted()),
                        std::string(tokens.rest()),
                        {},
                        lines_.number()};
      for (Vec3& p : face.key) {
        if (!lines_.next()) lines_.fail("the file ends within the key points of a TFACE (truncated)");
        Tokens coordinates(lines_.line());
        p = object_.frame.to_metres(read_point(lines_, coordinates, "of a TFACE's key"));
      }
      if (object_.frame.depth) std::swap(face.key[1], face.key[2]);
      object_.key_faces.push_back(face);
    } else if (keyword == "REGION") {
      region(tokens);
    }
  }

  void region(Tokens& tokens) {
    id(tokens, "the id of a region");
    GocadRegion region{std::string(tokens.next_quoted()), {}, lines_.number()};
    while (lines_.next()) {
      Tokens faces(lines_.line());
      for (std::string_view token = faces.next(); !token.empty(); token = faces.next()) {
        const auto i = to_integer(token);
        if (!i) lines_.fail("expected a signed TFACE id of region " + region.name + " or 0, found " + in_quotes(token));
        if (*i == 0) {
          object_.regions.push_back(std::move(region));
          return;
        }
        region.signed_faces.push_back(*i);
      }
    }
    lines_.fail("the list of region " + region.name + " has no 0 at its end (truncated)");
  }

  void finish() {
    if (object_.kind == "PLine") {
      std::erase_if(object_.lines, [](const auto& line) { return line.size() < 2; });
    }
  }

  LineReader& lines_;
  GocadObject object_;
  VertexIds ids_;
  VertexIndex part_first_point_ = 0;
  Vec3 reference_;
};

}  // namespace

std::vector<GocadObject> parse_gocad_objects(const InputFile& file) {
  std::vector<GocadObject> objects;
  LineReader lines(file);
  while (lines.next()) {
    Tokens tokens(lines.line());
    const std::string_view word = tokens.next();
    if (word.empty() || word.front() == '#') continue;
    if (word != "GOCAD") {
      if (!objects.empty() && word == "END") continue;
      lines.fail("expected 'GOCAD <kind> 1' at the beginning of an object, found " + in_quotes(lines.line()));
    }
    const std::string_view kind = tokens.next();
    if (kind.empty()) lines.fail("'GOCAD' is followed by no kind of object (TSurf, PLine, VSet, Well, Model3d)");
    objects.push_back(ObjectParser(lines, kind).parse());
  }
  return objects;
}

}  // namespace geomesh::geomodel
