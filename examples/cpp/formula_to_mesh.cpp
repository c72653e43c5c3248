// formula_to_mesh TEXT FILE: meshes a solid that is given as .frep text, and tells how large it is.
#include <cstdio>
#include <exception>

#include "fieldfab/mesh/triangle_mesh.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/solid/surface.h"

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: formula_to_mesh TEXT FILE\n", stderr), 2;
  try {
    const fieldfab::Solid solid = fieldfab::united(fieldfab::parse_model(argv[1], "the text", "."));
    const fieldfab::Surface surface = fieldfab::surface(solid, {.voxel = 0.25});
    fieldfab::write_mesh(surface.mesh, argv[2]);
    const fieldfab::Vec3 size = surface.mesh.bounds().size();
    std::printf("%zu triangles, %.2f x %.2f x %.2f mm\n", surface.mesh.triangles.size(), size.x(), size.y(), size.z());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
