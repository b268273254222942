// SPDX-License-Identifier: GPL-3.0-or-later
#include "refinement_flags.hpp"

#include <charconv>
#include <cmath>

namespace geomesh::app {

namespace {

/// Checks that a text is a length. CLI11's own validators would say "not in range 0.00000 to 17976931348...".
std::string is_length(const std::string& text) {
  double value = 0;
  const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (status == std::errc() && end == text.data() + text.size() && std::isfinite(value) && value > 0) return {};
  return "a number above zero was expected, found '" + text + "'";
}

}  // namespace

void RefinementFlags::add_to(CLI::App& app) {
  const CLI::Validator positive(is_length, "POSITIVE");
  app.add_option("--size", size_, "Refine: wanted edge length; less where the input's edges are shorter")
      ->type_name("H")
      ->check(positive);
  app.add_option(
         "--size-from", size_from_,
         "Refine: wanted edge lengths at points: lines of x y z size, or a .vti, .vtu or .vtp with an array \"size\"")
      ->type_name("FILE")
      ->check(CLI::ExistingFile);
  app.add_option("--quality", quality_, "Refine: how much is done for the elements' shapes")
      ->check(CLI::IsMember({"fast", "default", "best"}));
  app.add_option("--quality-measure", quality_measure_, "Refine: what makes a shape good (dihedral)")
      ->check(CLI::IsMember(std::vector<std::string>(quality_measure_names.begin(), quality_measure_names.end())));
  app.add_option("--gradation", gradation_, "Refine: growth of sizes per unit of distance (0.3)")
      ->type_name("G")
      ->check(positive);
  app.add_option("--curvature", curvature_, "Refine: degrees that one edge may turn on curved surfaces")
      ->type_name("A")
      ->check(positive);
  app.add_option("--tolerance", tolerance_,
                 "Refine: surfaces may be remeshed within this distance of the input (default: kept exactly)")
      ->type_name("T")
      ->check(positive);
  app.add_flag("--no-size-on-surfaces", inside_only_,
               "Refine: sizes hold inside only; surfaces keep their triangles, and get no points for sizes");
  app.add_option("--max-elements", max_elements_, "End with a message if the sizes require more tetrahedra")
      ->type_name("N")
      ->check(CLI::Range(std::size_t{1}, std::size_t{4'000'000'000}));
  app.add_option("--time-budget", time_budget_, "Seconds for improving shapes; the result then depends on the machine")
      ->type_name("S")
      ->check(positive);
  app.add_option(
         "--cell-arrays", cell_arrays_,
         "Also write these for each tetrahedron: size, min_dihedral, max_dihedral, radius_ratio, mean_ratio, aspect")
      ->type_name("NAME,...")
      ->delimiter(',')
      ->check(CLI::IsMember(geomodel::known_cell_arrays()));
}

geomodel::RefinementSettings RefinementFlags::settings() const {
  geomodel::RefinementSettings s;
  s.refine = size_ || gradation_ || curvature_ || tolerance_ || inside_only_ || !quality_.empty() ||
             !quality_measure_.empty() || !size_from_.empty();
  s.size.base.global = size_.value_or(0);
  s.size.base.gradation = gradation_.value_or(s.size.base.gradation);
  s.size.base.curvature_angle = curvature_.value_or(0);
  s.size.background = size_from_;
  if (tolerance_) s.honour = Honour::tolerance;
  if (tolerance_) s.tolerance = geomodel::ToleranceLedger::of_length(*tolerance_);
  s.sizes_on_surfaces = !inside_only_;
  if (quality_ == "fast") s.quality = QualityLevel::fast;
  if (quality_ == "best") s.quality = QualityLevel::best;
  s.quality_measure = quality_measure_of(quality_measure_).value_or(s.quality_measure);
  s.max_elements = max_elements_.value_or(s.max_elements);
  s.time_budget = time_budget_.value_or(0);
  s.cell_arrays = cell_arrays_;
  return s;
}

}  // namespace geomesh::app
