// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Valid models some ulps thick, in whole numbers from 2^52 on, where doubles are one apart. Each follows from its seed
/// alone; with many ulps the same shapes have room for every point.
#pragma once

#include "geomesh/core/plc.hpp"

namespace geomesh::test {

enum class ThinShape {
  slits,    ///< Chazelle's polyhedron, its lines a hundredth of a unit apart: `ulps` for a unit, at least 64
  plate,    ///< two rough sheets at most `ulps` apart, closed by walls
  wedge,    ///< two sheets that meet along a line and part by `ulps` at the other end
  needles,  ///< a plate of needle triangles: points of a row a few ulps apart, rows up to 2^20 apart
};
inline constexpr unsigned n_thin_shapes = 4;
const char* name_of(ThinShape shape);

/// A model of the corpus with `unit` ulps for a unit, as triangles, from 2^52 on.
PiecewiseLinearComplex in_ulps(const char* name, double unit);

/// Triangles alone, no two of which cross (searched exactly): one closed solid. Sheets are sheared by whole numbers, so
/// that most lie in no plane of two axes; the slits are not. `ulps`: from 1 to 2^20.
PiecewiseLinearComplex thin_model(unsigned seed, ThinShape shape, unsigned ulps);

}  // namespace geomesh::test
