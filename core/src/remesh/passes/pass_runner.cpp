// SPDX-License-Identifier: MIT
#include "remesh/passes/pass_runner.hpp"

#include <string>

namespace geomesh::remesh {

void PassRunner::run(const Pass& pass) const {
  if (!pass.applies) return;
  for (unsigned k = 0; k < pass.most_rounds && !out_of_time_(); ++k) {
    if (pass.most_rounds > 1) context_.report(k, pass.most_rounds);
    const Next next = pass.round(k);
    GEOMESH_EXPENSIVE_CHECK(mesh_.validate().empty());
    note(pass, k);
    if (next == Next::done) return;
  }
}

void PassRunner::note(const Pass& pass, unsigned round) const {
  std::string text(pass.name);
  if (pass.most_rounds > 1) text += ", round " + std::to_string(round + 1);
  context_.note(LogLevel::debug, text + ": " + std::to_string(mesh_.n_cells()) + " cells");
}

}  // namespace geomesh::remesh
