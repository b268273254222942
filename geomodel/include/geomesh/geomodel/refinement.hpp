// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Mesh sizes and shapes as requested by a project or the command line, with the names that users give
/// (docs/meshing.md).
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "geomesh/core/refine.hpp"
#include "geomesh/geomodel/tolerance_ledger.hpp"

namespace geomesh::geomodel {

/// A target edge length near a point.
struct PlaceSize {
  Vec3 place;  ///< place of the target size, in the project's coordinates
  AskedSize asked;
};

/// Target sizes by the names of units, surfaces and curves. `base` holds the settings without names: global size,
/// curvature, gaps, gradation, bounds.
struct NamedSizes {
  SizeOptions base;
  std::map<std::string, AskedSize> units;     ///< target sizes inside of units, bodies or regions, by name
  std::map<std::string, AskedSize> surfaces;  ///< target sizes on surfaces or sides of the box, by name
  /// Target sizes on curves, by name of the curve or well, or by kind: `wells`, `intersections`, `borders`,
  /// `fault_tips`.
  std::map<std::string, AskedSize> curves;
  std::vector<PlaceSize> near;
  /// Number of elements across a unit, body or region, however thin it is, by name.
  std::map<std::string, double> layers;
  /// Wave frequency in Hz. If it is given, target sizes in units become a fraction of the wavelength of the slower wave
  /// (from the attributes vs and vp).
  double frequency = 0;
  double points_per_wavelength = 5;
  struct DepthSize {
    double depth, size;
  };
  std::vector<DepthSize> by_depth;  ///< target sizes by depth below z = 0, ascending; interpolated linearly
  /// File with target sizes at points, read into base.background before meshing (formats: docs/meshing.md); may be
  /// empty.
  std::filesystem::path background;
};

struct RefinementSettings {
  /// Whether the mesh is refined. If not, points are added only to recover the facets, and other settings are ignored.
  bool refine = false;
  NamedSizes size;
  QualityLevel quality = QualityLevel::standard;
  QualityMeasure quality_measure = QualityMeasure::dihedral;
  Honour honour = Honour::exact;
  /// Tolerance within which surfaces may be remeshed (Honour::tolerance). If it follows the target sizes, settle_sizes
  /// sets its length.
  ToleranceLedger tolerance;
  bool derive_size = false;           ///< set if no global size is given, so that it must be derived from the model
  bool gaps_by_default = false;       ///< set if the project does not say how gaps between surfaces are refined
  bool gradation_by_default = false;  ///< set if the project gives no gradation, so that deriving sizes may change it
  double derived_elements = 1e5;      ///< approximate number of elements from which the global size is derived
  double target_elements = 0;  ///< all sizes are scaled to reach about this number of elements; 0: they are not scaled
  /// Whether points are added on surfaces to reach the target sizes (RefineOptions::size_surfaces).
  bool sizes_on_surfaces = true;
  std::size_t max_elements = 50'000'000;
  double time_budget = 0;
  /// Names of the cell arrays (among known_cell_arrays()) that are written with the mesh, whether it is refined or not.
  std::vector<std::string> cell_arrays;
};

/// Tolerance of surfaces as a share of the target size, used if the project gives neither a length nor a share.
inline constexpr double default_tolerance_share = 1.0 / 20;

/// Attribute values, by the name of the unit or region and then by the name of the attribute.
using UnitAttributes = std::map<std::string, std::map<std::string, double>>;

/// Returns the edge length, rounded to two digits, with which about the given number of elements fill a box.
double derived_size(const Box3& bounds, double elements = 1e5);
/// Returns the target size that follows from the frequency, the points per wavelength and the velocity of the slower
/// wave: the attribute vs if it is above 0, else vp. Returns 0 if the attributes give no velocity.
double wavelength_size(const NamedSizes& sizes, const std::map<std::string, double>& attributes);
/// Sets the mesh sizes that depend on the model: the global size, if it is to be derived or follows from a frequency;
/// sizes by depth as part of the background; and the tolerance of surfaces, if it follows the sizes. `origin` was
/// subtracted from the model's coordinates. Throws Error{usage} if a frequency is given and no unit has a velocity.
void settle_sizes(RefinementSettings& settings, const Box3& bounds, const UnitAttributes& attributes,
                  const Vec3& origin);
/// Returns the distance within which surfaces that meet are merged before they are remeshed within a tolerance: a fixed
/// share of the tolerance, or of the tolerance that belongs to the smallest requested size if that is less. Returns 0
/// (no merging) if sizes come from a file.
double merging_distance(const RefinementSettings& settings);
/// Returns settings for a coarse mesh in seconds: about 10,000 elements of one size and no other requests.
RefinementSettings preview_settings();

/// Returns the names of the cell arrays that can be written: size, min_dihedral, max_dihedral, radius_ratio,
/// mean_ratio, aspect.
const std::vector<std::string>& known_cell_arrays();

/// Describes any contradiction among the mesh settings, or with the recovery options; empty if there is none.
std::string contradiction(const RefinementSettings& settings, const RecoverOptions& recover);

}  // namespace geomesh::geomodel
