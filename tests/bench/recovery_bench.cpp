// SPDX-License-Identifier: GPL-3.0-or-later
// recovery_bench --data DIR [--markdown FILE] [--limit SECONDS] [--constrained] [NAME...]
//
// Recovery beside the TetGen 1.5 library, each input a row, each run a process of its own on one core: CPU time of
// everything from the model in memory to the classified mesh (delaunay, recover, classify and what lies between), added
// points, tetrahedra. Constrained mode beside TetGen's `pY`, conforming mode beside `p`. Our meshes are judged exactly;
// a mesh that does not pass is a failure here. With
// --markdown, the section "Recovery" of that file is replaced. With --constrained, constrained mode alone is measured.
// With names, only inputs whose name contains one of them.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <vector>

#include "corpus_run.hpp"
#include "corpus_shared.hpp"
#include "recovery_inputs.hpp"
#include "recovery_peer.hpp"

namespace {

using namespace geomesh;
using bench::Measurement;

struct Row {
  bench::RecoveryInput input;
  std::size_t n_triangles = 0, n_points = 0;
  Measurement constrained, preserved, conforming, tetgen_py, tetgen_p;
};

bool larger(const Row& row) { return row.n_triangles >= 1000; }

std::string cell(const Measurement& m, std::size_t n_triangles) {
  if (!m.ok) return m.message.rfind("died of signal 14", 0) == 0 ? "too long | – | –" : "**fails** | – | –";
  char text[100];
  std::snprintf(text, sizeof text, "%.3f | %zu | %.2f", m.cpu_s, m.answer.added_points,
                static_cast<double>(m.answer.tetrahedra) / static_cast<double>(n_triangles));
  return text;
}

/// Geometric mean of ours over theirs where both succeed, by time or by time per tetrahedron.
std::string mean_ratio(const std::vector<Row>& rows, Measurement Row::*ours, Measurement Row::*theirs,
                       bool per_tetrahedron, const std::string& group = "") {
  double sum = 0;
  int n = 0;
  for (const Row& row : rows) {
    const Measurement &a = row.*ours, &b = row.*theirs;
    if (!larger(row) || !a.ok || !b.ok || row.input.name.rfind(group, 0) != 0) continue;
    double ratio = a.cpu_s / b.cpu_s;
    if (per_tetrahedron) ratio *= static_cast<double>(b.answer.tetrahedra) / static_cast<double>(a.answer.tetrahedra);
    sum += std::log(ratio);
    ++n;
  }
  char text[60];
  std::snprintf(text, sizeof text, "%.2f over %d inputs", n ? std::exp(sum / n) : 0.0, n);
  return text;
}

/// Inputs that take over 20 times the median CPU time per triangle of those of at least 1,000 triangles.
std::string slow_inputs(const std::vector<Row>& rows) {
  std::vector<std::pair<double, std::string>> times;
  for (const Row& row : rows)
    if (larger(row) && row.constrained.ok)
      times.push_back({row.constrained.cpu_s / static_cast<double>(row.n_triangles), row.input.name});
  if (times.empty()) return "none";
  std::sort(times.begin(), times.end());
  const double median = times[times.size() / 2].first;
  std::string slow;
  for (const auto& [time, name] : times)
    if (time > 20 * median) slow += (slow.empty() ? "" : ", ") + name;
  return slow.empty() ? "none" : slow;
}

std::string added_share(const std::vector<Row>& rows, const std::string& group, Measurement Row::*run) {
  std::size_t added = 0, points = 0;
  for (const Row& row : rows)
    if (row.input.name.rfind(group, 0) == 0 && (row.*run).ok) {
      added += (row.*run).answer.added_points;
      points += row.n_points;
    }
  if (points == 0) return "–";
  char text[60];
  std::snprintf(text, sizeof text, "%zu (%.3f %%)", added,
                points ? 100.0 * static_cast<double>(added) / static_cast<double>(points) : 0.0);
  return text;
}

/// Tetrahedra per input triangle over all inputs of these groups that were meshed.
std::string density(const std::vector<Row>& rows, std::span<const char* const> groups, Measurement Row::*run) {
  std::size_t tetrahedra = 0, triangles = 0;
  for (const Row& row : rows)
    for (const char* group : groups)
      if (row.input.name.rfind(group, 0) == 0 && (row.*run).ok) {
        tetrahedra += (row.*run).answer.tetrahedra;
        triangles += row.n_triangles;
      }
  if (triangles == 0) return "–";
  char text[40];
  std::snprintf(text, sizeof text, "%.3f", static_cast<double>(tetrahedra) / static_cast<double>(triangles));
  return text;
}

std::string table(const std::vector<Row>& rows) {
  std::ostringstream out;
  out << "CPU seconds on one core from the model in memory to the classified mesh / points added / tetrahedra per "
         "input "
         "triangle.\n\n"
      << "| input | triangles | constrained | + | t/t | TetGen `pY` | + | t/t | boundary kept | + | t/t | conforming | "
         "+ | t/t | "
         "TetGen `p` | + | t/t |\n"
      << "|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const Row& r : rows) {
    out << "| " << r.input.name << " | " << r.n_triangles;
    for (const Measurement* m : {&r.constrained, &r.tetgen_py, &r.preserved, &r.conforming, &r.tetgen_p})
      out << " | " << cell(*m, r.n_triangles);
    out << " |\n";
  }
  out << "\nInputs of at least 1,000 triangles, geometric mean of ours over TetGen's where both succeed: time, "
         "constrained over "
         "`pY` "
      << mean_ratio(rows, &Row::constrained, &Row::tetgen_py, false) << "; time per tetrahedron, conforming over `p` "
      << mean_ratio(rows, &Row::conforming, &Row::tetgen_p, true) << "; time on the families, constrained over `p` "
      << mean_ratio(rows, &Row::constrained, &Row::tetgen_p, false, "families/")
      << ".\n\nOver 20 times the median time per triangle (constrained): " << slow_inputs(rows)
      << ".\n\n| points added | constrained | boundary kept | TetGen `pY` |\n|---|---|---|---|\n";
  for (const char* group : {"solids", "modelA4", "faults"})
    out << "| " << group << " | " << added_share(rows, group, &Row::constrained) << " | "
        << added_share(rows, group, &Row::preserved) << " | " << added_share(rows, group, &Row::tetgen_py) << " |\n";
  out << "\n| tetrahedra per input triangle | constrained | boundary kept | TetGen `pY` |\n|---|---|---|---|\n";
  const char* const groups[] = {"solids", "classic", "modelA4", "faults"};
  const auto density_row = [&](const std::string& name, std::span<const char* const> some) {
    out << "| " << name << " | " << density(rows, some, &Row::constrained) << " | "
        << density(rows, some, &Row::preserved) << " | " << density(rows, some, &Row::tetgen_py) << " |\n";
  };
  for (const char* const& group : groups) density_row(group, {&group, 1});
  density_row("all of these", groups);
  out << "\nFailures:\n\n";
  bool any = false;
  for (const Row& r : rows) {
    const std::pair<const char*, const Measurement*> runs[] = {{"constrained", &r.constrained},
                                                               {"boundary kept", &r.preserved},
                                                               {"conforming", &r.conforming},
                                                               {"TetGen `pY`", &r.tetgen_py},
                                                               {"TetGen `p`", &r.tetgen_p}};
    for (const auto& [name, m] : runs)
      if (!m->ok) {
        out << "- " << r.input.name << ", " << name << ": " << m->message << "\n";
        any = true;
      }
  }
  if (!any) out << "- none\n";
  return out.str();
}

