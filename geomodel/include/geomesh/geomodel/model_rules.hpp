// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Model building: the rules by which surfaces that stop short, have holes, are open or cross become a model. Two
/// steps, before and after the arrangement; both say what they changed and where, with areas or lengths.
///
///     surfaces --build_surfaces--> surfaces --arrange--> soup --trim_soup--> soup --make_plc--> ...
#pragma once

#include <algorithm>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/stack.hpp"
#include "geomesh/geomodel/surface.hpp"

namespace geomesh::geomodel {

/// How a surface goes on beyond its border. The continuation is made in the map for horizons, in the mean plane for
/// faults.
enum class Extend {
  none,
  flat,     ///< each point of the border goes on at its own height (faults: at its own distance from the mean plane)
  tangent,  ///< goes on with the mean slope near the border
  nearest,  ///< takes the height of the nearest vertex of the surface
};

/// What happens at the base of a unit, that is, at a horizon.
enum class BaseRule {
  conformable,
  erode,  ///< the horizon cuts what is older: parts of older horizons above it go
  onlap,  ///< what is younger ends on the horizon: parts of younger horizons below it go
};

/// Where horizons cross although no rule says how.
enum class OnCrossing {
  leave,         ///< both stay; pockets are named with a warning
  clip_younger,  ///< parts of the younger one below the older one go
  clip_older,    ///< parts of the older one above the younger one go
  error,         ///< Error{invalid_input} with both names, the area and the place
};

/// The triangles of a horizon that come from one field, and on which sides of faults that field holds.
struct FieldPart {
  Index end = 0;                                    ///< behind its last triangle; the first follows the part before
  std::vector<std::pair<std::string, bool>> sides;  ///< faults, each with whether the field holds above it
  std::optional<Vec3> block;                        ///< a place in the fault block where the field holds
  std::string field;                                ///< its file, or "its function", for messages
  /// A doubt tells what of the field's surface was not proven. Its warning is due if the model keeps one of the
  /// triangles, or if one of the places lies where the field holds.
  struct Doubt {
    std::vector<Index> triangles;
    std::vector<Vec3> places;
    std::string warning;
  };
  std::vector<Doubt> doubts;
};

struct SurfaceRules {
  Extend extend = Extend::none;  ///< to beyond the box
  double fill_holes = 0;         ///< fill holes whose border is at most this long (m); infinity: all
  std::string stop_at;           ///< faults: a fault or horizon where the continuation ends (`extent: to_fault NAME`)
  bool close_at_box =
      true;  ///< bodies: close open ends (rooted salt) beyond the side of the box that each end is nearest to
  /// Bodies: the surface is a sheet, and the body has two walls half of this (m) on either side of it; 0: no sheet.
  double thickness = 0;
  BaseRule base = BaseRule::conformable;  ///< horizons of the column
  std::vector<std::string> cut_units;     ///< faults: units of the column that it cuts, one after the other; none: all
  /// Horizons given block by block: faults across which it has throw. Each block's sheets are continued on their own
  /// (`extend`, flat where none) to beyond the faults; what then lies on the other side of one of them goes.
  std::vector<std::string> throw_at;
  bool throw_auto = false;  ///< find_ramps adds faults to throw_at; without any the horizon fills its blocks
  /// Horizons with fault polygons: faults that pass through them are added to throw_at, where that is no list.
  bool throw_at_polygons = false;
  /// Level sets of fields: one part a field. Those with sides or a block are cut off at the faults in throw_at.
  std::vector<FieldPart> field_parts;
  /// Level sets of fields: names of other horizons and, for faults, of faults, above or below which the field holds.
  std::vector<std::string> holds_above, holds_below;
  bool has_fault_domain() const {
    return std::any_of(field_parts.begin(), field_parts.end(),
                       [](const FieldPart& part) { return part.block || !part.sides.empty(); });
  }
  /// The surface is continued where it stops a little short of what bounds it (ContinuationRules).
  bool continues = true;
  bool continues_by_default() const {
    return continues && (fills_blocks() || (extend == Extend::none && throw_at.empty()));
  }
  /// In each fault block in which it has data the horizon is continued to the walls, however far they are.
  bool fills_blocks() const { return throw_auto && throw_at.empty(); }
  bool has_throw() const { return throw_auto || throw_at_polygons || !throw_at.empty(); }
  /// Horizons with throw_at: where one runs on across a fault as a ramp, the throw is restored in its place. False: the
  /// ramp stays.
  bool cut_smeared = true;
};

/// What becomes of layers of the column that are thinner than ModelRules::min_thickness.
enum class ThinLayers {
  keep,      ///< a warning tells where
  collapse,  ///< the younger horizon comes down onto the older one there
  error,     ///< Error{invalid_input} with both names, the area and the place
};

/// How far surfaces without a rule of their own are continued to what bounds them.
struct ContinuationRules {
  double within_of_horizons = 0;           ///< m; 0: borders stay as they are
  double within_of_faults = 0;             ///< m
  double within_by_size = 0;               ///< m; of horizons where nobody asks for another one
  Box3 bounds;                             ///< of the model volume
  std::vector<TriangulatedSurface> sides;  ///< of the model volume
};

struct ModelRules {
  std::optional<Box3> box;             ///< needed by extend and close_at_box
  std::vector<SurfaceRules> surfaces;  ///< parallel to the surfaces; missing ones have the defaults
  std::vector<std::string> column;     ///< as in Project: tells older from younger
  std::string topography;              ///< a horizon: parts of all other surfaces above it go
  std::string floor;                   ///< a horizon: parts of all other surfaces below it go
  OnCrossing on_crossing = OnCrossing::leave;
  /// Pieces of horizons and faults that end freely no further than this (m) from the surface that they overshoot are
  /// removed. Those on which alone another surface ends stay. 0: none.
  double trim_overshoot = 0;
  double min_thickness = 0;  ///< m, along the vertical; 0: no rule
  ThinLayers thin_layers = ThinLayers::keep;
  StackRules stack;
  /// `rules.continue_within` of the project, m: in place of the distances that follow from the model; negative: not
  /// given.
  double continue_within = -1;
  ContinuationRules continuation;

