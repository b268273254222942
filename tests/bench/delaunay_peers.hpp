// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The triangulators under comparison, each from unordered points to finished cells.
#pragma once

#include <span>

#include "geomesh/core/delaunay.hpp"
#include "measured_run.hpp"

namespace geomesh::bench {

Answer run_geomesh(std::span<const Vec3> points, const DelaunayOptions& options, unsigned threads);
Answer run_cgal_compact(std::span<const Vec3> points);
Answer run_cgal_fast_location(std::span<const Vec3> points);
Answer run_cgal_parallel(std::span<const Vec3> points, unsigned threads);
Answer run_tetgen(std::span<const Vec3> points);

}  // namespace geomesh::bench
