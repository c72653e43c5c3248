/// Fits a patch of a mesh to a sharp edge or corner.
#pragma once

#include <map>
#include <vector>

#include "fieldfab/field/field.h"
#include "mesh_editor.h"
#include "surface_feature.h"

namespace fieldfab::contouring {

/// A point of the mesh that is off the surface: a vertex, the middle of an edge, or the middle of a
/// triangle.
struct Flaw {
  std::array<std::uint32_t, 3> vertices;
  int count;    ///< number of vertices: 1, 2 or 3
  float error;  ///< mm
  Cell cell;    ///< in which it lies
};

/// The mesh that is sharpened, and what is known about its vertices.
struct Draft {
  const Field& solid;
  const float voxel, tolerance;  ///< mm
  TriangleMesh& mesh;
  MeshEditor& editor;
  /// Smooth surfaces near a crease wait until it is done.
  bool features_only = true;
  /// By vertex: whether it was moved since flaws were looked for.
  std::vector<char> moved;

  [[nodiscard]] Eigen::Vector3f at(std::uint32_t vertex) const { return Eigen::Vector3f(mesh.vertices[vertex].data()); }
  [[nodiscard]] Eigen::Vector3f middle(const Flaw& flaw) const;
};

/// The solid around the flaws of a region, restricted to it, and to blocks of its cells as they are needed.
struct Surroundings {
  struct Block {
    Box box;
    FieldPtr field;  ///< the solid in the box
  };
  Box box;
  FieldPtr field;  ///< the solid in the box
  std::map<Cell, Block> blocks;
  std::size_t counted = 0;  ///< cost that counts as kept

  /// Returns the cost of all Fields.
  [[nodiscard]] std::size_t cost() const;
};

/// Mends flaws of one region, one after the other. Others may mend flaws of other regions at the
/// same time.
class Mender {
 public:
  Mender(Draft& draft, MeshEditor::Region& region, Surroundings& surroundings)
      : draft_(draft), region_(region), surroundings_(surroundings) {}

  /// Moves a vertex, flips an edge, or divides an edge or a triangle, if that brings the mesh closer
  /// to the surface. Returns whether that was tried: false if the flaw was mended with another.
  bool mend(const Flaw& flaw);

  /// Numbers of the triangles that were made.
  std::vector<std::uint32_t> made;

 private:
  /// Distance of triangles from the surface.
  struct Misfit {
    float farthest = 0;  ///< mm
    float squares = 0;   ///< squared distance, summed over area
    [[nodiscard]] bool closer_than(const Misfit& other) const { return squares <= 0.8F * other.squares; }
  };
  /// A patch to be replaced by a fan around one vertex.
  struct Star {
    std::uint32_t vertex;
    std::vector<std::uint32_t> old;  ///< triangles of the patch
    /// Edges around the patch, each in the direction of the triangle inside.
    std::vector<std::array<std::uint32_t, 2>> rim;
    MeshEditor::Displaced displaced;
  };
  /// The two triangles at an edge.
  struct Diamond {
    std::array<std::uint32_t, 2> sides;
    std::uint32_t from, to;    ///< the edge, in the direction of the first triangle
    std::uint32_t one, other;  ///< the opposite vertices
  };

  const Surroundings::Block& block_of(const Cell& cell);
  void confine(const Flaw& flaw, float reach);
  void move(const Flaw& flaw);
  bool flip(const Diamond& diamond, Misfit& before);
  void divide(const Flaw& flaw, Star star, const Misfit& before);
  bool place(const Star& star, const Flaw& flaw, const Misfit& before);
  bool place_on(const Star& star, PlacedVertex target, float reach, const Misfit& before);
  bool span(Star star, Misfit before);
  [[nodiscard]] bool is_near_another(const Star& star) const;
  bool grow(Star& star, std::size_t edge);
  bool find_diamond(const Flaw& edge, Diamond& diamond) const;
  [[nodiscard]] std::uint32_t opposite(std::uint32_t triangle, std::uint32_t a, std::uint32_t b) const;
  [[nodiscard]] std::vector<Triangle> triangles(std::span<const std::uint32_t> numbers) const;
  void measure(std::span<const Triangle> triangles);
  [[nodiscard]] Misfit misfit(std::span<const Triangle> measured, std::size_t first, std::size_t count) const;
  Misfit misfit(std::span<const Triangle> triangles);
  float error_at(const Eigen::Vector3f& point);
  [[nodiscard]] bool faces_out(std::size_t i, const Triangle& triangle) const;

  Draft& draft_;
  MeshEditor::Region& region_;
  Surroundings& surroundings_;
  Box local_box_;
  FieldPtr local_;   ///< the solid inside `local_box_`, the surroundings of the current flaw
  Samples scratch_;  ///< of the last measure()
  FeatureSearch search_;
};

}  // namespace fieldfab::contouring
