// SPDX-License-Identifier: MIT
#include "quality/measure/cell_quality.hpp"

namespace geomesh::remesh {

namespace {

template <class Measure>
double shape_by(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& p) {
  return shape_of_cell<Measure>(a, b, c, p);
}

/// Appends the gradient of a measure that is one smooth term.
template <class Measure>
void append_gradient(const std::array<Vec3, 3>& face, const Vec3& p, double limit, std::vector<Vec3>& out) {
  const auto base = base_of(place<double>(face[0]), place<double>(face[1]), place<double>(face[2]));
  const auto apex = apex_over(base, place<double>(p));
  if (!(apex.det > 0)) return;
  const double value = Measure::value(base, apex);
  if (value > limit) return;
  const Vectors<double> g = Measure::gradient(base, apex, value);
  out.push_back({g.x, g.y, g.z});
}

/// Returns the function that appends the gradients of the measure: one for each of its terms, or the only one.
template <class Measure>
constexpr auto gradients_by() {
  if constexpr (requires { &Measure::append_gradients; })
    return &Measure::append_gradients;
  else
    return &append_gradient<Measure>;
}

}  // namespace

template <class Measure>
struct CellQuality::RulesOf {
  static constexpr Rules entry{shape_by<Measure>,        gradients_by<Measure>(), Measure::of_angle,
                               Measure::most_with_angle, Measure::poor,           Measure::largest};
};

const std::array<CellQuality::Rules, n_quality_measures> CellQuality::rules =
    QualityMeasures::table<CellQuality::Rules, CellQuality::RulesOf>();

CellQuality::CellQuality(QualityMeasure measure)
    : measure_(measure),
      rules_(&rules[static_cast<std::size_t>(measure)]),
      kernels_(&link_kernels(measure)),
      poor_(rules_->poor),
      bad_(rules_->of_angle(bad_angle)),
      largest_(rules_->largest) {}

}  // namespace geomesh::remesh
