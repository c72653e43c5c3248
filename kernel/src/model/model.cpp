#include "fieldfab/model/model.h"

#include <fmt/format.h>

#include <algorithm>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/mesh/load_mesh.h"
#include "fieldfab/mesh/mesh_distances.h"
#include "fieldfab/mesh/mesh_field.h"
#include "fieldfab/model/script.h"

namespace fieldfab {
namespace {

constexpr std::uintmax_t most_text = 256'000'000;  // bytes

Model from_expression(frep::Expression expression) {
  Model model;
  model.kind = "f-rep";
  model.field = frep::make_field(frep::simplify(expression));
  model.expression = std::move(expression);
  return model;
}

std::vector<ModelReader>& further_readers() {
  static std::vector<ModelReader> readers;
  return readers;
}

Model from_text(frep::Expression (*parse)(std::string_view, std::string_view), const std::filesystem::path& path) {
  return from_expression(parse(read_file(path, most_text), path.string()));
}

}  // namespace

std::vector<LatticeSource> lattices_of(const Scan& scan, int levels_wanted) {
  std::vector<LatticeSource> levels;
  VolumePtr volume = scan.volume;
  for (int level = 0; level < levels_wanted; ++level) {
    if (level > 0) volume = halved(std::move(volume));
    const SampleLattice& lattice = volume->lattice();
    levels.push_back(
        {lattice.box(), lattice.size, lattice.placement(), [volume, surface = scan.surface](int first, int count, float* out) {
           volume->read(first, count, out);
           const std::size_t samples = static_cast<std::size_t>(count) * volume->lattice().slice();
           for (std::size_t i = 0; i < samples; ++i) out[i] = surface.value(out[i]);
         }});
  }
  return levels;
}

ImportCounts import_scan(const Scan& scan, const std::filesystem::path& path, const ImportSettings& settings,
                         Progress& progress) {
  return import_asdf(lattices_of(scan, settings.file.levels), path, settings, progress);
}

Model model_of(const Scan& scan, Progress& progress) {
  const SampleLattice& lattice = scan.volume->lattice();
  Model model;
  model.kind = "volume";
  model.field = volume_field(*scan.volume, scan.surface, progress);
  model.voxel = lattice.spacing.minCoeff();
  const Eigen::Affine3d placement = lattice.placement();
  model.bounds = image_of(lattice.box(), placement.linear(), placement.translation());
  return model;
}

void add_model_reader(ModelReader reader) { further_readers().push_back(std::move(reader)); }

Model load_model(const std::filesystem::path& path, Scripts scripts, Progress& progress, const ScanOptions& scan,
                 const AsdfPart& part, Roundness roundness) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  if (extension == ".math") return from_text(frep::parse_math, path);
  if (extension == ".vm") return from_text(frep::parse_vm, path);
  if (extension == ".frep") return from_text(frep::parse_infix, path);
  if (extension == ".py") {
    if (scripts == Scripts::refused)
      throw Error(ErrorKind::bad_input, path.string(), "is a script; scripts are run by the fieldfab command only");
    return from_expression(run_script(path, progress));
  }
  if (extension == ".asdf") {
    AsdfPart own = part;  // in the file's coordinates
    if (part.region) {
      const Eigen::Affine3d back = Asdf::look(path).placement.inverse();
      own.region = image_of(*part.region, back.linear(), back.translation());
    }
    const auto asdf = Asdf::load(path, own);
    Model model;
    model.kind = "asdf";
    model.field = asdf->placed();
    model.voxel = asdf->finest();
    model.bounds = image_of(asdf->region(), asdf->placement().linear(), asdf->placement().translation());
    return model;
  }
  if (is_mesh_extension(extension)) {
    MeshFromFile file = load_mesh(path, progress);
    TriangleMesh& mesh = file.mesh;
    Model model;
    model.kind = "mesh";
    model.notes = std::move(file.notes);
    if (const Lids lids = lids_of(mesh); lids.are_good(mesh)) {
      mesh = closed_by(lids, mesh);
      model.notes.push_back(fmt::format("{} is open: {} {} closed by lids of {:.3g} mm2", path.filename().string(), lids.rims,
                                        lids.rims == 1 ? "rim is" : "rims are", lids.area));
    } else if (!lids.triangles.empty()) {
      model.notes.push_back(
          fmt::format("{} is open, and lids cannot close it: what is inside is found by winding numbers, which "
                      "takes long",
                      path.filename().string()));
    }
    model.field = mesh_field(mesh, progress);
    model.bounds = mesh.bounds().grown(mesh.bounds().size().maxCoeff() / 64);
    return model;
  }
  if (is_volume_path(path)) return model_of(open_scan(path, scan, progress), progress);
  std::string further;
  for (const ModelReader& reader : further_readers()) {
    if (std::find(reader.extensions.begin(), reader.extensions.end(), extension) != reader.extensions.end())
      return reader.read(path, roundness, progress);
    for (const std::string& known : reader.extensions) further += known + " ";
  }
  throw Error(ErrorKind::bad_input, path.string(),
              fmt::format("there is no reader for '{}' yet; known are .math .vm .frep .py .asdf .stl .ply .off .obj .3mf {}{}",
                          extension, further, volume_extensions()));
}

Box working_bounds(const Model& model, const std::optional<Box>& wanted, Progress& progress, EmptySolid empty) {
  if (wanted) {
    if (!wanted->valid() || wanted->size().minCoeff() <= 0)
      throw Error(ErrorKind::bad_input, "bounds", "a region must be finite and have a positive size along x, y and z");
    return *wanted;
  }
  if (model.bounds) return *model.bounds;
  const SolidBounds found = solid_bounds(*model.field, progress);
  if (found.empty && empty == EmptySolid::allowed) return {Vec3::Constant(-1), Vec3::Constant(1)};
  if (found.empty)
    throw Error(ErrorKind::bad_input, "bounds", "the solid is empty; give bounds to work on a region all the same");
  std::string open;
  for (int axis = 0; axis < 3; ++axis)
    if (!found.bounded[axis]) open += fmt::format("{}{}", open.empty() ? "" : ", ", "xyz"[axis]);
  if (!open.empty())
    throw Error(ErrorKind::bad_input, "bounds",
                fmt::format("the solid is unbounded along {}; give bounds x0,y0,z0,x1,y1,z1{}", open,
                            open == "z" ? ", or a thickness to make a plate of a flat model" : ""));
  return found.box.grown(found.box.size().maxCoeff() / 64);
}

}  // namespace fieldfab
