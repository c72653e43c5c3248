// Volumes compared with OpenVDB, on the same data in the same run: writes a table for
// docs/volumes.md to stdout. Times are the best of three.
#include <fmt/format.h>
#include <openvdb/io/File.h>
#include <openvdb/tools/Dense.h>
#include <openvdb/tools/Interpolation.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>
#include <sys/resource.h>

#include <chrono>
#include <cmath>
#include <fstream>
#include <random>

#include "fieldfab/check/check.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/solid/scan_solid.h"
#include "volume/openvdb/float_grid.h"

namespace {

using namespace fieldfab;
namespace tools = openvdb::tools;

template <class Work>
double seconds(const Work& work) {
  double best = 1e9;
  for (int run = 0; run < 3; ++run) {
    const auto started = std::chrono::steady_clock::now();
    work();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - started).count());
  }
  return best;
}

double megabytes(const std::filesystem::path& path) {
  return static_cast<double>(std::filesystem::file_size(path)) / 1e6;
}

/// Writes a raw volume, slice by slice.
template <class Sample, class Density>
void generate(const std::filesystem::path& path, const std::array<int, 3>& size, const Density& density) {
  std::ofstream file(path, std::ios::binary);
  std::vector<Sample> row(static_cast<std::size_t>(size[0]));
  for (int k = 0; k < size[2]; ++k)
    for (int j = 0; j < size[1]; ++j) {
      for (int i = 0; i < size[0]; ++i) row[static_cast<std::size_t>(i)] = static_cast<Sample>(density(i, j, k));
      file.write(reinterpret_cast<const char*>(row.data()), static_cast<std::streamsize>(row.size() * sizeof(Sample)));
    }
}

/// Mean and greatest distance of one function's surface from that of another, voxels. Points of the
/// first are found between points of different sign; around each the second is searched.
template <class Of, class From>
std::pair<double, double> distance(const Box& box, double voxel, const Of& of, const From& from) {
  std::mt19937 random(1);
  const auto uniform = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  double sum = 0, farthest = 0;
  int found = 0;
  for (int tries = 0; found < 20000 && tries < 20'000'000; ++tries) {
    Vec3 low = box.lower + box.size().cwiseProduct(Vec3(uniform(0.02, 0.97), uniform(0.02, 0.97), uniform(0.02, 0.97)));
    Vec3 high = low + uniform(0, voxel) * Vec3::Unit(static_cast<Eigen::Index>(random() % 3));
    const bool inside = of(low) < 0;
    if (inside == (of(high) < 0)) continue;
    for (int i = 0; i < 30; ++i) {
      const Vec3 middle = 0.5 * (low + high);
      ((of(middle) < 0) == inside ? low : high) = middle;
    }
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis)
      slope[axis] = from(low + 0.05 * voxel * Vec3::Unit(axis)) - from(low - 0.05 * voxel * Vec3::Unit(axis));
    // The nearest point of different sign, in steps of a seventh.
    const bool here = from(low) < 0;
    double near = 0.002 * voxel;
    const auto changes = [&](double t) {
      for (const Vec3& way : {slope, Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1)}) {
        const Vec3 step = way.norm() > 0 ? Vec3(t * way.normalized()) : Vec3::Zero();
        if ((from(low + step) < 0) != here || (from(low - step) < 0) != here) return true;
      }
      return false;
    };
    while (near < voxel && !changes(near)) near *= 8.0 / 7;
    ++found;
    sum += near / voxel;
    farthest = std::max(farthest, near / voxel);
  }
  return {sum / std::max(found, 1), farthest};
}

