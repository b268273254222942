// SPDX-License-Identifier: MIT
/// @file
/// Lengths and distances, under the names that improvement uses.
#pragma once

#include "common/geometry.hpp"
#include "geomesh/core/geometry.hpp"
