// SPDX-License-Identifier: MIT
#include "models.hpp"

#include <array>
#include <cmath>
#include <map>

namespace geomesh::corpus {

namespace {

constexpr double pi = 3.14159265358979323846;

using Quad = std::array<VertexIndex, 4>;

VertexIndex add(PiecewiseLinearComplex& plc, const Vec3& p) {
  plc.points.push_back(p);
  return static_cast<VertexIndex>(plc.points.size() - 1);
}
void add_polygon(PiecewiseLinearComplex& plc, std::vector<VertexIndex> loop) {
  const std::vector<std::vector<VertexIndex>> loops(1, std::move(loop));
  plc.add_polygon(loops);
}

/// The eight corners, bit i of the row telling the side in axis i.
std::array<VertexIndex, 8> add_corners(PiecewiseLinearComplex& plc, const Vec3& lo, const Vec3& hi) {
  std::array<VertexIndex, 8> out{};
  for (unsigned i = 0; i < 8; ++i) out[i] = add(plc, {i & 1 ? hi.x : lo.x, i & 2 ? hi.y : lo.y, i & 4 ? hi.z : lo.z});
  return out;
}
constexpr std::array<Quad, 6> box_sides{{{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}};
void add_box(PiecewiseLinearComplex& plc, const Vec3& lo, const Vec3& hi) {
  const auto c = add_corners(plc, lo, hi);
  for (const Quad& q : box_sides) add_polygon(plc, {c[q[0]], c[q[1]], c[q[2]], c[q[3]]});
}

/// A sphere by subdivided octahedron, triangles outward.
void add_sphere(PiecewiseLinearComplex& plc, const Vec3& centre, double radius, unsigned levels) {
  std::vector<Vec3> v{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triangle> t{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (unsigned level = 0; level < levels; ++level) {
    std::map<std::array<VertexIndex, 2>, VertexIndex> middle;
    const auto split = [&](VertexIndex a, VertexIndex b) {
      const std::array<VertexIndex, 2> key{std::min(a, b), std::max(a, b)};
      const auto [it, is_new] = middle.try_emplace(key, static_cast<VertexIndex>(v.size()));
      if (is_new) {
        const Vec3 m = v[a] + v[b];
        v.push_back((1 / std::sqrt(dot(m, m))) * m);
      }
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const Triangle& f : t) {
      const VertexIndex a = split(f[0], f[1]), b = split(f[1], f[2]), c = split(f[2], f[0]);
      for (const Triangle& s : {Triangle{f[0], a, c}, Triangle{a, f[1], b}, Triangle{c, b, f[2]}, Triangle{a, b, c}}) finer.push_back(s);
    }
    t = finer;
  }
  const VertexIndex first = static_cast<VertexIndex>(plc.points.size());
  for (const Vec3& p : v) add(plc, centre + radius * p);
  for (const Triangle& f : t) plc.add_triangle({first + f[0], first + f[1], first + f[2]});
}

}  // namespace

Model schonhardt(double degrees, bool in_box) {
  Model out{"schonhardt_" + std::to_string(static_cast<int>(degrees)) + (in_box ? "_in_box" : ""), {}, 0, in_box ? 2u : 1u};
  std::array<VertexIndex, 6> v{};
  for (unsigned i = 0; i < 6; ++i) {
    const double a = (120.0 * i + (i < 3 ? 0 : degrees)) * pi / 180;
    v[i] = add(out.plc, {std::cos(a), std::sin(a), i < 3 ? 0.0 : 1.0});
  }
  out.plc.add_triangle({v[0], v[2], v[1]});
  out.plc.add_triangle({v[3], v[4], v[5]});
  // The diagonals that make the side faces bend inwards.
  for (unsigned i = 0; i < 3; ++i) {
    const unsigned j = (i + 1) % 3;
    out.plc.add_triangle({v[i], v[j], v[j + 3]});
    out.plc.add_triangle({v[i], v[j + 3], v[i + 3]});
  }
  if (in_box) {
    add_box(out.plc, {-2, -2, -1}, {2, 2, 2});
    out.volume = 48;
  }
  return out;
}

Model chazelle(unsigned n) {
  Model out{"chazelle_" + std::to_string(n), {}, 0, 1};
  const double m = n + 1, top = m * m + 1, gap = 0.01;
  add_box(out.plc, {0, 0, -1}, {m, m, top});
  for (unsigned i = 1; i <= n; ++i) {
    const double x = i;
    const VertexIndex a = add(out.plc, {x, 0.5, -0.5});
    add(out.plc, {x, m - 0.5, -0.5});
    add(out.plc, {x, m - 0.5, x * (m - 0.5)});
    add(out.plc, {x, 0.5, x * 0.5});
    add_polygon(out.plc, {a, a + 1, a + 2, a + 3});
  }
  for (unsigned i = 1; i <= n; ++i) {
    const double y = i;
    const VertexIndex a = add(out.plc, {0.5, y, top - 0.5});
    add(out.plc, {m - 0.5, y, top - 0.5});
    add(out.plc, {m - 0.5, y, y * (m - 0.5) + gap});
    add(out.plc, {0.5, y, y * 0.5 + gap});
    add_polygon(out.plc, {a, a + 1, a + 2, a + 3});
  }
  out.volume = m * m * (top + 1);
  return out;
}

Model pyramids_and_block() {
  Model out{"pyramids_and_block", {}, 0, 9};
  PiecewiseLinearComplex& plc = out.plc;
  const VertexIndex apex = add(plc, {0, 0, 0});
  const auto block = add_corners(plc, {-1, -1, -1}, {1, 1, 1});
  add_polygon(plc, {block[0], block[2], block[3], block[1]});
  add_polygon(plc, {block[4], block[5], block[7], block[6]});
  const std::array<Quad, 4> sides{{{1, 3, 7, 5}, {2, 6, 7, 3}, {0, 4, 6, 2}, {0, 1, 5, 4}}};
  for (unsigned k = 0; k < 4; ++k) {
    const auto turn = [&](double along, double across, double z) {
      const Vec3 p{along, across, z};
      return k == 0 ? p : k == 1 ? Vec3{-p.y, p.x, p.z} : k == 2 ? Vec3{-p.x, -p.y, p.z} : Vec3{p.y, -p.x, p.z};
    };
    std::array<VertexIndex, 4> waist{}, base{};
    const std::array<std::array<double, 2>, 4> corner{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};
    for (unsigned i = 0; i < 4; ++i) {
      waist[i] = add(plc, turn(1, 0.5 * corner[i][0], 0.5 * corner[i][1]));
      base[i] = add(plc, turn(4, 2 * corner[i][0], 2 * corner[i][1]));
    }
    for (unsigned i = 0; i < 4; ++i) {
      const unsigned j = (i + 1) % 4;
      plc.add_triangle({apex, waist[i], waist[j]});
      add_polygon(plc, {waist[i], base[i], base[j], waist[j]});
    }
    add_polygon(plc, {base[0], base[1], base[2], base[3]});
    add_polygon(plc, {waist[0], waist[1], waist[2], waist[3]});
    const Quad& q = sides[k];
    plc.add_polygon(std::vector<std::vector<VertexIndex>>{{block[q[0]], block[q[1]], block[q[2]], block[q[3]]},
                                                         {waist[0], waist[1], waist[2], waist[3]}});
  }
  // The block, and the four pyramids' parts outside it: 1/3 (16 * 4 - 1 * 1) each.
  out.volume = 8 + 4 * (16.0 * 4 - 1) / 3;
  return out;
}

Model fan_of_segments(unsigned n) {
  Model out{"fan_" + std::to_string(n), {}, 0, 1};
  const VertexIndex centre = add(out.plc, {0, 0, 0.3}), top = add(out.plc, {0.1, -0.2, 3});
  for (unsigned i = 0; i < n; ++i) {
    const double a = 2 * pi * i / n, r = i % 3 == 0 ? 1.0 : i % 3 == 1 ? 2.3 : 0.4;
    add(out.plc, {r * std::cos(a), r * std::sin(a), 0.11 * ((i * 7) % 5)});
  }
  for (unsigned i = 0; i < n; ++i) {
    const VertexIndex a = 2 + i, b = 2 + (i + 1) % n;
    out.plc.add_triangle({centre, b, a});
    out.plc.add_triangle({top, a, b});
  }
  return out;
}

Model wedge(double angle) {
  Model out{"wedge", {}, 1, 3};
  PiecewiseLinearComplex& plc = out.plc;
  const double z0 = 0.25, z1 = 0.25 + std::tan(angle);
  const auto c = add_corners(plc, {0, 0, 0}, {1, 1, 1});
  const VertexIndex p0 = add(plc, {0, 0, z0}), p1 = add(plc, {0, 1, z0}), q0 = add(plc, {1, 0, z0}), q1 = add(plc, {1, 1, z0});
  const VertexIndex r0 = add(plc, {1, 0, z1}), r1 = add(plc, {1, 1, z1});
  add_polygon(plc, {p0, q0, q1, p1});
  add_polygon(plc, {p0, r0, r1, p1});
  add_polygon(plc, {c[0], c[2], c[3], c[1]});
  add_polygon(plc, {c[4], c[5], c[7], c[6]});
  add_polygon(plc, {c[0], p0, p1, c[2]});
  add_polygon(plc, {p0, c[4], c[6], p1});
  add_polygon(plc, {c[1], c[3], q1, q0});
  add_polygon(plc, {q0, q1, r1, r0});
  add_polygon(plc, {r0, r1, c[7], c[5]});
  const auto side = [&](VertexIndex c0, VertexIndex c1, VertexIndex c5, VertexIndex c4, VertexIndex p, VertexIndex q, VertexIndex r) {
    add_polygon(plc, {c0, c1, q, p});
    plc.add_triangle({p, q, r});
    add_polygon(plc, {p, r, c5, c4});
  };
  side(c[0], c[1], c[5], c[4], p0, q0, r0);
  side(c[2], c[3], c[7], c[6], p1, q1, r1);
  return out;
}

Model close_triangles() {
  Model out{"close_triangles", {}, 8, 1};
  add_box(out.plc, {9999, 9999, 9999}, {10001, 10001, 10001});
  for (const double z : {10000.0, 10000.0000001}) {
    const VertexIndex a = add(out.plc, {9999.5, 9999.5, z});
    add(out.plc, {10000.5, 9999.6, z});
    add(out.plc, {10000, 10000.5, z});
    out.plc.add_triangle({a, a + 1, a + 2});
  }
  return out;
}

Model nested_spheres(unsigned n_shells) {
  Model out{"nested_spheres", {}, 0, n_shells};
  for (unsigned i = 0; i < n_shells; ++i) add_sphere(out.plc, {0, 0, 0}, 1 - 0.2 * i, 3);
  return out;
}

Model touching_spheres() {
  Model out{"touching", {}, 0, 0};
  PiecewiseLinearComplex& plc = out.plc;
  const auto octahedron = [&](const std::array<VertexIndex, 6>& v) {
    for (const Triangle& t : {Triangle{0, 2, 4}, Triangle{2, 1, 4}, Triangle{1, 3, 4}, Triangle{3, 0, 4}, Triangle{2, 0, 5}, Triangle{1, 2, 5},
                              Triangle{3, 1, 5}, Triangle{0, 3, 5}})
      plc.add_triangle({v[t[0]], v[t[1]], v[t[2]]});
  };
  const VertexIndex shared = add(plc, {1, 0, 0});
  octahedron({shared, add(plc, {-1, 0, 0}), add(plc, {0, 1, 0}), add(plc, {0, -1, 0}), add(plc, {0, 0, 1}), add(plc, {0, 0, -1})});
  octahedron({add(plc, {3, 0, 0}), shared, add(plc, {2, 1, 0}), add(plc, {2, -1, 0}), add(plc, {2, 0, 1}), add(plc, {2, 0, -1})});
  // Two tetrahedra on one edge.
  const VertexIndex a = add(plc, {10, 0, 0}), b = add(plc, {10, 0, 2});
  for (const double side : {1.0, -1.0}) {
    const VertexIndex c = add(plc, {10 + side, -0.5, 1}), d = add(plc, {10 + side, 0.5, 1});
    for (const Triangle& t : {Triangle{a, b, c}, Triangle{a, b, d}, Triangle{a, c, d}, Triangle{b, c, d}}) plc.add_triangle(t);
  }
  out.volume = 2 * 4.0 / 3 + 2 * (1.0 * 1 * 2) / 6;
  out.n_components = 4;
  return out;
}

Model hanging_facet() {
  Model out{"hanging_facet", {}, 64, 1};
  add_box(out.plc, {0, 0, 0}, {4, 4, 4});
  // Its lower edge lies inside the bottom.
  const VertexIndex a = add(out.plc, {1, 1.5, 0}), b = add(out.plc, {3, 2.2, 0}), c = add(out.plc, {2.9, 2.1, 3}), d = add(out.plc, {1.2, 1.5, 2.5});
  out.plc.facet_segments.push_back({0, a, b});
  out.plc.add_triangle({a, b, c});
  out.plc.add_triangle({a, c, d});
  return out;
}

Model well_and_vertex() {
  Model out{"well_and_vertex", {}, 64, 1};
  add_box(out.plc, {0, 0, 0}, {4, 4, 4});
  const VertexIndex a = add(out.plc, {1, 1, 3.5}), b = add(out.plc, {3, 2.5, 0.5});
  out.plc.segments.push_back({a, b, 7});
  out.plc.isolated_points.push_back(add(out.plc, {2, 3, 2}));
  for (unsigned i = 0; i < 12; ++i) {
    // Vertices close about the well, so that it is missing at first.
    const double t = (i + 0.5) / 12, angle = 2.4 * i;
    const Vec3 p = Vec3{1, 1, 3.5} + t * Vec3{2, 1.5, -3};
    out.plc.isolated_points.push_back(add(out.plc, p + Vec3{0.01 * std::cos(angle), 0.01 * std::sin(angle), 0}));
  }
  return out;
}

Model lattice(unsigned n) {
  Model out{"lattice_" + std::to_string(n), {}, static_cast<double>(n * n * n), n * n * n};
  const auto row = [n](unsigned i, unsigned j, unsigned k) { return static_cast<VertexIndex>((i * (n + 1) + j) * (n + 1) + k); };
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= n; ++j)
      for (unsigned k = 0; k <= n; ++k) add(out.plc, {1.0 * i, 1.0 * j, 1.0 * k});
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j < n; ++j)
      for (unsigned k = 0; k < n; ++k) {
        add_polygon(out.plc, {row(i, j, k), row(i, j + 1, k), row(i, j + 1, k + 1), row(i, j, k + 1)});
        add_polygon(out.plc, {row(j, i, k), row(j + 1, i, k), row(j + 1, i, k + 1), row(j, i, k + 1)});
        add_polygon(out.plc, {row(j, k, i), row(j + 1, k, i), row(j + 1, k + 1, i), row(j, k + 1, i)});
      }
  return out;
}

Model coplanar_stack(unsigned n) {
  Model out{"coplanar_stack_" + std::to_string(n), {}, static_cast<double>(n), n};
  PiecewiseLinearComplex& plc = out.plc;
  for (unsigned i = 0; i <= n; ++i)
    for (const auto& [x, y] : {std::array{0.0, 0.0}, std::array{1.0, 0.0}, std::array{1.0, 1.0}, std::array{0.0, 1.0}}) add(plc, {x, y, 1.0 * i});
  for (unsigned i = 0; i <= n; ++i) add_polygon(plc, {4 * i, 4 * i + 1, 4 * i + 2, 4 * i + 3});
  for (unsigned i = 0; i < n; ++i)
    for (unsigned k = 0; k < 4; ++k) {
      const VertexIndex a = 4 * i + k, b = 4 * i + (k + 1) % 4;
      // As triangles, with diagonals that alternate.
      if ((i + k) % 2 == 0) {
        plc.add_triangle({a, b, b + 4});
        plc.add_triangle({a, b + 4, a + 4});
      } else {
        plc.add_triangle({a, b, a + 4});
        plc.add_triangle({b, b + 4, a + 4});
      }
    }
  return out;
}

Model pinching_layers(unsigned n) {
  Model out{"pinching_layers_" + std::to_string(n), {}, 0, 0};
  PiecewiseLinearComplex& plc = out.plc;
  constexpr unsigned n_sheets = 4;  // bottom, two horizons that meet in places, top
  std::vector<VertexIndex> row(n_sheets * (n + 1) * (n + 1));
  const auto at = [&](unsigned s, unsigned i, unsigned j) -> VertexIndex& { return row[(s * (n + 1) + i) * (n + 1) + j]; };
  for (unsigned i = 0; i <= n; ++i)
    for (unsigned j = 0; j <= n; ++j) {
      const double x = 1.0 * i / n, y = 1.0 * j / n;
      const double mid = 0.5 + 0.05 * std::sin(5 * x) * std::cos(4 * y);
      const double thickness = std::max(0.0, 0.03 * std::sin(6 * x + 2 * y));
      at(0, i, j) = add(plc, {x, y, 0});
      at(1, i, j) = add(plc, {x, y, mid});
      at(2, i, j) = thickness > 0 ? add(plc, {x, y, mid + thickness}) : at(1, i, j);
      at(3, i, j) = add(plc, {x, y, 1});
    }
  std::map<Triangle, bool> seen;
  const auto triangle = [&](VertexIndex a, VertexIndex b, VertexIndex c) {
    if (a == b || b == c || c == a) return;
    Triangle key{a, b, c};
    if (key[0] > key[1]) std::swap(key[0], key[1]);
    if (key[1] > key[2]) std::swap(key[1], key[2]);
    if (key[0] > key[1]) std::swap(key[0], key[1]);
    if (seen.emplace(key, true).second) plc.add_triangle({a, b, c});
  };
  for (unsigned s = 0; s < n_sheets; ++s)
    for (unsigned i = 0; i < n; ++i)
      for (unsigned j = 0; j < n; ++j) {
        triangle(at(s, i, j), at(s, i + 1, j), at(s, i + 1, j + 1));
        triangle(at(s, i, j), at(s, i + 1, j + 1), at(s, i, j + 1));
      }
  for (unsigned s = 0; s + 1 < n_sheets; ++s)
    for (unsigned i = 0; i < n; ++i)
      for (const unsigned e : {0u, n}) {
        for (const bool along_x : {true, false}) {
          const VertexIndex a = along_x ? at(s, i, e) : at(s, e, i), b = along_x ? at(s, i + 1, e) : at(s, e, i + 1);
          const VertexIndex c = along_x ? at(s + 1, i + 1, e) : at(s + 1, e, i + 1), d = along_x ? at(s + 1, i, e) : at(s + 1, e, i);
          triangle(a, b, c);
          triangle(a, c, d);
        }
      }
  out.volume = 1;
  return out;
}

std::vector<Model> all_models() {
  std::vector<Model> out;
  for (const double degrees : {5.0, 30.0, 45.0, 59.0}) {
    out.push_back(schonhardt(degrees, false));
    out.push_back(schonhardt(degrees, true));
  }
  out.push_back(chazelle(2));
  out.push_back(chazelle(4));
  out.push_back(pyramids_and_block());
  out.push_back(fan_of_segments(30));
  for (const double angle : {pi / 6, pi / 180, 1e-4, 1e-6}) out.push_back(wedge(angle));
  out.push_back(close_triangles());
  out.push_back(nested_spheres(3));
  out.push_back(touching_spheres());
  out.push_back(hanging_facet());
  out.push_back(well_and_vertex());
  out.push_back(lattice(4));
  out.push_back(coplanar_stack(8));
  out.push_back(pinching_layers(16));
  return out;
}

Model placed(const Model& model, const Placement& placement) {
  Model out = model;
  out.name += "/" + placement.name;
  for (Vec3& p : out.plc.points) p = placement.place(p);
  out.volume *= placement.volume_factor;
  return out;
}

std::vector<Placement> placements() {
  const auto turned = [](const Vec3& p) {
    const double a = 0.7318, b = 1.1173, ca = std::cos(a), sa = std::sin(a), cb = std::cos(b), sb = std::sin(b);
    const Vec3 q{ca * p.x - sa * p.y, sa * p.x + ca * p.y, p.z};
    return Vec3{q.x, cb * q.y - sb * q.z, sb * q.y + cb * q.z};
  };
  const auto to_utm = [](const Vec3& p) { return p + Vec3{549123.4, 7820456.7, -2345.6}; };
  const auto flat = [](const Vec3& p) { return Vec3{p.x, p.y, 1e-4 * p.z}; };
  return {{"turned", turned, 1, false},
          {"utm", to_utm, 1, false},
          {"turned_utm", [=](const Vec3& p) { return to_utm(turned(p)); }, 1, false},
          {"flat", flat, 1e-4, false}};
}

}  // namespace geomesh::corpus
