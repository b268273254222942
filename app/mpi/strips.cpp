// SPDX-License-Identifier: GPL-3.0-or-later
#include "strips.hpp"

namespace geomesh::app {

StripsResult improve_strips(RankMesh&, const RankModel&, const RefineOptions&, const Ranks&, const RunContext&) {
  return {};
}

}  // namespace geomesh::app
