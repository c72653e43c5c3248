// CAM benchmarks with the targets of issue 5. Each comment states its target.
#include <benchmark/benchmark.h>

#include <chrono>
#include <numbers>
#include <random>

#include "fieldfab/cam/plan/contour.h"
#include "fieldfab/cam/plan/distance.h"
#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/cam/plan/order.h"
#include "fieldfab/cam/plan/surface.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/parallel.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/text.h"
#include "fieldfab/mesh/mesh_field.h"
#include "fieldfab/solid/open.h"

namespace {

using namespace fieldfab;
using namespace fieldfab::cam;

FieldPtr circuit_board() {
  return scale(united(open_model(TEST_DATA "/frep/fab_ISP/fab_ISP_02.math")).field, Vec3::Constant(25.4));
}
const Rectangle board{{0, 0}, {0.805 * 25.4, 1.68 * 25.4}};

/// The board's bitmap at a resolution in dots per inch.
Bitmap board_bitmap(int dpi) {
  const FieldPtr field = circuit_board();
  const double cell = 25.4 / dpi;
  Bitmap bitmap(static_cast<int>(board.size().x() / cell) + 3, static_cast<int>(board.size().y() / cell) + 3, cell,
                board.lower - Vec2::Constant(cell), 0);
  std::vector<float> x(static_cast<std::size_t>(bitmap.width)), y(x.size()), z(x.size(), 0.0F), value(x.size());
  for (int row = 0; row < bitmap.height; ++row) {
    for (int column = 0; column < bitmap.width; ++column)
      x[static_cast<std::size_t>(column)] = static_cast<float>(bitmap.place(column, row).x()),
      y[static_cast<std::size_t>(column)] = static_cast<float>(bitmap.place(column, row).y());
    field->values({x.data(), y.data(), z.data(), x.size()}, value.data());
    for (int column = 0; column < bitmap.width; ++column)
      bitmap.at(column, row) = value[static_cast<std::size_t>(column)] < 0 ? 1 : 0;
  }
  return bitmap;
}

/// Distance transform and contour of fab_ISP; arguments: threads, dots per inch. Target: 1000 dpi
/// under 0.3 s, linear in pixels, speedup 1.6 with 2 threads.
void distance_and_contour(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const Bitmap bitmap = board_bitmap(static_cast<int>(state.range(1)));
  std::size_t points = 0;
  for (auto _ : state) {
    const FieldPtr distance = lattice_field(distance_transform(bitmap));
    points = 0;
    for (const Loop& loop : contours(*distance, bitmap.extent(), {bitmap.cell, 0, 0.2})) points += loop.points.size();
  }
  state.counters["pixels"] = static_cast<double>(bitmap.values.size());
  state.counters["points"] = static_cast<double>(points);
}
BENCHMARK(distance_and_contour)->ArgsProduct({{1, 2}, {500, 1000, 2000}})->Unit(benchmark::kMillisecond)->UseRealTime();

/// Only the distance transform.
void distance_alone(benchmark::State& state) {
  const ThreadLimit limit(static_cast<int>(state.range(0)));
  const Bitmap bitmap = board_bitmap(2000);
  for (auto _ : state) benchmark::DoNotOptimize(distance_transform(bitmap).values.data());
}
BENCHMARK(distance_alone)->Arg(1)->Arg(2)->Unit(benchmark::kMillisecond)->UseRealTime();

/// The ShopBot's bed, 24,000 x 12,000 cells: 40 boards with fab_ISP's outline, enlarged three
/// times, and their offsets. Target: 10 s, 500 MB.
void shopbot_bed(benchmark::State& state) {
  FieldPtr sheet;
  for (int i = 0; i < state.range(0); ++i) {
    FieldPtr part = translate(scale(circuit_board(), {10, 10, 10}), {20.0 + 235 * (i % 10), 5.0 + 290 * (i / 10), 0});
    sheet = sheet ? unite(sheet, part) : part;
  }
  const Rectangle bed{{0, 0}, {2400, 1200}};
  std::size_t points = 0;
  double length = 0;
  for (auto _ : state) {
    const Loops outline = contours(*sheet, bed, {0.1});
    const Loops moved = offset(outline, 3.175, 0.1);
    points = 0, length = 0;
    for (const Loop& loop : outline) points += loop.points.size(), length += loop.length();
    for (const Loop& loop : moved) points += loop.points.size();
  }
  state.counters["points"] = static_cast<double>(points);
  state.counters["outline_m"] = length / 1000;
}
BENCHMARK(shopbot_bed)->Arg(10)->Arg(40)->Unit(benchmark::kMillisecond)->Iterations(1);

/// A million positions of a ball cutter, 0.1 mm apart, over a freeform surface of 100 x 100 mm, one
/// thread; argument: diameter in mm. Target: 2 s for 6 mm.
void cutter_positions(benchmark::State& state) {
  const ThreadLimit limit(1);
  const FieldPtr form = frep::make_field(frep::parse_infix("z - 10 - 3*sin(0.13*x)*cos(0.11*y) - sin(0.3*x+0.2*y)"));
  const auto surface = Surface::of(*form, {{0, 0, 0}, {100, 100, 20}}, {0.1, 0.01});
  const double radius = static_cast<double>(state.range(0)) / 2;
  for (auto _ : state) {
    const TipSurface tips(surface, Profile(0, radius, 0, radius));
    double sum = 0;
    for (int j = 0; j < 1000; ++j) {
      Vec2 guess(0, 0.1 * j);
      for (int i = 0; i < 1000; ++i) {
        const auto touched = tips.contact({0.1 * i, 0.1 * j}, guess);
        guess = touched.place, sum += touched.tip;
      }
    }
    benchmark::DoNotOptimize(sum);
  }
}
BENCHMARK(cutter_positions)->Arg(3)->Arg(6)->Arg(12)->Arg(24)->Unit(benchmark::kMillisecond)->Iterations(1);

/// The same on a mesh of about 100,000 triangles, including the sampling of the mesh: a million
/// positions of a 6 mm ball. OpenCAMLib computes 608 of them per second (issue 5).
void cutter_positions_on_a_mesh(benchmark::State& state) {
  const ThreadLimit limit(1);
  const FieldPtr form = frep::make_field(frep::parse_infix("z - 10 - 3*sin(0.13*x)*cos(0.11*y) - sin(0.3*x+0.2*y)"));
  const Box bounds{{0, 0, 0}, {100, 100, 20}};
  const TriangleMesh mesh = contour(*form, bounds, {0.5, 0.004});
  const FieldPtr solid = mesh_field(mesh);
  constexpr int side = 1000;
  double seconds = 0;
  for (auto _ : state) {
    const auto begin = std::chrono::steady_clock::now();
    const TipSurface tips(Surface::of(*solid, bounds, {0.1, 0.01}), Profile(0, 3, 0, 3));
    double sum = 0;
    for (int j = 0; j < side; ++j)
      for (int i = 0; i < side; ++i) sum += tips.tip({0.1 * i, 0.1 * j});
    benchmark::DoNotOptimize(sum);
    seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  }
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
  state.counters["positions_a_second"] = side * side / seconds;
  state.counters["times_OpenCAMLib"] = side * side / seconds / 608;
}
BENCHMARK(cutter_positions_on_a_mesh)->Unit(benchmark::kMillisecond)->Iterations(1);

/// Ordering of paths spread over a sheet. Target: 100,000 in 5 s.
void ordering(benchmark::State& state) {
  std::mt19937 random(1);
  std::uniform_real_distribution<> any(0, 1000);
  std::vector<Path> paths;
  for (int i = 0; i < state.range(0); ++i) {
    Path path;
    path.closed = true;
    const Vec2 centre(any(random), any(random));
    const double radius = 0.2 + 0.003 * any(random);
    for (int k = 0; k < 12; ++k)
      path.points.push_back({{centre.x() + radius * std::cos(k * std::numbers::pi / 6),
                              centre.y() + radius * std::sin(k * std::numbers::pi / 6), 0}});
    paths.push_back(path);
  }
  AirTravel air;
  for (auto _ : state) {
    auto copy = paths;
    air = order(copy);
  }
  state.counters["air_before"] = air.before;
  state.counters["air_after"] = air.after;
}
BENCHMARK(ordering)->Arg(1000)->Arg(10000)->Arg(100000)->Unit(benchmark::kMillisecond)->Iterations(1);

}  // namespace

BENCHMARK_MAIN();
