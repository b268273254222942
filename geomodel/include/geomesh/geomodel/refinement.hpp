// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// What a project or a command line asks of sizes and shapes, in the user's names (docs/meshing.md).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/refine.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"

namespace geomesh::geomodel {

/// A size asked near a place.
struct PlaceSize {
  Vec3 place;  ///< in the project's coordinates
  AskedSize asked;
};

/// Sizes by name. `base` holds what needs no names: global size, curvature, gaps, gradation, bounds.
struct NamedSizes {
  SizeOptions base;
  std::map<std::string, AskedSize> units;     ///< by unit, body or region; inside of it
  std::map<std::string, AskedSize> surfaces;  ///< by surface or side of the box
  /// By curve, by well, or by kind: `wells`, `intersections`, `borders`, `fault_tips`.
  std::map<std::string, AskedSize> curves;
  std::vector<PlaceSize> near;
  std::map<std::string, double> layers;  ///< by unit, body or region: elements across it, however thin it is
  double frequency = 0;  ///< Hz: units ask for a share of the wavelength of their slower wave (attributes vs, vp)
  double points_per_wavelength = 5;
  struct DepthSize {
    double depth, size;
  };
  std::vector<DepthSize> by_depth;  ///< depth below z = 0, rising; linear between
  /// Sizes at points, read into base.background before meshing (docs/meshing.md says which files); empty: none.
  std::filesystem::path background;
};

struct RefinementSettings {
  bool refine = false;  ///< false: the mesh keeps the points that recovery needs, and the rest is not looked at
  NamedSizes size;
  QualityLevel quality = QualityLevel::standard;
  QualityMeasure quality_measure = QualityMeasure::dihedral;
  Honour honour = Honour::exact;
  ToleranceLedger tolerance;     ///< Honour::tolerance; its length is set by settle_sizes where it follows the sizes
  bool derive_size = false;      ///< nobody asks for a size of the whole model: settle_sizes derives one
  bool gaps_by_default = false;  ///< the project does not say what gaps between surfaces ask for
  bool gradation_by_default = false;  ///< nor how soon sizes grow
  double derived_elements = 1e5;      ///< for about so many elements
  double target_elements = 0;         ///< all sizes are scaled so that about so many elements come out; 0: none
  bool sizes_on_surfaces = true;      ///< false: surfaces get no points for sizes (RefineOptions::size_surfaces)
  std::size_t max_elements = 50'000'000;
  double time_budget = 0;
  std::vector<std::string> cell_arrays;  ///< of known_cell_arrays(), written with the mesh whether it is refined or not
};

/// Where neither is said: a twentieth of the size.
inline constexpr double default_tolerance_share = 1.0 / 20;

/// Values by unit or region: attribute: value.
using UnitAttributes = std::map<std::string, std::map<std::string, double>>;

/// An edge length that comes to about so many elements in a volume of these bounds, with two digits.
double derived_size(const Box3& bounds, double elements = 1e5);
/// By frequency and points per wavelength: of the slower of the waves whose velocities the attributes tell (vs where it
/// is above 0, else vp); 0 where they tell none.
double wavelength_size(const NamedSizes& sizes, const std::map<std::string, double>& attributes);
/// Sets what depends on the model: the size of the whole model where it is to be derived or follows from a frequency;
/// sizes by depth as part of the background; and the largest distance of surfaces from the input where it follows the
/// sizes. `origin` was subtracted from the model's coordinates. Throws Error{usage} where a frequency has no velocity.
void settle_sizes(RefinementSettings& settings, const Box3& bounds, const UnitAttributes& attributes,
                  const Vec3& origin);
/// How near to each other surfaces that meet are brought together before they are meshed within a tolerance: a share of
/// the tolerance, and of the one that the least size asked would get by itself. 0: not at all, as where sizes come from
/// a file.
double merging_distance(const RefinementSettings& settings);
/// A coarse mesh in seconds: about 10,000 elements of one size, nothing else asked for.
RefinementSettings preview_settings();

/// size, min_dihedral, max_dihedral, radius_ratio, mean_ratio, aspect.
const std::vector<std::string>& known_cell_arrays();

/// What about the settings contradicts itself or the mode of meshing, in words; empty: nothing.
std::string contradiction(const RefinementSettings& settings, const RecoverOptions& recover);

}  // namespace geomesh::geomodel