void compare(const std::string& name, const std::filesystem::path& path, const VolumeFileOptions& options,
             double threshold, const std::filesystem::path& folder) {
  const Scan scan{open_volume(path, options), {}};
  const Isosurface surface = isosurface(*scan.volume, threshold);
  const SampleLattice& lattice = scan.volume->lattice();
  const double voxel = lattice.spacing.minCoeff(), raw = 4e-6 * static_cast<double>(lattice.count());
  const auto asdf_file = folder / "figures.asdf", vdb_file = folder / "figures.vdb";
  const double import_seconds = seconds([&] {
    const VolumePtr volume = open_volume(path, options);
    import_scan({volume, isosurface(*volume, threshold)}, asdf_file, {});
  });
  const auto asdf = Asdf::load(asdf_file);
  const FieldPtr truth = volume_field(*scan.volume, surface);
  TriangleMesh mesh;
  const double mesh_seconds = seconds([&] { mesh = contour(*asdf, asdf->region(), {voxel}); });
  const MeshVerdict verdict = inspect(mesh);

  // OpenVDB: the same samples as a dense grid, its mesh, and the mesh's level set.
  std::vector<float> samples(lattice.count());
  scan.volume->read(0, lattice.size[2], samples.data());
  for (float& sample : samples) sample = surface.value(sample);
  openvdb::FloatGrid::Ptr grid, level_set;
  std::vector<openvdb::Vec3s> points;
  std::vector<openvdb::Vec4I> quads;
  std::vector<openvdb::Vec3I> triangles;
  const double theirs_seconds = seconds([&] {
    grid = openvdb::FloatGrid::create(static_cast<float>(10 * voxel));
    const openvdb::CoordBBox all({0, 0, 0}, {lattice.size[0] - 1, lattice.size[1] - 1, lattice.size[2] - 1});
    const tools::Dense<float, tools::LayoutXYZ> dense(all, samples.data());
    tools::copyFromDense(dense, *grid, 0.0F);
    const Box box = lattice.box();
    openvdb::Mat4d to_mm = openvdb::Mat4d::identity();
    to_mm.postScale(openvdb::Vec3d(lattice.spacing.x(), lattice.spacing.y(), lattice.spacing.z()));
    to_mm.postTranslate(openvdb::Vec3d(box.lower.x(), box.lower.y(), box.lower.z()));
    grid->setTransform(openvdb::math::Transform::createLinearTransform(to_mm));
    points.clear(), quads.clear(), triangles.clear();
  });
  const double theirs_mesh_seconds = seconds([&] {
    points.clear(), quads.clear(), triangles.clear();
    tools::volumeToMesh(*grid, points, triangles, quads, 0.0, 0.0);
  });
  TriangleMesh theirs;
  for (const auto& p : points) theirs.vertices.push_back({p.x(), p.y(), p.z()});
  for (const auto& q : quads)
    theirs.triangles.push_back({q[2], q[1], q[0]}), theirs.triangles.push_back({q[3], q[2], q[0]});
  const MeshVerdict their_verdict = inspect(theirs);
  const auto transform = openvdb::math::Transform::createLinearTransform(voxel);
  level_set = tools::meshToLevelSet<openvdb::FloatGrid>(*transform, points, triangles, quads, 3.0F);
  openvdb::io::File file(vdb_file.string());
  file.write({level_set});
  file.close();

  const auto of_field = [](const Field& field) { return [&field](const Vec3& p) { return double{field.value(p)}; }; };
  const tools::GridSampler<openvdb::FloatGrid, tools::BoxSampler> sampler(*level_set);
  const auto of_level_set = [&](const Vec3& p) {
    return double{sampler.wsSample(openvdb::Vec3d(p.x(), p.y(), p.z()))};
  };
  const Box box = lattice.box();
  const auto there = distance(box, voxel, of_field(*asdf), of_field(*truth)),
             back = distance(box, voxel, of_field(*truth), of_field(*asdf));
  const auto vdb_there = distance(box, voxel, of_level_set, of_field(*truth)),
             vdb_back = distance(box, voxel, of_field(*truth), of_level_set);
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  fmt::print(
      "| {} | {} x {} x {} | {:.1f} | {:.2f} ({:.0f}x) | {:.1f} | {:.4f} / {:.3f}, {:.4f} / {:.3f} | {:.4f} / {:.3f}, "
      "{:.4f} / "
      "{:.3f} |\n",
      name, lattice.size[0], lattice.size[1], lattice.size[2], raw, megabytes(asdf_file), raw / megabytes(asdf_file),
      megabytes(vdb_file), there.first, there.second, back.first, back.second, vdb_there.first, vdb_there.second,
      vdb_back.first, vdb_back.second);
  fmt::print(stderr,
             "{}: import {:.2f} s (OpenVDB's copyFromDense {:.2f} s); mesh {:.2f} s, {} triangles, valid {}, {} "
             "self-intersections; "
             "volumeToMesh {:.2f} s, {} quads, manifold {}, closed {}, {} self-intersections\n",
             name, import_seconds, theirs_seconds, mesh_seconds, mesh.triangles.size(), verdict.valid(),
             verdict.self_intersections, theirs_mesh_seconds, quads.size(), their_verdict.manifold,
             their_verdict.closed, their_verdict.self_intersections);
}

}  // namespace

int main(int count, char** arguments) {
  openvdb::initialize();
  const std::filesystem::path folder = count > 1 ? arguments[1] : ".";
  const bool large = count > 2 && std::string(arguments[2]) == "large";
  std::mt19937 random(1);
  std::normal_distribution<float> noise;
  fmt::print(
      "| volume | samples | raw floats, MB | .asdf, MB | OpenVDB's level set, MB | .asdf to samples and back, voxels "
      "(mean / "
      "most) | "
      "level set to samples and back |\n|---|---|---|---|---|---|---|\n");
  const std::filesystem::path data = TEST_DATA "/ct";
  compare("cthead, bone", data / "cthead", {}, 150, folder);
  compare("cthead, skin", data / "cthead", {}, 60, folder);
  compare("engine", data / "engine.nii.gz", {}, 80, folder);
  const auto lace = folder / "lace_255x255x511_float32.raw";
  generate<float>(lace, {255, 255, 511}, [&](int i, int j, int k) {
    const float x = 0.25F * static_cast<float>(i), y = 0.25F * static_cast<float>(j), z = 0.25F * static_cast<float>(k);
    const float web =
        std::abs(std::sin(x) * std::cos(y) + std::sin(y) * std::cos(z) + std::sin(z) * std::cos(x)) - 0.4F;
    const float sheet = std::abs(32 + 12 * std::sin(0.05F * z) + 6 * std::sin(0.1F * y) - x) - 6;
    return 1000 - 500 * std::max(web, 0.3F * sheet) + 10 * noise(random);
  });
  compare("lace, as large as the thesis's", lace, {}, 1000, folder);
  std::filesystem::remove(lace);
  if (large) {
    const auto scan = folder / "scan_512x512x361_int16.raw";
    const VolumePtr head = open_volume(data / "cthead");
    // flat, so that the cap at the border is thin
    const FieldPtr field = volume_field(*head, {0, false, 1e-4});
    const Box box = head->lattice().box();
    generate<std::int16_t>(scan, {512, 512, 361}, [&](int i, int j, int k) {
      const Vec3 at = box.size().cwiseProduct(Vec3(i / 511.0, j / 511.0, k / 360.0));
      return std::lround(-120000.0F * field->value(at * 0.999999) - 1000 + 12 * noise(random));
    });
    compare("head, 512 x 512 x 361, 16 bits", scan, {}, 800, folder);
    std::filesystem::remove(scan);
  }
  return 0;
}
