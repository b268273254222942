// SPDX-License-Identifier: GPL-3.0-or-later
// Checks the element shapes in the report against the mesh, declared in check/arrays/check_arrays.hpp.
#include <algorithm>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "check/arrays/check_arrays.hpp"
#include "check/arrays/element_shape.hpp"
#include "check/mesh/faults.hpp"

namespace geomesh::geomodel::checking {
namespace {

using json = nlohmann::json;

/// Bounds of a number that is uncertain because of rounding.
struct Between {
  double low, high;
  void make_least(double value, double slack) {
    low = std::min(low, value - slack);
    high = std::min(high, value + slack);
  }
  void make_greatest(double value, double slack) {
    low = std::max(low, value - slack);
    high = std::max(high, value + slack);
  }
};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr Between above_all{infinity, infinity}, below_all{-infinity, -infinity};

bool is_count(const json& told, std::size_t least, std::size_t most) {
  return told.is_number_unsigned() && told.get<std::size_t>() >= least && told.get<std::size_t>() <= most;
}

/// A histogram of values that are uncertain because of rounding. It counts the values that are certainly in a bin, and
/// those that may be in it.
class Bins {
 public:
  Bins(std::size_t n, double width) : certain_(n, 0), possible_(n, 0), width_(width) {}
  void add(double value, double slack) {
    const std::size_t first = bin_of(value - slack), last = bin_of(value + slack);
    if (first == last) ++certain_[first];
    for (std::size_t b = first; b <= last; ++b) ++possible_[b];
    ++n_;
  }
  bool agrees(const json& told) const {
    if (!told.is_array() || told.size() != certain_.size()) return false;
    std::size_t sum = 0;
    for (std::size_t b = 0; b < certain_.size(); ++b) {
      if (!is_count(told[b], certain_[b], possible_[b])) return false;
      sum += told[b].get<std::size_t>();
    }
    return sum == n_;
  }

 private:
  std::size_t bin_of(double value) const {
    const double bin = std::floor(value / width_);
    return static_cast<std::size_t>(std::clamp(bin, 0.0, static_cast<double>(certain_.size() - 1)));
  }
  std::vector<std::size_t> certain_, possible_;
  std::size_t n_ = 0;
  double width_;
};

/// The mean of uncertain values. The error of each value is limited by the length of the range of possible values.
class Mean {
 public:
  explicit Mean(double range) : range_(range) {}
  void add(double value, double slack) {
    sum_ += value;
    slack_ += std::min(slack, range_);
    ++n_;
  }
  Between between() const {
    const double n = static_cast<double>(n_);
    return {(sum_ - slack_) / n, (sum_ + slack_) / n};
  }

 private:
  double range_, sum_ = 0, slack_ = 0;
  std::size_t n_ = 0;
};

/// Elements with an angle below this many degrees are counted and listed.
constexpr double sharp = 8;

/// Shape statistics of the elements of the whole mesh or of one region.
struct Shapes {
  std::size_t n = 0, n_sharp = 0, n_sharp_at_most = 0;
  Between min_dihedral = above_all, max_dihedral = below_all, min_radius_ratio = above_all, shortest = above_all,
          longest = below_all;
  Mean mean_min_dihedral{180}, mean_max_dihedral{180}, mean_radius_ratio{1}, mean_mean_ratio{1}, mean_aspect{1};
  Bins least_angles{18, 5}, angles{36, 5}, radius_ratios{20, 0.05};

