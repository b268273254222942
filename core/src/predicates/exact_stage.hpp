// SPDX-License-Identifier: MIT
/// @file
/// What follows where a semi-static filter is not certain. First a dynamic filter, bound from the terms' own
/// magnitudes, then the exact sign by expansions. Inside the core only; callers elsewhere use
/// geomesh/core/predicates.hpp.
#pragma once

#include <cstddef>

#include "geomesh/core/geometry.hpp"

namespace geomesh::exact {

/// Exact signs in the conventions of predicates.hpp. Each first tries differences that happen to be exact (they are
/// where points are near each other), then works on the coordinates themselves.
Sign orient2d(double ax, double ay, double bx, double by, double cx, double cy);
Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
Sign in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace geomesh::exact

namespace geomesh::detail {

/// Dynamic filter, then exact; `exact_calls` grows by one where the dynamic filter is not certain either.
Sign orient3d_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, std::size_t& exact_calls);
Sign in_sphere_after_filter(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e,
                            std::size_t& exact_calls);

/// Sign of in_sphere_perturbed given that the unperturbed one is zero.
Sign in_sphere_tie(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

}  // namespace geomesh::detail
