// SPDX-License-Identifier: GPL-3.0-or-later
// Reads TetGen .poly, .smesh and .node (Si, TetGen manual 1.5, section 5.2): piecewise linear complexes, which are not
// changed.
#include "readers/triangles/tetgen.hpp"

#include "geomesh/geomodel/readers.hpp"
#include "readers/text/input_file.hpp"
#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

/// Reads a TetGen file by lines that are not blank; `#` begins a comment.
class TetgenLines {
 public:
  explicit TetgenLines(const InputFile& file) : lines_(file) {}

  bool next(Tokens& tokens) {
    while (lines_.next()) {
      const std::string_view content = trim(lines_.line().substr(0, lines_.line().find('#')));
      if (content.empty()) continue;
      tokens = Tokens(content);
      return true;
    }
    return false;
  }
  Tokens require(const std::string& what) {
    Tokens tokens("");
    if (!next(tokens)) lines_.fail("the file ends where " + what + " was expected (truncated?)");
    return tokens;
  }
  std::int64_t integer(Tokens& tokens, const char* what) const {
    const std::string_view token = tokens.next();
    const auto value = to_integer(token);
    if (!value)
      lines_.fail(std::string("expected ") + what + ", found " +
                  (token.empty() ? "the end of the line" : in_quotes(token)));
    return *value;
  }
  /// Reads a number of points, facets ... in a TetGen file. Throws if the file is shorter than two bytes for each.
  std::size_t count(Tokens& tokens, const char* what) const {
    const std::int64_t n = integer(tokens, what);
    if (n < 0 || static_cast<std::uint64_t>(n) > lines_.file().size() / 2) {
      lines_.fail(std::string(what) + " is given as " + std::to_string(n) + ", which a file of " +
                  std::to_string(lines_.file().size()) + " bytes cannot hold");
    }
    return static_cast<std::size_t>(n);
  }
  const LineReader& at() const { return lines_; }

 private:
  LineReader lines_;
};

class TetgenParser {
 public:
  explicit TetgenParser(const InputFile& file) : file_(file), lines_(file) {}

  PlcFile parse() {
    read_nodes();
    const std::string extension = file_.extension();
    if (extension == ".node") {
      for (VertexIndex v = 0; v < out_.plc.points.size(); ++v) out_.plc.isolated_points.push_back(v);
      return std::move(out_);
    }
    read_facets(extension == ".smesh");
    read_holes();
    read_regions();
    return std::move(out_);
  }

 private:
  void read_nodes() {
    Tokens head = lines_.require("the number of points");
    const std::size_t n = lines_.count(head, "the number of points");
    if (n == 0) {
      if (file_.extension() == ".node") lines_.at().fail("the file holds no points");
      std::filesystem::path beside = file_.path;
      beside.replace_extension(".node");
      if (!std::filesystem::exists(beside)) {
        lines_.at().fail("the points are said to stand in " + beside.filename().string() + ", which does not exist");
      }
      const InputFile node_file = load_input_file(beside);
      TetgenLines node_lines(node_file);
      Tokens node_head = node_lines.require("the number of points");
      const std::size_t n_beside = node_lines.count(node_head, "the number of points");
      read_node_list(node_lines, n_beside, node_head);
      return;
    }
    read_node_list(lines_, n, head);
  }

  void read_node_list(TetgenLines& lines, std::size_t n, Tokens& head) {
    if (!head.at_end() && lines.integer(head, "the dimension") != 3) lines.at().fail("the dimension must be 3");
    for (std::size_t i = 0; i < n; ++i) {
      Tokens tokens = lines.require("point " + std::to_string(i + 1) + " of " + std::to_string(n));
      const std::int64_t id = lines.integer(tokens, "the number of a point");
      if (i == 0) {
        if (id != 0 && id != 1)
          lines.at().fail("the points are numbered from " + std::to_string(id) + "; 0 or 1 was expected");
        base_ = id;
      }
      if (id != base_ + static_cast<std::int64_t>(i)) {
        lines.at().fail("point number " + std::to_string(base_ + static_cast<std::int64_t>(i)) +
                        " was expected, found " + std::to_string(id));
      }
      out_.plc.points.push_back(read_point(lines.at(), tokens, std::to_string(id)));
    }
  }

  /// Reads n vertex numbers of a TetGen polygon, which may continue on the following lines.
  std::vector<VertexIndex> vertices(Tokens& tokens, std::size_t n) {
    std::vector<VertexIndex> out;
    while (out.size() < n) {
      if (tokens.at_end()) tokens = lines_.require("a polygon's next vertex");
      const std::int64_t v = lines_.integer(tokens, "the number of a polygon's vertex") - base_;
      if (v < 0 || static_cast<std::uint64_t>(v) >= out_.plc.points.size()) {
        lines_.at().fail("vertex " + std::to_string(v + base_) + " does not exist; there are " +
                         std::to_string(out_.plc.points.size()) + " points numbered from " + std::to_string(base_));
      }
      out.push_back(static_cast<VertexIndex>(v));
    }
    return out;
  }

