// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The one header of Catch2 version 2, over version 3 (Debian 13). On the include path where version 3 was found.
#pragma once

#include <catch2/catch_all.hpp>

using Catch::Approx;

namespace Catch {
inline auto Contains(const std::string& text) { return Matchers::ContainsSubstring(text); }
}  // namespace Catch
