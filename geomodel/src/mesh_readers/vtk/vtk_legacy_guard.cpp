// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh_readers/vtk/vtk_legacy_guard.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <utility>
#include <vector>

namespace geomesh::geomodel::checking {
namespace {

std::optional<std::int64_t> integer(std::string_view word) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
  if (word.empty() || error != std::errc() || end != word.data() + word.size()) return std::nullopt;
  return value;
}

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
  std::optional<std::int64_t> number() { return integer(next()); }
  std::string_view rest_of_line() {
    const std::size_t begin = at_, end = std::min(text_.find('\n', at_), text_.size());
    at_ = std::min(end + 1, text_.size());
    const std::string_view line = text_.substr(begin, end - begin);
    return line.ends_with('\r') ? line.substr(0, line.size() - 1) : line;
  }
  /// False where there are fewer.
  bool pass_over(std::size_t n_bytes) {
    const bool are_there = n_bytes <= text_.size() - at_;
    at_ = are_there ? at_ + n_bytes : text_.size();
    return are_there;
  }
  /// Each begins with its length in 1, 2, 4 or 8 bytes; the two highest bits tell which. False where they are not
  /// there: VTK asks for as much memory before it reads them.
  bool pass_over_strings(std::size_t n) {
    for (; n > 0; --n) {
      if (at_ >= text_.size()) return false;
      const auto head = static_cast<unsigned char>(text_[at_]);
      std::size_t length = head & 63u;
      for (std::size_t k = 1; k < std::size_t{8} >> (head >> 6u) && at_ + 1 < text_.size(); ++k)
        length = length << 8 | static_cast<unsigned char>(text_[++at_]);
      ++at_;
      if (!pass_over(length)) return false;
    }
    return true;
  }
  void pass_over_lines(std::size_t n) {
    for (; n > 0 && at_ < text_.size(); --n) at_ = std::min(text_.find('\n', at_), text_.size() - 1) + 1;
  }
  /// What follows the end of this line.
  std::string_view behind_line() {
    const std::size_t end = text_.find('\n', at_);
    return end == std::string_view::npos ? std::string_view{} : text_.substr(end + 1);
  }

 private:
  static bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r' || c == '\v' || c == '\f'; }
  std::string_view text_;
  std::size_t at_ = 0;
};

