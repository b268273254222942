// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Exact intersection of all surfaces with each other, with the box and with wells. The result is a polygon soup in
/// doubles whose facets meet only in shared vertices and edges.
///
/// Pipeline: merging of near ends and sides -> pairs (broad phase) -> exact constructions (narrow phase) -> constrained
/// triangulation inside each triangle -> identification of vertices -> clipping (box, bodies with cuts_all) -> rounding
/// with an exact check, and merging within the tolerance, repeated until nothing crosses -> thin voids closed, cracks
/// and holes filled. docs/decisions/arrangement.md has the file of each step.
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

/// Triangles that meet only in shared vertices and edges, each with all its origins.
///
/// Invariants (validate_soup, which shares no code with the arrangement, lists every fault): indices in range; points
/// distinct; no degenerate facet; no two facets equal as sets; facets, segments and isolated points meet only in shared
/// vertices and edges.
struct PolygonSoup {
  std::vector<Vec3> points;
  std::vector<SoupVertexKind> kind;
  std::vector<Index> input_point;

  std::vector<Triangle> facets;
  /// One input triangle of which a facet is a part. `reversed`: the facet is oriented opposite to that triangle.
  struct Origin {
    Index surface, triangle;
    bool reversed;
    friend bool operator==(const Origin&, const Origin&) = default;
  };
  /// Facet f has origins[origin_offsets[f]] .. [f+1], ordered by (surface, triangle); the first one's orientation is
  /// the facet's.
  std::vector<Origin> origins;
  std::vector<Index> origin_offsets{0};

  /// Pieces of polylines (wells). `polyline` is the row of the polyline in the input.
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

/// A place where the arrangement found or changed something, for messages, the report and the VTP file of such places.
struct Spot {
  std::string what;  ///< "crossing", "self-crossing", "free border", "gap" (a closed free border), "overlap", "merged",
                     ///< "vanished", "clipped", ...
  Index surface_a = no_index, surface_b = no_index;
  std::size_t count = 0;  ///< number of pairs of triangles, edges or other items found at this place
  double measure = 0;     ///< area (m2) or length (m) of what was found, for kinds that have one
  Vec3 place;
  double area = 0;
  std::size_t n_pieces = 1;  ///< number of connected pieces of free borders
};
/// Describes a spot for a geologist: "horizon top crosses horizon base over 0.8 km2 along 3.1 km near (x, y, z)".
/// `surfaces` are the input surfaces followed by the sides of the box.
std::string describe(const Spot& spot, const std::vector<TriangulatedSurface>& surfaces);
/// Lists which surfaces cross, have gaps or have dangling faces, one line for each.
std::vector<std::string> findings(const std::vector<Spot>& spots, const std::vector<TriangulatedSurface>& surfaces);

struct ArrangementOptions {
  std::optional<Box3> box;
  /// Clip to a closed volume of another shape: its sides, together closed, oriented outwards and free of crossings, are
  /// then surfaces n, n+1
  /// ... in this order. Not together with a box.
  std::vector<TriangulatedSurface> volume;
  enum class Crossings { resolve, refuse } crossings = Crossings::resolve;
  unsigned max_rounding_rounds = 8;
  /// Points, edges and facets nearer to each other than this are merged (0: only equal ones). The soup is proven free
  /// of crossings in any case. If not 0, at least 1024 ulps of the largest coordinate.
  double tolerance = 0;
  /// The places at which `tolerance` merges: everywhere, including near the sides of the box; or only where one of two
  /// surfaces that meet somewhere ends near the other. Faults that end beside another surface count as meeting it.
  /// Borders that end near a side move to it. Surfaces that follow each other within a hundredth of the tolerance are
  /// merged wherever they are near, with a warning, as are parts of one fault. Both ways move faults to edges of the
  /// volume that they run along, and close thin voids.
  enum class MergingOf { everything, surfaces_that_meet } merging = MergingOf::everything;
  /// The part of each triangle, by surface; a surface without an entry, or with an empty one, is one part. Parts of one
  /// surface may be removed later, one without the other, so a facet that stands for several parts names them all.
  std::vector<std::vector<Index>> parts;
  /// By surface: how many of its parts, the first ones, were given; the others continue them. No entry: one.
  std::vector<Index> n_given_parts;
  /// By surface: rows of the walls at which its continuations end, ascending. What the walls cut off from what was
  /// given is removed before anything is merged. Surfaces without an entry, or with an empty one, lose nothing.
  std::vector<std::vector<Index>> ends_at;
  /// Largest memory in bytes that may be used; 0 means three quarters of the machine's memory. Each step estimates its
  /// need from measured sizes; if it exceeds the limit, arrange() throws Error{cannot_mesh} with the place.
  std::size_t max_memory = 0;
};

struct Displacement {
  double largest = 0, mean = 0;
  Vec3 where;
  std::size_t points_moved = 0;
};

struct ArrangementResult {
  PolygonSoup soup;
  std::vector<TriangulatedSurface> box_sides;
  Displacement rounding;
  /// Changes made by merging, within `tolerance` or at places too thin for any rounding.
  struct Merging {
    Displacement displacement;
    std::size_t vertices_merged = 0, vertices_inserted = 0, facets_merged = 0, facets_collapsed = 0;
    std::size_t pockets_closed = 0;  ///< number of thin voids that were closed by removing one of their walls
  } merging;
  /// Per input surface: area removed inside bodies with cuts_all, area removed outside the box, length of free border
  /// that is left.
  std::vector<double> area_clipped_by_bodies, area_clipped_by_box;
  std::vector<double> area_clipped_by_rules;
  std::vector<Spot> spots;
  std::vector<std::string> warnings;
  std::size_t n_pairs = 0, n_crossing_pairs = 0, n_rounding_rounds = 0;
  std::size_t memory_bound = 0;  ///< estimate of the memory needed, in bytes
};

/// Throws Error{invalid_input} if crossings are refused (with the pairs and places) or coordinates are not finite, and
/// Error{cannot_mesh} if no valid rounding is found (with the place).
ArrangementResult arrange(const std::vector<TriangulatedSurface>& surfaces, const std::vector<Polyline>& polylines,
                          const std::vector<NamedPoint>& points, const ArrangementOptions& options,
                          const RunContext& context = {});

/// Winding number of point p with respect to one input surface taken as a closed oriented surface. It is decided
/// exactly; p is in doubles and not on the surface. Zero outside. Used for `inside` and for bodies that cross
/// themselves. Complexity: linear in the surface; callers ask once a region.
int winding_number(const TriangulatedSurface& surface, const Vec3& p);

struct SoupFault {
  std::string what;
  std::vector<Index> facets;
  Vec3 place;
};
/// Exact check of the soup's invariants, written apart from the arrangement; collects all faults (at most `limit`).
std::vector<SoupFault> validate_soup(const PolygonSoup& soup, std::size_t limit = 100);

}  // namespace geomesh::geomodel
