// SPDX-License-Identifier: GPL-3.0-or-later
#include "pipeline/jobs/read_points.hpp"

#include <charconv>
#include <cmath>
#include <fstream>
#include <optional>
#include <sstream>
#include <string_view>

#include "geomesh/core/error.hpp"
#include "geomesh/geomodel/readers.hpp"

namespace geomesh::geomodel {
namespace {

bool is_separator(char c) { return c == ' ' || c == '\t' || c == ',' || c == ';' || c == '\r'; }

/// Parses the first three numbers of a line of a point file; further columns are allowed.
std::optional<Vec3> parse_point(std::string_view line) {
  Vec3 p;
  const char* at = line.data();
  const char* end = at + line.size();
  for (std::size_t i = 0; i < 3; ++i) {
    while (at != end && is_separator(*at)) ++at;
    if (at != end && *at == '+') ++at;
    const auto [next, status] = std::from_chars(at, end, p[i]);
    if (status != std::errc() || (next != end && !is_separator(*next))) return std::nullopt;
    at = next;
  }
  return p;
}

bool is_blank_or_comment(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  return first == std::string_view::npos || line[first] == '#';
}

std::string read_whole(const std::filesystem::path& path) {
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorKind::usage, "cannot open " + path.string());
  std::ostringstream text;
  text << in.rdbuf();
  return std::move(text).str();
}

/// Returns true if one of the first two lines of the text that are neither blank nor a comment is a point.
bool looks_like_points(std::string_view text) {
  int seen = 0;
  while (!text.empty() && seen < 2) {
    const std::string_view line = text.substr(0, text.find('\n'));
    if (!is_blank_or_comment(line)) {
      if (parse_point(line)) return true;
      ++seen;
    }
    text.remove_prefix(std::min(line.size() + 1, text.size()));
  }
  return false;
}

std::vector<Vec3> parse_points(std::string_view text, const std::string& name) {
  std::vector<Vec3> points;
  bool header_allowed = true;
  for (std::size_t n = 1; !text.empty(); ++n) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (is_blank_or_comment(line)) continue;
    const std::optional<Vec3> p = parse_point(line);
    if (!p && !header_allowed)
      throw Error(ErrorKind::invalid_input, name + ":" + std::to_string(n) +
                                                ": expected three numbers x y z, found \"" +
                                                std::string(line.substr(0, 60)) + "\"");
    header_allowed = false;
    if (!p) continue;
    for (std::size_t i = 0; i < 3; ++i)
      if (!std::isfinite((*p)[i]))
        throw Error(ErrorKind::invalid_input, name + ":" + std::to_string(n) + ": a coordinate is not a finite number");
    points.push_back(*p);
  }
  return points;
}

}  // namespace

std::vector<Vec3> read_points(const std::filesystem::path& path) {
  const std::string text = read_whole(path);
  if (looks_like_points(text)) return parse_points(text, path.filename().string());
  const FileContents contents = read_surface_file(path);
  std::vector<Vec3> points;
  for (const auto& surface : contents.surfaces)
    points.insert(points.end(), surface.points.begin(), surface.points.end());
  for (const auto& line : contents.polylines) points.insert(points.end(), line.points.begin(), line.points.end());
  for (const auto& set : contents.point_sets) points.insert(points.end(), set.points.begin(), set.points.end());
  for (const auto& point : contents.points) points.push_back(point.point);
  return points;
}

}  // namespace geomesh::geomodel
