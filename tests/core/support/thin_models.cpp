// SPDX-License-Identifier: GPL-3.0-or-later
#include "thin_models.hpp"

#include <algorithm>
#include <cmath>
#include <random>
#include <stdexcept>

#include "corpus_builder.hpp"
#include "corpus_models.hpp"
#include "corpus_transform.hpp"
#include "plc/find_crossing.hpp"

namespace geomesh::test {

namespace {

constexpr double far_out = 0x1p52;

class Dice {
 public:
  explicit Dice(unsigned seed) : random_(seed) {}
  /// A whole number from low to high.
  double whole(double low, double high) {
    const double part = static_cast<double>(random_()) * 0x1p-32;
    return low + std::floor(part * (high - low + 1));
  }
  bool heads() { return random_() & 0x10000u; }

 private:
  std::mt19937 random_;
};

PiecewiseLinearComplex slits(Dice& dice, unsigned ulps) {
  const char* names[] = {"chazelle_2", "chazelle_2", "chazelle_4", "chazelle_8"};
  return in_ulps(names[static_cast<unsigned>(dice.whole(0, 3))], std::max(64u, ulps));
}

/// Rows and columns of one sheet, before the shear.
struct Sheet {
  std::size_t n_columns, n_rows;
  std::vector<Vec3> points;
  const Vec3& at(std::size_t column, std::size_t row) const { return points[row * n_columns + column]; }
};

/// Two sheets over one rectangle. Their borders have the same x and y; inside each has its own.
class SheetPair {
 public:
  SheetPair(Dice& dice, ThinShape shape, unsigned ulps)
      : dice_(dice),
        shape_(shape),
        thickness_(ulps),
        n_columns_(static_cast<std::size_t>(dice.whole(3, 9))),
        n_rows_(static_cast<std::size_t>(dice.whole(3, 9))),
        spacing_(std::exp2(dice.whole(3, 20))) {
    const double gap = shape == ThinShape::needles ? 8 : spacing_;
    for (std::size_t i = 0; i < n_columns_; ++i) columns_.push_back(static_cast<double>(i) * gap);
    tilt_ = {dice.whole(-1, 1), dice.whole(-1, 1), 0};
  }

  PiecewiseLinearComplex make() {
    const Sheet below = sheet(-1), above = sheet(1);
    cover(below, true);
    cover(above, false);
    for (std::size_t i = 0; i + 1 < n_columns_; ++i) {
      wall(below.at(i, 0), below.at(i + 1, 0), above.at(i, 0), above.at(i + 1, 0));
      wall(below.at(i + 1, n_rows_ - 1), below.at(i, n_rows_ - 1), above.at(i + 1, n_rows_ - 1),
           above.at(i, n_rows_ - 1));
    }
    for (std::size_t j = 0; j + 1 < n_rows_; ++j) {
      wall(below.at(0, j + 1), below.at(0, j), above.at(0, j + 1), above.at(0, j));
      wall(below.at(n_columns_ - 1, j), below.at(n_columns_ - 1, j + 1), above.at(n_columns_ - 1, j),
           above.at(n_columns_ - 1, j + 1));
    }
    return std::move(builder_.plc);
  }

 private:
  /// `side`: 1 above, -1 below the middle. A wedge has its lower sheet in the middle.
  Sheet sheet(double side) {
    Sheet out{n_columns_, n_rows_, {}};
    for (std::size_t j = 0; j < n_rows_; ++j)
      for (std::size_t i = 0; i < n_columns_; ++i) {
        Vec3 p{columns_[i], static_cast<double>(j) * spacing_, 0};
        const bool is_inner_column = i > 0 && i + 1 < n_columns_, is_inner_row = j > 0 && j + 1 < n_rows_;
        if (is_inner_column && is_inner_row) {
          p.x += dice_.whole(-jitter(columns_[1]), jitter(columns_[1]));
          p.y += dice_.whole(-jitter(spacing_), jitter(spacing_));
        }
        p.z = height(i, side);
        out.points.push_back(p);
      }
    return out;
  }
  static double jitter(double gap) { return std::floor(gap / 5); }
  double height(std::size_t column, double side) {
    if (shape_ != ThinShape::wedge)
      return side > 0 ? dice_.whole(1, std::max(1.0, thickness_ - 1)) : -dice_.whole(0, 1);
    if (side < 0 || column == 0) return 0;
    const double most = std::max(1.0, std::floor(thickness_ * columns_[column] / columns_.back()));
    return dice_.whole(std::max(1.0, most - 2), most);
  }
  Vec3 placed(const Vec3& p) const {
    return {far_out + p.x, far_out + p.y, far_out + 0x1p30 + p.z + tilt_.x * p.x + tilt_.y * p.y};
  }
  void triangle(const Vec3& a, const Vec3& b, const Vec3& c) {
    if (!(a == b) && !(b == c) && !(c == a)) builder_.triangle(placed(a), placed(b), placed(c));
  }
  void cover(const Sheet& s, bool is_lower) {
    for (std::size_t j = 0; j + 1 < n_rows_; ++j)
      for (std::size_t i = 0; i + 1 < n_columns_; ++i) {
        const Vec3 &a = s.at(i, j), &b = s.at(i + 1, j), &c = s.at(i + 1, j + 1), &d = s.at(i, j + 1);
        const bool is_rising = dice_.heads();
        const std::array<Triangle, 2> halves = is_rising ? std::array<Triangle, 2>{{{0, 1, 2}, {0, 2, 3}}}
                                                         : std::array<Triangle, 2>{{{0, 1, 3}, {1, 2, 3}}};
        const std::array<Vec3, 4> corners{a, b, c, d};
        for (const Triangle& t : halves) {
          if (is_lower)
            triangle(corners[t[0]], corners[t[2]], corners[t[1]]);
          else
            triangle(corners[t[0]], corners[t[1]], corners[t[2]]);
        }
      }
  }
  /// Upright, between an edge of the lower sheet and the one above it.
  void wall(const Vec3& a, const Vec3& b, const Vec3& above_a, const Vec3& above_b) {
    triangle(a, b, above_b);
    triangle(a, above_b, above_a);
  }

  Dice& dice_;
  ThinShape shape_;
  double thickness_;
  std::size_t n_columns_, n_rows_;
  double spacing_;
  std::vector<double> columns_;
  Vec3 tilt_;
  PlcBuilder builder_;
};

}  // namespace

const char* name_of(ThinShape shape) {
  switch (shape) {
    case ThinShape::slits:
      return "slits";
    case ThinShape::plate:
      return "plate";
    case ThinShape::wedge:
      return "wedge";
    case ThinShape::needles:
      return "needles";
  }
  return "";
}

PiecewiseLinearComplex in_ulps(const char* name, double unit) {
  return mapped(as_triangles(corpus_model(name).make()), [=](const Vec3& p) {
    return Vec3{far_out + std::round(unit * p.x), far_out + std::round(unit * p.y), far_out + std::round(unit * p.z)};
  });
}

PiecewiseLinearComplex thin_model(unsigned seed, ThinShape shape, unsigned ulps) {
  Dice dice(seed);
  PiecewiseLinearComplex out = shape == ThinShape::slits ? slits(dice, ulps) : SheetPair(dice, shape, ulps).make();
  if (!validate_plc(out).empty() || find_crossing(out)) throw std::logic_error("a thin model is not valid");
  return out;
}

}  // namespace geomesh::test