void replace_section(const std::string& path, const std::string& body) {
  std::ifstream in(path);
  std::string text((std::istreambuf_iterator<char>(in)), {});
  const std::string heading = "## Recovery\n";
  std::size_t begin = text.find(heading);
  if (begin == std::string::npos) {
    if (text.empty()) text = "# Performance\n";
    text += "\n";
    begin = text.size();
  }
  std::size_t end = text.find("\n## ", begin + 1);
  if (end == std::string::npos) end = text.size();
  const std::string section =
      heading +
      "\nMade by `build/nightly/bin/recovery_bench --data ../shared/data --markdown docs/performance.md` "
      "(preset `nightly`).\n\n" +
      body;
  std::ofstream(path) << text.substr(0, begin) << section << text.substr(end);
}

/// `is_alone`: constrained mode alone.
Row run(const bench::RecoveryInput& input, unsigned limit, bool is_alone) {
  Row row;
  row.input = input;
  const PiecewiseLinearComplex plc = input.make();
  row.n_triangles = bench::n_triangles(plc);
  row.n_points = plc.points.size();
  row.constrained = bench::measure_ours(plc, test::constrained_mode(), limit);
  if (is_alone) return row;
  row.preserved = bench::measure_ours(plc, test::preserving_mode(), limit);
  row.conforming = bench::measure_ours(plc, test::conforming_mode(), limit);
  row.tetgen_py = bench::measure_tetgen(plc, "pYQ", limit);
  row.tetgen_p = bench::measure_tetgen(plc, "pQ", limit);
  return row;
}

}  // namespace

int main(int argc, char** argv) {
  std::string data, markdown;
  unsigned limit = 120;
  bool is_alone = false;
  std::vector<std::string> names;
  for (int i = 1; i < argc; ++i) {
    const std::string word = argv[i];
    const bool has_value = i + 1 < argc;
    if (word == "--data" && has_value) {
      data = argv[++i];
    } else if (word == "--markdown" && has_value) {
      markdown = argv[++i];
    } else if (word == "--limit" && has_value) {
      limit = static_cast<unsigned>(std::stoul(argv[++i]));
    } else if (word == "--constrained") {
      is_alone = true;
    } else {
      names.push_back(word);
    }
  }
  std::vector<Row> rows;
  for (const bench::RecoveryInput& input : bench::recovery_inputs(data)) {
    bool wanted = names.empty();
    for (const std::string& n : names) wanted = wanted || input.name.find(n) != std::string::npos;
    if (!wanted) continue;
    std::cerr << input.name << std::endl;
    rows.push_back(run(input, limit, is_alone));
  }
  const std::string text = table(rows);
  std::cout << text;
  if (!markdown.empty()) replace_section(markdown, text);
}
