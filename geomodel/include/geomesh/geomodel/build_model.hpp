// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Builds the PLC from the soup, and the named mesh from the core's result: patches, curves, names of regions, sets of
/// faces.
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

/// The PLC with everything needed to name the parts of its mesh. Points keep the rows of the soup.
struct ModelPlc {
  PiecewiseLinearComplex plc;
  /// Facet f stands for the soup facets facet_soup[facet_soup_offsets[f]] .. [f+1], ascending, all with the same
  /// orientation as f.
  std::vector<Index> facet_soup;
  std::vector<Index> facet_soup_offsets{0};
  std::vector<Index>
      /// Per facet, from 1: number of its patch, a maximal set of facets joined across edges that have two facets of
      /// the same surfaces.
      facet_patch;
  /// Sorted by kind (border, fault_tip, intersection), then by name; wells follow in input order.
  std::vector<SoupCurve> curves;
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

/// `surfaces` are the input surfaces followed by the box sides (the rows of PolygonSoup::Origin::surface). Linear
/// except for sorting edges.
ModelPlc make_plc(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                  const std::vector<Polyline>& polylines, const PlcOptions& options = {});

/// A mesh and the model from which it was made, all of which must outlive this record. `surfaces` as in make_plc.
struct MeshedModel {
  const ConstrainedTetrahedralization& mesh;
  const PolygonSoup& soup;
  const ModelPlc& plc;
  const std::vector<TriangulatedSurface>& surfaces;
  /// Largest distance, apart from rounding, between mesh faces and the input triangles that they represent.
  double moved_at_most = 0;
};

/// Rows of units in the column from `first` to `last`, both included. The range is empty if `first` is greater than
/// `last`.
struct UnitRange {
  Index first = 0, last = 0;
  bool empty() const { return first > last; }
  bool operator==(const UnitRange&) const = default;
};

/// How regions get their names, in this order: a seed point inside, a region seed of the PLC, the innermost body it
/// lies in, a hint, the column, else `region_1`, `region_2`, ... Among overlapping bodies the first in project order
/// counts; unnamed regions are numbered in the order of their first input triangle.
struct NamingRules {
  /// As in Project: unit, horizon, unit, ...; empty if there is no column, else of odd length.
  std::vector<std::string> column{};
  std::vector<RegionHint> hints{};        ///< names of regions that came with the file (GOCAD Model3d)
  std::vector<std::string> seed_names{};  ///< names of the PLC's region seeds by their ids
  /// If false, bodies give no names to regions and appear only in Region::inside (`geomesh mesh`).
  bool name_by_bodies = true;
  /// Row of the surface that represents the convex hull; a region enclosed by it alone is named `hull`.
  Index hull_surface = no_index;
  std::vector<NamedPoint> seeds{};  ///< names that the user assigns by points inside regions
  /// Names units of the column by fault block, for example `Unit__B2`. Blocks are the parts that faults separate
  /// (regions joined across horizons), numbered by position in the same way as regions of one name. Nothing is added to
  /// the name if there is only one block.
  bool fault_blocks = false;
  /// If set, all pieces of one unit in one fault block form one region, even if they do not touch.
  bool join_pieces = false;
  std::string topography{};  ///< horizon that is the ground: what lies above it is not meshed
  std::string floor{};       ///< horizon that is the base of the model: what lies below it is not meshed
  std::vector<std::string> unconformities{};  ///< names of the horizons that cut older surfaces
  /// Regions smaller than this (m3) are reported, and merged into the neighbour with the largest common area if
  /// requested.
  double min_volume = 0;
  bool merge_small = false;
  std::map<std::string, std::vector<std::string>> groups{};  ///< units, bodies or regions by the name of their group
  /// Values by unit or region, then by name of the attribute.
  std::map<std::string, std::map<std::string, double>> attributes{};
  /// Returns the units of the column that are possible at a place by the original order of deposition of the horizons;
  /// several where a horizon is missing. Used for components whose own faces leave several units possible, or none,
  /// which happens if all of a horizon was removed there.
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

/// Lists all violations of the invariants of ModelMesh (empty: none). Called before anything is written.
std::vector<std::string> validate_model_mesh(const ModelMesh& mesh, unsigned threads = 0);

}  // namespace geomesh::geomodel
