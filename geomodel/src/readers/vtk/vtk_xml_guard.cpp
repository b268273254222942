// SPDX-License-Identifier: GPL-3.0-or-later
#include "readers/vtk/vtk_xml_guard.hpp"

#include <algorithm>
#include <array>
#include <cstdint>

#include "readers/text/text.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::array<std::string_view, 12> known_types{"Int8",  "UInt8",  "Int16",   "UInt16",  "Int32",  "UInt32",
                                                       "Int64", "UInt64", "Float32", "Float64", "String", "Bit"};
constexpr std::array<std::string_view, 8> counts{"NumberOfPoints", "NumberOfCells",     "NumberOfVerts",
                                                 "NumberOfLines",  "NumberOfStrips",    "NumberOfPolys",
                                                 "NumberOfTuples", "NumberOfComponents"};

bool is_blank(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }

/// One start tag: its name and its attributes, in the order of the text.
class Tag {
 public:
  /// `rest` begins behind '<'; is moved behind the tag.
  explicit Tag(std::string_view& rest) : rest_(rest) {
    name_ = word();
    while (next_attribute()) {
    }
    rest = rest_;
  }
  std::string_view name() const { return name_; }
  std::string_view type() const { return type_; }
  std::uint64_t largest_count() const { return largest_count_; }

 private:
  std::string_view word() {
    std::size_t n = 0;
    while (n < rest_.size() && !is_blank(rest_[n]) && rest_[n] != '=' && rest_[n] != '>' && rest_[n] != '/') ++n;
    const std::string_view result = rest_.substr(0, n);
    rest_.remove_prefix(n);
    return result;
  }
  bool next_attribute() {
    while (!rest_.empty() && (is_blank(rest_.front()) || rest_.front() == '/')) rest_.remove_prefix(1);
    if (rest_.empty() || rest_.front() == '>') return false;
    const std::string_view key = word();
    while (!rest_.empty() && (is_blank(rest_.front()) || rest_.front() == '=')) rest_.remove_prefix(1);
    if (rest_.empty()) return false;
    const char quote = rest_.front();
    if (quote != '"' && quote != '\'') return !key.empty();
    const std::size_t end = rest_.find(quote, 1);
    if (end == std::string_view::npos) return false;
    take(key, rest_.substr(1, end - 1));
    rest_.remove_prefix(end + 1);
    return true;
  }
  void take(std::string_view key, std::string_view value) {
    if (key == "type") type_ = value;
    if (std::find(counts.begin(), counts.end(), key) == counts.end()) return;
    if (const auto n = to_integer(trim(value)); n && *n > 0)
      largest_count_ = std::max(largest_count_, static_cast<std::uint64_t>(*n));
  }

  std::string_view rest_, name_, type_;
  std::uint64_t largest_count_ = 0;
};

}  // namespace

std::string fault_of_vtk_elements(std::string_view head, std::size_t file_size) {
  // zlib packs at most 1032 bytes into one, and a point or a cell has four bytes at least; an empty text has one.
  constexpr std::uint64_t most_packed = 1100;
  for (std::size_t at = head.find('<'); at != std::string_view::npos; at = head.find('<')) {
    head.remove_prefix(at + 1);
    const Tag tag(head);
    if (tag.name() == "AppendedData") return "";
    const bool is_array = tag.name() == "DataArray" || tag.name() == "Array";
    if (is_array && std::find(known_types.begin(), known_types.end(), tag.type()) == known_types.end())
      return "an array of it has no known type (" + std::string(tag.type().substr(0, 40)) + ")";
    if (tag.largest_count() / most_packed > file_size)
      return "it says to hold " + std::to_string(tag.largest_count()) + " items, which a file of " +
             std::to_string(file_size) + " bytes cannot";
  }
  return "";
}

std::optional<std::string> with_point_data(std::string_view text) {
  constexpr std::string_view element = "<PointData></PointData>";
  const std::string_view head = text.substr(0, std::min(text.find("<AppendedData"), text.size()));
  std::string out;
  std::size_t copied = 0;  // of the text
  for (std::size_t at = head.find("<Piece"); at != std::string_view::npos; at = head.find("<Piece", at + 1)) {
    std::string_view rest = head.substr(at + 1);
    const Tag tag(rest);
    const std::size_t end = head.size() - rest.size() + 1;  // behind the tag
    if (tag.name() != "Piece" || !rest.starts_with('>') || head[end - 2] == '/') continue;
    if (head.substr(end, head.find("</Piece", end) - end).find("<PointData") != std::string_view::npos) continue;
    out.append(text.substr(copied, end - copied)).append(element);
    copied = end;
  }
  if (copied == 0) return std::nullopt;
  return out.append(text.substr(copied));
}

}  // namespace geomesh::geomodel
