// SPDX-License-Identifier: MIT
/// @file
/// Decides cases that a semi-static filter leaves open: first by a dynamic filter, whose bound follows from the
/// magnitudes of the terms, then by the exact sign with expansions. For use inside the core; other callers use
/// geomesh/core/predicates.hpp.
#pragma once

#include <cstddef>

#include "geomesh/core/geometry.hpp"

namespace geomesh::exact {

/// Exact signs of the predicates, in the conventions of predicates.hpp. Each function first tries differences of
/// coordinates, which are often exact for points near each other, and otherwise uses the coordinates themselves.
Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy);
Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
Sign in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace geomesh::exact

namespace geomesh::detail {

/// Apply the dynamic filter, then exact arithmetic. `exact_calls` counts undecided dynamic filters.
Sign orient3d_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, std::size_t& exact_calls);
Sign in_sphere_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                            std::size_t& exact_calls);

/// Returns the sign of in_sphere_perturbed for points whose unperturbed in-sphere determinant is zero.
Sign in_sphere_tie(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace geomesh::detail
