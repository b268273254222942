// SPDX-License-Identifier: GPL-3.0-or-later
// Reads OMF v1 (Open Mining Format 0.9.0). The header has 60 bytes: magic, version, project id, start of the JSON. It
// is followed by arrays compressed with zlib, then JSON: a map from ids to objects that refer to each other. The
// position of a vertex is project origin + geometry origin + array.
#include <zlib.h>

#include <cmath>
#include <limits>

#include "common/foreign_json.hpp"
#include "readers/formats.hpp"
#include "readers/omf/omf_grid.hpp"
#include "readers/text/binary.hpp"
#include "readers/text/frame.hpp"

namespace geomesh::geomodel {
namespace {

using Json = nlohmann::json;
constexpr std::size_t header_bytes = 60;
// Largest number of nodes of all flat grids of an OMF file, since flat grids take no space in it.
constexpr std::size_t most_flat_nodes = 100'000'000;
/// Largest number of bytes of all inflated arrays of an OMF file: a constant, plus a multiple of the file's size. A
/// limit is needed because an OMF file can refer to one array many times.
constexpr std::size_t bytes_always = 100'000'000, bytes_a_byte = 100;
constexpr std::string_view magic("\x84\x83\x82\x81", 4);

class OmfReader {
 public:
  explicit OmfReader(const InputFile& file) : file_(file), bytes_left_(bytes_always + bytes_a_byte * file.size()) {}

  FileContents read() {
    read_header();
    contents_.format = "OMF v1";
    const Json& project = object(project_id_, "the project");
    project_origin_ = vector_of(project, "origin");
    if (project.contains("units") && project["units"].is_string())
      contents_.frame.unit = project["units"].get<std::string>();
    if (!project.contains("elements") || !project["elements"].is_array())
      file_.fail("the project has no list of elements");
    for (const Json& id : project["elements"]) element(text_of(id, "the id of an element"));
    if (contents_.surfaces.empty() && contents_.polylines.empty() && contents_.point_sets.empty())
      file_.fail("the project holds no surface, line or point");
    convert_by_frame(file_, contents_);
    return std::move(contents_);
  }

 private:
  void read_header() {
    if (file_.size() < header_bytes) file_.fail("the file ends within the header of OMF (truncated)");
    const std::string_view version = file_.text().substr(4, 32);
    if (!version.starts_with("OMF-v0.9.0"))
      file_.fail("the version of OMF is " + in_quotes(version.substr(0, version.find('\0'))) +
                 "; OMF-v0.9.0 was expected");
    const auto json_begin = read_little<std::uint64_t>(file_.bytes, 52);
    if (json_begin < header_bytes || json_begin >= file_.size())
      file_.fail("the description (JSON) is said to begin at byte " + std::to_string(json_begin) + " of " +
                 std::to_string(file_.size()) + " (truncated)");
    objects_ = parse_foreign_json(file_.text().substr(static_cast<std::size_t>(json_begin)));
    if (!objects_.is_object()) file_.fail("its description is no valid JSON (truncated)");
    static constexpr char digits[] = "0123456789abcdef";
    for (std::size_t i = 0; i < 16; ++i) {
      if (i == 4 || i == 6 || i == 8 || i == 10) project_id_ += '-';
      const auto byte = static_cast<unsigned char>(file_.bytes[36 + i]);
      project_id_ += {digits[byte >> 4], digits[byte & 15]};
    }
    if (objects_.contains(project_id_)) return;
    for (const auto& [id, entry] : objects_.items())  // the id of the OMF project may be stored in another byte order
      if (entry.is_object() && entry.value("__class__", Json()) == "Project") project_id_ = id;
  }

  std::string text_of(const Json& value, const std::string& what) const {
    if (!value.is_string()) file_.fail(what + " is no text");
    return value.get<std::string>();
  }
  const Json& object(const std::string& id, const std::string& what) const {
    const auto it = objects_.find(id);
    if (it == objects_.end() || !it->is_object()) file_.fail(what + " (" + in_quotes(id) + ") is not in the file");
    return *it;
  }
  const Json& member(const Json& owner, const char* key, const std::string& what) const {
    const auto it = owner.find(key);
    if (it == owner.end()) file_.fail(what + " lacks '" + key + "'");
    return object(text_of(*it, what + "." + key), what + "." + key);
  }
  Vec3 vector_of(const Json& owner, const char* key) const {
    const auto it = owner.find(key);
    if (it == owner.end() || it->is_null()) return {};
    Vec3 v;
    if (it->is_array() && it->size() == 3) {
      for (std::size_t i = 0; i < 3; ++i)
        v[i] = (*it)[i].is_number() ? (*it)[i].get<double>() : std::numeric_limits<double>::quiet_NaN();
    } else {
      v.x = std::numeric_limits<double>::quiet_NaN();
    }
    if (!std::isfinite(v.x) || !std::isfinite(v.y) || !std::isfinite(v.z))
      file_.fail(std::string("'") + key + "' is no vector of three finite numbers");
    return v;
  }

