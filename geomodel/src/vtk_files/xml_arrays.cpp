// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtk_files/xml_arrays.hpp"

#include <utility>

#include "readers/text/text.hpp"
#include "vtk_files/typed.hpp"

namespace geomesh::geomodel {
namespace {

constexpr std::pair<std::string_view, VtkType> types[] = {
    {"Int8", VtkType::int8},       {"UInt8", VtkType::uint8},    {"Int16", VtkType::int16},
    {"UInt16", VtkType::uint16},   {"Int32", VtkType::int32},    {"UInt32", VtkType::uint32},
    {"Int64", VtkType::int64},     {"UInt64", VtkType::uint64},  {"Float32", VtkType::float32},
    {"Float64", VtkType::float64}, {"String", VtkType::text},    {"Bit", VtkType::bit},
    {"float", VtkType::float32},   {"double", VtkType::float64}, {"int", VtkType::int32}};

/// Returns the text of an XML element without its child elements (VTK stores the range of an array in one).
std::string_view text_of(const pugi::xml_node& element, std::string& room) {
  std::size_t n = 0;
  for (const pugi::xml_node& child : element.children()) n += child.type() == pugi::node_pcdata;
  if (n < 2) return element.text().get();
  for (const pugi::xml_node& child : element.children())
    if (child.type() == pugi::node_pcdata) room += std::string(child.value()) + " ";
  return room;
}

std::size_t n_words(std::string_view text) {
  std::size_t n = 0;
  while (!next_word(text).empty()) ++n;
  return n;
}

}  // namespace

std::optional<std::size_t> count_attribute(const InputFile& file, const pugi::xml_node& element, const char* name) {
  const pugi::xml_attribute attribute = element.attribute(name);
  if (!attribute) return std::nullopt;
  const auto n = to_integer(trim(attribute.value()));
  if (!n || *n < 0)
    file.fail(std::string(element.name()) + ": " + name + " is " + in_quotes(attribute.value()) +
              ", where a count was expected");
  return static_cast<std::size_t>(*n);
}

void XmlArrays::fail(const VtkColumn& column, const std::string& why) const {
  file_.fail("the array " + in_quotes(column.name) + " " + why);
}

VtkColumn XmlArrays::read(const pugi::xml_node& element, std::optional<std::size_t> n_tuples) const {
  VtkColumn column;
  column.name = element.attribute("Name").value();
  const std::string_view type = element.attribute("type").value();
  const auto* known = std::find_if(std::begin(types), std::end(types), [&](const auto& t) { return t.first == type; });
  if (known == std::end(types)) fail(column, "has the type " + in_quotes(type) + ", which no VTK file has");
  column.type = known->second;
  column.n_components = count_attribute(file_, element, "NumberOfComponents").value_or(1);
  if (column.n_components == 0) column.n_components = 1;
  if (!n_tuples) n_tuples = count_attribute(file_, element, "NumberOfTuples");
  const std::size_t n_values = n_tuples ? product(*n_tuples, column.n_components) : SIZE_MAX;
  if (n_tuples && n_values == SIZE_MAX) fail(column, "says to hold more numbers than any file can");
  const std::string_view format = element.attribute("format").as_string("ascii");
  std::string room;
  try {
    if (format == "ascii") {
      read_ascii(element, column, n_values);
    } else if (format == "binary") {
      read_bytes(ByteSource(text_of(element, room), true), column, n_values);
    } else if (format == "appended") {
      const auto offset = count_attribute(file_, element, "offset");
      if (!offset || *offset > appended_.text.size()) fail(column, "begins behind the end of the file (truncated?)");
      read_bytes(ByteSource(appended_.text.substr(*offset), appended_.base64), column, n_values);
    } else {
      fail(column, "has the format " + in_quotes(format) + ", which no VTK file has");
    }
  } catch (const DamagedArray& damage) {
    fail(column, damage.what());
  }
  return column;
}

void XmlArrays::read_ascii(const pugi::xml_node& element, VtkColumn& column, std::size_t n_values) const {
  std::string room;
  std::string_view text = text_of(element, room);
  if (n_values == SIZE_MAX || column.is_text()) {
    const std::size_t n = n_words(text);
    if (n_values == SIZE_MAX) n_values = n - n % column.n_components;
    if (column.is_text()) {
      const std::vector<std::byte> bytes = numbers_of_text(text, VtkType::uint8, n);
      take_texts({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, column);
      return;
    }
  }
  column.bytes = numbers_of_text(text, column.type, n_values);
  const std::size_t n_read = column.bytes.size() / size_of(column.type);
  if (n_read < n_values) {
    const std::string_view word = next_word(text);
    fail(column, word.empty() ? "holds " + std::to_string(n_read) + " numbers where " + std::to_string(n_values) +
                                    " were expected"
                              : "holds " + in_quotes(word) + " where a number of its type was expected");
  }
  column.n_tuples = n_values / column.n_components;
}

void XmlArrays::read_bytes(ByteSource source, VtkColumn& column, std::size_t n_values) const {
  const bool all = n_values == SIZE_MAX || column.is_text();
  const std::size_t size = size_of(column.type), n_bytes = column.type == VtkType::bit && !all
                                                               ? n_values / 8 + (n_values % 8 != 0)
                                                               : product(n_values, size);
  if (!all && n_bytes == SIZE_MAX) fail(column, "says to hold more numbers than any file can");
  if (n_values == 0) return;  // a VTK array without values may lack the header of its data
  const std::string bytes = decoded_array(source, encoding_, all ? SIZE_MAX : n_bytes);
  if (column.is_text()) return take_texts(bytes, column);
  const auto begin = reinterpret_cast<const std::byte*>(bytes.data());
  column.bytes.assign(begin, begin + bytes.size());
  if (column.type == VtkType::bit) {
    column.bytes = unpacked_bits(column.bytes, all ? 8 * bytes.size() : n_values);
  } else {
    to_native_order(column.bytes, size, encoding_.order);
  }
  column.n_tuples = column.bytes.size() / size / column.n_components;
  column.bytes.resize(column.n_tuples * column.n_components * size);
}

/// Reads the texts of a VTK array, each of which ends with a zero byte.
void XmlArrays::take_texts(std::string_view bytes, VtkColumn& column) const {
  while (!bytes.empty()) {
    const std::size_t end = std::min(bytes.find('\0'), bytes.size());
    column.texts.emplace_back(bytes.substr(0, end));
    bytes.remove_prefix(std::min(end + 1, bytes.size()));
  }
  column.n_tuples = column.texts.size() / column.n_components;
}

}  // namespace geomesh::geomodel
