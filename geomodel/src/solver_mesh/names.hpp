// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// Makes names that the file formats of solvers accept.
#pragma once

#include <cstddef>
#include <set>
#include <string>

namespace geomesh::geomodel {

/// Greatest length of names in each file format.
inline constexpr std::size_t name_limit_abaqus = 80, name_limit_med = 80, name_limit_gmsh = 80, name_limit_exodus = 256,
                             name_limit_plain = 80;

/// Makes the names of one name space of a file. They match [A-Za-z][A-Za-z0-9_.-]*, have at most `limit` characters and
/// are distinct even if case is ignored. Accented letters are written without accents (ae for ä, e for é), other
/// characters as `_`. A name that had to be shortened, or that was used before, gets a number at its end.
class SolverNames {
 public:
  explicit SolverNames(std::size_t limit) : limit_(limit) {}
  std::string give(const std::string& full_name);

 private:
  std::size_t limit_;
  std::set<std::string> taken_;  // in lower case
};

/// Converts UTF-8 to ASCII: ä becomes ae, ß ss, é e, Ø Oe; other characters without such a spelling become one `_`.
std::string transliterated(const std::string& text);

}  // namespace geomesh::geomodel
