// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Model building: the rules by which surfaces that stop short, have holes, are open or cross become a model. There are
/// two steps, before and after the arrangement; both report what they changed and where, with areas or lengths.
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

/// How a surface is extended beyond its border. The extension is computed over the map for horizons, over the mean
/// plane for faults.
enum class Extend {
  none,
  flat,  ///< each point of the border is extended at its own height (faults: at its own distance from the mean plane)
  tangent,  ///< the extension has the mean slope of the surface near the border
  nearest,  ///< the extension takes the height of the nearest vertex of the surface
};

/// How the base of a unit, which is a horizon, cuts other horizons.
enum class BaseRule {
  conformable,
  erode,  ///< the horizon cuts what is older: parts of older horizons above it are removed
  onlap,  ///< younger units end on the horizon: parts of younger horizons below it are removed
};

/// The treatment of horizons that cross where no rule applies.
enum class OnCrossing {
  leave,         ///< both horizons are kept; regions between them get names, with a warning
  clip_younger,  ///< parts of the younger horizon below the older one are removed
  clip_older,    ///< parts of the older horizon above the younger one are removed
  error,         ///< throws Error{invalid_input} with both names, the area and the place
};

/// The triangles of a horizon that come from one scalar field, and the sides of faults on which that field is valid.
struct FieldPart {
  Index end = 0;  ///< one past the row of its last triangle; its first row is the end of the part before
  std::vector<std::pair<std::string, bool>> sides;
  std::optional<Vec3> block;  ///< a point in the fault block in which the field is valid
  std::string field;          ///< name of the field in messages: its file, or "its function"
  /// Something that could not be proven about the level set of the field. The user is warned of it only if the model
  /// keeps one of the triangles, or if one of the places lies where the field is valid.
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
  std::string stop_at;
  bool close_at_box =
      true;  ///< for bodies: whether open ends (rooted salt) are closed beyond the side of the box nearest to each end
  /// For bodies given as a sheet: thickness in m, half of it on either side of the surface. 0: the surface itself is
  /// the body's boundary.
  double thickness = 0;
  BaseRule base = BaseRule::conformable;  ///< how a horizon of the column cuts other horizons
  std::vector<std::string> cut_units;
  /// For horizons given block by block: names of the faults that displace the horizon. The sheets of each block are
  /// extended (`extend`, flat if none is given) beyond these faults, and whatever then lies on the other side of one of
  /// them is removed.
  std::vector<std::string> throw_at;
  bool throw_auto = false;
  /// For horizons with fault polygons: whether faults that pass through the polygons are added to throw_at, if the
  /// project lists none.
  bool throw_at_polygons = false;
  /// For level sets of fields: one part for each field. Parts with sides or a block are cut off at the faults in
  /// throw_at.
  std::vector<FieldPart> field_parts;
  /// For level sets of fields: names of the surfaces above or below which the field is valid, which are horizons for
  /// horizons, and horizons or faults for faults.
  std::vector<std::string> holds_above, holds_below;
  bool has_fault_domain() const {
    return std::any_of(field_parts.begin(), field_parts.end(),
                       [](const FieldPart& part) { return part.block || !part.sides.empty(); });
  }
  /// Whether the surface is continued where it ends a little short of a surface that should bound it
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
  /// false, the ramp is kept.
  bool cut_smeared = true;
};

/// The treatment of layers of the column that are thinner than ModelRules::min_thickness.
enum class ThinLayers {
  keep,      ///< they are kept, and a warning says where they are
  collapse,  ///< the younger horizon is lowered onto the older one there
  error,     ///< throws Error{invalid_input} with both names, the area and the place
};

/// How far surfaces without rules of their own are continued to what bounds them.
struct ContinuationRules {
  double within_of_horizons = 0;
  double within_of_faults = 0;             ///< m
  double within_by_size = 0;               ///< m; of horizons where nobody asks for another one
  Box3 bounds;                             ///< bounding box of the model volume
  std::vector<TriangulatedSurface> sides;  ///< sides of the model volume
};

struct ModelRules {
  std::optional<Box3> box;  ///< model box, required by extend and close_at_box
  std::vector<SurfaceRules> surfaces;
  std::vector<std::string> column;  ///< as in Project: defines which horizons are older and younger
  std::string topography;  ///< name of the horizon that is the ground: parts of all other surfaces above it are removed
  std::string floor;       ///< name of the horizon that is the base: parts of all other surfaces below it are removed
  OnCrossing on_crossing = OnCrossing::leave;
  /// Pieces of horizons and faults that end freely no further than this (m) from the surface that they overshoot are
  /// removed. Pieces that are the only support of another surface's end are kept. 0: nothing is removed.
  double trim_overshoot = 0;
  double min_thickness = 0;  ///< least thickness of layers in m along the vertical; 0: no limit
  ThinLayers thin_layers = ThinLayers::keep;
  StackRules stack;
  /// The project's `rules.continue_within` in m, which replaces the distances derived from the model; negative: not
  /// given.
  double continue_within = -1;
  ContinuationRules continuation;