  SurfaceRules of(std::size_t row) const { return row < surfaces.size() ? surfaces[row] : SurfaceRules{}; }
  /// Whether any rule acts on the soup.
  bool trims() const {
    for (const SurfaceRules& rule : surfaces)
      if (!rule.stop_at.empty() || rule.base != BaseRule::conformable || !rule.cut_units.empty() || rule.has_throw() ||
          !rule.holds_above.empty() || !rule.holds_below.empty())
        return true;
    return on_crossing != OnCrossing::leave || trim_overshoot > 0 || !topography.empty() || !floor.empty();
  }
};

struct HorizonBlocks;

/// Which triangles are whose, per input surface.
struct BuiltRows {
  std::vector<Index> n_given_triangles;  ///< from this row on triangles were made by rule
  /// Per surface with a list of faults under throw_at: the block of each triangle, or of_every_block; the field (row of
  /// SurfaceRules::field_parts) where fields hold on certain sides of faults. Empty for others.
  std::vector<std::vector<Index>> block_of_triangle;
  /// Per surface and block of throw_blocks: the field that holds there, or no_index. Empty for surfaces without fields
  /// that hold on certain sides of faults.
  std::vector<std::vector<Index>> field_of_block;
  /// Per surface: the blocks of these faults alone, as if each went on through the model; null for others.
  std::vector<std::shared_ptr<const HorizonBlocks>> throw_blocks;
  /// The blocks of all faults; null while no horizon needs them.
  std::shared_ptr<const HorizonBlocks> blocks_of_faults;
  /// Per surface: rows of the faults that part it into these blocks, ascending.
  std::vector<std::vector<Index>> parted_at;
  /// Per surface: from this row on a fault that ends inside the model was continued only to part blocks; no_index where
  /// none was.
  std::vector<Index> first_only_parting;
  /// Per surface: triangles from this row on are those of add_steps; no_index where it has none.
  std::vector<Index> first_step;

