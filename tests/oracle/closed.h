/// Requirements on closed meshes.
#pragma once

#include <gtest/gtest.h>

#include <map>

#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab {

/// Each edge of a closed mesh belongs to two triangles, once in each direction.
inline void expect_closed(const TriangleMesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& t : mesh.triangles)
    for (std::size_t i = 0; i < 3; ++i) ++edges[{t[i], t[(i + 1) % 3]}];
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1);
    ASSERT_TRUE(edges.contains({edge.second, edge.first}));
  }
}

}  // namespace fieldfab
