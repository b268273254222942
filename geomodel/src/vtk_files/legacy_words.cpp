// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_files/legacy_words.hpp"

#include <algorithm>
#include <utility>

#include "readers/text/text.hpp"
#include "vtk_files/typed.hpp"

namespace geomesh::geomodel {
namespace {

/// Names of number types in legacy VTK files. Binary files store vtkIdType as a 32-bit number.
constexpr std::pair<std::string_view, VtkType> types[] = {{"bit", VtkType::bit},
                                                          {"char", VtkType::int8},
                                                          {"signed_char", VtkType::int8},
                                                          {"unsigned_char", VtkType::uint8},
                                                          {"short", VtkType::int16},
                                                          {"unsigned_short", VtkType::uint16},
                                                          {"int", VtkType::int32},
                                                          {"unsigned_int", VtkType::uint32},
                                                          {"long", VtkType::int64},
                                                          {"unsigned_long", VtkType::uint64},
                                                          {"vtktypeint64", VtkType::int64},
                                                          {"vtktypeuint64", VtkType::uint64},
                                                          {"vtktypeint32", VtkType::int32},
                                                          {"vtkidtype", VtkType::int32},
                                                          {"float", VtkType::float32},
                                                          {"double", VtkType::float64},
                                                          {"string", VtkType::text},
                                                          {"utf8_string", VtkType::text}};

int hex_digit(char c) {
  const auto byte = static_cast<unsigned char>(c);
  return c >= '0' && c <= '9' ? c - '0' : (byte | 0x20) >= 'a' && (byte | 0x20) <= 'f' ? (byte | 0x20) - 'a' + 10 : -1;
}

/// Decodes a name: %XX stands for the byte with that hexadecimal number.
std::string decoded(std::string_view text) {
  std::string result;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const bool is_code =
        text[i] == '%' && i + 2 < text.size() && hex_digit(text[i + 1]) >= 0 && hex_digit(text[i + 2]) >= 0;
    result += is_code ? static_cast<char>(16 * hex_digit(text[i + 1]) + hex_digit(text[i + 2])) : text[i];
    if (is_code) i += 2;
  }
  return result;
}

}  // namespace

void LegacyWords::fail(const std::string& message) const {
  file_.fail(message + (message.find("damaged") == std::string::npos ? " (damaged?)" : ""));
}

std::string_view LegacyWords::line() {
  const std::size_t end = std::min(rest_.find('\n'), rest_.size());
  std::string_view line = rest_.substr(0, end);
  rest_.remove_prefix(std::min(end + 1, rest_.size()));
  if (line.ends_with('\r')) line.remove_suffix(1);
  return line;
}

std::string LegacyWords::keyword() { return to_lower(next_word(rest_)); }

std::string LegacyWords::next_keyword() const {
  std::string_view copy = rest_;
  return to_lower(next_word(copy));
}

std::string LegacyWords::name() { return decoded(next_word(rest_)); }

std::size_t LegacyWords::count(const char* what) {
  const std::string_view word = next_word(rest_);
  const auto n = to_integer(word);
  if (!n || *n < 0) fail(std::string("the number of ") + what + " was expected, found " + in_quotes(word));
  if (static_cast<std::size_t>(*n) / 8 > file_.size())
    fail("it says to hold " + std::to_string(*n) + " " + what + ", which a file of " + std::to_string(file_.size()) +
         " bytes cannot");
  return static_cast<std::size_t>(*n);
}

VtkType LegacyWords::type() {
  const std::string word = keyword();
  for (const auto& [name, type] : types)
    if (word == name) return type;
  fail("a type of numbers was expected, found " + in_quotes(word));
}

std::vector<std::string_view> LegacyWords::words_of_line() {
  std::string_view rest = line();
  std::vector<std::string_view> words;
  for (std::string_view word = next_word(rest); !word.empty(); word = next_word(rest)) words.push_back(word);
  return words;
}

void LegacyWords::end_line() { line(); }

std::string_view LegacyWords::bytes(std::size_t n) {
  if (n > rest_.size()) fail("it ends within a block of numbers (truncated?)");
  const std::string_view result = rest_.substr(0, n);
  rest_.remove_prefix(n);
  return result;
}

VtkColumn LegacyWords::values(std::string name, VtkType type, std::size_t n_tuples, std::size_t n_components) {
  VtkColumn column;
  column.name = std::move(name);
  column.type = type;
  column.n_tuples = n_tuples;
  column.n_components = std::max<std::size_t>(n_components, 1);
  const std::size_t n = product(n_tuples, column.n_components);
  if (n / 8 > file_.size()) fail("the array " + in_quotes(column.name) + " says to hold more than the file (damaged)");
  if (type == VtkType::text) {
    end_line();
    read_texts(column, n);
  } else if (binary) {
    end_line();
    read_binary(column, n);
  } else {
    column.bytes = numbers_of_text(rest_, type, n);
    if (column.bytes.size() / size_of(type) < n) {
      std::string_view copy = rest_;
      const std::string_view word = next_word(copy);
      const std::string array = column.name.empty() ? "a block of numbers" : "the array " + in_quotes(column.name);
      fail(array + (word.empty() ? " ends too early (truncated?)"
                                 : " holds " + in_quotes(word) + " where a number of its type was expected"));
    }
  }
  return column;
}

void LegacyWords::read_binary(VtkColumn& column, std::size_t n) {
  const std::size_t size = size_of(column.type);
  const std::string_view raw = bytes(column.type == VtkType::bit ? n / 8 + (n % 8 != 0) : product(n, size));
  const auto begin = reinterpret_cast<const std::byte*>(raw.data());
  if (column.type == VtkType::bit) {
    column.bytes = unpacked_bits({begin, raw.size()}, n);
    return;
  }
  column.bytes.assign(begin, begin + raw.size());
  to_native_order(column.bytes, size, std::endian::big);
}

/// Reads the length of a text in a binary VTK file: 1, 2, 4 or 8 bytes, as the two highest bits of the first byte say.
std::size_t LegacyWords::length_of_text() {
  const auto head = static_cast<unsigned char>(bytes(1).front());
  std::size_t length = head & 63u;
  for (const char c : bytes((std::size_t{8} >> (head >> 6u)) - 1)) length = length << 8 | static_cast<unsigned char>(c);
  return length;
}

void LegacyWords::read_texts(VtkColumn& column, std::size_t n) {
  for (std::size_t i = 0; i < n; ++i) {
    if (!binary && rest_.empty()) fail("the array " + in_quotes(column.name) + " ends too early (truncated?)");
    column.texts.push_back(binary ? std::string(bytes(length_of_text())) : decoded(line()));
  }
}

}  // namespace geomesh::geomodel
