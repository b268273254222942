// SPDX-License-Identifier: MIT
/// @file
/// The two predicates that everything topological reduces to (Cavalcanti and Mello 1999, section 2: P1 in-sphere, P2
/// orientation), in 2D and 3D, exact for all finite doubles whose exponents `exponents_are_safe` accepts.
///
/// Convention (one for the whole project): `orient3d(a,b,c,d)` is the sign of det[b-a, c-a, d-a]. It is positive for a
/// tetrahedron in VTK order: (a,b,c) appear counter-clockwise from d. `orient2d(a,b,c)` is positive if they are
/// counter-clockwise. `in_sphere(a,b,c,d,e)` is positive if e is strictly inside the sphere through the positively
/// oriented
/// a,b,c,d.
///
/// Ties are broken by a symbolic perturbation of the lifted height |p|^2, not of the coordinates, so that no flat
/// simplex is ever made. It is ordered by the vertices' coordinates (lexicographic x, y, z): the greater the point, the
/// greater its perturbation. It therefore does not depend on numbering and is the same in 2D, in a facet's plane and in
/// 3D.
/// Source: Devillers and Teillaud 2011, "Perturbations for Delaunay and weighted Delaunay 3D triangulations",
/// section 4.
#pragma once

#include <span>

#include "geomesh/core/geometry.hpp"

namespace geomesh {

/// Returns the exact sign of the area of the triangle a, b, c; zero if the three points are collinear.
Sign orient2d(const Vec2& a, const Vec2& b, const Vec2& c);
/// Returns the exact sign of the volume of the tetrahedron a, b, c, d; zero if the four points are coplanar.
Sign orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);
/// Returns exactly whether d is inside (positive), on (zero) or outside the circle through the counter-clockwise a,b,c.
Sign in_circle(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
/// Returns exactly whether e is inside (positive), on (zero) or outside the sphere through the positively oriented
/// a,b,c,d.
Sign in_sphere(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

/// The in-circle and in-sphere tests with the symbolic perturbation, so that the sign is never zero for distinct
/// points. The last point must not equal any other argument.
Sign in_circle_perturbed(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d);
Sign in_sphere_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d, const Vec3& e);

/// Coplanar in-circle test of points in space, perturbed as in 3D: returns whether d is inside the circle of a,b,c. All
/// four are exactly coplanar and a,b,c are not collinear. Independent of the orientation of a,b,c. Agrees with
/// in_sphere_perturbed: if a facet's points are exactly coplanar and the facet is present in the Delaunay
/// tetrahedralization, it equals the 2D Delaunay triangulation under this test.
Sign in_circle_coplanar_perturbed(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Returns true if a, b, c are exactly collinear.
bool collinear(const Vec3& a, const Vec3& b, const Vec3& c);

/// Compares two points by x, then y, then z, which is the order that the symbolic perturbation uses. Returns -1, 0 or 1
/// if a is less than, equal to or greater than b.
int compare_lexicographic(const Vec3& a, const Vec3& b);

/// Returns true if all nonzero coordinates are finite and no product of the exact computation can over- or underflow.
/// The limits on the magnitudes are stated in the implementation and in the documents. Callers reject other input.
bool exponents_are_safe(std::span<const Vec3> points);

}  // namespace geomesh