  void read_facets(bool smesh) {
    Tokens head = lines_.require("the number of facets");
    const std::size_t n = lines_.count(head, "the number of facets");
    const bool has_markers = !head.at_end() && lines_.integer(head, "0 or 1 (facet markers)") != 0;
    for (std::size_t f = 0; f < n; ++f) {
      Tokens tokens = lines_.require("facet " + std::to_string(f + 1) + " of " + std::to_string(n));
      TetgenFacet facet;
      int marker = 0;
      if (smesh) {
        facet.polygons.push_back(vertices(tokens, lines_.count(tokens, "the number of a facet's vertices")));
        if (has_markers && !tokens.at_end()) marker = static_cast<int>(lines_.integer(tokens, "the facet's marker"));
      } else {
        const std::size_t n_polygons = lines_.count(tokens, "the number of a facet's polygons");
        const std::size_t n_holes = tokens.at_end() ? 0 : lines_.count(tokens, "the number of a facet's holes");
        if (has_markers && !tokens.at_end()) marker = static_cast<int>(lines_.integer(tokens, "the facet's marker"));
        read_polygons(facet, n_polygons, n_holes);
      }
      add_facet(facet, marker);
    }
  }

  void read_polygons(TetgenFacet& facet, std::size_t n_polygons, std::size_t n_holes) {
    for (std::size_t i = 0; i < n_polygons; ++i) {
      Tokens tokens = lines_.require("a facet's polygon");
      const std::size_t n = lines_.count(tokens, "the number of a polygon's vertices");
      facet.polygons.push_back(vertices(tokens, n));
    }
    for (std::size_t i = 0; i < n_holes; ++i) {
      Tokens tokens = lines_.require("a facet's hole");
      tokens.next();
      facet.holes.push_back(read_point(lines_.at(), tokens, "of a facet's hole"));
    }
  }

  void add_facet(const TetgenFacet& facet, int marker) {
    PiecewiseLinearComplex& plc = out_.plc;
    const std::vector<FacetPiece> pieces = facet_pieces(plc.points, facet);
    if (pieces.empty()) add_loose(facet);
    for (const FacetPiece& piece : pieces) {
      const Index f = plc.add_polygon(piece.loops);
      for (const auto& [a, b] : piece.segments) plc.facet_segments.push_back({f, a, b});
      for (const VertexIndex v : piece.points) plc.facet_points.push_back({f, v});
      out_.facet_markers.push_back(marker);
    }
  }

  /// Adds a TetGen facet that has no closed polygon: its segments and points become isolated constraints.
  void add_loose(const TetgenFacet& facet) {
    for (const auto& polygon : facet.polygons) {
      if (polygon.size() == 2) out_.plc.segments.push_back({polygon[0], polygon[1]});
      if (polygon.size() == 1) out_.plc.isolated_points.push_back(polygon[0]);
    }
  }

  void read_holes() {
    Tokens head("");
    if (!lines_.next(head)) return;
    const std::size_t n = lines_.count(head, "the number of holes");
    for (std::size_t i = 0; i < n; ++i) {
      Tokens tokens = lines_.require("hole " + std::to_string(i + 1) + " of " + std::to_string(n));
      tokens.next();
      out_.plc.hole_seeds.push_back({read_point(lines_.at(), tokens, "of a hole"), no_index});
    }
  }

  void read_regions() {
    Tokens head("");
    if (!lines_.next(head)) return;
    const std::size_t n = lines_.count(head, "the number of regions");
    for (std::size_t i = 0; i < n; ++i) {
      Tokens tokens = lines_.require("region " + std::to_string(i + 1) + " of " + std::to_string(n));
      const std::string number(tokens.next());
      const Vec3 p = read_point(lines_.at(), tokens, "of a region");
      const std::string attribute(tokens.at_end() ? std::string_view(number) : tokens.next());
      out_.plc.region_seeds.push_back({p, static_cast<Index>(out_.region_names.size())});
      out_.region_names.push_back("region_" + attribute);
    }
  }

  const InputFile& file_;
  TetgenLines lines_;
  PlcFile out_;
  std::int64_t base_ = 1;
};

}  // namespace

bool is_plc_file(const std::filesystem::path& path) {
  const std::string extension = to_lower(path.extension().string());
  return extension == ".poly" || extension == ".smesh" || extension == ".node";
}

PlcFile read_plc_file(const std::filesystem::path& path) {
  const InputFile file = load_input_file(path);
  if (trim(file.text()).empty()) file.fail("the file is empty");
  if (looks_binary(file)) file.fail("a binary file, not a TetGen file, though its extension says so");
  return TetgenParser(file).parse();
}

}  // namespace geomesh::geomodel
