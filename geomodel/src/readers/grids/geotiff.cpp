// SPDX-License-Identifier: GPL-3.0-or-later
// Reads GeoTIFF with GDAL, which is in a module (geotiff_plugin.hpp): GDAL's geotransform handles pixel-is-area and
// pixel-is-point, as well as the no-data tag, scale and offset. The raster is read from memory. Its size is compared
// with that of the file before anything is allocated.
#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

#include "modules/module.hpp"
#include "readers/formats.hpp"
#include "readers/grids/geotiff_plugin.hpp"
#include "readers/grids/grid.hpp"
#include "readers/text/frame.hpp"

namespace geomesh::geomodel {

const GeomeshRasterReader& geotiff_plugin() {
  constexpr ModuleName gdal{"geomesh-gdal.so", "geomesh_raster_reader", "GeoTIFF is read by", "geomesh-gdal",
                            "libgdal-dev"};
  // If loading the GDAL module throws an exception, the next call tries again.
  static const void* const table = module_table(gdal, [](const void* t) {
    return static_cast<const GeomeshRasterReader*>(t)->version == geomesh_raster_reader_version;
  });
  return *static_cast<const GeomeshRasterReader*>(table);
}

namespace {

class Raster {
 public:
  Raster(const InputFile& file, const GeomeshRasterReader& reader)
      : file_(file), reader_(reader), raster_(reader.open(file.bytes.data(), file.size())) {
    if (*raster_->error == '\0') return;
    const std::string reason = raster_->error;
    reader_.close(raster_);
    file_.fail(reason);
  }
  ~Raster() { reader_.close(raster_); }
  Raster(const Raster&) = delete;
  Raster& operator=(const Raster&) = delete;

  const GeomeshRaster& header() const { return *raster_; }
  void read_row(std::size_t row, double* heights) const {
    if (const char* reason = reader_.read_row(raster_, row, heights))
      file_.fail("row " + std::to_string(row) + " of the raster " + reason);
  }
  std::vector<std::string> warnings() const {
    std::vector<std::string> warnings;
    while (const char* text = reader_.next_warning(raster_)) warnings.emplace_back(text);
    return warnings;
  }

 private:
  const InputFile& file_;
  const GeomeshRasterReader& reader_;
  GeomeshRaster* raster_;
};

/// Throws if a compressed raster file is too short to contain so many columns and rows.
void check_size(const InputFile& file, const GeomeshRaster& header) {
  constexpr std::size_t most_nodes_a_byte = 2000, most_nodes = 400'000'000;
  if (header.n_columns < 2 || header.n_rows < 2) file.fail("the raster has fewer than two columns or rows");
  if (header.n_columns > std::min(file.size() * most_nodes_a_byte, most_nodes) / header.n_rows) {
    file.fail("the raster is given as " + std::to_string(header.n_columns) + " by " + std::to_string(header.n_rows) +
              " cells, which a file of " + std::to_string(file.size()) +
              " bytes does not hold or the memory would not; cut it to the area of the model");
  }
}

void check_place(const InputFile& file, const GeomeshRaster& header) {
  if (!header.has_transform)
    file.fail("the TIFF file says nowhere where it lies (no geotransform, no tie points): a GeoTIFF was expected");
  const double* const t = header.transform;
  for (int i = 0; i < 6; ++i)
    if (!std::isfinite(t[i])) file.fail("the georeference holds a number that is not finite");
  if (t[1] * t[5] - t[2] * t[4] == 0) file.fail("the georeference gives cells of no area");
}

SourceFrame described_frame(const GeomeshRaster& header) {
  SourceFrame frame;
  frame.crs = header.system;
  frame.geographic = header.is_geographic != 0;
  const double metres = header.metres_per_unit;
  if (std::abs(metres - 0.3048) < 1e-9) frame.unit = "ft";
  if (std::abs(metres - 1200.0 / 3937.0) < 1e-9) frame.unit = "ftUS";
  if (metres == 1000) frame.unit = "km";
  if (const std::string unit = header.unit_of_heights; !unit.empty()) frame.z_unit = unit == "metre" ? "m" : unit;
  return frame;
}

/// Returns the heights in band 1 at the centres of the cells, with rows in the order of the file.
NodeLattice read_nodes(const Raster& raster) {
  const GeomeshRaster& header = raster.header();
  const double* const t = header.transform;
  NodeLattice lattice{header.n_columns, header.n_rows, {}};
  std::vector<double> row(header.n_columns);
  for (std::size_t j = 0; j < header.n_rows; ++j) {
    raster.read_row(j, row.data());
    for (std::size_t i = 0; i < header.n_columns; ++i) {
      const double u = static_cast<double>(i) + 0.5, v = static_cast<double>(j) + 0.5;
      const bool present = std::isfinite(row[i]) && !(header.has_no_data && row[i] == header.no_data);
      lattice.nodes.push_back(
          {t[0] + u * t[1] + v * t[2], t[3] + u * t[4] + v * t[5],
           present ? row[i] * header.scale + header.offset : std::numeric_limits<double>::quiet_NaN()});
    }
  }
  return lattice;
}

}  // namespace

bool is_geotiff(const InputFile& file) {
  const std::string_view head = file.text().substr(0, 4);
  return head == std::string_view("II*\0", 4) || head == std::string_view("MM\0*", 4) ||
         head == std::string_view("II+\0", 4) || head == std::string_view("MM\0+", 4);
}

FileContents read_geotiff(const InputFile& file) {
  const Raster raster(file, geotiff_plugin());
  const GeomeshRaster& header = raster.header();
  if (header.n_bands < 1) file.fail("the TIFF file holds no band");
  check_place(file, header);
  check_size(file, header);
  const NodeLattice lattice = read_nodes(raster);
  FileContents contents;
  contents.format = "GeoTIFF";
  contents.frame = described_frame(header);
  const double* const t = header.transform;
  const double rotation = std::atan2(t[4], t[1]) * 180 / 3.14159265358979323846;
  const Vec3& first = lattice.nodes[(lattice.n_rows - 1) * lattice.n_columns];
  add_lattice(file, file.path.stem().string(), lattice,
              {{}, 0, 0, 0, {first.x, first.y}, {std::hypot(t[1], t[4]), std::hypot(t[2], t[5])}, rotation, true},
              contents);
  contents.notes.push_back(
      "values of cells: they stand at the cells' centres, so the surface ends half a cell inside the raster");
  if (header.n_bands > 1)
    contents.warnings.push_back("band 1 of " + std::to_string(header.n_bands) + " is taken as height");
  convert_by_frame(file, contents);
  for (const std::string& text : raster.warnings()) contents.warnings.push_back("GDAL says: " + text);
  return contents;
}

}  // namespace geomesh::geomodel
