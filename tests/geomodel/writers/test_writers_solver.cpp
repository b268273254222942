// SPDX-License-Identifier: GPL-3.0-or-later
// A solver uses what we write: CalculiX on a box of three layers.
#include <catch2/catch.hpp>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "geomesh/geomodel/formats.hpp"
#include "hand_made.hpp"
#include "installed.hpp"
#include "test_places.hpp"

using namespace geomesh;
using namespace geomesh::geomodel;
using namespace geomesh::geomodel::testing;
namespace fs = std::filesystem;

namespace {

/// Name in the file of the group of one type with this full name.
std::string name_in_file(const nlohmann::json& sidecar, const std::string& type, const std::string& full_name) {
  for (const auto& g : sidecar["groups"])
    if (g["type"] == type && g["full_name"] == full_name) return g["name"];
  FAIL("no group " << full_name);
  return "";
}

/// Numbers of the lines of a .dat file below the first line that holds `title`, up to the next text.
std::vector<std::vector<double>> table_below(const fs::path& file, const std::string& title) {
  std::ifstream in(file);
  std::string line;
  while (std::getline(in, line) && line.find(title) == std::string::npos) {
  }
  std::vector<std::vector<double>> rows;
  while (std::getline(in, line)) {
    std::istringstream words(line);
    std::vector<double> row;
    double value;
    while (words >> value) row.push_back(value);
    if (!row.empty()) rows.push_back(row);
    if (row.empty() && !rows.empty()) break;
  }
  return rows;
}

}  // namespace

TEST_CASE("CalculiX conducts heat through three layers of a written box as the analytic solution says", "[writers]") {
  if (exit_code_of("command -v ccx > /dev/null 2>&1") != 0) {
    WARN("skipped: calculix-ccx is not installed");
    return;
  }
  const fs::path folder = fs::path(GEOMESH_BINARY_DIR) / "test-output" / "ccx";
  fs::remove_all(folder);
  fs::create_directories(folder);
  const ModelMesh mesh = three_layer_mesh(4);  // 4 x 4 x 3, layers one unit thick
  write_format(mesh, "inp", folder / "model");
  std::ifstream in(folder / "model.inp.json");
  const nlohmann::json sidecar = nlohmann::json::parse(in);

  const double conductivity[] = {1, 2, 4};  // top, middle, bottom
  const double hot = 100, area = 16;
  std::ofstream deck(folder / "heat.inp");
  deck << "*INCLUDE, INPUT=model.inp\n";
  for (std::size_t r = 0; r < 3; ++r)
    deck << "*MATERIAL, NAME=m" << r << "\n*CONDUCTIVITY\n"
         << conductivity[r] << "\n*SOLID SECTION, MATERIAL=m" << r
         << ", ELSET=" << name_in_file(sidecar, "elset", mesh.regions[r].name) << "\n";
  deck << "*STEP\n*HEAT TRANSFER, STEADY STATE\n*BOUNDARY\n"
       << name_in_file(sidecar, "nset", "zmin") << ", 11, 11, " << hot << "\n"
       << name_in_file(sidecar, "nset", "zmax") << ", 11, 11, 0\n";
  for (const char* horizon : {"upper", "lower"})
    deck << "*NODE PRINT, NSET=" << name_in_file(sidecar, "nset", horizon) << "\nNT\n";
  deck << "*SECTION PRINT, SURFACE=" << name_in_file(sidecar, "surface", "zmin.faces")
       << ", NAME=bottom_flux\nFLUX\n*END STEP\n";
  deck.close();
  const std::string command = "cd '" + folder.string() + "' && timeout 100 ccx heat > ccx.log 2>&1";
  REQUIRE(exit_code_of(command) == 0);

  const double flux = hot / (1 / conductivity[0] + 1 / conductivity[1] + 1 / conductivity[2]);
  const std::pair<const char*, double> expected[] = {{"UPPER", flux / conductivity[0]},
                                                     {"LOWER", flux / conductivity[0] + flux / conductivity[1]}};
  for (const auto& [set, temperature] : expected) {
    const auto rows = table_below(folder / "heat.dat", std::string("temperatures for set ") + set);
    CHECK(rows.size() == 25);
    for (const auto& row : rows) CHECK(row.at(1) == Approx(temperature).epsilon(1e-5));
  }
  // The integration points that CalculiX places on the sides of elements lie on zmin, and the heat through them adds
  // up.
  const auto points = table_below(folder / "heat.dat", "heat flux at the integration points");
  CHECK(points.size() == 32);
  for (const auto& row : points) CHECK(row.at(6) == 0);
  const auto total = table_below(folder / "heat.dat", "total surface flux");
  REQUIRE(!total.empty());
  CHECK(total.front().at(0) == Approx(-flux * area).epsilon(1e-5));
}
