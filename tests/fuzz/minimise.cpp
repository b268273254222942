// SPDX-License-Identifier: GPL-3.0-or-later
#include "minimise.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <vector>

#include "corpus_run.hpp"

namespace geomesh::test {

namespace {

/// The facets with keep[f]; inner segments and points go with their facet.
PiecewiseLinearComplex subset(const PiecewiseLinearComplex& plc, const std::vector<bool>& keep_facet,
                              const std::vector<bool>& keep_segment, const std::vector<bool>& keep_point) {
  PiecewiseLinearComplex out;
  std::vector<VertexIndex> row(plc.points.size(), no_vertex);
  const auto use = [&](VertexIndex v) {
    if (row[v] == no_vertex) {
      row[v] = static_cast<VertexIndex>(out.points.size());
      out.points.push_back(plc.points[v]);
    }
    return row[v];
  };
  std::vector<Index> new_facet(plc.n_facets(), no_index);
  for (Index f = 0; f < plc.n_facets(); ++f) {
    if (!keep_facet[f]) continue;
    std::vector<std::vector<VertexIndex>> loops;
    for (Index l = plc.facet_loops[f]; l < plc.facet_loops[f + 1]; ++l) {
      loops.emplace_back();
      for (VertexIndex v : plc.loop(l)) loops.back().push_back(use(v));
    }
    new_facet[f] = out.add_polygon(loops, plc.facet_provenance[f]);
  }
  for (const auto& s : plc.facet_segments)
    if (keep_facet[s.facet]) out.facet_segments.push_back({new_facet[s.facet], use(s.a), use(s.b)});
  for (const auto& p : plc.facet_points)
    if (keep_facet[p.facet]) out.facet_points.push_back({new_facet[p.facet], use(p.v)});
  for (std::size_t s = 0; s < plc.segments.size(); ++s)
    if (keep_segment[s])
      out.segments.push_back({use(plc.segments[s].a), use(plc.segments[s].b), plc.segments[s].curve});
  for (std::size_t i = 0; i < plc.isolated_points.size(); ++i)
    if (keep_point[i]) out.isolated_points.push_back(use(plc.isolated_points[i]));
  return out;
}

PiecewiseLinearComplex without_items(const PiecewiseLinearComplex& plc, std::size_t first, std::size_t end) {
  const std::size_t f = plc.n_facets(), s = plc.segments.size(), p = plc.isolated_points.size();
  std::vector<bool> keep[3] = {std::vector<bool>(f, true), std::vector<bool>(s, true), std::vector<bool>(p, true)};
  for (std::size_t i = first; i < end; ++i) {
    if (i < f) {
      keep[0][i] = false;
    } else if (i < f + s) {
      keep[1][i - f] = false;
    } else {
      keep[2][i - f - s] = false;
    }
  }
  return subset(plc, keep[0], keep[1], keep[2]);
}

std::size_t n_items(const PiecewiseLinearComplex& plc) {
  return plc.n_facets() + plc.segments.size() + plc.isolated_points.size();
}

std::string read_until(int pipe, double seconds, bool& expired) {
  std::string text;
  expired = false;
  for (char buffer[512];;) {
    pollfd wait{pipe, POLLIN, 0};
    if (poll(&wait, 1, static_cast<int>(1000 * seconds)) <= 0) {
      expired = true;
      return text;
    }
    const ssize_t n = read(pipe, buffer, sizeof buffer);
    if (n <= 0) return text;
    text.append(buffer, static_cast<std::size_t>(n));
  }
}

}  // namespace

std::string outcome_of(const PiecewiseLinearComplex& plc, const TetrahedralizeOptions& options, double time_limit) {
  int ends[2];
  if (pipe(ends) != 0) return "no pipe";
  const pid_t child = fork();
  if (child == 0) {
    close(ends[0]);
    const std::string trouble = run_and_judge(plc, options, 10 * time_limit).trouble;
    const ssize_t written = write(ends[1], trouble.data(), trouble.size());
    _exit(written < 0 ? 1 : 0);
  }
  close(ends[1]);
  bool expired = false;
  std::string text = read_until(ends[0], time_limit, expired);
  close(ends[0]);
  if (expired) kill(child, SIGKILL);
  int status = 0;
  waitpid(child, &status, 0);
  if (expired) return "hangs";
  if (WIFSIGNALED(status)) return "crashes: signal " + std::to_string(WTERMSIG(status));
  return text;
}

std::string kind_of(const std::string& outcome) { return outcome.substr(0, outcome.find(':')); }

PiecewiseLinearComplex minimised_while(PiecewiseLinearComplex plc,
                                       const std::function<bool(const PiecewiseLinearComplex&)>& is_kept, int budget) {
  for (std::size_t chunk = (n_items(plc) + 1) / 2; chunk > 0; chunk /= 2) {
    bool shrank = true;
    while (shrank) {
      shrank = false;
      for (std::size_t first = 0; first < n_items(plc) && budget > 0; --budget) {
        PiecewiseLinearComplex smaller = without_items(plc, first, std::min(first + chunk, n_items(plc)));
        if (n_items(smaller) > 0 && is_kept(smaller)) {
          plc = std::move(smaller);
          shrank = true;
        } else {
          first += chunk;
        }
      }
      if (chunk > 1) break;
    }
  }
  return plc;
}

PiecewiseLinearComplex minimised(PiecewiseLinearComplex plc, const TetrahedralizeOptions& options, double time_limit,
                                 int budget) {
  const std::string kind = kind_of(outcome_of(plc, options, time_limit));
  const auto fails_alike = [&](const PiecewiseLinearComplex& smaller) {
    const std::string outcome = outcome_of(smaller, options, time_limit);
    const bool open = outcome.find("enclose") != std::string::npos;
    return !outcome.empty() && !open && kind_of(outcome) == kind;
  };
  return minimised_while(std::move(plc), fails_alike, budget);
}

}  // namespace geomesh::test
