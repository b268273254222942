// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// A file in memory that is read as words, lines and numbers. It counts lines for messages.
#pragma once

#include <algorithm>
#include <charconv>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <string_view>
#include <unordered_map>

#include "geomesh/core/error.hpp"

namespace geomesh::geomodel {

class FileCursor {
 public:
  explicit FileCursor(std::filesystem::path path) : path_(std::move(path)) {
    std::ifstream file(path_, std::ios::binary);
    if (!file) throw Error(ErrorKind::usage, path_.string() + ": cannot be opened");
    text_.assign(std::istreambuf_iterator<char>(file), {});
  }

  bool at_end() const { return at_ >= text_.size(); }
  std::size_t size() const { return text_.size(); }
  /// Returns the rest of the current line without its end, and advances to the next line.
  std::string_view line() {
    if (at_end()) refuse("ends too early");
    line_start_ = at_;
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    std::string_view result(text_.data() + at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    if (!result.empty() && result.back() == '\r') result.remove_suffix(1);
    return result;
  }
  std::string_view word() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    if (at_end()) refuse("ends too early");
    line_start_ = at_;
    const std::size_t first = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return std::string_view(text_).substr(first, at_ - first);
  }
  template <class T>
  T number() {
    const std::string_view text = word();
    T value{};
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc() || end != text.data() + text.size())
      refuse("a number was expected, found \"" + std::string(text) + "\"");
    return value;
  }
  /// Returns a number that the file stores in binary, as it is in memory.
  template <class T>
  T raw() {
    if (text_.size() - at_ < sizeof(T)) refuse("ends too early");
    T value;
    std::memcpy(&value, text_.data() + at_, sizeof(T));
    at_ += sizeof(T);
    return value;
  }
  const std::filesystem::path& path() const { return path_; }
  [[noreturn]] void refuse(const std::string& why) const {
    const auto n = std::count(text_.begin(), text_.begin() + static_cast<std::ptrdiff_t>(line_start_), '\n');
    throw Error(ErrorKind::invalid_input, path_.string() + ":" + std::to_string(n + 1) + ": " + why);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\n' || c == '\r' || c == '\t'; }
  std::filesystem::path path_;
  std::string text_;
  std::size_t at_ = 0, line_start_ = 0;
};

class NodeRows {
 public:
  void add(std::size_t number, const FileCursor& in) {
    if (rows_.size() >= no_vertex) in.refuse("holds more nodes than 32 bits can count");
    if (!rows_.emplace(number, static_cast<VertexIndex>(rows_.size())).second)
      in.refuse("node " + std::to_string(number) + " is there twice");
  }
  bool knows(std::size_t number) const { return rows_.contains(number); }
  VertexIndex row(std::size_t number, const FileCursor& in) const {
    const auto it = rows_.find(number);
    if (it == rows_.end()) in.refuse("node " + std::to_string(number) + " is not there");
    return it->second;
  }

 private:
  std::unordered_map<std::size_t, VertexIndex> rows_;
};

}  // namespace geomesh::geomodel
