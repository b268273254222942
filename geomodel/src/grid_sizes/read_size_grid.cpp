// SPDX-License-Identifier: GPL-3.0-or-later
// Sizes from a file, declared in grid_sizes/size_grid.hpp.
#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDataSet.h>
#include <vtkImageData.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLImageDataReader.h>
#include <vtkXMLPolyDataReader.h>
#include <vtkXMLUnstructuredGridReader.h>

#include <cmath>
#include <memory>
#include <optional>

#include "grid_sizes/size_grid.hpp"
#include "readers/tables/table.hpp"
#include "readers/text/text.hpp"
#include "readers/vtk/vtk_parse.hpp"

namespace geomesh::geomodel {
namespace {

struct Sizes {
  std::vector<Vec3> points;
  std::vector<double> sizes;
};

/// What is read: the array of a VTK file, and whether values must be sizes.
struct Wanted {
  std::string array, noun;
  bool positive;
  bool holds(double v) const { return std::isfinite(v) && (v > 0 || !positive); }
  std::string expected() const { return positive ? noun + " above zero" : "a finite " + noun; }
};

/// Four numbers of a line; nothing where they are not.
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

Vec3 centre_of(vtkDataSet& data, vtkIdType cell) {
  double sum[3] = {0, 0, 0}, p[3];
  vtkCell& c = *data.GetCell(cell);
  const vtkIdType n = c.GetNumberOfPoints();
  for (vtkIdType i = 0; i < n; ++i) {
    data.GetPoint(c.GetPointId(i), p);
    for (int k = 0; k < 3; ++k) sum[k] += p[k] / static_cast<double>(n);
  }
  return {sum[0], sum[1], sum[2]};
}

Sizes sizes_of(const InputFile& file, const Wanted& wanted, vtkDataSet& data) {
  Sizes sizes;
  vtkDataArray* at_points = data.GetPointData()->GetArray(wanted.array.c_str());
  vtkDataArray* at_cells = data.GetCellData()->GetArray(wanted.array.c_str());
  vtkDataArray* array = at_points ? at_points : at_cells;
  if (!array || array->GetNumberOfComponents() != 1)
    file.fail("has no point or cell array \"" + wanted.array + "\" of one number each");
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
    const double size = array->GetComponent(i, 0);
    if (!wanted.holds(size))
      file.fail("the array \"" + wanted.array + "\" holds a value that is no " + wanted.expected() + ", at row " +
                std::to_string(i));
    double p[3];
    if (at_points) data.GetPoint(i, p);
    sizes.points.push_back(at_points ? Vec3{p[0], p[1], p[2]} : centre_of(data, i));
    sizes.sizes.push_back(size);
  }
  return sizes;
}

Sizes read_sizes(const InputFile& file, const Wanted& wanted) {
  const std::string extension = file.extension();
  if (extension == ".vti") return sizes_of(file, wanted, *parse_vtk<vtkXMLImageDataReader, vtkImageData>(file));
  if (extension == ".vtu")
    return sizes_of(file, wanted, *parse_vtk<vtkXMLUnstructuredGridReader, vtkUnstructuredGrid>(file));
  if (extension == ".vtp") return sizes_of(file, wanted, *parse_vtk<vtkXMLPolyDataReader, vtkPolyData>(file));
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
