// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Runs on the models of the quality benchmark: geomesh, and Debian's command-line programs `tetgen` and `gmsh`.
#pragma once

#include <string>

#include "geomesh/core/quality.hpp"
#include "geomesh/core/refine.hpp"
#include "measured_run.hpp"
#include "quality_models.hpp"

namespace geomesh::bench {

struct Row {
  std::string tool;  ///< with what kept it from a result, where anything did
  std::size_t tetrahedra = 0;
  ElementShapes shapes;
  double cpu_s = 0;
};

ElementShapes shapes_of(const ShapeStatistics& s);
/// A row of the table whose head print_row_header() prints.
void print_row(const std::string& model, const Row& row);
void print_row_header(const char* second_column);

/// Our own run, in a process of its own, so that one that takes more than `limit_s` of processor time is a result.
Row run_geomesh(const QualityModel& model, const RefineOptions& options, const std::string& label, double limit_s);

/// `tetgen -pq1.414`: the facets as they are, polygons with holes included. TetGen adds points on them.
/// Files go to STEM.poly, STEM.1.node ...; `limit_s` of processor time.
Row run_tetgen(const QualityModel& model, const std::string& stem, double limit_s);

/// `gmsh -3 -optimize_netgen`: a discrete surface for each part of a surface between two regions, and a volume for each
/// region with the parts that bound it; parts with one region on both sides are embedded in it. Facets are triangulated
/// as our recovery does without refinement, since gmsh keeps discrete surfaces as they are. Where gmsh says that Netgen
/// is not compiled in, what its own optimiser left is the result, and the row says so.
Row run_gmsh(const QualityModel& model, const std::string& stem, double limit_s);

/// Netgen by its Python module (`python3-netgen`), with its three rounds of optimisation, between the triangles that
/// run_gmsh() takes. Reading and writing by Python counts as its time.
Row run_netgen(const QualityModel& model, const std::string& stem, double limit_s);

}  // namespace geomesh::bench
