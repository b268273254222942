// SPDX-License-Identifier: GPL-3.0-or-later
// Writes input of TOUGH2, TOUGH3 and iTOUGH2: NAME.tough, the blocks ELEME and CONNE of a MESH file for the Voronoi
// dual. Fixed columns: names of elements have 5 characters, numbers 10. Source: TOUGH2 User's Guide, LBNL-43134,
// Appendix E.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <cstdio>

#include "formats/format_list.hpp"
#include "geomesh/core/error.hpp"
#include "solver_mesh/sidecar.hpp"
#include "voronoi/control_volumes.hpp"
#include "writers/text_file.hpp"
#include "writers/written_files.hpp"

namespace geomesh::geomodel {

namespace {

/// Characters of TOUGH element names, which consist of three letters or digits and a two-digit number.
constexpr const char* letters = "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789";
constexpr std::size_t n_first = 26, n_letters = 36, most_elements = n_first * n_letters * n_letters * 100;

std::string element_name(std::size_t i) {
  const std::size_t number = i % 100, rest = i / 100;
  std::string name;
  name += letters[rest / (n_letters * n_letters)];
  name += letters[rest / n_letters % n_letters];
  name += letters[rest % n_letters];
  name += static_cast<char>('0' + number / 10);
  name += static_cast<char>('0' + number % 10);
  return name;
}

/// Returns the five-character name of a region as a TOUGH rock: R and the region's number.
std::string rock_name(std::int32_t region) {
  char text[16];
  std::snprintf(text, sizeof text, "R%04d", static_cast<int>(region));
  return text;
}

/// A number or text in a TOUGH column of ten characters. A number has as many digits as fit; a long text is cut.
class Ten {
 public:
  explicit Ten(double value) {
    std::fill_n(text_, columns, ' ');
    // With nine digits, a negative sign or a leading "0." makes a number too long for a TOUGH field of ten characters,
    // so fewer digits are tried first.
    for (int digits = 9 - (std::signbit(value) ? 1 : 0) - (std::abs(value) < 1 ? 1 : 0); digits > 0;) {
      char buffer[32];
      char* const end = std::to_chars(buffer, buffer + sizeof buffer, value, std::chars_format::general, digits).ptr;
      const auto size = static_cast<std::size_t>(end - buffer);
      if (size <= columns) {
        std::replace_copy(buffer, end, text_ + columns - size, 'e', 'E');
        return;
      }
      digits -= static_cast<int>(size - columns);
    }
    text_[columns - 1] = '0';
  }
  operator std::string_view() const { return {text_, columns}; }

 private:
  static constexpr std::size_t columns = 10;
  char text_[columns];
};

void write_mesh(OutputText& out, const ModelMesh& mesh, const ControlVolumes& grid) {
  out << "ELEME----1----*----2----*----3----*----4----*----5----*----6----*----7----*----8\n";
  for (std::size_t v = 0; v < mesh.points.size(); ++v) {
    const Vec3& p = mesh.points[v];
    out << element_name(v) << "          " << rock_name(grid.region[v]) << Ten(grid.volume[v]) << "                    "
        << Ten(p.x) << Ten(p.y) << Ten(p.z) << "\n";
  }
  out << "\nCONNE----1----*----2----*----3----*----4----*----5----*----6----*----7----*----8\n";
  for (const auto& c : grid.connections) {
    const Vec3 along = mesh.points[c.b] - mesh.points[c.a];
    const double length = std::sqrt(dot(along, along));
    // TOUGH: every connection has direction 1; its last number is the cosine between gravity and the line from its
    // first element to its second.
    const Ten half(length / 2);
    out << element_name(c.a) << element_name(c.b) << "                   1" << half << half << Ten(c.area)
        << Ten(-along.z / length) << "\n";
  }
  out << "\n";
}

std::vector<std::filesystem::path> write_tough(const ModelMesh& mesh, const WriteOptions&,
                                               const std::filesystem::path& stem) {
  if (mesh.points.size() > most_elements)
    throw Error(ErrorKind::cannot_mesh, "TOUGH can distinguish at most " + std::to_string(most_elements) +
                                            " elements apart by their names; the mesh has " +
                                            std::to_string(mesh.points.size()) + " points");
  if (mesh.regions.size() > 9999)
    throw Error(ErrorKind::cannot_mesh, "names of rocks have 5 characters here: at most 9999 regions");
  const ControlVolumes grid = control_volumes(mesh);
  const std::filesystem::path file = stem.string() + ".tough";
  WrittenFiles written;
  write_output_text(file, [&](OutputText& out) { write_mesh(out, mesh, grid); });
  written.add(file);
  std::vector<SidecarGroup> sidecar;
  for (const Region& region : mesh.regions)
    sidecar.push_back({"rock", 3, region.id, rock_name(region.id), region.name, {region.id}});
  written.add(write_sidecar(mesh, sidecar, file, {{"negative_areas", grid.n_negative_areas}}));
  return written.keep();
}

}  // namespace

Format tough_format() {
  return {"tough", {".tough"}, "TOUGH2 and TOUGH3 (Voronoi)", {.names = false}, write_tough, nullptr};
}

}  // namespace geomesh::geomodel
