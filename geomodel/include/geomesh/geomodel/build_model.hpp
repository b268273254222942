// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Builds the PLC from the soup of the arrangement. Builds the named mesh from the tetrahedra of the core: patches,
/// curves, names of regions, sets of faces.
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

/// A curve of the model before meshing: all edges of the soup that have the same curve name.
///
/// Kinds: "intersection" (different surfaces meet, or one surface meets itself in an edge of three or more facets): the
/// names of the surfaces in alphabetical order, joined by `*` (`main_fault*top_chalk`, `base*base`, `xmin*ymin`);
/// "border" (free edge of a surface): `NAME.border`; "fault_tip" (free edge of a fault): `NAME.tip`; "well": the
/// polyline's name.
struct SoupCurve {
  std::string name;
  std::string kind;  ///< as NamedCurve::kind
};

/// A PLC with everything needed to name the parts of its mesh. Its points have the same rows as in the polygon soup.
struct ModelPlc {
  PiecewiseLinearComplex plc;
  /// Soup facets that each facet of the PLC stands for: those of facet f are facet_soup[facet_soup_offsets[f]] ..
  /// [f+1], ascending, all with the orientation of f.
  std::vector<Index> facet_soup;
  std::vector<Index> facet_soup_offsets{0};
  std::vector<Index>
      /// For each facet, the number of its patch, from 1. A patch is a maximal set of facets that are connected across
      /// edges at which two facets of the same surfaces meet.
      facet_patch;
  /// Curves sorted by kind (border, fault_tip, intersection), then by name; wells follow in input order.
  std::vector<SoupCurve> curves;
  /// For each segment of the PLC, the ascending rows of all its curves (a well may run along a fault's tip).
  /// Segment::curve is the first of them.
  std::vector<std::vector<Index>> segment_curves;
};

struct PlcOptions {
  /// Whether each planar patch on a side of the box becomes one polygon with holes instead of the soup's triangles.
  /// Only the border of such a patch then has to be recovered. Patches that belong to several surfaces, are not exactly
  /// planar, or have a border that passes a point twice remain triangles.
  bool merge_box_sides = true;
};

/// Builds the PLC. `surfaces` are the input surfaces followed by the sides of the box, which are the rows of
/// PolygonSoup::Origin::surface. The time is linear except for the sorting of edges.
ModelPlc make_plc(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces,
                  const std::vector<Polyline>& polylines, const PlcOptions& options = {});

/// References to a mesh and to the model from which it was made; they must outlive this record. `surfaces` are the
/// input surfaces followed by the sides of the box.
struct MeshedModel {
  const ConstrainedTetrahedralization& mesh;
  const PolygonSoup& soup;
  const ModelPlc& plc;
  const std::vector<TriangulatedSurface>& surfaces;
  /// Largest distance, apart from rounding, between mesh faces and the input triangles that they represent.
  double moved_at_most = 0;
};

/// A range of units in the stratigraphic column, by their rows from `first` to `last`, both included. It is empty if
/// `first` is greater than `last`.
struct UnitRange {
  Index first = 0, last = 0;
  bool empty() const { return first > last; }
  bool operator==(const UnitRange&) const = default;
};

/// How regions get their names, in this order: a seed point inside, a region seed of the PLC, the innermost body it
/// lies in, a region of the input file (hint), the column, else `region_1`, `region_2`, ... Among overlapping bodies
/// the first in project order counts; unnamed regions are numbered in the order of their first input triangle.
struct NamingRules {
  /// Stratigraphic column, alternating unit, horizon, unit, ...; empty if there is none, else of odd length.
  std::vector<std::string> column{};
  std::vector<RegionHint> hints{};        ///< names of regions that came with the file (GOCAD Model3d)
  std::vector<std::string> seed_names{};  ///< names of the PLC's region seeds by their ids
  /// If false, bodies give no names to regions and appear only in Region::inside (`geomesh mesh`).
  bool name_by_bodies = true;
  /// Row of the surface that represents the convex hull; a region enclosed by it alone is named `hull`.
  Index hull_surface = no_index;
  std::vector<NamedPoint> seeds{};  ///< names that the user assigns to regions by points inside them
  /// Names units of the stratigraphic column by fault block, for example `Unit__B2`. Blocks are the parts that faults
  /// separate (regions joined across horizons), numbered by position in the same way as regions of one name. Nothing is
  /// added to the name if there is only one block.
  bool fault_blocks = false;
  /// If set, all pieces of one unit in one fault block form one region, even if they do not touch.
  bool join_pieces = false;
  std::string topography{};  ///< horizon that is the ground: what lies above it is not meshed
  std::string floor{};       ///< horizon that is the base of the model: what lies below it is not meshed
  std::vector<std::string> unconformities{};  ///< names of the horizons that cut older surfaces (unconformities)
  /// Regions smaller than this (m3) are reported, and merged into the neighbour with the largest common area if
  /// requested.
  double min_volume = 0;
  bool merge_small = false;
  /// Lists of units, bodies or regions by the name of their group.
  std::map<std::string, std::vector<std::string>> groups{};
  /// Attribute values, by the name of the unit or region and then by the name of the attribute.
  std::map<std::string, std::map<std::string, double>> attributes{};
  /// Returns the units of the stratigraphic column that can lie at a place, by the order in which the horizons were
  /// deposited; several if a horizon is missing. It names mesh components whose own faces leave several units possible
  /// or none, as where all of a horizon was removed.
  std::function<UnitRange(const Vec3&)> units_at{};
};

/// Builds the named mesh: names its regions, orders them, and builds face sets and curves. `points` name the isolated
/// points of the soup.
///
/// Region ids count from 1 in this order: units of the column youngest first, then bodies in project order, hints,
/// seeds, unnamed ones by first input triangle, hull. Regions of one name get the suffixes `__1`, `__2`, ... by place:
/// the lexicographically smallest (x, y, z) of their points, then the greatest, then the centroid; the extreme points
/// are input or intersection points, so the order survives remeshing. Surfaces have the ids after the regions in input
/// order, then curves, then marked points.
///
/// Appends to `warnings`: units that join through a gap, regions that got a suffix, horizons that stop short or have
/// holes. Throws Error{usage} where the column is malformed or names a horizon that is not there.
ModelMesh name_model(const MeshedModel& model, const std::vector<NamedPoint>& points, const NamingRules& rules,
                     std::vector<std::string>& warnings, unsigned threads = 1);

/// Lists all violations of the invariants of ModelMesh; returns an empty list if there are none.
std::vector<std::string> validate_model_mesh(const ModelMesh& mesh, unsigned threads = 0);

}  // namespace geomesh::geomodel
