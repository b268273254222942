// SPDX-License-Identifier: GPL-3.0-or-later
// families_bench [--every K] [--limit SECONDS] [--peer SWITCHES] [--kept] [--largest N] [--growth] [--list] [FAMILY...]
//
// The families of recovery_families.hpp, and networks of discs where geomodel is built, each model in a process of its
// own on one core. A model must be meshed and pass the exact checker, fill its volume to 1e-9, get few added points,
// take at most 20 times its family's median time a facet, and at most 60 CPU seconds for each 50,000 facets. Exit
// status 1 where one does not. --every K: each K-th model alone. --peer: TetGen with these switches beside it, "p" or
// "pY". With "p" the exit status is 1 also if the geometric mean of the families' times over TetGen's is above 1; it
// counts each family once, and models that TetGen does not mesh within the limit not at all. --kept: all given
// triangles stay and no point is added on them (preserve_boundary). --largest N: models of at most N facets. --growth:
// recovery of 1,000 discs over that of 200 too, which may be at most 8.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "corpus_run.hpp"
#include "recovery_families.hpp"
#include "recovery_peer.hpp"
#ifdef GEOMESH_BENCH_GEOMODEL
#include "disc_network.hpp"
#endif

namespace {

using namespace geomesh;
using bench::Measurement;

struct Options {
  unsigned every = 1, limit = 600;
  std::string peer;
  bool lists = false, keeps_boundary = false, has_growth = false;
  double largest = 1e9;  ///< facets
  std::vector<std::string> families;
};

struct Row {
  std::string name, fault, peer_fault;
  double facets = 0, points = 0, cpu_s = 0, added = 0, ratio = 0;  ///< ratio: of TetGen's time; 0 where it has none
  double per_facet() const { return cpu_s / facets; }
};

Options options_of(int argc, char** argv) {
  Options out;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--every" && has_value)
      out.every = static_cast<unsigned>(std::stoul(argv[++i]));
    else if (word == "--limit" && has_value)
      out.limit = static_cast<unsigned>(std::stoul(argv[++i]));
    else if (word == "--peer" && has_value)
      out.peer = argv[++i];
    else if (word == "--largest" && has_value)
      out.largest = std::stod(argv[++i]);
    else if (word == "--list")
      out.lists = true;
    else if (word == "--kept")
      out.keeps_boundary = true;
    else if (word == "--growth")
      out.has_growth = true;
    else
      out.families.push_back(word);
  }
  return out;
}

/// Added points: at most half a percent of the vertices; plates and fans may keep one for ten needles.
double most_added(const std::string& family, const Row& row) {
  const double of_needles = family == "plates" || family == "fans" ? 0.1 : 0;
  return std::max(1.0, std::max(0.005, of_needles) * row.points);
}

/// Facets of a model; lines have more points than facets.
double size_of(const test::FamilyModel& model) {
  return static_cast<double>(std::max(model.plc.points.size(), bench::n_triangles(model.plc)));
}

TetrahedralizeOptions mode_of(const Options& options) {
  return options.keeps_boundary ? test::preserving_mode() : test::constrained_mode();
}

Row run(const std::string& family, const test::FamilyModel& model, const Options& options) {
  Row row;
  row.name = model.name;
  row.points = static_cast<double>(model.plc.points.size());
  row.facets = size_of(model);
  const Measurement ours = bench::measure_ours(model.plc, mode_of(options), options.limit);
  row.cpu_s = ours.cpu_s;
  row.added = static_cast<double>(ours.answer.added_points);
  if (!ours.ok)
    row.fault = ours.message;
  else if (!(std::fabs(ours.answer.volume / model.volume - 1) < 1e-9))
    row.fault = "wrong volume";
  else if (row.added > most_added(family, row))
    row.fault = "too many added points";
  else if (row.cpu_s > 60 * std::max(1.0, row.facets / 50000))
    row.fault = "takes too long";
  if (!options.peer.empty()) {
    const Measurement theirs = bench::measure_tetgen(model.plc, options.peer + "Q", options.limit);
    if (theirs.ok && ours.ok) row.ratio = row.cpu_s / theirs.cpu_s;
    if (!theirs.ok) row.peer_fault = theirs.message;
  }
  return row;
}

/// Geometric mean of positive numbers; 0 if there are none.
double geometric_mean(const std::vector<double>& numbers) {
  double sum = 0;
  for (const double x : numbers) sum += std::log(x);
  return numbers.empty() ? 0 : std::exp(sum / static_cast<double>(numbers.size()));
}

