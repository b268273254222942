// SPDX-License-Identifier: GPL-3.0-or-later
#include "arrange_target.hpp"

#include <algorithm>
#include <stdexcept>
#include <string>

#include "corpus_judge.hpp"
#include "geomesh/core/error.hpp"
#include "soup_models.hpp"

namespace fuzz_bytes {
namespace {

using namespace geomesh;
using namespace geomesh::geomodel;

constexpr std::size_t bytes_of_head = 1, bytes_of_triangle = 9, most_triangles = 12;

struct Model {
  std::vector<TriangulatedSurface> surfaces;
  ArrangementOptions options;
  TetrahedralizeOptions tetrahedralize;
};

/// The first byte: the grid's values a side, whether the box cuts, whether the boundary is kept. Then nine a triangle.
Model model_of(const std::uint8_t* data, std::size_t size) {
  const unsigned side = 2 + data[0] % 7u;
  const bool is_cut = (data[0] & 64u) != 0;
  Model model;
  model.surfaces.resize(2);
  model.surfaces[0].name = "first";
  model.surfaces[1].name = "second";
  const std::size_t n = std::min((size - bytes_of_head) / bytes_of_triangle, most_triangles);
  for (std::size_t t = 0; t < n; ++t) {
    const std::uint8_t* at = data + bytes_of_head + t * bytes_of_triangle;
    TriangulatedSurface& surface = model.surfaces[t % 2];
    const auto first = static_cast<VertexIndex>(surface.points.size());
    for (std::size_t corner = 0; corner < 3; ++corner, at += 3)
      surface.points.push_back({static_cast<double>(at[0] % (side + 1)), static_cast<double>(at[1] % (side + 1)),
                                static_cast<double>(at[2] % (side + 1))});
    surface.triangles.push_back({first, first + 1, first + 2});
  }
  const double low = is_cut ? 0.5 : -1, high = side + (is_cut ? -0.25 : 1.0);
  model.options.box = Box3{{low, low, low}, {high, high, high}};
  model.tetrahedralize.recover.preserve_boundary = data[0] >= 128;
  return model;
}

}  // namespace

void arrange_and_recover(const std::uint8_t* data, std::size_t size) {
  if (size < bytes_of_head) return;
  const Model model = model_of(data, size);
  RunContext context;
  context.threads = 1;
  const PolygonSoup soup = arrange(model.surfaces, {}, {}, model.options, context).soup;
  if (const auto faults = validate_soup(soup); !faults.empty())
    throw std::logic_error("the arrangement is wrong: " + faults.front().what);
  const PiecewiseLinearComplex plc = testing::complex_of(soup);
  try {
    const auto mesh = tetrahedralize(plc, model.tetrahedralize, context);
    if (const auto faults = test::check_tetrahedralization(plc, model.tetrahedralize, mesh); !faults.empty())
      throw std::logic_error("the mesh is wrong: " + faults.front());
  } catch (const Error& error) {
    throw std::logic_error(std::string("a valid complex is refused: ") + error.what());
  }
}

}  // namespace fuzz_bytes
