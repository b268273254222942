// SPDX-License-Identifier: GPL-3.0-or-later
#include "plausibility/plausibility.hpp"

#include <algorithm>

#include "geomesh/core/error.hpp"
#include "plausibility/doubts.hpp"

namespace geomesh::geomodel {

std::vector<Finding> find_doubts(const Project& project, const ProjectInputs& inputs,
                                 const std::optional<Box3>& volume) {
  std::vector<Finding> findings;
  const Inspected model{project, inputs, volume};
  doubt_places(model, findings);
  doubt_box_extent(model, findings);
  doubt_heights(model, findings);
  doubt_shapes(model, findings);
  doubt_column(model, findings);
  std::stable_sort(findings.begin(), findings.end(),
                   [](const Finding& a, const Finding& b) { return a.sureness < b.sureness; });
  return findings;
}

std::string to_text(const Finding& finding) {
  return finding.text + (finding.remedy.empty() ? "" : "; " + finding.remedy);
}

void refuse_nonsense(const std::vector<Finding>& findings) {
  std::string text;
  for (const Finding& finding : findings)
    if (finding.sureness == Finding::Sureness::certain) text += (text.empty() ? "" : "\n") + to_text(finding);
  if (!text.empty()) throw Error(ErrorKind::invalid_input, text);
}

std::string few_of(const std::vector<std::string>& names) {
  constexpr std::size_t most_named = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), most_named); ++i) text += (i > 0 ? ", " : "") + names[i];
  if (names.size() > most_named) text += " and " + std::to_string(names.size() - most_named) + " more";
  return text;
}

}  // namespace geomesh::geomodel
