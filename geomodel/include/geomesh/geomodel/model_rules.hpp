// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Model building: the rules by which surfaces that stop short, have holes, are open or cross become a model. Rules act
/// in two steps, before and after the arrangement (the exact intersection of all surfaces). Each step reports what it
/// changed and where, with areas or lengths.
///
///     surfaces --build_surfaces--> surfaces --arrange--> soup --trim_soup--> soup --make_plc--> ...
#pragma once

#include <algorithm>
#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/stack.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// How a surface is extended beyond its border. The extension is computed over the map for horizons, and over the mean
/// plane for faults.
enum class Extend {
  none,
  flat,     ///< the extension keeps the height of each border point; for faults, its distance from the mean plane
  tangent,  ///< the surface is extended with its mean slope near the border
  nearest,  ///< the extension has the height of the nearest vertex of the surface
};

/// How the base of a unit, which is a horizon, cuts other horizons.
enum class BaseRule {
  conformable,
  erode,  ///< the horizon cuts what is older: parts of older horizons above it are removed
  onlap,  ///< younger units end on the horizon (onlap): parts of younger horizons below it are removed
};

/// Treatment of horizons that cross each other where no other rule applies.
enum class OnCrossing {
  leave,         ///< both crossing horizons are kept; regions between them get names, with a warning
  clip_younger,  ///< parts of the younger horizon below the older horizon are removed
  clip_older,    ///< parts of the older horizon above the younger horizon are removed
  error,         ///< the run ends with Error{invalid_input}, which names the crossing horizons, the area and the place
};

/// The triangles of a horizon that come from one scalar field, and the domain in which that field is valid.
struct FieldPart {
  /// One past the row of this field's last triangle in the horizon. Its first one follows the previous field's last.
  Index end = 0;
  /// Names of faults, each with true if the field is valid above the fault and false if it is valid below.
  std::vector<std::pair<std::string, bool>> sides;
  std::optional<Vec3> block;  ///< a point in the fault block in which the scalar field is valid
  std::string field;          ///< name of the scalar field in messages: its file, or "its function"
  /// Something that could not be proven about the level set of a scalar field. The user is warned only if the model
  /// keeps one of the triangles concerned, or if one of the places lies where the field is valid.
  struct Doubt {
    std::vector<Index> triangles;
    std::vector<Vec3> places;
    std::string warning;
  };
  std::vector<Doubt> doubts;
};

struct SurfaceRules {
  Extend extend = Extend::none;  ///< how the surface is extended beyond the box
  double fill_holes = 0;         ///< holes with a border of at most this length (m) are filled; infinity: all holes
  /// For faults: name of the fault or horizon at which the extension ends (`extent: to_fault NAME`).
  std::string stop_at;
  bool close_at_box =
      true;  ///< For bodies: whether open ends (rooted salt) are closed beyond the side of the box nearest to each end.
  /// For bodies given as a single open surface: thickness in m, half of it on either side of that surface. 0: the
  /// surface itself is the boundary of the body.
  double thickness = 0;
  BaseRule base = BaseRule::conformable;  ///< how a horizon of the stratigraphic column cuts other horizons
  /// For faults: consecutive units of the stratigraphic column that the fault cuts; if empty, it cuts all units.
  std::vector<std::string> cut_units;
  /// For horizons that consist of a separate piece in each fault block: names of the faults that displace the horizon.
  /// Each piece is extended beyond these faults (by the rule `extend`, flat if none is given); then whatever lies on
  /// the other side of a fault is removed.
  std::vector<std::string> throw_at;
  /// Whether find_ramps adds faults to throw_at, the faults that displace this horizon. If throw_at is still empty
  /// after that, the horizon is continued to the walls of its fault blocks.
  bool throw_auto = false;
  /// For horizons with fault polygons: whether faults that pass through the polygons are added to throw_at, if the
  /// project lists no faults for the horizon.
  bool throw_at_polygons = false;
  /// For surfaces that are level sets: the triangles of each scalar field. Those of fields that are valid only in
  /// certain blocks or on certain sides of faults are cut off at the faults in throw_at.
  std::vector<FieldPart> field_parts;
  /// For surfaces that are level sets: names of the surfaces above or below which the scalar field is valid. A horizon
  /// may name horizons; a fault may name horizons and faults.
  std::vector<std::string> holds_above, holds_below;
  bool has_fault_domain() const {
    return std::any_of(field_parts.begin(), field_parts.end(),
                       [](const FieldPart& part) { return part.block || !part.sides.empty(); });
  }
  /// Whether a surface that ends a little short of the surface that should bound it is continued up to there
  /// (ContinuationRules).
  bool continues = true;
  bool continues_by_default() const {
    return continues && (fills_blocks() || (extend == Extend::none && throw_at.empty()));
  }
  /// Returns whether the horizon is continued to the walls of every fault block in which it has data, however far they
  /// are.
  bool fills_blocks() const { return throw_auto && throw_at.empty(); }
  bool has_throw() const { return throw_auto || throw_at_polygons || !throw_at.empty(); }
  /// For horizons with throw_at: whether the throw is restored where the horizon crosses a fault as a smooth ramp. If
  /// not, the ramp remains.
  bool cut_smeared = true;
};