  /// Returns the decompressed bytes of an array in an OMF file, up to the end of its data, whatever length is declared.
  std::string inflate(const Json& owner, const std::string& what) {
    const auto array = owner.find("array");
    if (array == owner.end() || !array->is_object() || !array->contains("start") || !array->contains("length") ||
        !(*array)["start"].is_number_integer() || !(*array)["length"].is_number_integer())
      file_.fail(what + " has no array with start and length");
    const auto start = (*array)["start"].get<std::int64_t>(), length = (*array)["length"].get<std::int64_t>();
    const auto size = static_cast<std::int64_t>(file_.size());
    if (start < 0 || length < 0 || start > size || length > size - start)
      file_.fail(what + " is said to lie at bytes " + std::to_string(start) + " to " + std::to_string(start) + " + " +
                 std::to_string(length) + " of " + std::to_string(size) + " (truncated)");
    z_stream stream{};
    if (inflateInit(&stream) != Z_OK) file_.fail("zlib cannot be started");
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(file_.bytes.data() + start));
    stream.avail_in = static_cast<uInt>(length);
    std::string bytes;
    std::vector<char> block(1 << 16);
    int status = Z_OK;
    while (status == Z_OK) {
      stream.next_out = reinterpret_cast<Bytef*>(block.data());
      stream.avail_out = static_cast<uInt>(block.size());
      status = ::inflate(&stream, Z_NO_FLUSH);
      bytes.append(block.data(), block.size() - stream.avail_out);
      if (bytes.size() > bytes_left_) break;
    }
    inflateEnd(&stream);
    if (bytes.size() > bytes_left_)
      file_.fail(what +
                 ": with it, the arrays that are named hold more than 100 MB and a hundred times the file's size, more "
                 "than can be right");
    bytes_left_ -= bytes.size();
    if (status != Z_STREAM_END) file_.fail(what + " cannot be decompressed (truncated or damaged)");
    return bytes;
  }

  std::string numbers(const Json& owner, const std::string& what, const char* type) {
    std::string bytes = inflate(owner, what);
    const Json& array = owner["array"];
    if (array.value("dtype", Json(type)) != type)
      file_.fail(what + " holds numbers of type " + array["dtype"].dump() + "; " + type + " was expected");
    return bytes;
  }
  std::vector<double> doubles(const Json& owner, const std::string& what) {
    const std::string bytes = numbers(owner, what, "<f8");
    std::vector<double> values(bytes.size() / 8);
    for (std::size_t i = 0; i < values.size(); ++i) {
      values[i] = read_little<double>(bytes, 8 * i);
      if (!std::isfinite(values[i]))
        file_.fail(what + ": number " + std::to_string(i) + " (counted from 0) is not finite");
    }
    return values;
  }
  std::vector<VertexIndex> rows(const Json& owner, const std::string& what, std::size_t n_points) {
    const std::string bytes = numbers(owner, what, "<i8");
    std::vector<VertexIndex> values(bytes.size() / 8);
    for (std::size_t i = 0; i < values.size(); ++i) {
      const auto v = read_little<std::int64_t>(bytes, 8 * i);
      if (v < 0 || static_cast<std::uint64_t>(v) >= n_points)
        file_.fail(what + " names vertex row " + std::to_string(v) + " (counted from 0), but there are " +
                   std::to_string(n_points));
      values[i] = static_cast<VertexIndex>(v);
    }
    return values;
  }

  std::vector<Vec3> vertices(const Json& geometry, const std::string& what) {
    const std::vector<double> values = doubles(member(geometry, "vertices", what), what + ".vertices");
    const Vec3 origin = project_origin_ + vector_of(geometry, "origin");
    std::vector<Vec3> points;
    for (std::size_t i = 0; i + 2 < values.size(); i += 3)
      points.push_back(origin + Vec3{values[i], values[i + 1], values[i + 2]});
    return points;
  }

  void element(const std::string& id) {
    const Json& e = object(id, "an element");
    const Json given = e.value("name", Json());
    const std::string name =
        given.is_string() && !given.get<std::string>().empty() ? given.get<std::string>() : file_.path.stem().string();
    const Json& geometry = member(e, "geometry", "element '" + name + "'");
    const Json kind = geometry.value("__class__", Json());
    if (kind == "SurfaceGeometry") {
      surface(geometry, name);
    } else if (kind == "SurfaceGridGeometry") {
      grid_surface(geometry, name);
    } else if (kind == "PointSetGeometry") {
      contents_.point_sets.push_back({name, file_.shown(), vertices(geometry, name)});
    } else if (kind == "LineSetGeometry") {
      lines(geometry, name);
    } else {
      contents_.notes.push_back("element '" + name + "' of kind " + (kind.is_string() ? kind.get<std::string>() : "?") +
                                " passed over");
    }
  }

