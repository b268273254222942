// SPDX-License-Identifier: GPL-3.0-or-later
#include "aim_camera.hpp"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkMatrix4x4.h>

#include <algorithm>
#include <cmath>

namespace geomesh::picture {
namespace {

constexpr double pi = 3.14159265358979323846;

/// Returns the least and greatest x and y of all actors' boxes in the picture, whose coordinates reach from -1 to 1.
std::array<double, 4> seen_bounds(vtkRenderer& scene, vtkCamera& camera, double aspect) {
  std::array<double, 4> seen{1e300, -1e300, 1e300, -1e300};
  vtkMatrix4x4* const matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1);
  vtkActorCollection* const actors = scene.GetActors();
  actors->InitTraversal();
  while (vtkActor* const actor = actors->GetNextActor()) {
    const double* const b = actor->GetBounds();
    for (unsigned corner = 0; corner < 8; ++corner) {
      std::array<double, 4> p{b[corner & 1u], b[2 + (corner >> 1 & 1u)], b[4 + (corner >> 2)], 1};
      matrix->MultiplyPoint(p.data(), p.data());
      for (std::size_t k = 0; k < 2; ++k) {
        seen[2 * k] = std::min(seen[2 * k], p[k] / p[3]);
        seen[2 * k + 1] = std::max(seen[2 * k + 1], p[k] / p[3]);
      }
    }
  }
  return seen;
}

void fill_picture(vtkRenderer& scene, const PictureOptions& options, double legend_share) {
  vtkCamera& camera = *scene.GetActiveCamera();
  const double bottom = options.view == View::quality && options.legend ? -0.72 : -0.95, top = 0.95,
               left = -0.95 + 2 * legend_share, right = 0.95;
  const std::array<double, 4> seen = seen_bounds(scene, camera, static_cast<double>(options.width) / options.height);
  const double zoom =
      std::min((right - left) / (seen[1] - seen[0]), (top - bottom) / (seen[3] - seen[2])) * options.zoom;
  const double half_angle = camera.GetViewAngle() * pi / 360;
  camera.SetViewAngle(std::atan(std::tan(half_angle) / zoom) * 360 / pi);
  camera.SetWindowCenter(0.5 * zoom * (seen[0] + seen[1]) - 0.5 * (left + right),
                         0.5 * zoom * (seen[2] + seen[3]) - 0.5 * (bottom + top));
}

}  // namespace

std::array<double, 2> towards_camera(const PictureOptions& options) {
  const double a = options.azimuth * pi / 180;
  return {std::sin(a), std::cos(a)};
}

void aim_camera(vtkRenderer& scene, const PictureOptions& options, double legend_share) {
  const auto [tx, ty] = towards_camera(options);
  const double e = options.elevation * pi / 180;
  vtkCamera* const camera = scene.GetActiveCamera();
  camera->SetFocalPoint(0, 0, 0);
  camera->SetPosition(tx * std::cos(e), ty * std::cos(e), std::sin(e));
  camera->SetViewUp(0, 0, 1);
  camera->SetViewAngle(25);
  scene.ResetCamera();
  fill_picture(scene, options, legend_share);
  scene.ResetCameraClippingRange();
}

}  // namespace geomesh::picture
