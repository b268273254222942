// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh ensemble`: starts the Python package geomesh, which meshes many realisations in each of its processes.
#pragma once

#include "options.hpp"

namespace geomesh::app {

/// Replaces this program by Python. Throws Error{usage} if there is no Python 3.
[[noreturn]] void run_ensemble(const EnsembleCommand& command);

}  // namespace geomesh::app
