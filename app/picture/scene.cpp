// SPDX-License-Identifier: GPL-3.0-or-later
#include "scene.hpp"

#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkImageResize.h>
#include <vtkLightKit.h>
#include <vtkLookupTable.h>
#include <vtkOutlineSource.h>
#include <vtkPNGWriter.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty.h>
#include <vtkProperty2D.h>
#include <vtkRenderWindow.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkWindowToImageFilter.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <set>
#include <stdexcept>

#include "aim_camera.hpp"
#include "geomesh/geomodel/palette.hpp"

namespace geomesh::picture {
namespace {

constexpr int oversampling = 2;
constexpr std::size_t most_names = 12;  ///< in the legend

using geomodel::Colour;
using geomodel::Palette;

class SceneBuilder {
 public:
  SceneBuilder(const MeshFile& mesh, const PictureOptions& options) : mesh_(mesh), options_(options) {
    mesh_.cells->GetBounds(bounds_.data());
    scene_->SetBackground(1, 1, 1);
  }

  vtkSmartPointer<vtkRenderer> build() {
    switch (options_.view) {
      case View::regions:
        add_regions([](vtkIdType) { return true; });
        break;
      case View::cut:
        add_cut();
        break;
      case View::elements:
        add_regions(behind_the_cut());
        break;
      case View::exploded:
        add_exploded();
        break;
      case View::surfaces:
        add_surfaces();
        break;
      case View::quality:
        add_quality();
        break;
    }
    if (options_.legend && options_.view != View::quality) add_legend();
    if (options_.scale_z != 1) add_scale_words();
    auto lights = vtkSmartPointer<vtkLightKit>::New();
    lights->SetKeyLightWarmth(0.5);
    lights->SetFillLightWarmth(0.5);
    lights->SetKeyToFillRatio(2.5);
    lights->SetKeyLightIntensity(0.75);
    lights->AddLightsToRenderer(scene_);
    aim_camera(*scene_, options_, legend_share_);
    return scene_;
  }

 private:
  using Wanted = std::function<bool(vtkIdType)>;

  std::array<double, 2> side() const {
    const auto [tx, ty] = towards_camera(options_);
    return {tx < 0 ? -1.0 : 1.0, ty < 0 ? -1.0 : 1.0};
  }
  std::array<double, 2> middle() const { return {0.5 * (bounds_[0] + bounds_[1]), 0.5 * (bounds_[2] + bounds_[3])}; }

  /// Adds the model without the quarter nearest to the camera as two blocks: the half behind the first wall, and the
  /// quarter beside the one that is removed.
  void add_cut() {
    auto table = colours_of(ids_in(mesh_.region_of_cell), mesh_.region_names, units());
    const auto [sx, sy] = side();
    const auto whole = with_region_values(mesh_);
    const auto front = beyond(whole, {middle(), {sx, 0}});
    for (const auto& block : {beyond(whole, {middle(), {-sx, 0}}), beyond(front, {middle(), {0, -sy}})})
      add(outside_of(block), table, low_, high_);
  }

  /// Returns a function that decides whether a tetrahedron is kept: all but the quarter on the camera's side are.
  Wanted behind_the_cut() const {
    const auto [cx, cy] = middle();
    const auto [sx, sy] = side();
    return [this, cx = cx, cy = cy, sx = sx, sy = sy](vtkIdType c) {
      std::array<double, 3> centre{};
      centre_of(mesh_, c, centre.data());
      return (centre[0] - cx) * sx < 0 || (centre[1] - cy) * sy < 0;
    };
  }

  std::set<int> ids_in(const std::vector<int>& ids) const { return {ids.begin(), ids.end()}; }

