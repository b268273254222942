// SPDX-License-Identifier: GPL-3.0-or-later
// Reads target sizes at points from a file, declared in grid_sizes/size_grid.hpp.
#include <cmath>
#include <memory>
#include <optional>

#include "grid_sizes/size_grid.hpp"
#include "readers/tables/table.hpp"
#include "readers/text/text.hpp"
#include "vtk_files/vtk_data.hpp"

namespace geomesh::geomodel {
namespace {

struct Sizes {
  std::vector<Vec3> points;
  std::vector<double> sizes;
};

/// Name of the VTK array to read, and whether its values must be positive sizes.
struct Wanted {
  std::string array, noun;
  bool positive;
  bool holds(double v) const { return std::isfinite(v) && (v > 0 || !positive); }
  std::string expected() const { return positive ? noun + " above zero" : "a finite " + noun; }
};

std::optional<std::array<double, 4>> four_numbers(std::string_view line) {
  const Separation separation = sniff_separation(line);
  const auto fields = separation.split(line);
  if (fields.size() < 4) return std::nullopt;
  std::array<double, 4> values{};
  for (std::size_t i = 0; i < 4; ++i) {
    const auto value = separation.number(fields[i]);
    if (!value || !std::isfinite(*value)) return std::nullopt;
    values[i] = *value;
  }
  return values;
}

Sizes read_text(const InputFile& file, const Wanted& wanted) {
  if (looks_binary(file))
    file.fail("holds no " + wanted.noun + "s that are understood: lines of x y z " + wanted.noun +
              ", or a .vti, .vtu or .vtp with an array \"" + wanted.array + "\", were expected");
  Sizes sizes;
  LineReader lines(file);
  bool header_allowed = true;
  while (lines.next()) {
    const std::string_view line = trim(lines.line());
    if (line.empty() || line.front() == '#' || line.front() == '!') continue;
    const auto values = four_numbers(line);
    if (!values && !header_allowed) lines.fail("four numbers x y z " + wanted.noun + " were expected");
    header_allowed = false;
    if (!values) continue;
    if (!wanted.holds((*values)[3])) lines.fail("a " + wanted.expected() + " was expected");
    sizes.points.push_back({(*values)[0], (*values)[1], (*values)[2]});
    sizes.sizes.push_back((*values)[3]);
  }
  return sizes;
}

Vec3 centre_of(const VtkData& data, std::size_t cell) {
  Vec3 sum{0, 0, 0};
  const auto corners = data.cells.of(cell);
  for (const VertexIndex v : corners) sum = sum + (1 / static_cast<double>(corners.size())) * data.points[v];
  return sum;
}

Sizes sizes_of(const InputFile& file, const Wanted& wanted, const VtkData& data) {
  Sizes sizes;
  const VtkColumn* const at_points = data.point_data.numbers(wanted.array);
  const VtkColumn* const array = at_points ? at_points : data.cell_data.numbers(wanted.array);
  if (!array || array->n_components != 1)
    file.fail("has no point or cell array \"" + wanted.array + "\" of one number each");
  const std::size_t n = at_points ? data.points.size() : data.cells.size();
  for (std::size_t i = 0; i < n; ++i) {
    const double size = array->number(i);
    if (!wanted.holds(size))
      file.fail("the array \"" + wanted.array + "\" holds a value that is no " + wanted.expected() + ", at row " +
                std::to_string(i));
    if (!at_points && data.cells.of(i).empty()) continue;
    sizes.points.push_back(at_points ? data.points[i] : centre_of(data, i));
    sizes.sizes.push_back(size);
  }
  return sizes;
}

Sizes read_sizes(const InputFile& file, const Wanted& wanted) {
  const std::string extension = file.extension();
  if (extension == ".vti" || extension == ".vtu" || extension == ".vtp")
    return sizes_of(file, wanted, read_vtk_xml_data(file));
  return read_text(file, wanted);
}

SizeGrid read_grid(const std::filesystem::path& path, const Wanted& wanted) {
  const InputFile file = load_input_file(path);
  Sizes sizes = read_sizes(file, wanted);
  if (sizes.points.empty())
    file.fail("holds no " + wanted.noun + "s: lines of x y z " + wanted.noun + " were expected");
  return SizeGrid(std::move(sizes.points), std::move(sizes.sizes));
}

}  // namespace

SizeGrid read_size_grid(const std::filesystem::path& path) { return read_grid(path, {"size", "size", true}); }

SizeGrid read_value_grid(const std::filesystem::path& path, const std::string& array) {
  return read_grid(path, {array, "value", false});
}

void load_background(NamedSizes& sizes, const Vec3& origin) {
  if (sizes.background.empty()) return;
  const auto grid = std::make_shared<const SizeGrid>(read_size_grid(sizes.background));
  sizes.base.background = [grid, origin](const Vec3& p) { return grid->at(p + origin); };
}

}  // namespace geomesh::geomodel
