// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Time of refinement and improvement by the number of elements.
#pragma once

namespace geomesh::bench {

/// Prints a table: round grains with one size for the whole model, from about 1e5 to 1e6 tetrahedra, with the share of
/// each stage. A size that takes more than `limit_s` of processor time ends the table.
void measure_growth(double limit_s);

}  // namespace geomesh::bench
