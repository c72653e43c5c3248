/// Fields of solids that can make their own faces, as Python has them.
#pragma once

#include <functional>
#include <optional>

#include "fieldfab/core/progress.h"
#include "fieldfab/field/field.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::python {

/// As Model::faces and Design::faces are.
using MakeFaces = std::function<std::optional<TriangleMesh>(std::optional<double> thickness, Progress& progress)>;

/// The same Field, which knows how its solid's faces are made; `thickness` of a plate, where a flat solid was made one. The Field
/// itself where `make` is null.
FieldPtr with_faces(FieldPtr field, MakeFaces make, std::optional<double> thickness = std::nullopt);

/// The faces of a Field of with_faces(), where they can be had; nothing for any other Field, also for what is made of such a one.
std::optional<TriangleMesh> faces_of(const Field& field, Progress& progress);

}  // namespace fieldfab::python
