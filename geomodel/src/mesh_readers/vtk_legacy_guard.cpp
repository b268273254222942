// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/vtk_legacy_guard.hpp"

#include <cctype>
#include <charconv>
#include <cstdint>
#include <optional>
#include <vector>

namespace geomesh::geomodel::checking {
namespace {

/// The words of a file one after the other; VTK takes any of them as a keyword, in small letters or capitals.
class Words {
 public:
  explicit Words(std::string_view text) : text_(text) {}
  std::string_view next() {
    while (at_ < text_.size() && is_blank(text_[at_])) ++at_;
    const std::size_t begin = at_;
    while (at_ < text_.size() && !is_blank(text_[at_])) ++at_;
    return text_.substr(begin, at_ - begin);
  }
  std::optional<std::int64_t> number() {
    const std::string_view word = next();
    std::int64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || error != std::errc() || end != word.data() + word.size()) return std::nullopt;
    return value;
  }
  /// What follows the end of this line.
  std::string_view behind_line() {
    const std::size_t end = text_.find('\n', at_);
    return end == std::string_view::npos ? std::string_view{} : text_.substr(end + 1);
  }
  bool at_end() const { return at_ >= text_.size(); }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }
  std::string_view text_;
  std::size_t at_ = 0;
};

bool is_word(std::string_view word, std::string_view wanted) {
  if (word.size() != wanted.size()) return false;
  for (std::size_t i = 0; i < word.size(); ++i)
    if (std::tolower(static_cast<unsigned char>(word[i])) != wanted[i]) return false;
  return true;
}

/// The numbers of the block, which begins behind the line; nothing where there are fewer.
std::optional<std::vector<std::int64_t>> block_of(std::string_view bytes, std::size_t size, bool binary) {
  std::vector<std::int64_t> numbers;
  if (binary) {
    if (bytes.size() / 4 < size) return std::nullopt;
    for (std::size_t i = 0; i < size; ++i) {
      std::uint32_t value = 0;
      for (std::size_t k = 0; k < 4; ++k) value = value << 8 | static_cast<unsigned char>(bytes[4 * i + k]);
      numbers.push_back(static_cast<std::int32_t>(value));
    }
    return numbers;
  }
  Words words(bytes);
  for (std::size_t i = 0; i < size; ++i) {
    const auto number = words.number();
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  return numbers;
}

/// Each cell is a count and as many rows; n of them fill the block.
bool fills(const std::vector<std::int64_t>& block, std::int64_t n) {
  std::size_t at = 0;
  for (; n > 0; --n) {
    if (at >= block.size() || block[at] < 0 || static_cast<std::size_t>(block[at]) >= block.size() - at) return false;
    at += static_cast<std::size_t>(block[at]) + 1;
  }
  return at == block.size();
}

}  // namespace

std::string fault_of_legacy_cells(std::string_view content) {
  for (int line = 0; line < 2; ++line) {  // the version, and a title that may hold any word
    const std::size_t end = content.find('\n');
    content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
  }
  Words words(content);
  bool binary = false;
  std::optional<std::int64_t> n_cells;
  while (!words.at_end()) {
    const std::string_view word = words.next();
    if (is_word(word, "binary")) binary = true;
    if (is_word(word, "cell_types")) {
      const auto n = words.number();
      if (!n || (n_cells && *n != *n_cells)) return "says another number of CELL_TYPES than of CELLS (damaged)";
      if (n_cells) return "";  // what follows are attributes
    }
    if (!is_word(word, "cells")) continue;
    const auto n = words.number(), size = words.number();
    const std::string fault = "has cells that do not fill their block of numbers (damaged)";
    if (!n || !size || *n < 0 || *size < 0 || static_cast<std::size_t>(*size) > content.size()) return fault;
    n_cells = n;
    Words behind(words.behind_line());
    if (is_word(behind.next(), "offsets")) return "";  // version 5: its arrays are judged when they are there
    const auto block = block_of(words.behind_line(), static_cast<std::size_t>(*size), binary);
    if (!block || !fills(*block, *n)) return fault;
  }
  return "";
}

}  // namespace geomesh::geomodel::checking
