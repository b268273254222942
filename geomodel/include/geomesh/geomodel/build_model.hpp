// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From soup to PLC and from the core's result to the named mesh: patches, curves, region names, face sets.
#pragma once

#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A curve of the model before meshing: the segments of soup edges that bear one name.
struct SoupCurve {
  std::string name;
  std::string kind;  ///< as NamedCurve::kind
};

/// The PLC with everything needed to name its result again.
struct ModelPlc {
  PiecewiseLinearComplex plc;        ///< one triangular facet for each soup facet, same order; segments carry curve rows
  std::vector<Index> facet_patch;    ///< per facet, from 1: maximal sets joined across edges with two facets of the same surface set
  std::vector<SoupCurve> curves;     ///< rows are Segment::curve
};
ModelPlc make_plc(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces, const std::vector<Polyline>& polylines);

/// How regions get their names.
struct NamingRules {
  std::vector<std::string> column;  ///< as in Project
  std::vector<RegionHint> hints;    ///< names that came with the file (GOCAD Model3d)
};

/// Names components, orders regions by place, builds face sets and curves. `surfaces` are the input surfaces followed by the box sides.
/// Appends to `warnings`: units that join through a gap, regions that got a suffix, horizons that stop short.
ModelMesh name_model(const ConstrainedTetrahedralization& mesh, const PolygonSoup& soup, const ModelPlc& plc,
                     const std::vector<TriangulatedSurface>& surfaces, const std::vector<NamedPoint>& points, const NamingRules& rules,
                     std::vector<std::string>& warnings);

/// Lists every fault against the invariants of ModelMesh (empty: none). Runs before anything is written.
std::vector<std::string> validate_model_mesh(const ModelMesh& mesh);

}  // namespace geomesh::geomodel