  SurfaceRules of(std::size_t row) const { return row < surfaces.size() ? surfaces[row] : SurfaceRules{}; }
  /// Returns whether any rule acts on the soup.
  bool trims() const {
    for (const SurfaceRules& rule : surfaces)
      if (!rule.stop_at.empty() || rule.base != BaseRule::conformable || !rule.cut_units.empty() || rule.has_throw() ||
          !rule.holds_above.empty() || !rule.holds_below.empty())
        return true;
    return on_crossing != OnCrossing::leave || trim_overshoot > 0 || !topography.empty() || !floor.empty();
  }
};

struct HorizonBlocks;

/// Per surface, which of its triangles were given and which were made by rules.
struct BuiltRows {
  std::vector<Index> n_given_triangles;
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
  /// Per surface: row of the first triangle by which a fault that ends inside the model was extended only to separate
  /// blocks; no_index if there is none.
  std::vector<Index> first_only_parting;
  /// Per surface: triangles from this row on are those of add_steps; no_index where it has none.
  std::vector<Index> first_step;

  /// Per surface that was continued to what bounds it: 0 for triangles given or filled in, k for those that continue
  /// its k-th run of border. Empty for others.
  std::vector<std::vector<Index>> part_of_triangle;
  /// Per surface and part from 1: number of the fault block in which the part continues the surface; no_index for parts
  /// that follow a run of border.
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
  std::string walls;    ///< comma-separated names of the surfaces up to which it was continued
  double length = 0;    ///< of border, m
  double farthest = 0;  ///< m
  Vec3 place;           ///< of the farthest
  double area = 0;      ///< area of the continuation in m2 before it is cut off at the walls
  std::size_t n_filled = 0;
  double area_filled = 0;  ///< area in m2 of the gaps that were filled
  Vec3 place_filled;       ///< of the largest
};

struct BuiltSurfaces {
  /// Given points and triangles keep their rows, and those that rules add follow; but horizons of layers that collapse
  /// get new triangles.
  std::vector<TriangulatedSurface> surfaces;
  BuiltRows rows;
  SettledStack stack;
  std::vector<ContinuedSurface> continued;
  /// Returns the surfaces without the parts that only separate blocks, which is what the model should contain before
  /// anything is trimmed.
  std::vector<TriangulatedSurface> model_surfaces() const;
  std::vector<std::string> notes;     ///< what each rule changed, with areas
  std::vector<std::string> warnings;  ///< rules that could not be applied, and why
};

/// Adds faults to SurfaceRules::throw_at of horizons with `throw_auto`: those that the horizon crosses as a ramp and,
/// if there are any, those that lie between separate sheets of the horizon. Notes report which. Cost: that of find_ramp
/// for each such horizon and each fault.
void find_ramps(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules, std::vector<std::string>& notes);

/// Removes from SurfaceRules::throw_at of each horizon the faults that, as given, lie entirely above or below it. Such
/// a fault does not displace the horizon, and its extension would divide it. Each is reported by a warning. Cost:
/// vertices of such faults times a search in the map of the horizon.
void leave_out_unreached_faults(const std::vector<TriangulatedSurface>& surfaces, ModelRules& rules,
                                std::vector<std::string>& warnings);

/// Fills holes, extends surfaces and closes bodies. Throws Error{usage} if a rule needs a box and there is none.
/// Progress is counted in surfaces, and a cancelled run ends between two of them. Cost: a 2D triangulation of the
/// borders for each surface that has a rule.
BuiltSurfaces build_surfaces(const std::vector<TriangulatedSurface>& surfaces, const ModelRules& rules,
                             const RunContext& context = {});

/// Returns the names of the horizons that cut older surfaces: those that erode, and those that truncate faults. Cost:
/// surfaces times the logarithm of the truncations.
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
/// on the vertical through their largest facet. `surfaces` are the built ones followed by the box sides; `built` lists
/// which of their triangles were made by rules.
TrimmedSoup trim_soup(const PolygonSoup& soup, const std::vector<TriangulatedSurface>& surfaces, const BuiltRows& built,
                      const ModelRules& rules);

}  // namespace geomesh::geomodel