/// Times over TetGen's, of the rows that have both.
std::vector<double> ratios_of(const std::vector<Row>& rows) {
  std::vector<double> out;
  for (const Row& row : rows)
    if (row.ratio > 0) out.push_back(row.ratio);
  return out;
}

/// Returns whether all bounds are kept.
bool report(const std::string& family, std::vector<Row> rows, const Options& options) {
  std::vector<double> times;
  for (const Row& row : rows) times.push_back(row.per_facet());
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2];
  double worst = 0, longest = 0, added = 0, points = 0;
  int n_faults = 0;
  for (Row& row : rows) {
    if (row.fault.empty() && row.per_facet() > 20 * median) row.fault = "over 20 times the median time a facet";
    worst = std::max(worst, row.per_facet() / median);
    longest = std::max(longest, row.cpu_s);
    added += row.added;
    points += row.points;
    if (options.lists || !row.fault.empty())
      std::printf("  %-36s %8.0f facets %8.3f s %6.1f us/facet %6.0f added %6.2f %s%s%s\n", row.name.c_str(),
                  row.facets, row.cpu_s, 1e6 * row.per_facet(), row.added, row.ratio, row.fault.c_str(),
                  row.peer_fault.empty() ? "" : " TetGen: ", row.peer_fault.c_str());
    n_faults += !row.fault.empty();
  }
  std::printf("| %s | %zu | %d | %.1f | %.1f | %.1f | %.3f %% | %.2f over %zu |\n", family.c_str(), rows.size(),
              n_faults, 1e6 * median, worst, longest, 100 * added / points, geometric_mean(ratios_of(rows)),
              ratios_of(rows).size());
  std::fflush(stdout);
  return n_faults == 0;
}

#ifdef GEOMESH_BENCH_GEOMODEL
/// Recovery of 1,000 discs over that of 200 in the same cube, the number of discs that one meets the same.
bool report_growth(const Options& options) {
  double seconds[2] = {0, 0}, facets[2] = {0, 0};
  const unsigned sizes[2] = {200, 1000};
  for (const unsigned k : {0u, 1u}) {
    const test::FamilyModel model = geomodel::testing::disc_network(1, sizes[k]);
    const Measurement m = bench::measure_ours(model.plc, mode_of(options), options.limit);
    if (!m.ok) std::printf("%s: %s\n", model.name.c_str(), m.message.c_str());
    seconds[k] = m.ok ? m.answer.stage_cpu_s[1] : 1e9;
    facets[k] = size_of(model);
  }
  std::printf("Recovery of 200 discs (%.0f facets) %.2f s, of 1,000 (%.0f facets) %.2f s: %.1f times\n", facets[0],
              seconds[0], facets[1], seconds[1], seconds[1] / seconds[0]);
  return seconds[1] <= 8 * seconds[0];
}
#endif

}  // namespace

int main(int argc, char** argv) {
  const Options options = options_of(argc, argv);
  std::vector<test::ModelFamily> families = test::model_families();
#ifdef GEOMESH_BENCH_GEOMODEL
  families.push_back(geomodel::testing::disc_family());
#endif
  std::printf(
      "| family | models | faults | median us/facet | worst/median | longest s | added | time over TetGen |\n"
      "|---|---|---|---|---|---|---|---|\n");
  bool all_kept = true;
  std::vector<double> ratios;  // of the families
  for (const test::ModelFamily& family : families) {
    const auto& wanted = options.families;
    if (!wanted.empty() && std::find(wanted.begin(), wanted.end(), family.name) == wanted.end()) continue;
    std::vector<Row> rows;
    for (unsigned i = options.every / 2; i < test::ModelFamily::n_models; i += options.every) {
      const test::FamilyModel model = family.make(i);
      if (size_of(model) <= options.largest) rows.push_back(run(family.name, model, options));
    }
    if (rows.empty()) continue;
    all_kept = report(family.name, rows, options) && all_kept;
    if (const double ratio = geometric_mean(ratios_of(rows)); ratio > 0) ratios.push_back(ratio);
  }
  if (!options.peer.empty())
    std::printf("Time over TetGen `%s`, geometric mean of %zu families: %.2f\n", options.peer.c_str(), ratios.size(),
                geometric_mean(ratios));
  if (options.peer == "p") all_kept = all_kept && geometric_mean(ratios) <= 1;
#ifdef GEOMESH_BENCH_GEOMODEL
  if (options.has_growth) all_kept = report_growth(options) && all_kept;
#endif
  return all_kept ? 0 : 1;
}
