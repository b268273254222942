// SPDX-License-Identifier: GPL-3.0-or-later
// Reads PLY, ASCII and binary in both byte orders: vertices (x, y, z) and polygons (vertex_indices or vertex_index);
// other elements and properties are ignored.
#include <cmath>
#include <map>
#include <optional>

#include "readers/formats.hpp"
#include "readers/text/binary.hpp"
#include "readers/text/text.hpp"
#include "readers/triangles/single_surface.hpp"

namespace geomesh::geomodel {
namespace {

enum class PlyType { int8, uint8, int16, uint16, int32, uint32, float32, float64 };

std::optional<PlyType> ply_type(std::string_view name) {
  static const std::map<std::string_view, PlyType> types{
      {"char", PlyType::int8},      {"int8", PlyType::int8},       {"uchar", PlyType::uint8},
      {"uint8", PlyType::uint8},    {"short", PlyType::int16},     {"int16", PlyType::int16},
      {"ushort", PlyType::uint16},  {"uint16", PlyType::uint16},   {"int", PlyType::int32},
      {"int32", PlyType::int32},    {"uint", PlyType::uint32},     {"uint32", PlyType::uint32},
      {"float", PlyType::float32},  {"float32", PlyType::float32}, {"double", PlyType::float64},
      {"float64", PlyType::float64}};
  const auto it = types.find(name);
  return it == types.end() ? std::nullopt : std::optional(it->second);
}

std::size_t size_of(PlyType t) {
  switch (t) {
    case PlyType::int8:
    case PlyType::uint8:
      return 1;
    case PlyType::int16:
    case PlyType::uint16:
      return 2;
    case PlyType::float64:
      return 8;
    default:
      return 4;
  }
}

struct PlyProperty {
  std::string name;
  PlyType type;
  std::optional<PlyType> count_type;  ///< lists
};

struct PlyElement {
  std::string name;
  std::size_t count;
  std::vector<PlyProperty> properties;
};

enum class PlyEncoding { ascii, little, big };

class PlyValues {
 public:
  PlyValues(const InputFile& file, std::size_t body, PlyEncoding encoding, std::size_t header_lines)
      : file_(file), at_(body), encoding_(encoding), line_(header_lines) {}

  double next(PlyType type) { return encoding_ == PlyEncoding::ascii ? next_ascii() : next_binary(type); }
  std::size_t bytes_left() const { return file_.size() - at_; }
  std::size_t line() const { return encoding_ == PlyEncoding::ascii ? line_ : 0; }
  [[noreturn]] void fail(const std::string& message) const {
    if (line() > 0) file_.fail(line_, message);
    file_.fail(message);
  }

 private:
  double next_ascii() {
    const std::string_view text = file_.text();
    while (at_ < text.size() && (text[at_] == ' ' || text[at_] == '\t' || text[at_] == '\n' || text[at_] == '\r')) {
      if (text[at_] == '\n') ++line_;
      ++at_;
    }
    const std::size_t begin = at_;
    while (at_ < text.size() && text[at_] != ' ' && text[at_] != '\t' && text[at_] != '\n' && text[at_] != '\r') ++at_;
    const std::string_view token = text.substr(begin, at_ - begin);
    if (token.empty()) fail("the file ends before the counts in its header are met (truncated, or a wrong count)");
    const auto value = to_double(token);
    if (!value) fail("expected a number, found " + in_quotes(token));
    return *value;
  }

  double next_binary(PlyType type) {
    if (bytes_left() < size_of(type))
      fail("the file ends before the counts in its header are met (truncated, or a wrong count)");
    const std::size_t at = at_;
    at_ += size_of(type);
    const std::endian order = encoding_ == PlyEncoding::little ? std::endian::little : std::endian::big;
    switch (type) {
      case PlyType::int8:
        return read_number<std::int8_t>(file_.bytes, at, order);
      case PlyType::uint8:
        return read_number<std::uint8_t>(file_.bytes, at, order);
      case PlyType::int16:
        return read_number<std::int16_t>(file_.bytes, at, order);
      case PlyType::uint16:
        return read_number<std::uint16_t>(file_.bytes, at, order);
      case PlyType::int32:
        return read_number<std::int32_t>(file_.bytes, at, order);
      case PlyType::uint32:
        return read_number<std::uint32_t>(file_.bytes, at, order);
      case PlyType::float32:
        return static_cast<double>(read_number<float>(file_.bytes, at, order));
      case PlyType::float64:
        return read_number<double>(file_.bytes, at, order);
    }
    return 0;
  }

