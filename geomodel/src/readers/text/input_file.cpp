// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/text/input_file.hpp"

#include <algorithm>
#include <cctype>
#include <cerrno>
#include <cstring>
#include <fstream>

namespace geomesh::geomodel {

std::string InputFile::extension() const {
  std::string e = path.extension().string();
  std::transform(e.begin(), e.end(), e.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return e;
}

void InputFile::fail(const std::string& message) const {
  throw Error(ErrorKind::invalid_input, shown() + ": " + as_utf8(message));
}

void InputFile::fail(std::size_t line, const std::string& message) const {
  throw Error(ErrorKind::invalid_input, shown() + ":" + std::to_string(line) + ": " + as_utf8(message));
}

InputFile load_input_file(const std::filesystem::path& path) {
  std::error_code ec;
  const auto status = std::filesystem::status(path, ec);
  if (!std::filesystem::exists(status)) throw Error(ErrorKind::usage, path.string() + ": no such file");
  if (std::filesystem::is_directory(status))
    throw Error(ErrorKind::usage, path.string() + ": is a folder, a file was expected");
  if (!std::filesystem::is_regular_file(status))
    throw Error(ErrorKind::usage,
                path.string() + ": is a pipe or a device, which may never end; save its content to a file first");
  std::ifstream in(path, std::ios::binary);
  if (!in) throw Error(ErrorKind::usage, path.string() + ": cannot be opened: " + std::strerror(errno));
  InputFile file{path, {}, {}};
  const auto size = std::filesystem::file_size(path, ec);
  if (!ec) file.bytes.reserve(static_cast<std::size_t>(size));
  char block[1 << 16];
  while (in.read(block, sizeof block) || in.gcount() > 0)
    file.bytes.append(block, static_cast<std::size_t>(in.gcount()));
  if (in.bad()) throw Error(ErrorKind::usage, path.string() + ": reading failed: " + std::strerror(errno));
  return file;
}

std::string in_quotes(std::string_view token) {
  std::string out = "'";
  for (const char c : token.substr(0, 40)) {
    const auto u = static_cast<unsigned char>(c);
    out += (u < 0x20 || u == 0x7f) ? '?' : c;
  }
  if (token.size() > 40) out += "...";
  return out + "'";
}

namespace {

/// Returns the length of the UTF-8 sequence that begins at `at`; 0 if there is none.
std::size_t utf8_length(std::string_view text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char lead = byte(at);
  const std::size_t n = lead < 0x80 ? 1 : lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : lead < 0xf5 ? 4 : 0;
  if (n == 0 || at + n > text.size()) return 0;
  for (std::size_t i = 1; i < n; ++i)
    if ((byte(at + i) & 0xc0) != 0x80) return 0;
  return n;
}

}  // namespace

std::string as_utf8(std::string_view text) {
  bool valid = true;
  for (std::size_t at = 0; valid && at < text.size();) {
    const std::size_t n = utf8_length(text, at);
    valid = n > 0;
    at += n;
  }
  if (valid) return std::string(text);
  std::string out;
  for (const char c : text) {
    const auto u = static_cast<unsigned char>(c);
    if (u < 0x80) {
      out += c;
    } else {
      out += static_cast<char>(0xc0 | (u >> 6));
      out += static_cast<char>(0x80 | (u & 0x3f));
    }
  }
  return out;
}

bool looks_binary(const InputFile& file) {
  const std::string_view head = file.text().substr(0, 1024);
  return std::any_of(head.begin(), head.end(), [](char c) {
    const auto u = static_cast<unsigned char>(c);
    return u < 0x09 || (u > 0x0d && u < 0x20 && u != 0x1a && u != 0x1b);
  });
}

}  // namespace geomesh::geomodel