  vtkSmartPointer<vtkActor> add(vtkPolyData* data, vtkLookupTable* colours, double low, double high) {
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputData(data);
    mapper->SetLookupTable(colours);
    mapper->SetScalarRange(low, high);
    mapper->SetScalarModeToUseCellData();
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->SetScale(1, 1, options_.scale_z);
    actor->GetProperty()->SetInterpolationToFlat();
    actor->GetProperty()->SetAmbient(0.15);
    actor->GetProperty()->SetSpecular(0);
    if (options_.edges) {
      actor->GetProperty()->EdgeVisibilityOn();
      actor->GetProperty()->SetEdgeColor(0.25, 0.25, 0.28);
      actor->GetProperty()->SetLineWidth(1.1f);
    }
    scene_->AddActor(actor);
    return actor;
  }

  /// Returns one colour per name, in the order of the ids, as on the page; the parts of a unit (`sand__1`, `sand__2`)
  /// have shades of one colour. Fills the legend's entries.
  vtkSmartPointer<vtkLookupTable> colours_of(const std::set<int>& ids, const std::map<int, std::string>& names,
                                             Palette palette) {
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    low_ = *ids.begin();
    high_ = std::max(*ids.rbegin(), low_ + 1);
    table->SetNumberOfTableValues(high_ - low_ + 1);
    for (int row = 0; row <= high_ - low_; ++row) table->SetTableValue(row, 0.6, 0.6, 0.6);  // all opaque
    for (const int id : ids) {
      const auto known = names.find(id);
      const std::string name = known == names.end() ? std::to_string(id) : known->second;
      const std::string unit = geomodel::unit_of_part(name);
      const Colour c = palette.colour_of(name);
      const bool is_listed =
          std::any_of(entries_.begin(), entries_.end(), [&](const Entry& e) { return e.name == unit; });
      if (!is_listed) entries_.push_back({unit, c});
      table->SetTableValue(id - low_, c[0], c[1], c[2]);
    }
    return table;
  }
  Palette units() const { return Palette(Palette::Of::units, mesh_.colours); }
  Palette surfaces() const { return Palette(Palette::Of::surfaces, mesh_.colours); }

  double region(vtkIdType c) const { return mesh_.region_of_cell[static_cast<std::size_t>(c)]; }

  void add_regions(const Wanted& wanted) {
    auto table = colours_of(ids_in(mesh_.region_of_cell), mesh_.region_names, units());
    add(outside_of(mesh_, wanted, [this](vtkIdType c) { return region(c); }), table, low_, high_);
  }

  std::map<int, std::string> units_of_regions(const std::set<int>& ids) const {
    std::map<int, std::string> units;
    for (const int id : ids) {
      const auto name = mesh_.region_names.find(id);
      units[id] = name == mesh_.region_names.end() ? std::to_string(id) : geomodel::unit_of_part(name->second);
    }
    return units;
  }

  /// Moves units apart from the highest to the lowest, each by a share of the model's height above the next; the parts
  /// of one unit stay together.
  void add_exploded() {
    const std::set<int> ids = ids_in(mesh_.region_of_cell);
    auto table = colours_of(ids, mesh_.region_names, units());
    const std::map<int, std::string> unit_of = units_of_regions(ids);
    std::map<std::string, std::pair<double, std::size_t>> heights;
    for (vtkIdType c = 0; c < mesh_.cells->GetNumberOfCells(); ++c) {
      std::array<double, 3> centre{};
      centre_of(mesh_, c, centre.data());
      auto& [sum, n] = heights[unit_of.at(static_cast<int>(region(c)))];
      sum += centre[2];
      ++n;
    }
    std::vector<std::pair<double, std::string>> order;
    for (const auto& [unit, sum] : heights) order.emplace_back(sum.first / static_cast<double>(sum.second), unit);
    std::sort(order.begin(), order.end());
    const double step = 0.35 * std::max(bounds_[5] - bounds_[4], 0.3 * (bounds_[1] - bounds_[0]) / options_.scale_z);
    for (const auto& [id, unit] : unit_of) {
      const auto row =
          std::find_if(order.begin(), order.end(), [&, name = unit](const auto& o) { return o.second == name; });
      auto actor = add(
          outside_of(
              mesh_, [&, id = id](vtkIdType c) { return region(c) == id; }, [this](vtkIdType c) { return region(c); }),
          table, low_, high_);
      actor->SetPosition(0, 0, static_cast<double>(row - order.begin()) * step * options_.scale_z);
    }
  }

