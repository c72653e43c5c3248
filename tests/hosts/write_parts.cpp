// Writes three parts to the given files, for hosts/formats_test.py: boxes of 30 by 20 by 10 mm,
// stacked.
#include <cstdio>

#include "fieldfab/core/error.h"
#include "fieldfab/mesh/mesh_parts.h"

namespace {

fieldfab::TriangleMesh box_above(float z) {
  fieldfab::TriangleMesh mesh;
  for (const float top : {0.0F, 10.0F})
    for (const float y : {0.0F, 20.0F})
      for (const float x : {0.0F, 30.0F}) mesh.vertices.push_back({x, y, z + top});
  mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                    {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
  return mesh;
}

}  // namespace

int main(int count, char** arguments) try {
  const fieldfab::MeshPart parts[] = {{box_above(0), "Fuß <unten> & 'so'", fieldfab::colour_named("tomato")},
                                      {box_above(15), "middle", std::nullopt},
                                      {box_above(30), "top", fieldfab::Colour{1, 128, 255}}};
  for (int i = 1; i < count; ++i) fieldfab::write_mesh_parts(parts, arguments[i]);
} catch (const fieldfab::Error& error) {
  std::fprintf(stderr, "%s\n", error.what());
  return 1;
}
