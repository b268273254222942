// SPDX-License-Identifier: GPL-3.0-or-later
#include "geomesh/geomodel/tops.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "common/union_find.hpp"
#include "naming/sheets.hpp"
#include "naming/sums.hpp"
#include "readers/tables/table.hpp"

namespace geomesh::geomodel {
namespace {

constexpr double nowhere = std::numeric_limits<double>::quiet_NaN();
// Default distance within which a well top moves a horizon, as a share of the horizon's extent.
constexpr double share_of_bounds = 0.2;

struct TopColumns {
  std::size_t well = 0, horizon = 0, depth = 0;
};

std::size_t column_named(const LineReader& at, const std::vector<std::string>& names,
                         const std::vector<std::string_view>& meant) {
  for (std::size_t i = 0; i < names.size(); ++i)
    if (std::find(meant.begin(), meant.end(), names[i]) != meant.end()) return i;
  std::string words;
  for (const std::string_view word : meant) words += (words.empty() ? "" : ", ") + std::string(word);
  at.fail("a first line with the names of the columns was expected, one of them " + words);
}

TopColumns columns_of(const LineReader& at, const Separation& separation) {
  std::vector<std::string> names;
  for (const std::string_view field : separation.split(at.line())) names.push_back(to_lower(field));
  return {column_named(at, names, {"well", "well_name", "wellname"}),
          column_named(at, names, {"horizon", "top", "surface", "marker", "pick"}),
          column_named(at, names, {"depth", "md", "z"})};
}

bool says_nothing(std::string_view line) {
  const std::string_view text = trim(line);
  return text.empty() || text.front() == '#' || text.front() == '!';
}

/// A triangle above or below a point, with the point's barycentric coordinates in the triangle after projection onto
/// the map.
struct Hit {
  Index triangle = no_index;
  std::array<double, 3> shares{};
  double height = nowhere;
};

/// Returns where the vertical line through p meets a triangle; nothing if it misses it, or the triangle is vertical.
std::optional<Hit> hit_of(const Vec3& p, std::span<const Vec3> points, const Triangle& t) {
  const Vec3 &a = points[t[0]], &b = points[t[1]], &c = points[t[2]];
  if (p.x < std::min({a.x, b.x, c.x}) || p.x > std::max({a.x, b.x, c.x}) || p.y < std::min({a.y, b.y, c.y}) ||
      p.y > std::max({a.y, b.y, c.y}))
    return std::nullopt;
  const auto twice_area = [](const Vec3& u, const Vec3& v, const Vec3& w) {
    return (v.x - u.x) * (w.y - u.y) - (v.y - u.y) * (w.x - u.x);
  };
  const double whole = twice_area(a, b, c);
  if (whole == 0) return std::nullopt;
  Hit hit;
  hit.shares = {twice_area(p, b, c) / whole, twice_area(a, p, c) / whole, twice_area(a, b, p) / whole};
  constexpr double on_side = -1e-9;  // slack: a point on an edge counts as inside both triangles at it
  if (*std::min_element(hit.shares.begin(), hit.shares.end()) < on_side) return std::nullopt;
  hit.height = hit.shares[0] * a.z + hit.shares[1] * b.z + hit.shares[2] * c.z;
  return hit;
}

/// Returns the triangle above or below p that is nearest in height; `triangle` is no_index if there is none.
Hit nearest_hit(const Vec3& p, std::span<const Vec3> points, std::span<const Triangle> triangles) {
  Hit nearest;
  for (Index t = 0; t < triangles.size(); ++t) {
    auto hit = hit_of(p, points, triangles[t]);
    if (!hit || (nearest.triangle != no_index && std::abs(p.z - hit->height) >= std::abs(p.z - nearest.height)))
      continue;
    nearest = *hit;
    nearest.triangle = t;
  }
  return nearest;
}

/// Wendland's positive definite radial function in the plane with two continuous derivatives: 1 at 0, and 0 from 1 on.
double wendland(double r) {
  if (r >= 1) return 0;
  const double s = 1 - r;
  return s * s * s * s * (4 * r + 1);
}

double distance_in_map(const Vec3& a, const Vec3& b) { return std::hypot(a.x - b.x, a.y - b.y); }

/// Returns the connected part of the horizon to which each point belongs, after merging equal points.
std::vector<Index> sheet_of_points(const TriangulatedSurface& horizon) {
  const std::vector<VertexIndex> merged = merge_equal_points(horizon.points);
  UnionFind joined(horizon.points.size());
  for (std::size_t v = 0; v < merged.size(); ++v) joined.unite(static_cast<Index>(v), merged[v]);
  for (const Triangle& t : horizon.triangles) {
    joined.unite(t[0], t[1]);
    joined.unite(t[0], t[2]);
  }
  std::vector<Index> sheet(horizon.points.size());
  for (Index v = 0; v < sheet.size(); ++v) sheet[v] = joined.find(v);
  return sheet;
}

double usual_reach(const TriangulatedSurface& horizon) {
  Box3 bounds;
  for (const Vec3& p : horizon.points) bounds.add(p);
  return share_of_bounds * std::max(bounds.max.x - bounds.min.x, bounds.max.y - bounds.min.y);
}

/// Returns the weights of the radial functions around well tops. If the tops do not determine them, they follow from
/// least squares with minimum norm.
Eigen::VectorXd weights_of(const TriangulatedSurface& horizon, const std::vector<Index>& sheet,
                           std::span<const FittedTop* const> tops, std::span<const Hit> hits, double reach) {
  const auto n = static_cast<Eigen::Index>(tops.size());
  Eigen::MatrixXd moves = Eigen::MatrixXd::Zero(n, n);
  Eigen::VectorXd misfits(n);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Hit& hit = hits[static_cast<std::size_t>(i)];
    const Triangle& t = horizon.triangles[hit.triangle];
    misfits[i] = tops[static_cast<std::size_t>(i)]->place.z - hit.height;
    for (Eigen::Index j = 0; j < n; ++j) {
      const auto of = static_cast<std::size_t>(j);
      if (sheet[t[0]] != sheet[horizon.triangles[hits[of].triangle][0]]) continue;
      for (std::size_t k = 0; k < 3; ++k)
        moves(i, j) += hit.shares[k] * wendland(distance_in_map(horizon.points[t[k]], tops[of]->place) / reach);
    }
  }
  return moves.completeOrthogonalDecomposition().solve(misfits);
}

}  // namespace

