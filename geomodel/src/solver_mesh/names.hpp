// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes names that solvers accept.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace geomesh::geomodel {

/// Longest names by format.
inline constexpr std::size_t name_limit_abaqus = 80, name_limit_med = 80, name_limit_gmsh = 80, name_limit_exodus = 256,
                             name_limit_plain = 80;

/// Returns names that match [A-Za-z][A-Za-z0-9_.-]*, have at most `limit` characters and are distinct even if case is
/// ignored. Accented letters are written without accents (ae for ä, e for é), other characters as `_`. A name that had
/// to be shortened or is taken gets a number at its end. Use one object for each name space of a file.
class SolverNames {
 public:
  explicit SolverNames(std::size_t limit) : limit_(limit) {}
  std::string give(const std::string& full_name);

 private:
  std::size_t limit_;
  std::set<std::string> taken_;  // in lower case
};

/// Converts UTF-8 to ASCII: ä ae, ß ss, é e, Ø Oe; characters without such a spelling become one `_`.
std::string transliterated(const std::string& text);

}  // namespace geomesh::geomodel
