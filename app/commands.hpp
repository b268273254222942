// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// One function per command: calls the library and prints the result. Each returns the exit status.
#pragma once

#include "geomesh/core/run_context.hpp"
#include "options.hpp"

namespace geomesh::app {

int run(const CommandLine& line, const RunContext& context);

}  // namespace geomesh::app
