// SPDX-License-Identifier: GPL-3.0-or-later
#include "recovery_families.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "corpus_builder.hpp"

namespace geomesh::test {

namespace {

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  double unit() { return (static_cast<double>(random_()) + 0.5) / 4294967296.0; }
  std::size_t below(std::size_t n) { return random_() % n; }

 private:
  std::mt19937 random_;
};

double on_grid(double x) { return std::ldexp(std::round(std::ldexp(x, 32)), -32); }

using Outline = std::vector<Vec3>;  // z = 0

/// At random angles that keep a third of their mean distance. Counter-clockwise.
Outline ellipse(Dice& dice, unsigned n, double a, double b) {
  Outline out;
  for (unsigned i = 0; i < n; ++i) {
    const double angle = 2 * std::numbers::pi * (i + 0.66 * dice.unit()) / n;
    out.push_back({on_grid(a * std::cos(angle)), on_grid(b * std::sin(angle)), 0});
  }
  return out;
}

double area(const Outline& outline) {
  double sum = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const Vec3 &p = outline[i], &q = outline[(i + 1) % outline.size()];
    sum += p.x * q.y - p.y * q.x;
  }
  return sum / 2;
}

/// Corners as rows of an outline.
using Cap = std::vector<Triangle>;

/// From vertex `start` on, from side to side.
Cap zigzag(VertexIndex n, VertexIndex start) {
  Cap out;
  VertexIndex low = 0, high = n - 1;
  const auto row = [&](VertexIndex i) { return (i + start) % n; };
  for (bool from_low = true; low + 1 < high; from_low = !from_low) {
    const VertexIndex apex = from_low ? low + 1 : high - 1;
    out.push_back({row(low), row(apex), row(high)});
    (from_low ? low : high) = apex;
  }
  return out;
}

/// A convex polygon, cut at a random apex again and again.
Cap random_ears(Dice& dice, VertexIndex n) {
  Cap out;
  std::vector<std::array<VertexIndex, 2>> open{{0, n - 1}};
  while (!open.empty()) {
    const auto [a, b] = open.back();
    open.pop_back();
    if (b - a < 2) continue;
    const auto c = static_cast<VertexIndex>(a + 1 + dice.below(b - a - 1));
    out.push_back({a, c, b});
    open.push_back({a, c});
    open.push_back({c, b});
  }
  return out;
}

/// Between an outer outline and a hole about the same centre of as many points, with rows from n on: quadrilaterals,
/// each cut along one of its diagonals at random.
Cap ring(Dice& dice, VertexIndex n) {
  Cap out;
  for (VertexIndex i = 0; i < n; ++i) {
    const VertexIndex next = (i + 1) % n;
    if (dice.unit() < 0.5) {
      out.push_back({i, next, n + next});
      out.push_back({i, n + next, n + i});
    } else {
      out.push_back({i, next, n + i});
      out.push_back({next, n + next, n + i});
    }
  }
  return out;
}

class PlateMaker {
 public:
  explicit PlateMaker(const PlateOptions& options) : options_(options), dice_(options.seed) {}

  FamilyModel make() {
    outline_ = ellipse(dice_, options_.n, 2, 1);
    Outline hole;
    if (options_.has_hole)
      for (const Vec3& p : outline_) hole.push_back({on_grid(0.5 * p.x), on_grid(0.5 * p.y), 0});
    for (unsigned layer = 0; layer <= options_.layers; ++layer) {
      add_cap(outline_, hole, layer);
      if (layer == options_.layers) continue;
      add_walls(outline_, layer);
      if (!hole.empty()) add_walls(hole, layer);
    }
    model_.plc = std::move(builder_.plc);
    model_.volume = height(options_.layers) * (area(outline_) - area(hole));
    static const char* const names[] = {"zigzag", "turned_zigzag", "random_ears"};
    model_.name = std::string("plate_") + names[static_cast<int>(options_.triangles)] + "_" +
                  std::to_string(options_.n) + "x" + std::to_string(options_.layers);
    if (options_.has_hole) model_.name += "_hole";
    if (options_.is_tilted) model_.name += "_tilted";
    model_.name += "_" + std::to_string(options_.seed);
    return std::move(model_);
  }

 private:
  double height(unsigned layer) const { return layer * on_grid(options_.thickness); }
  Vec3 place(const Vec3& p, unsigned layer) const {
    const double z = height(layer);
    return options_.is_tilted ? Vec3{p.x, p.y, z + p.x - 3 * p.y} : Vec3{p.x, p.y, z};
  }

  void add_cap(const Outline& outer, const Outline& hole, unsigned layer) {
    const auto n = static_cast<VertexIndex>(outer.size());
    Outline both = outer;
    both.insert(both.end(), hole.begin(), hole.end());
    Cap cap;
    if (!hole.empty())
      cap = ring(dice_, n);
    else if (options_.triangles == CapTriangles::random_ears)
      cap = random_ears(dice_, n);
    else
      cap = zigzag(n, options_.triangles == CapTriangles::turned_zigzag && layer % 2 ? n / 4 : 0);
    for (const Triangle& t : cap)
      builder_.triangle(place(both[t[0]], layer), place(both[t[1]], layer), place(both[t[2]], layer));
  }

