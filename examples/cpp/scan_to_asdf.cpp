// scan_to_asdf SCAN FILE: makes a distance field of a scan, and saves it.
#include <cstdio>
#include <exception>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/solid/open.h"
#include "fieldfab/solid/surface.h"

int main(int argc, char** argv) {
  if (argc != 3) return std::fputs("usage: scan_to_asdf SCAN FILE\n", stderr), 2;
  try {
    const fieldfab::Solid solid = fieldfab::united(fieldfab::open_model(argv[1]));
    const fieldfab::Box region = fieldfab::working_bounds(solid, {});
    const auto asdf = fieldfab::Asdf::build(*solid.field, region, {fieldfab::default_voxel(solid, region), -1, true});
    asdf->save(argv[2]);
    std::printf("%zu cells of %.3f mm\n", asdf->statistics().cells(), asdf->voxel());
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 1;
  }
}
