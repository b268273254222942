// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh ensemble`: starts the Python package geomesh, each of whose processes meshes many realisations.
#pragma once

#include "options.hpp"

namespace geomesh::app {

/// Replaces this program by Python. Throws Error{usage} if there is no Python 3.
[[noreturn]] void run_ensemble(const EnsembleCommand& command);

}  // namespace geomesh::app