/// In small letters.
std::string lower(std::string_view word) {
  std::string result(word);
  for (char& c : result) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return result;
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

/// Types of numbers and their bytes.
constexpr std::pair<std::string_view, std::size_t> widths[] = {
    {"bit", 1},          {"char", 1},           {"signed_char", 1},   {"unsigned_char", 1},
    {"short", 2},        {"unsigned_short", 2}, {"int", 4},           {"float", 4},
    {"unsigned_int", 4}, {"long", 8},           {"unsigned_long", 8}, {"double", 8},
    {"vtkidtype", 4},    {"vtktypeint64", 8},   {"vtktypeuint64", 8}};

std::optional<std::size_t> width_of(const std::string& type) {
  for (const auto& [name, width] : widths)
    if (type.starts_with(name)) return width;  // as VTK compares them
  return std::nullopt;
}

/// A number as a stream of C++ reads it: one beyond its type is none.
bool is_number(std::string_view word, const std::string& type, std::size_t width) {
  if (word.starts_with('+')) word.remove_prefix(1);
  const bool is_double = type.starts_with("double");
  if (type.starts_with("float") || is_double) {
    double value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size() && std::isfinite(value) &&
           (is_double || std::abs(value) <= std::numeric_limits<float>::max());
  }
  if (type.starts_with("unsigned_long") || type.starts_with("vtktypeuint64")) {
    std::uint64_t value = 0;
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
  }
  const auto value = integer(word);
  if (!value || type.starts_with("vtkidtype") || width == 8) return value.has_value();
  const bool is_unsigned = type.starts_with("unsigned");
  const std::int64_t beyond = std::int64_t{1} << (8 * width - (is_unsigned ? 0 : 1));
  return *value >= (is_unsigned ? 0 : -beyond) && *value < beyond;
}

/// Counts stand before a type: `POINTS 5 double`, and `porosity 1 5 double` in a field. VTK takes their product without
/// looking, and writes as many values as follow.
std::string fault_of_counts(std::string_view content) {
  const auto most = static_cast<std::int64_t>(8 * content.size());  // as many bits
  const auto is_wrong = [&](std::int64_t a, std::int64_t b) { return a < 0 || b < 0 || (a > 0 && b > most / a); };
  Words words(content);
  std::string_view before, last;
  for (std::string_view word = words.next(); !word.empty(); word = words.next()) {
    if (const auto n = integer(last); n && width_of(lower(word))) {
      const auto first = lower(before).starts_with("points") ? std::optional<std::int64_t>(3) : integer(before);
      if (first && is_wrong(*first, *n)) return "says to hold more numbers than a file of its size can (damaged)";
    }
    before = last;
    last = word;
  }
  return "";
}

/// The keywords of cells one after the other. VTK goes by the first letters of a word, and takes a block again where it
/// comes again. It follows types whose count is not that of the cells.
class CellBlocks {
 public:
  /// `version`: the first number of the file's version; from 5 on, blocks of cells begin with OFFSETS.
  CellBlocks(std::string_view content, std::int64_t version) : content_(content), words_(content), version_(version) {}

  std::string fault() {
    for (std::string word = lower(words_.next()); !word.empty(); word = lower(words_.next())) {
      if (word.starts_with("cell_data") || word.starts_with("point_data")) return "";  // what follows are attributes
      if (word == "binary") binary_ = true;
      const std::string fault = word.starts_with("field")    ? fault_of_field()
                                : word.starts_with("points") ? fault_of_points()
                                : word.starts_with("cells")  ? fault_of_cells()
                                : word.starts_with("cell_")  ? fault_of_types()
                                                             : "";
      if (!fault.empty()) return fault;
    }
    return "";
  }

 private:
  /// Passes over arrays, whose names may be any words.
  /// Where VTK cannot read one of them it follows a null pointer.
  std::string fault_of_field() {
    const std::string fault = "has a field that does not fill its arrays (damaged)";
    words_.next();
    auto n = words_.number();
    if (!n) return fault;
    for (; *n > 0; --*n) {
      std::string name = lower(words_.next());
      for (; name == "metadata"; name = lower(words_.next())) {
        words_.rest_of_line();
        while (!words_.rest_of_line().empty()) {
        }
      }
      if (name == "null_array") continue;
      const auto width = words_.number(), length = words_.number();
      const std::string type = lower(words_.next());
      const auto most = static_cast<std::int64_t>(8 * content_.size());
      if (!width || !length || *width < 0 || *length < 0 || (*width > 0 && *length > most / *width)) return fault;
      if (!holds_array(type, static_cast<std::size_t>(*width * *length))) return fault;
    }
    return "";
  }
  /// Passes over it.
  bool holds_array(const std::string& type, std::size_t n) {
    if (type.starts_with("string")) {
      words_.rest_of_line();
      if (binary_) return words_.pass_over_strings(n);
      words_.pass_over_lines(n);
      return true;
    }
    const auto width = width_of(type);
    if (!width) return false;
    if (binary_) {
      words_.rest_of_line();
      return words_.pass_over(type.starts_with("bit") ? (n + 7) / 8 : n * *width);
    }
    for (; n > 0; --n)
      if (!is_number(words_.next(), type, *width)) return false;
    return true;
  }
  /// Bytes might look like keywords. In text VTK takes what follows the last number that it can read for one.
  std::string fault_of_points() {
    const auto n = words_.number();
    const std::string type = lower(words_.next());
    if (!n || *n < 0 || static_cast<std::size_t>(*n) > content_.size() ||
        !holds_array(type, 3 * static_cast<std::size_t>(*n)))
      return "has points that do not fill their block of numbers (damaged)";
    return "";
  }
  std::string fault_of_types() {
    if (n_types_) return "has CELL_TYPES twice (damaged)";
    n_types_ = words_.number();
    if (!n_types_ || *n_types_ < 0 || static_cast<std::size_t>(*n_types_) > content_.size() || !counts_agree())
      return "says another number of CELL_TYPES than of CELLS (damaged)";
    return holds_array("int", static_cast<std::size_t>(*n_types_)) ? "" : "ends within its CELL_TYPES (damaged)";
  }
  /// In files of version 5: the offsets, then the rows of points.
  bool holds_arrays_of_cells(std::size_t n_offsets, std::size_t n_rows) {
    for (const std::size_t n : {n_offsets, n_rows}) {
      words_.next();
      if (!holds_array(lower(words_.next()), n)) return false;
    }
    return true;
  }
  std::string fault_of_cells() {
    if (n_cells_) return "has CELLS twice (damaged)";
    const auto n = words_.number(), size = words_.number();
    const std::string fault = "has cells that do not fill their block of numbers (damaged)";
    if (!n || !size || *n < 0 || *size < 0 || static_cast<std::size_t>(*size) > content_.size()) return fault;
    Words behind(words_.behind_line());
    const bool is_version_5 = lower(behind.next()) == "offsets";  // its arrays are judged when they are there
    if (is_version_5 != (version_ >= 5)) return "has cells as another version of the format has them (damaged)";
    n_cells_ = is_version_5 ? std::max<std::int64_t>(*n - 1, 0) : *n;
    const auto block =
        is_version_5 ? std::nullopt : block_of(words_.behind_line(), static_cast<std::size_t>(*size), binary_);
    if (!is_version_5 && (!block || !fills(*block, *n))) return fault;
    if (is_version_5 && !holds_arrays_of_cells(static_cast<std::size_t>(*n), static_cast<std::size_t>(*size)))
      return fault;
    if (binary_ && !is_version_5 && !holds_array("int", static_cast<std::size_t>(*size))) return fault;
    return counts_agree() ? "" : "says another number of CELL_TYPES than of CELLS (damaged)";
  }
  bool counts_agree() const { return !n_types_ || !n_cells_ || *n_types_ == *n_cells_; }

  std::string_view content_;
  Words words_;
  std::int64_t version_;
  bool binary_ = false;
  std::optional<std::int64_t> n_cells_, n_types_;
};

}  // namespace

std::string fault_of_legacy_cells(std::string_view content) {
  constexpr std::string_view head = "# vtk DataFile Version ";
  if (!content.starts_with(head)) return "does not begin as a VTK file";
  const std::string_view version =
      content.substr(head.size(), std::min(content.find('\n'), content.size()) - head.size());
  const std::size_t point = std::min(version.find('.'), version.size());
  const auto first = integer(version.substr(0, point));
  // Where one of the two numbers is none VTK reads the cells as those of the oldest version.
  const bool has_second = point + 1 < version.size() && std::isdigit(static_cast<unsigned char>(version[point + 1]));
  if (!first || *first < 1 || !has_second) return "says no version of the format that is known";
  for (int line = 0; line < 2; ++line) {  // the version, and a title that may hold any word
    const std::size_t end = content.find('\n');
    content.remove_prefix(end == std::string_view::npos ? content.size() : end + 1);
  }
  const std::string fault = fault_of_counts(content);
  return fault.empty() ? CellBlocks(content, *first).fault() : fault;
}

}  // namespace geomesh::geomodel::checking