  void add_surfaces() {
    auto data = inner_surfaces(mesh_);
    if (!data)
      throw std::runtime_error(
          "there are no surfaces but the sides of the box to show (NAME.faces.vtp is read beside "
          "the mesh)");
    std::set<int> ids;
    auto* const values = data->GetCellData()->GetScalars();
    for (vtkIdType i = 0; i < values->GetNumberOfTuples(); ++i) ids.insert(static_cast<int>(values->GetTuple1(i)));
    auto table = colours_of(ids, mesh_.surface_names, surfaces());
    add(data, table, low_, high_);
    auto outline = vtkSmartPointer<vtkOutlineSource>::New();
    outline->SetBounds(bounds_.data());
    auto mapper = vtkSmartPointer<vtkPolyDataMapper>::New();
    mapper->SetInputConnection(outline->GetOutputPort());
    auto actor = vtkSmartPointer<vtkActor>::New();
    actor->SetMapper(mapper);
    actor->SetScale(1, 1, options_.scale_z);
    actor->GetProperty()->SetColor(0.35, 0.35, 0.35);
    actor->GetProperty()->LightingOff();
    scene_->AddActor(actor);
  }

  void add_quality() {
    auto table = vtkSmartPointer<vtkLookupTable>::New();
    const auto& steps = geomodel::angle_colours;
    table->SetNumberOfTableValues(static_cast<vtkIdType>(steps.size()));
    for (std::size_t i = 0; i < steps.size(); ++i)
      table->SetTableValue(static_cast<vtkIdType>(i), steps[i][0], steps[i][1], steps[i][2]);
    table->SetTableRange(0, geomodel::best_angle);
    add(outside_of(mesh_, behind_the_cut(), [this](vtkIdType c) { return smallest_dihedral(mesh_, c); }), table, 0,
        geomodel::best_angle);
    if (!options_.legend) return;
    auto bar = vtkSmartPointer<vtkScalarBarActor>::New();
    bar->SetLookupTable(table);
    bar->SetTitle("smallest dihedral angle (degrees)");
    bar->SetLabelFormat("%.0f");
    bar->SetNumberOfLabels(8);
    bar->SetOrientationToHorizontal();
    bar->SetPosition(0.25, 0.02);
    bar->SetWidth(0.5);
    bar->SetHeight(0.09);
    for (vtkTextProperty* text : {bar->GetTitleTextProperty(), bar->GetLabelTextProperty()}) {
      text->SetColor(0.1, 0.1, 0.1);
      text->ItalicOff();
      text->BoldOff();
      text->ShadowOff();
    }
    scene_->AddActor2D(bar);
  }

  /// Adds the legend: a square of each colour with its name, from the upper left corner of the picture down.
  void add_legend() {
    const std::size_t n = std::min(entries_.size(), most_names);
    const double row = oversampling * 0.035 * options_.height, left = 0.4 * row;
    std::size_t longest = 0;
    for (std::size_t i = 0; i < n; ++i) longest = std::max(longest, entries_[i].name.size());
    constexpr double letter = 0.6;  // width of letters divided by the font size
    legend_share_ = (left + row + letter * 0.72 * row * static_cast<double>(longest)) / (oversampling * options_.width);
    for (std::size_t i = 0; i < n; ++i) {
      const bool rest = i + 1 == n && entries_.size() > n;
      const double bottom = oversampling * options_.height - row * static_cast<double>(i + 1) - left;
      if (!rest) add_square(left, bottom + 0.1 * row, 0.65 * row, entries_[i].colour);
      auto text = vtkSmartPointer<vtkTextActor>::New();
      const std::string more = "and " + std::to_string(entries_.size() - n + 1) + " more";
      text->SetInput((rest ? more : entries_[i].name).c_str());
      text->SetPosition(left + row, bottom);
      text->GetTextProperty()->SetFontSize(static_cast<int>(0.72 * row));
      text->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
      scene_->AddActor2D(text);
    }
  }

