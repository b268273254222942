// SPDX-License-Identifier: GPL-3.0-or-later
// geomesh-picture: draws a mesh into a PNG file. It is a separate program because VTK ends the process if there is no
// display; `geomesh picture` calls it, with a virtual display if there is none.
#include <vtkObject.h>

#include <cstdio>
#include <exception>

#include "mesh_parts.hpp"
#include "picture_options.hpp"
#include "scene.hpp"

#if defined(__SANITIZE_ADDRESS__)
/// Display drivers are not unloaded with the sanitizer: the memory that they keep would look leaked.
extern "C" int dlclose(void*) { return 0; }
#endif

int main(int argc, char** argv) {
  using namespace geomesh::picture;
  PictureOptions options = parse_picture_options(argc, argv);
  try {
    const MeshFile mesh = read_mesh_file(options.mesh);
    if (options.scale_z == 0) {
      options.scale_z = fitting_scale(mesh);
      if (options.scale_z != 1)
        std::printf("heights are drawn %s times (--scale-z 1 draws them as they are)\n",
                    scale_words(options.scale_z).c_str());
    }
    write_picture(*make_scene(mesh, options), options);
    return 0;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "error: %s\n", error.what());
    return 3;
  }
}
