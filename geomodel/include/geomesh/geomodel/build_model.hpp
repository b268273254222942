// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// From soup to PLC and from the core's result to the named mesh: patches, curves, region names, face sets.
#pragma once

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/plc.hpp"
#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

/// A curve of the model before meshing: the soup edges that bear one name.
///
/// Kinds: "intersection" (different surfaces meet, or one surface meets itself in an edge of three or more facets): the
/// names of the surfaces in alphabetical order, joined by `*` (`main_fault*top_chalk`, `base*base`, `xmin*ymin`);
/// "border" (free edge of a surface): `NAME.border`; "fault_tip" (free edge of a fault): `NAME.tip`; "well": the
/// polyline's name.
struct SoupCurve {
  std::string name;
  std::string kind;  ///< as NamedCurve::kind
};

/// The PLC with everything needed to name its result again. Points keep the rows of the soup.
struct ModelPlc {
  PiecewiseLinearComplex plc;
  /// Facet f stands for the soup facets facet_soup[facet_soup_offsets[f]] .. [f+1], ascending, all with the same
  /// orientation as f.
  std::vector<Index> facet_soup;
  std::vector<Index> facet_soup_offsets{0};
  std::vector<Index>
      facet_patch;  ///< per facet, from 1: maximal sets joined across edges with two facets of the same surface set
  std::vector<SoupCurve> curves;  ///< by kind (border, fault_tip, intersection), then name; then wells in input order
  /// Per segment of the PLC: rows of all its curves, ascending (a well may run along a fault's tip); the first is
  /// Segment::curve.
  std::vector<std::vector<Index>> segment_curves;
};

struct PlcOptions {
  /// Give each patch on a box side as one polygon with holes instead of the soup's triangles. Such a patch is of one
  /// surface, and all its points have exactly the same coordinate: only its border has to be recovered then. Patches
  /// whose border passes a point twice stay triangles.
  bool merge_box_sides = true;
};

/// `surfaces` are the input surfaces followed by the box sides (the rows of PolygonSoup::Origin::surface). Linear but
/// for sorting edges.
ModelPlc make_plc(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                  const std::vector<Polyline>& polylines, const PlcOptions& options = {});

/// A mesh with what it was made of; all outlive it. `surfaces` as in make_plc.
struct MeshedModel {
  const ConstrainedTetrahedralization& mesh;
  const PolygonSoup& soup;
  const ModelPlc& plc;
  const std::vector<TriangulatedSurface>& surfaces;
  /// How far faces may be from the triangles that they stand for, but for rounding.
  double moved_at_most = 0;
};

/// Units of the column, by row: from `first` to `last`, both counted. No unit where `first` is beyond `last`.
struct UnitRange {
  Index first = 0, last = 0;
  bool empty() const { return first > last; }
  bool operator==(const UnitRange&) const = default;
};

/// How regions get their names, in this order: a seed point inside, a region seed of the PLC, the innermost body it
/// lies in, a hint, the column, else `region_1`, `region_2`, ... Among overlapping bodies the first in project order
/// counts; unnamed regions are numbered in the order of their first input triangle.
struct NamingRules {
  std::vector<std::string> column{};      ///< as in Project: unit, horizon, unit, ...; empty or of odd length
  std::vector<RegionHint> hints{};        ///< names that came with the file (GOCAD Model3d)
  std::vector<std::string> seed_names{};  ///< by id of the PLC's region seeds
  bool name_by_bodies = true;             ///< false: bodies are told in Region::inside only (`geomesh mesh`)
  Index hull_surface = no_index;    ///< surface that stands for the convex hull: what it alone encloses is named `hull`
  std::vector<NamedPoint> seeds{};  ///< own names by points
  /// Units of the column are named by fault block, `Unit__B2`: blocks are what faults divide (regions joined across
  /// horizons), ordered by place as regions of one name are. Nothing is added where there is one block.
  bool fault_blocks = false;
  /// Pieces of one unit of the column in one fault block are one region, whether they touch or not.
  bool join_pieces = false;
  std::string topography{};                   ///< a horizon: what lies above it is left out of the mesh
  std::string floor{};                        ///< a horizon: what lies below it is left out of the mesh
  std::vector<std::string> unconformities{};  ///< horizons that cut what is older (names)
  double min_volume = 0;  ///< smaller regions are reported; merged with the neighbour across most area where asked
  bool merge_small = false;
  std::map<std::string, std::vector<std::string>> groups{};           ///< group: units, bodies or regions
  std::map<std::string, std::map<std::string, double>> attributes{};  ///< unit or region: attribute: value
  /// The column's units that the horizons as they were laid down leave at a place; several where a horizon is not
  /// there. It is asked of components whose own faces leave several, or none: all of a horizon may be away there.
  std::function<UnitRange(const Vec3&)> units_at{};
};

/// Names components, orders regions, builds face sets and curves. `points` are those of the soup's isolated points.
///
/// Region ids from 1: units of the column youngest first, then bodies in project order, hints, seeds, unnamed ones by
/// first input triangle, hull. Regions of one name get the suffixes `__1`, `__2`, ... by place: the lexicographically
/// smallest (x, y, z) of their points, then the greatest, then the centroid; the extreme points are input or
/// intersection points, so the order survives remeshing. Surfaces have the ids after the regions in input order, then
/// curves, then marked points.
///
/// Appends to `warnings`: units that join through a gap, regions that got a suffix, horizons that stop short or have
/// holes. Throws Error{usage} where the column is malformed or names a horizon that is not there.
ModelMesh name_model(const MeshedModel& model, const std::vector<NamedPoint>& points, const NamingRules& rules,
                     std::vector<std::string>& warnings, unsigned threads = 1);

/// Lists every fault against the invariants of ModelMesh (empty: none). Runs before anything is written.
std::vector<std::string> validate_model_mesh(const ModelMesh& mesh, unsigned threads = 0);

}  // namespace geomesh::geomodel