  /// Adds the vertical exaggeration at the lower right, so that the picture itself states it.
  void add_scale_words() {
    const double row = oversampling * 0.03 * options_.height;
    auto text = vtkSmartPointer<vtkTextActor>::New();
    text->SetInput(("heights " + scale_words(options_.scale_z) + " times").c_str());
    text->SetPosition(oversampling * options_.width - 0.5 * row, 0.5 * row);
    text->GetTextProperty()->SetJustificationToRight();
    text->GetTextProperty()->SetFontSize(static_cast<int>(0.72 * row));
    text->GetTextProperty()->SetColor(0.1, 0.1, 0.1);
    scene_->AddActor2D(text);
  }

  void add_square(double x, double y, double width, const Colour& colour) {
    auto points = vtkSmartPointer<vtkPoints>::New();
    for (const auto& [i, j] : {std::pair{0, 0}, {1, 0}, {1, 1}, {0, 1}})
      points->InsertNextPoint(x + i * width, y + j * width, 0);
    auto cells = vtkSmartPointer<vtkCellArray>::New();
    cells->InsertNextCell({0, 1, 2, 3});
    auto square = vtkSmartPointer<vtkPolyData>::New();
    square->SetPoints(points);
    square->SetPolys(cells);
    auto mapper = vtkSmartPointer<vtkPolyDataMapper2D>::New();
    mapper->SetInputData(square);
    auto actor = vtkSmartPointer<vtkActor2D>::New();
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour[0], colour[1], colour[2]);
    scene_->AddActor2D(actor);
  }

  const MeshFile& mesh_;
  const PictureOptions& options_;
  vtkSmartPointer<vtkRenderer> scene_ = vtkSmartPointer<vtkRenderer>::New();
  std::array<double, 6> bounds_{};
  int low_ = 0, high_ = 1;
  struct Entry {
    std::string name;
    Colour colour;
  };
  std::vector<Entry> entries_;
  double legend_share_ = 0;  ///< share of the picture's width that the legend takes
};

}  // namespace

std::string scale_words(double scale) {
  std::array<char, 32> text{};
  std::snprintf(text.data(), text.size(), "%g", scale);
  return text.data();
}

double fitting_scale(const MeshFile& mesh) {
  std::array<double, 6> b{};
  mesh.cells->GetBounds(b.data());
  return geomodel::vertical_exaggeration({{b[0], b[2], b[4]}, {b[1], b[3], b[5]}});
}

vtkSmartPointer<vtkRenderer> make_scene(const MeshFile& mesh, const PictureOptions& options) {
  return SceneBuilder(mesh, options).build();
}

void write_picture(vtkRenderer& scene, const PictureOptions& options) {
  auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  window->SetMultiSamples(0);
  window->SetSize(oversampling * options.width, oversampling * options.height);
  window->AddRenderer(&scene);
  window->Render();
  auto grab = vtkSmartPointer<vtkWindowToImageFilter>::New();
  grab->SetInput(window);
  grab->SetInputBufferTypeToRGB();
  grab->ReadFrontBufferOff();
  auto smaller = vtkSmartPointer<vtkImageResize>::New();
  smaller->SetInputConnection(grab->GetOutputPort());
  smaller->SetOutputDimensions(options.width, options.height, 1);
  const std::filesystem::path temporary = options.output.string() + ".part";
  auto writer = vtkSmartPointer<vtkPNGWriter>::New();
  writer->SetCompressionLevel(9);
  writer->SetFileName(temporary.c_str());
  writer->SetInputConnection(smaller->GetOutputPort());
  writer->Write();
  if (writer->GetErrorCode() != 0) throw std::runtime_error(options.output.string() + " could not be written");
  std::filesystem::rename(temporary, options.output);
}

}  // namespace geomesh::picture
