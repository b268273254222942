// SPDX-License-Identifier: GPL-3.0-or-later
#include "file_words.hpp"

#include <cctype>
#include <cstdio>
#include <string_view>

namespace geomesh::app {

namespace {

bool is_plain(char c, std::string_view further) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || further.find(c) != std::string_view::npos;
}

}  // namespace

std::string file_address(const std::filesystem::path& file) {
  std::string address = "file://";
  for (const char c : std::filesystem::absolute(file).lexically_normal().string()) {
    if (is_plain(c, "/-._~")) {
      address += c;
      continue;
    }
    char code[4];
    std::snprintf(code, sizeof code, "%%%02X", static_cast<unsigned>(static_cast<unsigned char>(c)));
    address += code;
  }
  return address;
}

std::string shell_word(const std::filesystem::path& file) {
  const std::string name = file.string();
  bool all_plain = !name.empty();
  std::string quoted = "'";
  for (const char c : name) {
    all_plain = all_plain && is_plain(c, "._-/+=:,@%");
    quoted += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return all_plain ? name : quoted + "'";
}

}  // namespace geomesh::app