  void add(const ElementShape& s) {
    const double of_angles = s.slack_of_angles(), of_ratios = s.slack_of_ratios();
    ++n;
    n_sharp += s.min_dihedral + of_angles < sharp;
    n_sharp_at_most += s.min_dihedral - of_angles < sharp;
    min_dihedral.make_least(s.min_dihedral, of_angles);
    max_dihedral.make_greatest(s.max_dihedral, of_angles);
    min_radius_ratio.make_least(s.radius_ratio, of_ratios);
    mean_min_dihedral.add(s.min_dihedral, of_angles);
    mean_max_dihedral.add(s.max_dihedral, of_angles);
    mean_radius_ratio.add(s.radius_ratio, of_ratios);
    mean_mean_ratio.add(s.mean_ratio, of_ratios);
    mean_aspect.add(s.aspect, of_ratios);
    shortest.make_least(s.shortest_edge, s.slack_of_lengths());
    longest.make_greatest(s.longest_edge, s.slack_of_lengths());
    least_angles.add(s.min_dihedral, of_angles);
    for (const double angle : s.dihedral) angles.add(angle, of_angles);
    radius_ratios.add(s.radius_ratio, of_ratios);
  }
};

/// Returns the JSON value at a path of the report, or null if the report has no such entry.
const json& at(const json& from, const char* path) {
  static const json nothing;
  const json::json_pointer pointer(path);
  return from.contains(pointer) ? from.at(pointer) : nothing;
}
bool is_in(const json& told, const Between& due) {
  return told.is_number() && told.get<double>() >= due.low && told.get<double>() <= due.high;
}

bool histograms_agree(const json& told, const Shapes& due) {
  return due.least_angles.agrees(at(told, "/min_dihedral_histogram")) &&
         due.angles.agrees(at(told, "/dihedral_histogram")) &&
         due.radius_ratios.agrees(at(told, "/radius_ratio_histogram"));
}

bool agree(const json& told, const Shapes& due) {
  return is_count(at(told, "/tetrahedra"), due.n, due.n) && is_in(at(told, "/min_dihedral/min"), due.min_dihedral) &&
         is_in(at(told, "/max_dihedral/max"), due.max_dihedral) &&
         is_in(at(told, "/radius_ratio/min"), due.min_radius_ratio) &&
         is_in(at(told, "/min_dihedral/mean"), due.mean_min_dihedral.between()) &&
         is_in(at(told, "/max_dihedral/mean"), due.mean_max_dihedral.between()) &&
         is_in(at(told, "/radius_ratio/mean"), due.mean_radius_ratio.between()) &&
         is_in(at(told, "/mean_ratio/mean"), due.mean_mean_ratio.between()) &&
         is_in(at(told, "/aspect/mean"), due.mean_aspect.between()) &&
         is_in(at(told, "/edge_length/min"), due.shortest) && is_in(at(told, "/edge_length/max"), due.longest) &&
         histograms_agree(told, due);
}

/// Returns whether the report's extremes, histograms and number of sharp elements agree with the measured ones.
bool agree_on_whole(const json& quality, const Shapes& due) {
  return agree(at(quality, "/whole"), due) && is_in(at(quality, "/min_dihedral"), due.min_dihedral) &&
         is_in(at(quality, "/max_dihedral"), due.max_dihedral) &&
         is_in(at(quality, "/min_radius_ratio"), due.min_radius_ratio) && histograms_agree(quality, due) &&
         is_count(at(quality, "/below_8_degrees/tetrahedra"), due.n_sharp, due.n_sharp_at_most);
}

/// Checks the quality statistics in the report of a mesh made on MPI ranks (docs/ranks-report.schema.json).
bool agree_on_parts(const json& quality, const Shapes& due) {
  return is_in(at(quality, "/min_dihedral/min"), due.min_dihedral) &&
         is_in(at(quality, "/min_dihedral/mean"), due.mean_min_dihedral.between()) &&
         is_in(at(quality, "/max_dihedral"), due.max_dihedral) &&
         is_in(at(quality, "/radius_ratio/min"), due.min_radius_ratio) &&
         is_in(at(quality, "/radius_ratio/mean"), due.mean_radius_ratio.between()) &&
         is_in(at(quality, "/mean_ratio"), due.mean_mean_ratio.between());
}

/// Checks one entry of the report's list of worst elements: cell index, angles, position and region.
bool agree_on_element(const CheckedMesh& mesh, const json& told, double ulp) {
  const json& row = at(told, "/tetrahedron");
  if (!is_count(row, 0, mesh.cells.size() - 1)) return false;
  const std::size_t c = row.get<std::size_t>();
  const ElementShape s = element_shape(mesh, mesh.cells[c], ulp);
  const double slack = s.slack_of_angles();
  const Vec3 place = centroid(mesh, mesh.cells[c]);
  const double by_rounding = 8 * ulp;
  return is_in(at(told, "/min_dihedral"), {s.min_dihedral - slack, s.min_dihedral + slack}) &&
         is_in(at(told, "/max_dihedral"), {s.max_dihedral - slack, s.max_dihedral + slack}) &&
         is_in(at(told, "/place/0"), {place.x - by_rounding, place.x + by_rounding}) &&
         is_in(at(told, "/place/1"), {place.y - by_rounding, place.y + by_rounding}) &&
         is_in(at(told, "/place/2"), {place.z - by_rounding, place.z + by_rounding}) &&
         at(told, "/region") == json(mesh.file.region[c]);
}

struct MeasuredShapes {
  const Shapes& whole;
  const std::map<std::int32_t, Shapes>& regions;
  double ulp;
};

/// Checks the quality statistics in the report of a mesh made in one process (docs/report.schema.json).
void compare(const CheckedMesh& mesh, const json& quality, const MeasuredShapes& due, FaultCollector& differs) {
  if (!agree_on_whole(quality, due.whole)) differs.add(0, {});
  const json& told = at(quality, "/regions");
  for (const auto& [id, shapes] : due.regions) {
    const auto is_of_region = [id = id](const json& entry) { return at(entry, "/region") == json(id); };
    const auto entry = told.is_array() ? std::find_if(told.begin(), told.end(), is_of_region) : told.end();
    if (entry == told.end() || !agree(*entry, shapes)) differs.add(static_cast<std::size_t>(id), {});
  }
  if (const json& worst = at(quality, "/worst"); worst.is_array())
    for (const json& element : worst)
      if (!agree_on_element(mesh, element, due.ulp)) differs.add(0, {});
}

}  // namespace

void check_report_quality(const CheckedMesh& mesh, const json& report, double ulp, CheckResult& result) {
  const json& quality = at(report, "/quality");
  if (!quality.is_object()) return;
  Shapes whole;
  std::map<std::int32_t, Shapes> regions;
  for (std::size_t c = 0; c < mesh.cells.size(); ++c) {
    const ElementShape shape = element_shape(mesh, mesh.cells[c], ulp);
    whole.add(shape);
    regions[mesh.file.region[c]].add(shape);
  }
  FaultCollector differs("report_differs");
  if (at(quality, "/min_dihedral").is_object()) {
    if (!agree_on_parts(quality, whole)) differs.add(0, {});
  } else {
    compare(mesh, quality, {whole, regions, ulp}, differs);
  }
  differs.report(result, "entries of the report's quality are not what the elements of the mesh are");
  result.checks_done.emplace_back("the report's shapes of elements are those of the mesh");
}

}  // namespace geomesh::geomodel::checking