  /// Per surface that was continued to what bounds it: 0 for triangles given or filled in, k for those that continue
  /// its k-th run of border. Empty for others.
  std::vector<std::vector<Index>> part_of_triangle;
  /// Per surface and part from 1: the fault block in which it continues the surface; no_index for what follows a run of
  /// border.
  std::vector<std::vector<Index>> block_of_part;
  /// Per surface: rows of the surfaces at which its continuations end, ascending.
  std::vector<std::vector<Index>> continued_to;
  /// Rows of the faults that run a little beyond faults on which they end, ascending.
  std::vector<Index> overshooting;
  /// Rows of faults, each with that of a horizon that truncates it (an unconformity), ascending.
  std::vector<std::pair<Index, Index>> truncations;
  bool any_continued() const {
    return !overshooting.empty() || !truncations.empty() ||
           std::any_of(part_of_triangle.begin(), part_of_triangle.end(),
                       [](const auto& part) { return !part.empty(); });
  }

  static constexpr Index of_every_block = no_index;  ///< not cut off at the faults between blocks
};

/// A surface that was continued to what bounds it, for the report and the page.
struct ContinuedSurface {
  std::string name;
  std::string walls;    ///< names of what it was continued to, with commas
  double length = 0;    ///< of border, m
  double farthest = 0;  ///< m
  Vec3 place;           ///< of the farthest
  double area = 0;      ///< of the continuation before it is cut off at the walls, m2
  std::size_t n_filled = 0;
  double area_filled = 0;  ///< of gaps in it, m2
  Vec3 place_filled;       ///< of the largest
};

struct BuiltSurfaces {
  /// Rows of points and triangles as given stay, and what rules add follows; but layers that collapse give their
  /// horizons new triangles.
  std::vector<TriangulatedSurface> surfaces;
  BuiltRows rows;
  SettledStack stack;
  std::vector<ContinuedSurface> continued;
  /// The surfaces without what only served to part blocks: what the model is to hold before anything is trimmed.
  std::vector<TriangulatedSurface> model_surfaces() const;
  std::vector<std::string> notes;     ///< what each rule did, with areas
  std::vector<std::string> warnings;  ///< rules that could not be applied, and why
};

/// Adds faults to SurfaceRules::throw_at of horizons with `throw_auto`: those that horizons run across as ramps and,
/// where there are any, those that lie between sheets of the horizon. Notes tell. Cost: that of find_ramp for each such
/// horizon and each fault.
void find_ramps(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules, std::vector<std::string>& notes);

/// Takes from SurfaceRules::throw_at of each horizon the faults that lie wholly above or below it, as given. Such a
/// fault has no throw there, and its continuation would part the horizon. A warning tells of each.
/// Cost: vertices of such faults times a search in the map of the horizon.
void leave_out_unreached_faults(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules,
                                std::vector<std::string>& warnings);

/// Fills holes, extends, closes bodies. Throws Error{usage} where a rule needs a box and there is none. Surfaces done
/// are counted, and a cancelled run ends between them.
/// Cost: a 2D triangulation of the borders for each surface that has a rule.
BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                             const RunContext& context = {});

/// Names of the horizons that cut what is older: those that erode, and those that truncate faults.
/// Cost: surfaces times the logarithm of the truncations.
std::vector<std::string> unconformities(const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                                        const ModelRules& rules);

/// Beyond the end of a fault that ends inside, what continues it to part blocks is removed again, and the blocks of a
/// horizon need not meet there: throw is left, or they were settled one by one. Appends to each horizon that has blocks
/// or parts the triangles by which such faults were continued. trim_soup gives those of their parts to the horizon that
/// lie between its blocks. Called after the arrangement. Sets BuiltRows::first_step.
void add_steps(std::vector<TriangulatedSurface>& surfaces, BuiltRows& built);

struct TrimmedSoup {
  PolygonSoup soup;
  std::vector<double> area_removed;  ///< per surface
  std::vector<std::string> notes;
  std::vector<std::string> warnings;  ///< rules that could not be applied, and why
};
/// Applies stop_at, erode, onlap, on_crossing and trim_overshoot to the arranged soup. Sides are decided by exact
/// orientation along the curves where surfaces meet; pieces that do not meet the cutting surface are compared with it
/// on the vertical through their largest facet. `surfaces` are the built ones followed by the box sides; `built` tells
/// which of their triangles rules made.
TrimmedSoup trim_soup(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                      const ModelRules& rules);

}  // namespace geomesh::geomodel
