// Benchmarks of the first issue, on one thread, with the times of kokopelli's own library on this
// kind of machine ("x kokopelli" is its time divided by ours; it was measured there and is not run
// here).
#include <benchmark/benchmark.h>

#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <numbers>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/file.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/bounds.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/render/render.h"

namespace {

using namespace fieldfab;

FieldPtr vm(const char* name) {
  return frep::make_field(frep::simplify(frep::parse_vm(read_file(std::string(TEST_DATA "/frep/") + name))));
}

/// The 35 parts of mtm_az with their bounds; inches, as the files have them.
const std::vector<std::pair<FieldPtr, Box>>& mtm_az() {
  static const auto parts = [] {
    std::vector<std::pair<FieldPtr, Box>> made;
    for (int i = 0; i < 35; ++i) {
      char name[64];
      std::snprintf(name, sizeof name, "/frep/mtm_az/mtm_az_%02d.math", i);
      const FieldPtr field =
          frep::make_field(frep::simplify(frep::parse_math(read_file(std::string(TEST_DATA) + name))));
      const Box found = solid_bounds(*field).box;
      made.emplace_back(field, found.grown(found.size().maxCoeff() / 64));
    }
    return made;
  }();
  return parts;
}

void compare(benchmark::State& state, double kokopelli_seconds) {
  state.counters["x kokopelli"] = benchmark::Counter(kokopelli_seconds, benchmark::Counter::kIsIterationInvariantRate);
}

const Box tangle_box{Vec3::Constant(-2.5), Vec3::Constant(2.5)};
constexpr double tangle_voxel = 5.0 / 256, mtm_voxel = 1 / (25.4 * 5);

void ProsperoBitmap1024(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = vm("prospero.vm");
  for (auto _ : state) benchmark::DoNotOptimize(render(*field, {{-1, -1, 0}, {1, 1, 0}}, {RenderMode::bitmap, 1024}));
  compare(state, 0.397);
}
BENCHMARK(ProsperoBitmap1024)->Unit(benchmark::kMillisecond);

void TanglecubeAsdf256(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = vm("tanglecube.vm");
  AsdfStatistics counts;
  for (auto _ : state) counts = Asdf::build(*field, tangle_box, {tangle_voxel})->statistics();
  compare(state, 0.434);
  state.counters["cells"] = static_cast<double>(counts.cells());
  state.counters["cells of kokopelli's"] = static_cast<double>(counts.cells()) / 1256137;
  state.counters["bytes a cell"] = static_cast<double>(counts.bytes) / static_cast<double>(counts.cells());
}
BENCHMARK(TanglecubeAsdf256)->Unit(benchmark::kMillisecond);

/// As fine as kokopelli's, which joins leafs only where nothing is lost to speak of.
void TanglecubeAsdf256Exact(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = vm("tanglecube.vm");
  AsdfStatistics counts;
  for (auto _ : state) counts = Asdf::build(*field, tangle_box, {tangle_voxel, 1e-6, true})->statistics();
  compare(state, 0.434);
  state.counters["cells"] = static_cast<double>(counts.cells());
  state.counters["cells of kokopelli's"] = static_cast<double>(counts.cells()) / 1256137;
  state.counters["bytes a cell"] = static_cast<double>(counts.bytes) / static_cast<double>(counts.cells());
}
BENCHMARK(TanglecubeAsdf256Exact)->Unit(benchmark::kMillisecond);

void TanglecubeMesh256(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = vm("tanglecube.vm");
  std::size_t triangles = 0;
  for (auto _ : state) triangles = contour(*field, tangle_box, {tangle_voxel}).triangles.size();
  compare(state, 3.604);
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(TanglecubeMesh256)->Unit(benchmark::kMillisecond);

/// No cells merged: as many triangles as the lattice asks for.
void TanglecubeMesh256Unmerged(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = vm("tanglecube.vm");
  std::size_t triangles = 0;
  for (auto _ : state) triangles = contour(*field, tangle_box, {tangle_voxel, 0}).triangles.size();
  compare(state, 3.604);
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(TanglecubeMesh256Unmerged)->Unit(benchmark::kMillisecond);

void MtmAzAsdfs(benchmark::State& state) {
  const ThreadLimit one(1);
  mtm_az();
  std::size_t cells = 0;
  for (auto _ : state) {
    cells = 0;
    for (const auto& [field, box] : mtm_az()) cells += Asdf::build(*field, box, {mtm_voxel})->statistics().cells();
  }
  compare(state, 3.1);
  state.counters["cells"] = static_cast<double>(cells);
}
BENCHMARK(MtmAzAsdfs)->Unit(benchmark::kMillisecond);

void MtmAzMeshes(benchmark::State& state) {
  const ThreadLimit one(1);
  mtm_az();
  std::size_t triangles = 0;
  for (auto _ : state) {
    triangles = 0;
    for (const auto& [field, box] : mtm_az()) triangles += contour(*field, box, {mtm_voxel}).triangles.size();
  }
  compare(state, 9.7);
  state.counters["triangles"] = static_cast<double>(triangles);
}
BENCHMARK(MtmAzMeshes)->Unit(benchmark::kMillisecond);

/// Solids that are everywhere wider than two cells, with the proof that their meshes are complete and without it, in
/// turn: the proof may cost a tenth of the time.
void ProofOfWideSolids(benchmark::State& state) {
  const ThreadLimit one(1);
  std::vector<std::pair<FieldPtr, Box>> solids{{vm("tanglecube.vm"), tangle_box}};
  for (const char* text : {"sphere(40)", "torus(30, 10)", "box(60, 40, 30)", "cylinder(20, 40)",
                           "rotate_x(box(60, 40, 30), 20) - cylinder(10, 80)"}) {
    const FieldPtr field = frep::make_field(frep::parse_infix(text));
    const Box found = solid_bounds(*field).box;
    solids.emplace_back(field, found.grown(found.size().maxCoeff() / 64));
  }
  std::array<std::clock_t, 2> spent{};  // processor time: the two are some percent apart
  for (auto _ : state)
    for (const auto& [field, box] : solids)
      for (const bool proof : {false, true}) {
        ContourSettings settings{box.size().maxCoeff() / 128};
        settings.depth = proof ? 6 : 0;
        const std::clock_t begin = std::clock();
        benchmark::DoNotOptimize(contour(*field, box, settings).triangles.size());
        spent[proof] += std::clock() - begin;
      }
  state.counters["% more with proof"] = 100.0 * static_cast<double>(spent[1]) / static_cast<double>(spent[0]) - 100;
}
BENCHMARK(ProofOfWideSolids)->Unit(benchmark::kMillisecond);

/// The baseline: the tape run over whole rows, without intervals.
void ProsperoRows1024(benchmark::State& state) {
  const FieldPtr field = vm("prospero.vm");
  constexpr std::size_t side = 1024;
  std::vector<float> x(side), y(side), z(side), out(side);
  for (std::size_t i = 0; i < side; ++i) x[i] = (static_cast<float>(i) + 0.5F) / 512 - 1;
  for (auto _ : state)
    for (std::size_t row = 0; row < side; ++row) {
      std::fill(y.begin(), y.end(), 1 - (static_cast<float>(row) + 0.5F) / 512);
      field->values({x.data(), y.data(), z.data(), side}, out.data());
    }
}
BENCHMARK(ProsperoRows1024)->Unit(benchmark::kMillisecond);

void ProsperoBitmap4096(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = vm("prospero.vm");
  for (auto _ : state) benchmark::DoNotOptimize(render(*field, {{-1, -1, 0}, {1, 1, 0}}, {RenderMode::bitmap, 4096}));
}
BENCHMARK(ProsperoBitmap4096)->Unit(benchmark::kMillisecond);

void ProsperoBitmap1024TwoThreads(benchmark::State& state) {
  const ThreadLimit two(2);
  const FieldPtr field = vm("prospero.vm");
  for (auto _ : state) benchmark::DoNotOptimize(render(*field, {{-1, -1, 0}, {1, 1, 0}}, {RenderMode::bitmap, 1024}));
}
BENCHMARK(ProsperoBitmap1024TwoThreads)->Unit(benchmark::kMillisecond)->UseRealTime();

void TanglecubeHeights512(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = vm("tanglecube.vm");
  for (auto _ : state) benchmark::DoNotOptimize(render(*field, tangle_box, {RenderMode::height, 512}));
  compare(state, 0.178);
}
BENCHMARK(TanglecubeHeights512)->Unit(benchmark::kMillisecond);

/// Keeter's example of two lines of text.
void TextBitmap2048(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field =
      frep::make_field(frep::simplify(frep::parse_math(read_file(TEST_DATA "/frep/text/text_00.math"))));
  const Box box = solid_bounds(*field).box;
  for (auto _ : state) benchmark::DoNotOptimize(render(*field, box, {RenderMode::bitmap, 2048}));
  compare(state, 0.078);
}
BENCHMARK(TextBitmap2048)->Unit(benchmark::kMillisecond);

/// A first, coarse picture of all parts: what someone sees at once.
void MtmAzFirstPicture(benchmark::State& state) {
  const ThreadLimit one(1);
  mtm_az();
  for (auto _ : state)
    for (const auto& [field, box] : mtm_az()) benchmark::DoNotOptimize(render(*field, box, {RenderMode::shaded, 64}));
}
BENCHMARK(MtmAzFirstPicture)->Unit(benchmark::kMillisecond);

/// Values a second of prospero's whole tape: each evaluator beside the portable one is the ratio of their rates.
void Evaluator(benchmark::State& state) {
  const auto evaluator = static_cast<frep::Evaluator>(state.range(0));
  state.SetLabel(std::string(frep::name(evaluator)));
  if (!frep::available(evaluator)) return state.SkipWithError("not on this processor");
  const FieldPtr field = frep::make_field(frep::parse_vm(read_file(TEST_DATA "/frep/prospero.vm")), evaluator);
  std::vector<float> x(4096), y(4096), z(4096), out(4096);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<float>(i % 64) / 32 - 1, y[i] = static_cast<float>(i / 64) / 32 - 1;
  for (auto _ : state) field->values({x.data(), y.data(), z.data(), x.size()}, out.data());
  state.SetItemsProcessed(state.iterations() * 4096);
}
BENCHMARK(Evaluator)->DenseRange(1, 6)->Unit(benchmark::kMillisecond);

/// Time of the C library's functions for floats, point by point; they are the peer of ours.
template <class Function>
double plain_seconds(const Function& function) {
  double best = 1e9;
  for (int run = 0; run < 20; ++run) {
    const auto begin = std::chrono::steady_clock::now();
    function();
    best = std::min(best, std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count());
  }
  return best;
}

/// A transcendental function in lanes; its points a second, and how many times the C library's.
template <class Plain>
void Function(benchmark::State& state, frep::Opcode op, const Plain& plain) {
  std::vector<float> x(4096), y(4096), z(4096), out(4096);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = (static_cast<float>(i % 64) + 0.5F) / 64, y[i] = (static_cast<float>(i / 64) + 0.5F) / 64;
  const frep::Expression a = frep::Expression::x();
  const FieldPtr field = frep::make_field(
      frep::info(op).arity == 1 ? frep::Expression::make(op, a) : frep::Expression::make(op, a, frep::Expression::y()));
  const double peer = plain_seconds([&] {
    for (std::size_t i = 0; i < x.size(); ++i) out[i] = plain(x[i], y[i]);
    benchmark::DoNotOptimize(out.data());
  });
  for (auto _ : state) field->values({x.data(), y.data(), z.data(), x.size()}, out.data());
  state.SetItemsProcessed(state.iterations() * 4096);
  state.counters["x C library"] = benchmark::Counter(peer, benchmark::Counter::kIsIterationInvariantRate);
}
#define FIELDFAB_FUNCTION(name, call) \
  BENCHMARK_CAPTURE(Function, name, frep::Opcode::name, [](float a, [[maybe_unused]] float b) { return call; })
FIELDFAB_FUNCTION(sine, std::sin(a));
FIELDFAB_FUNCTION(cosine, std::cos(a));
FIELDFAB_FUNCTION(tangent, std::tan(a));
FIELDFAB_FUNCTION(arcsine, std::asin(a));
FIELDFAB_FUNCTION(arccosine, std::acos(a));
FIELDFAB_FUNCTION(arctangent, std::atan(a));
FIELDFAB_FUNCTION(exponential, std::exp(a));
FIELDFAB_FUNCTION(logarithm, std::log(a));
FIELDFAB_FUNCTION(power, std::pow(a, b));
FIELDFAB_FUNCTION(arctangent2, std::atan2(a, b));

constexpr double blend_sharpness = 0.8;  // 1/mm
constexpr int blend_balls = 29;
Vec3 blend_centre(int ball) {
  const double t = ball / (blend_balls - 1.0), angle = 6 * std::numbers::pi * t, radius = 14 * (0.4 + 0.6 * t);
  return {radius * std::cos(angle), radius * std::sin(angle), 30 * t - 15};
}

/// Balls along a spiral, blended by exponentials: -ln(sum of exp(-k distance)) / k.
FieldPtr exponential_blend() {
  frep::Expression sum = 0.0;
  for (int ball = 0; ball < blend_balls; ++ball) {
    const Vec3 c = blend_centre(ball);
    const frep::Expression distance =
        sqrt(square(frep::Expression::x() - c.x()) + square(frep::Expression::y() - c.y()) +
             square(frep::Expression::z() - c.z()));
    sum = sum + exp((3.5 - distance) * blend_sharpness);
  }
  return frep::make_field(-ln(sum) / blend_sharpness);
}
const Box blend_box{Vec3::Constant(-20), Vec3::Constant(20)};

/// Values of the blend, and how many times those of a loop in C++ with the C library's exp and log.
void ExponentialBlendValues(benchmark::State& state) {
  const FieldPtr field = exponential_blend();
  std::vector<float> x(4096), y(4096), z(4096), out(4096);
  for (std::size_t i = 0; i < x.size(); ++i)
    x[i] = static_cast<float>(i % 16) - 8, y[i] = static_cast<float>(i / 16 % 16) - 8,
    z[i] = static_cast<float>(i / 256) - 8;
  std::vector<std::array<float, 3>> centres;
  for (int ball = 0; ball < blend_balls; ++ball) {
    const Vec3 c = blend_centre(ball);
    centres.push_back({static_cast<float>(c.x()), static_cast<float>(c.y()), static_cast<float>(c.z())});
  }
  const double peer = plain_seconds([&] {
    for (std::size_t i = 0; i < x.size(); ++i) {
      float sum = 0;
      for (const auto& c : centres) {
        const float dx = x[i] - c[0], dy = y[i] - c[1], dz = z[i] - c[2];
        sum += std::exp((3.5F - std::sqrt(dx * dx + dy * dy + dz * dz)) * static_cast<float>(blend_sharpness));
      }
      out[i] = -std::log(sum) / static_cast<float>(blend_sharpness);
    }
    benchmark::DoNotOptimize(out.data());
  });
  for (auto _ : state) field->values({x.data(), y.data(), z.data(), x.size()}, out.data());
  state.SetItemsProcessed(state.iterations() * 4096);
  state.counters["x plain C++"] = benchmark::Counter(peer, benchmark::Counter::kIsIterationInvariantRate);
}
BENCHMARK(ExponentialBlendValues)->Unit(benchmark::kMicrosecond);

void ExponentialBlendHeights512(benchmark::State& state) {
  const ThreadLimit one(1);
  const FieldPtr field = exponential_blend();
  for (auto _ : state) benchmark::DoNotOptimize(render(*field, blend_box, {RenderMode::height, 512}));
}
BENCHMARK(ExponentialBlendHeights512)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
