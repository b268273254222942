// SPDX-License-Identifier: GPL-3.0-or-later
// vtk_dump FILE...: what our readers find in each, one JSON a line; {"error": ...} where a file is refused.
#include <cstdio>
#include <string>
#include <type_traits>

#include "geomesh/core/error.hpp"
#include "vtk_files/typed.hpp"
#include "vtk_files/vtk_data.hpp"

namespace {

using namespace geomesh::geomodel;

std::string quoted(const std::string& text) {
  std::string result = "\"";
  for (const char c : text) {
    char code[8];
    std::snprintf(code, sizeof code, "\\u%04x", static_cast<unsigned char>(c));  // bytes, one a code point
    result += code;
  }
  return result + "\"";
}

void print_number(double value) {
  if (value != value)
    std::printf("NaN");
  else if (value - value != 0)
    std::printf(value > 0 ? "Infinity" : "-Infinity");
  else
    std::printf("%.17g", value);
}

template <class List, class Print>
void print_list(const List& list, Print print) {
  std::printf("[");
  bool first = true;
  for (const auto& item : list) {
    if (!first) std::printf(",");
    first = false;
    print(item);
  }
  std::printf("]");
}

void print_values(const VtkColumn& column) {
  if (column.is_text())
    return print_list(column.texts, [](const std::string& text) { std::printf("%s", quoted(text).c_str()); });
  with_type(column.type, [&](auto value) {
    std::printf("[");
    for (std::size_t i = 0; i < column.n_tuples * column.n_components; ++i) {
      std::memcpy(&value, column.bytes.data() + i * sizeof value, sizeof value);
      if (i > 0) std::printf(",");
      if constexpr (std::is_floating_point_v<decltype(value)>)
        print_number(value);
      else
        std::printf("%s", std::to_string(value).c_str());
    }
    std::printf("]");
  });
}

void print_table(const char* name, const VtkTable& table) {
  std::printf(",\"%s\":", name);
  print_list(table.columns, [](const VtkColumn& column) {
    std::printf("{\"name\":%s,\"type\":\"%s\",\"components\":%zu,\"tuples\":%zu,\"values\":",
                quoted(column.name).c_str(), name_of(column.type).c_str(), column.n_components, column.n_tuples);
    print_values(column);
    std::printf("}");
  });
}

void print(const VtkData& data) {
  std::printf("{\"points\":");
  print_list(data.points, [](const geomesh::Vec3& p) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (k > 0) std::printf(",");
      print_number(p[k]);
    }
  });
  std::printf(",\"first\":");
  print_list(data.cells.first, [](std::size_t i) { std::printf("%zu", i); });
  std::printf(",\"corners\":");
  print_list(data.cells.corners, [](geomesh::VertexIndex i) { std::printf("%zu", static_cast<std::size_t>(i)); });
  std::printf(",\"types\":");
  print_list(data.cells.types, [](std::uint8_t t) { std::printf("%d", t); });
  print_table("point_data", data.point_data);
  print_table("cell_data", data.cell_data);
  print_table("field_data", data.field_data);
  std::printf("}\n");
}

}  // namespace

int main(int argc, char** argv) {
  for (int i = 1; i < argc; ++i) try {
      const InputFile file = load_input_file(argv[i]);
      print(is_vtk_legacy(file) ? read_vtk_legacy_data(file) : read_vtk_xml_data(file));
    } catch (const geomesh::Error& e) {
      std::printf("{\"error\":%s}\n", quoted(e.what()).c_str());
    }
}