  void surface(const Json& geometry, const std::string& name) {
    TriangulatedSurface s;
    s.name = name;
    s.file = file_.shown();
    s.points = vertices(geometry, name);
    const std::vector<VertexIndex> row =
        rows(member(geometry, "triangles", name), name + ".triangles", s.points.size());
    for (std::size_t i = 0; i + 2 < row.size(); i += 3) s.triangles.push_back({row[i], row[i + 1], row[i + 2]});
    if (s.triangles.empty()) {
      contents_.warnings.push_back("surface '" + name + "' has no triangles and is left out");
      return;
    }
    contents_.surfaces.push_back(std::move(s));
  }

  /// Returns the widths of grid cells, which an OMF geometry holds itself or in an array to which it refers.
  std::vector<double> widths(const Json& geometry, const char* key, const std::string& name) {
    const std::string what = name + "." + key;
    const auto it = geometry.find(key);
    if (it == geometry.end()) file_.fail(what + " is not there");
    std::vector<double> values =
        it->is_string() ? doubles(object(it->get<std::string>(), what), what) : doubles(Json{{"array", *it}}, what);
    if (values.empty()) file_.fail(what + " is empty: a grid has one cell or more each way");
    return values;
  }

  void grid_surface(const Json& geometry, const std::string& name) {
    OmfGrid grid;
    grid.origin = project_origin_ + vector_of(geometry, "origin");
    grid.axis_u = geometry.contains("axis_u") ? vector_of(geometry, "axis_u") : Vec3{1, 0, 0};
    grid.axis_v = geometry.contains("axis_v") ? vector_of(geometry, "axis_v") : Vec3{0, 1, 0};
    grid.cells_u = widths(geometry, "tensor_u", name);
    grid.cells_v = widths(geometry, "tensor_v", name);
    const auto offset = geometry.find("offset_w");
    if (offset != geometry.end() && !offset->is_null()) {
      grid.offsets = doubles(member(geometry, "offset_w", name), name + ".offset_w");
      if (grid.offsets.size() / grid.n_columns() != grid.n_rows() || grid.offsets.size() % grid.n_columns() != 0)
        file_.fail(name + ".offset_w holds " + std::to_string(grid.offsets.size()) + " numbers; a grid of " +
                   std::to_string(grid.n_columns()) + " by " + std::to_string(grid.n_rows()) + " nodes has one each");
    } else if (grid.n_columns() > flat_nodes_left_ / grid.n_rows()) {
      file_.fail(name + " is a flat grid of " + std::to_string(grid.n_columns()) + " by " +
                 std::to_string(grid.n_rows()) + " nodes, more than can be right");
    } else {
      flat_nodes_left_ -= grid.n_columns() * grid.n_rows();
    }
    const auto lattice = nodes_of(grid);
    if (!lattice) {
      contents_.warnings.push_back("surface '" + name +
                                   "' is a grid, and the format leaves open along which axis its nodes run first, "
                                   "which its heights do not show either: it is left out; export it as triangles");
      return;
    }
    const Vec3 &first = lattice->nodes.front(), &right = lattice->nodes[1], &up = lattice->nodes[lattice->n_columns];
    add_lattice(file_, name, *lattice,
                {name, 0, 0, 0, {first.x, first.y}, {right.x - first.x, up.y - first.y}, 0, false}, contents_);
    if (!grid.offsets.empty())
      contents_.notes.push_back(
          "the nodes of grid '" + name +
          "' are taken in the order in which its surface is smoother; the format leaves the order open");
  }

  void lines(const Json& geometry, const std::string& name) {
    const std::vector<Vec3> points = vertices(geometry, name);
    const std::vector<VertexIndex> row = rows(member(geometry, "segments", name), name + ".segments", points.size());
    std::size_t n = 0;
    for (std::size_t i = 0; i + 1 < row.size(); i += 2) {
      const bool goes_on = i > 0 && row[i] == row[i - 1];
      if (!goes_on) contents_.polylines.push_back({name + "__" + std::to_string(++n), file_.shown(), {points[row[i]]}});
      contents_.polylines.back().points.push_back(points[row[i + 1]]);
    }
  }

  const InputFile& file_;
  std::size_t bytes_left_, flat_nodes_left_ = most_flat_nodes;
  Json objects_;
  std::string project_id_;
  Vec3 project_origin_;
  FileContents contents_;
};

bool is_omf_2(const InputFile& file) {
  return file.text().starts_with("PK\x03\x04") &&
         (file.extension() == ".omf" || file.text().find("Open Mining Format 2") != std::string_view::npos);
}

}  // namespace

bool is_omf(const InputFile& file) { return file.text().starts_with(magic) || is_omf_2(file); }

FileContents read_omf(const InputFile& file) {
  if (is_omf_2(file))
    file.fail("OMF version 2 is not read; export version 1 (OMF-v0.9.0), or the surfaces as GOCAD TSurf or OBJ");
  return OmfReader(file).read();
}

}  // namespace geomesh::geomodel
