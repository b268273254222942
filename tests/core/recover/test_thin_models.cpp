// SPDX-License-Identifier: GPL-3.0-or-later
// Models a few ulps thick: each is meshed, or refused with its facets, place and advice. Neither takes more than ten
// times as long as models of the same shape and size with room, or as the Delaunay tetrahedralization of 55,000 uniform
// points where that is more: 0.07 CPU seconds on the machine of 2026-11, and more on a busy one, as for the models.
#include <algorithm>
#include <catch2/catch.hpp>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "corpus_run.hpp"
#include "geomesh/core/delaunay.hpp"
#include "judged_seeds.hpp"
#include "thin_models.hpp"

using namespace geomesh;
using namespace geomesh::test;

namespace {

constexpr double most_times = 10;  ///< the median of the kind
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || defined(GEOMESH_EXPENSIVE_CHECKS)
/// Sanitizers slow exact arithmetic, which allocates, more than all else; validators run once a stage and attempt.
constexpr bool times_count = false;
#else
constexpr bool times_count = true;
#endif
constexpr std::size_t n_measure = 55000;  ///< points of the measure: some dozen facets take less, too little to compare

/// Counts of what came of the models.
struct Outcomes {
  unsigned n_meshed = 0, n_refused = 0;
  double largest_ratio = 0;  ///< of times a facet, to the median of the kind
};

double median(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

/// CPU seconds of one run on this thread.
double seconds_of(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options) {
  const double start = thread_cpu_seconds();
  try {
    tetrahedralize(plc, options);
  } catch (const Error&) {
  }
  return thread_cpu_seconds() - start;
}

/// CPU seconds that the machine takes now for the same piece of work.
double seconds_of_measure() {
  static const std::vector<Vec3> points = [] {
    std::mt19937_64 random(1);
    std::vector<Vec3> out(n_measure);
    for (Vec3& p : out)
      for (unsigned axis = 0; axis < 3; ++axis) p[axis] = std::ldexp(static_cast<double>(random() >> 11), -53);
    return out;
  }();
  const double start = thread_cpu_seconds();
  delaunay_tetrahedralization(points);
  return thread_cpu_seconds() - start;
}

/// Measures that one run takes: both are timed one after the other, since the pace of a machine drifts.
double measures_of(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options) {
  const double before = seconds_of_measure();
  const double seconds = seconds_of(plc, options);
  return 2 * seconds / (before + seconds_of_measure());
}

/// The least of several runs, while that is above `bound`: a busy machine makes single ones long.
double least_measures_of(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options, double bound) {
  double least = measures_of(plc, options);
  for (unsigned i = 0; i < 4 && least > bound; ++i) least = std::min(least, measures_of(plc, options));
  return least;
}

void check_refusal(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options) {
  try {
    tetrahedralize(plc, options);
    FAIL("the judge was told of a refusal");
  } catch (const Error& e) {
    const std::string words = e.what();
    INFO(words);
    CHECK(e.kind() == ErrorKind::cannot_mesh);
    CHECK(!e.context().places.empty());
    CHECK(!e.context().facets.empty());
    CHECK(words.find("facet") != std::string::npos);
    CHECK(words.find("too thin for double precision: move or merge") != std::string::npos);
    REQUIRE(e.context().excerpt);
    CHECK(!e.context().excerpt->tetrahedra.empty());
  }
}

/// The kind: the same shape and size with room.
void check_kind(unsigned seed, ThinShape shape, const TetrahedralizeOptions& options, Outcomes& outcomes) {
  std::vector<double> with_room;
  for (const unsigned ulps : {1u << 14, 1u << 16, 1u << 18}) {
    const CorpusRun run = run_and_judge(thin_model(seed, shape, ulps), options);
    CHECK(run.trouble == "");
    with_room.push_back(measures_of(thin_model(seed, shape, ulps), options));
  }
  const double usual = std::max(1.0, median(with_room));
  for (unsigned ulps = shape == ThinShape::slits ? 64 : 1; ulps <= 256; ulps *= 2) {
    INFO(name_of(shape) << ", seed " << seed << ", " << ulps << " ulps");
    const PiecewiseLinearComplex plc = thin_model(seed, shape, ulps);
    const CorpusRun run = run_and_judge(plc, options);
    if (!run.ok()) {
      REQUIRE(run.error == ErrorKind::cannot_mesh);
      check_refusal(plc, options);
    }
    ++(run.ok() ? outcomes.n_meshed : outcomes.n_refused);
    const double ratio = least_measures_of(plc, options, most_times * usual) / usual;
    outcomes.largest_ratio = std::max(outcomes.largest_ratio, ratio);
    if (times_count) CHECK(ratio <= most_times);
  }
}

Outcomes check_shapes(unsigned first, unsigned count) {
  Outcomes out;
  for (unsigned seed = first; seed < first + count; ++seed)
    for (unsigned shape = 0; shape < n_thin_shapes; ++shape)
      for (const TetrahedralizeOptions& options : {constrained_mode(), preserving_mode()})
        check_kind(seed, static_cast<ThinShape>(shape), options, out);
  return out;
}

}  // namespace

TEST_CASE("models some ulps thick are meshed, or refused with facets, place and advice, as fast as models with room",
          "[recover][judged][thin]") {
  const Outcomes out = check_shapes(0, 2);
  CHECK(out.n_meshed > 0);
  CHECK(out.n_refused > 0);
}

TEST_CASE("lines of 8 by 8 slits that pass at 40 ulps and more are meshed, with the boundary kept too",
          "[recover][judged][thin]") {
  for (const char* name : {"chazelle_4", "chazelle_8"})
    for (double unit = 0x1p12; unit <= 0x1p18; unit *= 4)  // a hundred times the ulps between the lines
      for (const TetrahedralizeOptions& options : {constrained_mode(), preserving_mode()}) {
        INFO(name << ", " << unit << " ulps for a unit");
        CHECK(run_and_judge(in_ulps(name, unit), options).trouble == "");
      }
}

// GEOMESH_THIN="FIRST COUNT" test_core "[thin-seeds]": any range of seeds.
TEST_CASE("models some ulps thick of the seeds asked for", "[recover][judged][.][thin-seeds]") {
  const std::vector<unsigned> asked = seeds_asked("GEOMESH_THIN");
  const Outcomes out = check_shapes(asked[0], asked[1]);
  WARN(out.n_meshed << " meshed, " << out.n_refused << " refused, at most " << out.largest_ratio
                    << " times the median of the kind");
}

TEST_CASE("hundreds of models some ulps thick", "[recover][judged][nightly][thin]") { check_shapes(100, 50); }
