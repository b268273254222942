// SPDX-License-Identifier: GPL-3.0-or-later
#include "partition/metis.hpp"

#ifdef GEOMESH_WITH_METIS
#include <metis.h>
#endif

#include <algorithm>
#include <limits>
#include <string>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

#ifdef GEOMESH_WITH_METIS

namespace {

/// Number of parts up to which METIS' recursive bisection cuts fewer faces than its k-way method.
constexpr std::int32_t most_parts_by_bisection = 8;

/// Largest sum of all weights that are passed to METIS, because its integers may have 32 bits.
constexpr double most_weight = 1e9;

/// Converts weights to integers from 1 in the same ratios, as far as the limit on their sum allows.
std::vector<idx_t> whole_weights(const std::vector<double>& weights) {
  double sum = 0;
  for (const double w : weights) sum += w;
  const double scale = std::min(1.0, most_weight / std::max(sum, 1.0));
  std::vector<idx_t> whole;
  whole.reserve(weights.size());
  for (const double w : weights) whole.push_back(std::max<idx_t>(1, static_cast<idx_t>(scale * w)));
  return whole;
}

[[noreturn]] void refuse(const std::string& why) { throw Error(ErrorKind::cannot_mesh, "partitions: " + why); }

}  // namespace

std::vector<std::int32_t> parts_by_metis(const std::vector<Neighbours>& across, std::int32_t n_parts,
                                         const PartWeights& weights) {
  const std::size_t n = across.size();
  if (n >= static_cast<std::size_t>(std::numeric_limits<idx_t>::max()) / 4)
    refuse("the mesh has more faces than the installed METIS can count");
  if (static_cast<std::size_t>(n_parts) > n)
    refuse("there are " + std::to_string(n) + " tetrahedra for " + std::to_string(n_parts) + " parts");
  std::vector<idx_t> first{0}, neighbours, part(n, 0);
  first.reserve(n + 1);
  std::vector<double> cuts;  // weights of the faces between neighbouring cells, in the order of `neighbours`
  for (std::size_t t = 0; t < n; ++t) {
    for (std::size_t i = 0; i < 4; ++i) {
      if (across[t][i] == no_neighbour) continue;
      neighbours.push_back(static_cast<idx_t>(across[t][i]));
      if (!weights.of_face.empty()) cuts.push_back(weights.of_face[t][i]);
    }
    first.push_back(static_cast<idx_t>(neighbours.size()));
  }
  idx_t options[METIS_NOPTIONS];
  METIS_SetDefaultOptions(options);
  options[METIS_OPTION_SEED] = 1;
  options[METIS_OPTION_NUMBERING] = 0;
  idx_t n_cells = static_cast<idx_t>(n), n_constraints = 1, wanted = n_parts, cut = 0;
  auto* const method = n_parts <= most_parts_by_bisection ? METIS_PartGraphRecursive : METIS_PartGraphKway;
  std::vector<idx_t> of_cell = whole_weights(weights.of_cell), of_face = whole_weights(cuts);
  if (method(&n_cells, &n_constraints, first.data(), neighbours.data(), of_cell.empty() ? nullptr : of_cell.data(),
             nullptr, of_face.empty() ? nullptr : of_face.data(), &wanted, nullptr, nullptr, options, &cut,
             part.data()) != METIS_OK)
    refuse("METIS could not divide the mesh");
  std::vector<bool> is_used(static_cast<std::size_t>(n_parts), false);
  for (const idx_t p : part) is_used[static_cast<std::size_t>(p)] = true;
  if (std::find(is_used.begin(), is_used.end(), false) != is_used.end())
    refuse("one of " + std::to_string(n_parts) + " parts would have no tetrahedron; choose fewer");
  return {part.begin(), part.end()};
}

#else

std::vector<std::int32_t> parts_by_metis(const std::vector<Neighbours>&, std::int32_t, const PartWeights&) {
  throw Error(ErrorKind::usage, "partitions: this program was built without METIS");
}

#endif

}  // namespace geomesh::geomodel
