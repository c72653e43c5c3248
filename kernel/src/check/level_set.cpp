#include "level_set.h"

#include "core/module.h"
#include "fieldfab/check/vdb.h"
#include "fieldfab/core/error.h"

namespace fieldfab {

std::unique_ptr<LevelSet> LevelSet::of(const Field& solid, const Box& bounds, double voxel, Progress& progress) {
  return in_part<LevelSetPart>("openvdb", "fieldfab_level_set").of(solid, bounds, voxel, progress);
}

void write_vdb(const Field& solid, const Box& bounds, double voxel, const std::filesystem::path& path,
               Progress& progress) {
  const std::unique_ptr<LevelSet> level_set = LevelSet::of(solid, bounds, voxel, progress);
  if (level_set->empty()) throw Error(ErrorKind::bad_input, "bounds", "there is no surface within the bounds");
  level_set->save(path);
}

}  // namespace fieldfab
