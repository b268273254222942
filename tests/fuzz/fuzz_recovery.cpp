// SPDX-License-Identifier: GPL-3.0-or-later
// fuzz_recovery [--boxes] [--mode constrained|preserve|conforming] [--image NAME] [--first SEED] [--count N] [--points
// N] [--seconds S]
// [--save DIR]
//               [FILE|MODEL...|corpus]
// Meshes random valid models (or the files and corpus models named), one child process each, and judges them. Prints
// one line a failure; with --save, writes each failure made as small as it goes to DIR. --image: shuffled, mirrored,
// triangles, turned, utm, turned_utm. --boxes: warped boxes (corpus_boxes.hpp) in place of distorted meshes
// (corpus_random.hpp). Exit status 1 where anything failed.
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "corpus_boxes.hpp"
#include "corpus_random.hpp"
#include "corpus_run.hpp"
#include "corpus_transform.hpp"
#include "minimise.hpp"
#include "plc_reader.hpp"

namespace {

using namespace geomesh;
using namespace geomesh::test;

struct Arguments {
  std::string mode = "constrained", image, save;
  std::uint64_t first = 0, count = 200;
  unsigned points = 120;
  double seconds = 20;
  bool boxes = false;
  std::vector<std::string> inputs;
};

Arguments parse(int argc, char** argv) {
  Arguments a;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const auto value = [&] { return i + 1 < argc ? std::string(argv[++i]) : std::string(); };
    if (word == "--mode") {
      a.mode = value();
    } else if (word == "--boxes") {
      a.boxes = true;
    } else if (word == "--first") {
      a.first = std::strtoull(value().c_str(), nullptr, 10);
    } else if (word == "--count") {
      a.count = std::strtoull(value().c_str(), nullptr, 10);
    } else if (word == "--points") {
      a.points = static_cast<unsigned>(std::strtoul(value().c_str(), nullptr, 10));
    } else if (word == "--seconds") {
      a.seconds = std::strtod(value().c_str(), nullptr);
    } else if (word == "--image") {
      a.image = value();
    } else if (word == "corpus") {
      for (const CorpusModel& model : corpus_models())
        if (!model.is_large) a.inputs.push_back(model.name);
    } else if (word == "--save") {
      a.save = value();
    } else {
      a.inputs.push_back(word);
    }
  }
  return a;
}

PiecewiseLinearComplex image_of(const PiecewiseLinearComplex& plc, const std::string& image) {
  if (image == "shuffled") return shuffled(plc, 7);
  if (image == "mirrored") return mapped(plc, mirrored(), -1);
  if (image == "triangles") return as_triangles(plc);
  if (image == "turned") return mapped(as_triangles(plc), turned());
  if (image == "utm") return mapped(as_triangles(plc), moved_to_utm());
  if (image == "turned_utm") return mapped(mapped(as_triangles(plc), turned()), moved_to_utm());
  return plc;
}

/// True where the model passes.
bool run(const std::string& name, const PiecewiseLinearComplex& original, const Arguments& a,
         const TetrahedralizeOptions& options) {
  const PiecewiseLinearComplex plc = image_of(original, a.image);
  const std::string outcome = outcome_of(plc, options, a.seconds);
  if (outcome.empty()) return true;
  std::printf("%s: %.300s\n", name.c_str(), outcome.c_str());
  if (!a.save.empty()) {
    const PiecewiseLinearComplex small = minimised(plc, options, a.seconds);
    std::filesystem::create_directories(a.save);
    const std::string path = a.save + "/" + a.mode + "_" + std::filesystem::path(name).stem().string() +
                             (a.image.empty() ? "" : "_" + a.image) + ".poly";
    write_poly(small, path);
    std::printf("  %s: %zu points, %zu facets, %zu segments: %.300s\n", path.c_str(), small.points.size(),
                small.n_facets(), small.segments.size(), outcome_of(small, options, a.seconds).c_str());
  }
  std::fflush(stdout);
  return false;
}

}  // namespace

int main(int argc, char** argv) {
  const Arguments a = parse(argc, argv);
  const TetrahedralizeOptions options = a.mode == "conforming" ? conforming_mode()
                                        : a.mode == "preserve" ? preserving_mode()
                                                               : constrained_mode();
  std::size_t failures = 0, n = 0;
  for (const std::string& input : a.inputs) {
    const bool is_file = std::filesystem::exists(input);
    failures += !run(input, is_file ? read_plc(input) : corpus_model(input).make(), a, options);
    ++n;
  }
  if (a.inputs.empty())
    for (std::uint64_t seed = a.first; seed < a.first + a.count; ++seed, ++n)
      failures +=
          !run("seed_" + std::to_string(seed), a.boxes ? random_boxes(seed) : random_plc(seed, a.points), a, options);
  std::printf("%zu of %zu models failed\n", failures, n);
  return failures == 0 ? 0 : 1;
}
