// SPDX-License-Identifier: MIT
/// @file
/// Includes the functions for lengths and distances that mesh improvement uses.
#pragma once

#include "common/geometry.hpp"
#include "geomesh/core/geometry.hpp"
