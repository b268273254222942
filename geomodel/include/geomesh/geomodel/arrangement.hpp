// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Exact intersection of all surfaces with each other, with the box and with wells. The result is a polygon soup in
/// doubles whose facets meet only in shared vertices and edges.
///
/// Pipeline: merging of surfaces that nearly touch -> pairs of triangles (broad phase) -> exact constructions (narrow
/// phase) -> constrained triangulation inside each triangle -> identification of equal vertices -> clipping (box,
/// bodies with cuts_all) -> rounding with an exact check, and merging within the tolerance, repeated until nothing
/// crosses -> thin voids closed, cracks and holes filled. docs/decisions/arrangement.md lists the source file of each
/// step.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/geometry.hpp"
#include "geomesh/core/run_context.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

enum class SoupVertexKind : std::uint8_t { input, intersection, triple_point };

/// Triangles (facets) that meet only in shared vertices and edges. Each facet knows the input triangles of which it is
/// a part (its origins).
///
/// Invariants (validate_soup, which shares no code with the arrangement, lists every fault): indices in range; points
/// distinct; no degenerate facet; no two facets equal as sets; facets, segments and isolated points meet only in shared
/// vertices and edges.
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<SoupVertexKind> kind;
  /// For each point: its row among the vertices of all input surfaces one after the other (the first of equal
  /// vertices), or no_index for points that the arrangement added.
  std::vector<Index> input_point;

  std::vector<Triangle> facets;
  /// One input triangle of which a facet is a part. `reversed`: the facet is oriented opposite to that triangle.
  struct Origin {
    Index surface, triangle;
    bool reversed;
    friend bool operator==(const Origin&, const Origin&) = default;
  };
  /// Origins of all facets: those of facet f are origins[origin_offsets[f]] .. [f+1], ordered by (surface, triangle). A
  /// facet has the orientation of its first origin.
  std::vector<Origin> origins;
  std::vector<Index> origin_offsets{0};

  /// A piece of a polyline (well). `polyline` is the row of the polyline in the input.
  struct Segment {
    VertexIndex a, b;
    Index polyline;
  };
  std::vector<Segment> segments;
  struct IsolatedPoint {
    VertexIndex v;
    Index point;
  };
  std::vector<IsolatedPoint> isolated_points;
};

/// A place where the arrangement found or changed something. Messages, the report and a VTP file list these places.
struct Spot {
  /// The finding: "crossing", "self-crossing", "free border", "gap" (a closed free border), "overlap", ...
  std::string what;
  Index surface_a = no_index, surface_b = no_index;
  std::size_t count = 0;  ///< number of pairs of triangles, or of edges or other items, found at the place
  double measure = 0;     ///< area (m2) or length (m) of the crossing, gap or other finding, for kinds that have one
  Vec3 place;
  /// For forbidden crossings of two surfaces: each surface has a part that lies beyond the other one; this is the area
  /// of the smaller of these two parts, or 0 if nothing is cut off.
  double area = 0;
  std::size_t n_pieces = 1;  ///< for free borders and gaps: number of connected borders that the finding stands for
};
/// Describes a finding of the arrangement for a geologist: "horizon top crosses horizon base over 0.8 km2 along 3.1 km
/// near (x, y, z)". `surfaces` are the input surfaces followed by the sides of the box.
std::string describe(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces);
/// Lists which surfaces cross, have gaps or have dangling faces, one line for each.
std::vector<std::string> findings(const std::vector<Spot>& spots, const std::vector<TriangulatedSurface>& surfaces);