  void add_walls(const Outline& outline, unsigned layer) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
      const Vec3 &p = outline[i], &q = outline[(i + 1) % outline.size()];
      builder_.triangle(place(p, layer), place(q, layer), place(q, layer + 1));
      builder_.triangle(place(p, layer), place(q, layer + 1), place(p, layer + 1));
    }
  }

  const PlateOptions options_;
  Dice dice_;
  Outline outline_;
  PlcBuilder builder_;
  FamilyModel model_;
};

}  // namespace

FamilyModel plate_of_needles(const PlateOptions& options) { return PlateMaker(options).make(); }

FamilyModel crossing_fans(unsigned seed, unsigned n, double gap) {
  Dice dice(seed);
  PlcBuilder builder;
  builder.box({-0.5, -0.75, -0.5}, {1.5, 0.75, 0.5});
  for (const double side : {0.0, 1.0}) {
    const auto rough = [&] { return (side - 0.5) * gap + (dice.unit() - 0.5) * gap / 3; };
    const Vec3 apex{side, 0, rough()};
    const double far = 1 - side;
    std::vector<Vec3> rim;
    for (unsigned i = 0; i <= n; ++i) rim.push_back({far, (i + 0.8 * (dice.unit() - 0.5)) / n - 0.5, rough()});
    for (unsigned i = 0; i < n; ++i) builder.triangle(apex, rim[i], rim[i + 1]);
  }
  return {"fans_" + std::to_string(n) + "_" + std::to_string(seed), std::move(builder.plc), 2 * 1.5 * 1};
}

FamilyModel flat_sheets(unsigned n, unsigned cells, double gap) {
  PlcBuilder builder;
  const double height = n * gap;
  builder.box({-0.25, -0.25, -0.25 - height / 2}, {1.25, 1.25, 0.25 + height / 2});
  for (unsigned k = 0; k < n; ++k) {
    const auto at = [&](unsigned i, unsigned j) {
      return Vec3{static_cast<double>(i) / cells, static_cast<double>(j) / cells, (k + 0.5) * gap - height / 2};
    };
    for (unsigned i = 0; i < cells; ++i)
      for (unsigned j = 0; j < cells; ++j) {
        builder.triangle(at(i, j), at(i + 1, j), at(i + 1, j + 1));
        builder.triangle(at(i, j), at(i + 1, j + 1), at(i, j + 1));
      }
  }
  return {"sheets_" + std::to_string(n) + "x" + std::to_string(cells), std::move(builder.plc),
          1.5 * 1.5 * (0.5 + height)};
}

FamilyModel points_on_line(unsigned n) {
  PlcBuilder builder;
  builder.box({-1, -1, -1}, {2, 2, 2});
  for (unsigned i = 0; i < n; ++i) {
    const double t = std::ldexp(i, -20);
    builder.isolated_point({t, 0.5 * t, 0.25 * t});
  }
  return {"line_" + std::to_string(n), std::move(builder.plc), 27};
}

double volume_of(const ConstrainedTetrahedralization& mesh) {
  double sum = 0;
  for (const Tetrahedron& t : mesh.tetrahedra) {
    const Vec3& o = mesh.points[t[0]];
    sum += dot(cross(mesh.points[t[1]] - o, mesh.points[t[2]] - o), mesh.points[t[3]] - o) / 6;
  }
  return sum;
}

namespace {

/// The i-th of ModelFamily::n_models sizes in geometric progression.
unsigned size_of(unsigned i, double first, double last) {
  return static_cast<unsigned>(std::round(first * std::pow(last / first, i / (ModelFamily::n_models - 1.0))));
}

FamilyModel plate(unsigned i) {
  PlateOptions options;
  options.seed = i;
  options.n = size_of(i, 100, 20000);
  options.triangles = static_cast<CapTriangles>(i % 3);
  options.thickness = std::pow(0.1, 1 + i % 4 % 3);
  options.layers = 1 + i % 5 % 3;
  options.has_hole = i % 7 == 3;
  options.is_tilted = i % 2 == 1;
  return plate_of_needles(options);
}

FamilyModel fans(unsigned i) { return crossing_fans(i, size_of(i, 10, 2000), std::pow(0.1, 1 + i % 3)); }

FamilyModel sheets(unsigned i) {
  return flat_sheets(size_of(i, 2, 200), 4 + i % 4 * 4, std::pow(10.0, -6 + i * 11 % 50 * 6 / 49.0));
}

FamilyModel line(unsigned i) { return points_on_line(size_of(i, 100, 100000)); }

}  // namespace

const std::vector<ModelFamily>& model_families() {
  static const std::vector<ModelFamily> families{
      {"plates", plate}, {"fans", fans}, {"sheets", sheets}, {"lines", line}};
  return families;
}

}  // namespace geomesh::test
