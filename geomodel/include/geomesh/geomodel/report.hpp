// SPDX-License-Identifier: GPL-3.0-or-later
/// @file
/// The report: what was understood, done, measured and warned of. JSON by docs/report.schema.json.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "geomesh/core/tetrahedralize.hpp"
#include "geomesh/geomodel/arrangement.hpp"
#include "geomesh/geomodel/model_mesh.hpp"

namespace geomesh::geomodel {

struct StageRecord {
  std::string name;
  double wall_s = 0, cpu_s = 0;     ///< cpu counts all threads
  std::size_t peak_bytes = 0;       ///< peak resident size of the process at the stage's end
};

/// Element quality: histograms and extremes. Angles in degrees; radius ratio 3 r_in / r_circ, 1 for the regular tetrahedron.
struct QualityStatistics {
  std::vector<std::size_t> min_dihedral_histogram;  ///< 18 bins of 10 degrees: smallest dihedral angle per tetrahedron
  std::vector<std::size_t> dihedral_histogram;      ///< 18 bins of 10 degrees: all six angles
  std::vector<std::size_t> radius_ratio_histogram;  ///< 20 bins of 0.05
  double min_dihedral = 0, max_dihedral = 0, min_radius_ratio = 0;
  struct Worst {
    std::size_t tetrahedron;
    double min_dihedral, max_dihedral, radius_ratio;
    Vec3 place;
    std::int32_t region;
    std::string cause;
  };
  std::vector<Worst> worst;  ///< at most ten, worst first
};
QualityStatistics measure_quality(const ModelMesh& mesh);

/// Everything a report may hold; what a command did not do stays empty and is left out.
struct Report {
  std::string command;  ///< "project", "mesh", "delaunay", "check", "info"
  std::string name;
  std::vector<StageRecord> stages;
  std::string input_json;  ///< the input as understood, a JSON object in text ("" if none)
  const ConstrainedTetrahedralization* core = nullptr;
  const ArrangementResult* arrangement = nullptr;
  const ModelMesh* mesh = nullptr;
  std::vector<std::string> surface_names;  ///< input surfaces, then box sides, for areas and spots; empty: those of `mesh`
  std::optional<QualityStatistics> quality;
  std::vector<std::string> notes;  ///< what rules of the model changed, with areas
  std::vector<std::string> warnings;
  std::vector<std::string> files;  ///< written, relative to the report
};
std::string to_json(const Report& report);
void write_report(const Report& report, const std::filesystem::path& file);

/// The report as one web page that needs no other file: a turnable picture of the units, sections, tables, histograms, warnings. It holds
/// the stages' times, so it differs from run to run as the JSON does. Size and time linear in the mesh.
std::string to_html(const Report& report);
void write_html_report(const Report& report, const std::filesystem::path& file);

}  // namespace geomesh::geomodel