struct ArrangementOptions {
  std::optional<Box3>
      /// Box to which the n input surfaces are clipped. Its sides become surfaces n .. n+5 (xmin xmax ymin ymax zmin
      /// zmax).
      box;
  /// Sides of a closed volume other than a box, to which the n input surfaces are clipped. They must be oriented
  /// outwards and free of crossings, and become surfaces n, n+1, ... in this order. Cannot be combined with a box.
  std::vector<TriangulatedSurface> volume;
  enum class Crossings { resolve, refuse } crossings = Crossings::resolve;
  unsigned max_rounding_rounds = 8;
  /// Points, edges and facets nearer to each other than this distance are merged; 0: only equal ones are. If not 0, it
  /// must be at least 1024 ulps of the largest coordinate. The result is proven free of crossings for any value.
  double tolerance = 0;
  /// Selects the places at which features nearer than `tolerance` are merged: everywhere, including near the sides of
  /// the box; or only where one of two surfaces that meet somewhere ends near the other. In the second case a fault
  /// that ends beside another surface counts as meeting it, borders that end near a side of the volume move to that
  /// side, and surfaces that follow each other within a hundredth of the tolerance are merged wherever they are near,
  /// with a warning, as are parts of one fault. In both cases faults move to edges of the volume that they run along,
  /// and thin voids are closed.
  enum class MergingOf { everything, surfaces_that_meet } merging = MergingOf::everything;
  /// For each surface, the part (such as a fault block or a continuation) to which each of its triangles belongs, by
  /// number. A surface without an entry, or with an empty one, is a single part. Rules may remove one part of a surface
  /// and keep another, so a facet that stands for several parts names them all.
  std::vector<std::vector<Index>> parts;
  /// For each surface, the ascending rows of its walls: the surfaces at which its continuations (parts 1, 2, ...) end.
  /// Facets that walls separate from the original surface (part 0) are removed before any merging. Surfaces without an
  /// entry, or with an empty one, are not cut.
  std::vector<std::vector<Index>> ends_at;
  /// Largest memory in bytes that may be used; 0 means three quarters of the machine's memory. Each step of arrange()
  /// estimates its need of memory from measured sizes, and throws Error{cannot_mesh} if that exceeds the limit.
  std::size_t max_memory = 0;
};

struct Displacement {
  double largest = 0, mean = 0;
  Vec3 where;
  std::size_t points_moved = 0;
};

struct ArrangementResult {
  PolygonSoup soup;
  /// Sides of the box (six) or of another closed volume to which n input surfaces were clipped. Side i counts as
  /// surface n + i.
  std::vector<TriangulatedSurface> box_sides;
  Displacement rounding;
  /// Result of merging surfaces nearer to each other than `tolerance`, or so near that rounding cannot keep them apart.
  struct Merging {
    Displacement displacement;
    std::size_t vertices_merged = 0, vertices_inserted = 0, facets_merged = 0, facets_collapsed = 0;
    std::size_t pockets_closed = 0;  ///< number of thin voids that were closed by removing one of their walls
  } merging;
  /// For each input surface: area removed inside bodies that cut other surfaces, and area removed outside the box.
  std::vector<double> area_clipped_by_bodies, area_clipped_by_box;
  /// For each input surface: area removed by rules, which the caller of trim_soup fills in; empty without such rules.
  std::vector<double> area_clipped_by_rules;
  std::vector<Spot> spots;
  std::vector<std::string> warnings;
  std::size_t n_pairs = 0, n_crossing_pairs = 0, n_rounding_rounds = 0;
  std::size_t memory_bound = 0;  ///< estimate of the memory in bytes that the arrangement needs
};

/// Intersects all surfaces, wells and points with each other. Throws Error{invalid_input} with the pairs and places if
/// crossings are not allowed, or if coordinates are not finite; throws Error{cannot_mesh} with the place if no valid
/// rounding is found.
ArrangementResult arrange(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Polyline>& polylines,
                          const std::vector<NamedPoint>& points, const ArrangementOptions& options,
                          const RunContext& context = {});

/// Winding number of point p with respect to one input surface taken as a closed oriented surface. The result is exact,
/// and zero outside. Precondition: p is not on the surface. Used for `inside` and for bodies that cross themselves.
/// Time is linear in the number of triangles.
int winding_number(const TriangulatedSurface& surface, const Vec3& p);

struct SoupFault {
  std::string what;
  std::vector<Index> facets;
  Vec3 place;
};
/// Checks the invariants of a PolygonSoup exactly, without code of the arrangement. Returns at most `limit` faults.
std::vector<SoupFault> validate_soup(const PolygonSoup& soup, std::size_t limit = 100);

}  // namespace geomesh::geomodel