std::vector<WellTop> read_tops(const std::filesystem::path& file) {
  const InputFile input = load_input_file(file);
  LineReader lines(input);
  std::optional<TopColumns> columns;
  Separation separation;
  std::vector<WellTop> tops;
  while (lines.next()) {
    if (says_nothing(lines.line())) continue;
    if (!columns) {
      separation.delimiter = ' ';
      for (const char c : {';', '\t', ','})
        if (separation.delimiter == ' ' && lines.line().find(c) != std::string_view::npos) separation.delimiter = c;
      columns = columns_of(lines, separation);
      continue;
    }
    const std::vector<std::string_view> fields = separation.split(lines.line());
    if (fields.size() <= std::max({columns->well, columns->horizon, columns->depth}))
      lines.fail("a well, a horizon and a depth were expected");
    WellTop top{std::string(fields[columns->well]), std::string(fields[columns->horizon]), 0, lines.number()};
    top.depth = finite_number(lines, fields[columns->depth], "depth of a top");
    tops.push_back(std::move(top));
  }
  if (!columns) input.fail("a table with the columns well, horizon and depth was expected; the file holds no line");
  return tops;
}

std::optional<Vec3> place_on_path(const std::vector<Vec3>& path, double depth, bool height) {
  double before = 0;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) {
    const Vec3 way = path[i + 1] - path[i];
    const double length = norm(way);
    const double from = height ? path[i].z : before, to = height ? path[i + 1].z : before + length;
    before += length;
    if (from == depth) return path[i];
    if (to == depth) return path[i + 1];
    if ((from < depth) == (depth < to)) return path[i] + ((depth - from) / (to - from)) * way;
  }
  return std::nullopt;
}

double misfit_of(const Vec3& place, std::span<const Vec3> points, std::span<const Triangle> triangles) {
  return place.z - nearest_hit(place, points, triangles).height;
}

void fit_to_tops(TriangulatedSurface& horizon, std::span<FittedTop> tops, double reach) {
  if (!(reach > 0)) reach = usual_reach(horizon);
  std::vector<const FittedTop*> known;
  std::vector<Hit> hits;
  for (FittedTop& top : tops) {
    const Hit hit = nearest_hit(top.place, horizon.points, horizon.triangles);
    top.misfit_given = top.misfit_fitted = top.place.z - hit.height;
    if (hit.triangle == no_index) continue;
    known.push_back(&top);
    hits.push_back(hit);
  }
  if (known.empty()) return;
  const std::vector<Index> sheet = sheet_of_points(horizon);
  const Eigen::VectorXd weights = weights_of(horizon, sheet, known, hits, reach);
  std::vector<double> move(horizon.points.size(), 0);
  for (std::size_t j = 0; j < known.size(); ++j) {
    const Index own = sheet[horizon.triangles[hits[j].triangle][0]];
    for (std::size_t v = 0; v < move.size(); ++v)
      if (sheet[v] == own)
        move[v] += weights[static_cast<Eigen::Index>(j)] *
                   wendland(distance_in_map(horizon.points[v], known[j]->place) / reach);
  }
  for (std::size_t v = 0; v < move.size(); ++v) horizon.points[v].z += move[v];
  for (FittedTop& top : tops) top.misfit_fitted = misfit_of(top.place, horizon.points, horizon.triangles);
}

}  // namespace geomesh::geomodel
