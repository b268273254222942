// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// `geomesh ensemble`: hands over to the Python package geomesh, whose processes mesh many realisations each.
#pragma once

#include "options.hpp"

namespace geomesh::app {

/// Replaces this program by Python. Throws Error{usage} where there is no Python 3.
[[noreturn]] void run_ensemble(const EnsembleCommand& command);

}  // namespace geomesh::app