/// Treatment of layers of the stratigraphic column that are thinner than the least thickness.
enum class ThinLayers {
  keep,      ///< thin layers are kept, and a warning says where they are
  collapse,  ///< the younger horizon is lowered onto the older one where the layer is too thin
  error,     ///< a too thin layer ends the run: Error{invalid_input} names both horizons, the area and the place
};

/// Distances over which surfaces without rules of their own are continued to the surfaces that bound them.
struct ContinuationRules {
  /// Greatest distance in m over which borders of horizons are continued; 0: they are left as they are.
  double within_of_horizons = 0;
  double within_of_faults = 0;             ///< m
  Box3 bounds;                             ///< bounding box of the model volume
  std::vector<TriangulatedSurface> sides;  ///< sides of the model volume
};

struct ModelRules {
  std::optional<Box3> box;  ///< model box; required by the rules extend and close_at_box
  /// Rules of each surface, in the order of the surfaces; surfaces without an entry have the default rules.
  std::vector<SurfaceRules> surfaces;
  std::vector<std::string> column;  ///< stratigraphic column, which defines which horizons are older and younger
  std::string topography;  ///< name of the horizon that is the ground: parts of all other surfaces above it are removed
  std::string floor;       ///< name of the horizon that is the base: parts of all other surfaces below it are removed
  OnCrossing on_crossing = OnCrossing::leave;
  /// Pieces of horizons and faults that reach at most this distance (m) beyond the surface on which they should end are
  /// removed, unless another surface ends only on such a piece. 0: nothing is removed.
  double trim_overshoot = 0;
  double min_thickness = 0;  ///< least thickness of layers in m along the vertical; 0: no limit
  ThinLayers thin_layers = ThinLayers::keep;
  StackRules stack;
  /// The project's `rules.continue_within` in m, which replaces distances derived from the model; negative if not
  /// given.
  double continue_within = -1;
  ContinuationRules continuation;

  SurfaceRules of(std::size_t row) const { return row < surfaces.size() ? surfaces[row] : SurfaceRules{}; }
  /// Returns whether any of the rules removes parts of surfaces after the arrangement.
  bool trims() const {
    for (const SurfaceRules& rule : surfaces)
      if (!rule.stop_at.empty() || rule.base != BaseRule::conformable || !rule.cut_units.empty() || rule.has_throw() ||
          !rule.holds_above.empty() || !rule.holds_below.empty())
        return true;
    return on_crossing != OnCrossing::leave || trim_overshoot > 0 || !topography.empty() || !floor.empty();
  }
};

/// For each surface, which of its triangles are input and which were made by rules.
struct BuiltRows {
  /// Number of input triangles of each surface; triangles in later rows were made by rules.
  std::vector<Index> n_given_triangles;
  std::vector<std::vector<Index>>
      /// For each surface with throw_at, the number of the fault block of each triangle, from 0, or of_every_block or
      /// of_no_block. Empty for other surfaces.
      block_of_triangle;
  /// For each surface, the rows of the faults that divide it into blocks: those of throw_at across which it is not
  /// continued.
  std::vector<std::vector<Index>> parted_at;
  /// For each surface and each of its fault blocks: whether the block lies above each fault that divides the surface
  /// (parted_at). Empty for surfaces without blocks.
  std::vector<std::vector<std::vector<bool>>> sides_of_block;
  /// For each surface, each of its fault blocks, and each fault that divides the surface (parted_at): whether the
  /// scalar field of the block is valid on both sides of the fault. Empty for surfaces without fields that are
  /// restricted to certain sides of faults.
  std::vector<std::vector<std::vector<bool>>> on_both_sides;
  /// Returns whether the field of a fault block is valid on both sides of the k-th fault that divides the surface.
  bool is_on_both_sides(Index surface, Index block, std::size_t k) const {
    return surface < on_both_sides.size() && !on_both_sides[surface].empty() && on_both_sides[surface][block][k];
  }
  /// For each surface, the row of its first triangle that only separates fault blocks; this and all later triangles
  /// extend a fault that ends inside the model. no_index if there is none.
  std::vector<Index> first_only_parting;