  const InputFile& file_;
  std::size_t at_;
  PlyEncoding encoding_;
  std::size_t line_;
};

struct PlyHeader {
  std::optional<PlyEncoding> encoding;
  std::vector<PlyElement> elements;
  std::size_t body = 0, n_lines = 0;
};

void read_property(LineReader& lines, Tokens& tokens, PlyHeader& header) {
  if (header.elements.empty()) lines.fail("a property stands before the first element");
  PlyProperty property;
  std::string_view type = tokens.next();
  if (type == "list") {
    property.count_type = ply_type(tokens.next());
    if (!property.count_type) lines.fail("the list's count has no known type");
    type = tokens.next();
  }
  const auto known = ply_type(type);
  if (!known) lines.fail("the property's type " + in_quotes(type) + " is not known");
  property.type = *known;
  property.name = tokens.next();
  header.elements.back().properties.push_back(property);
}

PlyHeader read_header(const InputFile& file) {
  PlyHeader header;
  const std::size_t end = file.text().find("end_header");
  if (end == std::string_view::npos) file.fail("the PLY header has no end_header (truncated)");
  LineReader lines(file);
  while (lines.next()) {
    Tokens tokens(lines.line());
    const std::string_view word = tokens.next();
    if (word == "end_header") break;
    if (word == "format") {
      const std::string_view name = tokens.next();
      if (name == "ascii") header.encoding = PlyEncoding::ascii;
      if (name == "binary_little_endian") header.encoding = PlyEncoding::little;
      if (name == "binary_big_endian") header.encoding = PlyEncoding::big;
      if (!header.encoding)
        lines.fail("the format is " + in_quotes(name) +
                   "; ascii, binary_little_endian or binary_big_endian was expected");
    } else if (word == "element") {
      const std::string name(tokens.next());
      const auto n = to_integer(tokens.next());
      if (!n || *n < 0) lines.fail("expected the count of element " + name);
      header.elements.push_back({name, static_cast<std::size_t>(*n), {}});
    } else if (word == "property") {
      read_property(lines, tokens, header);
    }
  }
  if (!header.encoding) file.fail("the PLY header names no format");
  header.n_lines = lines.number() + 1;
  header.body = file.text().find('\n', end);
  header.body = header.body == std::string_view::npos ? file.size() : header.body + 1;
  return header;
}

void read_vertex(PlyValues& values, const PlyElement& element, std::size_t row, SurfaceBuilder& builder) {
  Vec3 p;
  for (const PlyProperty& property : element.properties) {
    if (property.count_type) {
      for (double n = values.next(*property.count_type); n >= 1; --n) values.next(property.type);
      continue;
    }
    const double v = values.next(property.type);
    if (property.name.size() != 1 || property.name[0] < 'x' || property.name[0] > 'z') continue;
    p[static_cast<std::size_t>(property.name[0] - 'x')] = v;
    if (!std::isfinite(v))
      values.fail("coordinate " + property.name + " of vertex " + std::to_string(row) + " is not finite");
  }
  builder.points().push_back(p);
}

void read_face(PlyValues& values, const PlyElement& element, std::vector<std::int64_t>& polygon,
               SurfaceBuilder& builder) {
  polygon.clear();
  for (const PlyProperty& property : element.properties) {
    if (!property.count_type) {
      values.next(property.type);
      continue;
    }
    const double n = values.next(*property.count_type);
    const bool corners = property.name == "vertex_indices" || property.name == "vertex_index";
    if (!(n >= 0 && n <= static_cast<double>(values.bytes_left()))) values.fail("a list's length is wrong");
    for (double k = 0; k < n; ++k) {
      const double v = values.next(property.type);
      if (!(std::abs(v) < 1e15)) values.fail("the index of a vertex is no whole number");
      if (corners) polygon.push_back(static_cast<std::int64_t>(v));
    }
  }
  builder.add_polygon(polygon, values.line());
}

/// Returns the least number of bytes that one item of a PLY element (a vertex, a face) takes, so that a header cannot
/// declare more items than the file can contain.
std::size_t least_bytes(const PlyElement& element, PlyEncoding encoding) {
  std::size_t bytes = 0;
  for (const PlyProperty& p : element.properties) {
    bytes += encoding == PlyEncoding::ascii ? 2 : size_of(p.count_type.value_or(p.type));
  }
  return std::max<std::size_t>(bytes, 1);
}

void require_xyz(const InputFile& file, const PlyElement& element) {
  for (const char* axis : {"x", "y", "z"}) {
    bool found = false;
    for (const PlyProperty& p : element.properties) found = found || (p.name == axis && !p.count_type);
    if (!found) file.fail(std::string("element vertex has no property ") + axis);
  }
}

}  // namespace

bool is_ply(const InputFile& file) { return file.text().starts_with("ply\n") || file.text().starts_with("ply\r"); }

FileContents read_ply(const InputFile& file) {
  const PlyHeader header = read_header(file);
  PlyValues values(file, header.body, *header.encoding, header.n_lines);
  SurfaceBuilder builder(file);
  std::vector<std::int64_t> polygon;
  bool single_precision = false;
  for (const PlyElement& element : header.elements) {
    if (element.count > values.bytes_left() / least_bytes(element, *header.encoding) + 1) {
      values.fail("element " + element.name + " is given as " + std::to_string(element.count) + " items, but only " +
                  std::to_string(values.bytes_left()) + " bytes follow (truncated, or a wrong count)");
    }
    if (element.name == "vertex") {
      require_xyz(file, element);
      for (const PlyProperty& p : element.properties)
        single_precision = single_precision || (p.name == "x" && p.type == PlyType::float32);
    }
    for (std::size_t i = 0; i < element.count; ++i) {
      if (element.name == "vertex") {
        read_vertex(values, element, i, builder);
      } else if (element.name == "face") {
        read_face(values, element, polygon, builder);
      } else {
        for (const PlyProperty& p : element.properties)
          for (double n = p.count_type ? values.next(*p.count_type) : 1; n >= 1; --n) values.next(p.type);
      }
    }
  }
  const bool ascii = header.encoding == PlyEncoding::ascii;
  FileContents contents = one_surface(file, ascii ? "PLY (ASCII)" : "PLY (binary)", std::move(builder));
  if (!ascii && single_precision) contents.notes.push_back("coordinates have single precision in the file");
  return contents;
}

}  // namespace geomesh::geomodel