  /// For each surface that was continued to its bounding surfaces: 0 for triangles that are input or fill a hole, k for
  /// triangles that continue the k-th run of border edges. Empty for other surfaces.
  std::vector<std::vector<Index>> part_of_triangle;
  /// For each surface and each of its continuations, numbered from 1: the fault block in which it continues the
  /// surface, or no_index if it continues a run of border edges.
  std::vector<std::vector<Index>> block_of_part;
  /// For each surface, the ascending rows of the surfaces at which its continuations end.
  std::vector<std::vector<Index>> continued_to;
  /// Rows, ascending, of the faults that extend a little beyond the faults on which they end.
  std::vector<Index> overshooting;
  /// Pairs of a fault and a horizon (an unconformity) that truncates it, as surface rows, ascending.
  std::vector<std::pair<Index, Index>> truncations;
  bool any_continued() const {
    return !overshooting.empty() || !truncations.empty() ||
           std::any_of(part_of_triangle.begin(), part_of_triangle.end(),
                       [](const auto& part) { return !part.empty(); });
  }

  /// Block number of triangles that continue a surface beyond the tip of a fault with throw, where the blocks on both
  /// sides are connected.
  static constexpr Index of_every_block = no_index;
  /// Block number of input triangles at a fault that ends inside the model; the surface is rebuilt there.
  static constexpr Index of_no_block = no_index - 1;
  static Index n_blocks(const std::vector<Index>& block_of) {
    Index n = 0;
    for (const Index block : block_of)
      if (block < of_no_block) n = std::max(n, block + 1);
    return n;
  }
};

/// A surface that was continued to the surfaces that bound it, as described by the report.
struct ContinuedSurface {
  std::string name;
  std::string walls;    ///< comma-separated names of the bounding surfaces up to which this surface was continued
  double length = 0;    ///< of border, m
  double farthest = 0;  ///< m
  Vec3 place;           ///< of the farthest
  double area = 0;      ///< area of the continuation in m2, before parts beyond the bounding surfaces are cut off
  std::size_t n_filled = 0;
  double area_filled = 0;  ///< area in m2 of the gaps in the surface that were filled
  Vec3 place_filled;       ///< of the largest
};

struct BuiltSurfaces {
  /// Surfaces after the rules were applied. Input points and triangles keep their rows, and those made by rules follow.
  /// Horizons of layers that collapse get new triangles instead.
  std::vector<TriangulatedSurface> surfaces;
  BuiltRows rows;
  SettledStack stack;
  std::vector<ContinuedSurface> continued;
  /// Returns the surfaces without the triangles that only separate fault blocks: those that the arranged model should
  /// contain before any of them is trimmed.
  std::vector<TriangulatedSurface> model_surfaces() const;
  std::vector<std::string> notes;     ///< descriptions, with areas, of what each model-building rule changed
  std::vector<std::string> warnings;  ///< model-building rules that could not be applied, and why
};

/// Adds faults to SurfaceRules::throw_at of horizons with `throw_auto`: those that the horizon crosses as a smooth ramp
/// and, if there are any, those that lie between separate pieces of the horizon. Notes report which faults were added.
/// Cost: that of find_ramp for each such horizon and each fault.
void find_ramps(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules, std::vector<std::string>& notes);

/// Removes from SurfaceRules::throw_at of each horizon the faults whose input lies entirely above or below the horizon.
/// Such a fault does not displace the horizon, and its extension would divide it. Each removal is reported by a
/// warning. Cost: vertices of such faults times a search in the map of the horizon.
void leave_out_unreached_faults(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules,
                                std::vector<std::string>& warnings);

/// Fills holes, extends surfaces and closes bodies. Throws Error{usage} if a rule needs a box and there is none.
/// Progress is reported after each surface, when the run can also be cancelled. Cost: a 2D triangulation of the borders
/// for each surface that has a rule.
BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                             const RunContext& context = {});

/// Returns the names of the horizons that cut older surfaces: those with the base rule `erode`, and those that truncate
/// faults. Cost: surfaces times the logarithm of the truncations.
std::vector<std::string> unconformities(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                                        const ModelRules& rules);

struct TrimmedSoup {
  PolygonSoup soup;
  std::vector<double> area_removed;  ///< per surface
  std::vector<std::string> notes;
  std::vector<std::string> warnings;  ///< model-building rules that could not be applied, and why
};
/// Applies stop_at, erode, onlap, on_crossing and trim_overshoot to the arranged soup. The side of a cutting surface on
/// which a piece lies is decided exactly along the curves where the two meet. A piece that does not meet the cutting
/// surface is compared with it on the vertical through the largest facet of the piece. `surfaces` are the surfaces that
/// build_surfaces returned, followed by the sides of the box; `built` lists which of their triangles were made by
/// rules.
TrimmedSoup trim_soup(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                      const ModelRules& rules);

}  // namespace geomesh::geomodel
