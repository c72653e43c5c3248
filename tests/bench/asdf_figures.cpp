// Writes the data of Keeter's Figures 2-4, 2-5 and 2-6 as CSV files into the given folder;
// tests/bench/plot_figures.py draws them.
#include <fmt/format.h>

#include <fstream>
#include <numbers>

#include "fieldfab/asdf/asdf.h"
#include "fieldfab/field/operations.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"

int main(int count, char** arguments) {
  using namespace fieldfab;
  namespace s = frep::shapes;
  const std::string folder = count > 1 ? arguments[1] : ".";

  // A wheel as in Fig. 2-3: rim, hub, five spokes.
  frep::Expression spokes = s::rectangle(0.16, 1.7);
  for (int i = 1; i < 5; ++i)
    spokes = s::unite(spokes, s::rotate_z(s::intersect(s::rectangle(0.16, 1.7), frep::Expression::y()),
                                          2 * std::numbers::pi * i / 5));
  const frep::Expression wheel = s::unite(s::subtract(s::circle(1), s::circle(0.8)),
                                          s::unite(s::subtract(s::circle(0.25), s::circle(0.1)),
                                                   s::intersect(s::subtract(spokes, s::circle(0.2)), s::circle(0.9))));
  const Box square{{-1.1, -1.1, 0}, {1.1, 1.1, 0}};
  std::ofstream wheel_file(folder + "/fig_2_4.csv");
  wheel_file << "resolution,octree,asdf\n";
  for (const int n : {16, 32, 64, 128, 256, 512, 1024, 2048}) {
    const double voxel = 2.2 / n;
    const auto field = frep::make_field(wheel);
    wheel_file << fmt::format("{},{},{}\n", n, Asdf::build(*field, square, {voxel, 0, false})->statistics().cells(),
                              Asdf::build(*field, square, {voxel, 1e-3, true})->statistics().cells());
  }

  std::ofstream circle_file(folder + "/fig_2_5.csv");
  circle_file << "resolution,max_error,leafs\n";
  for (const double max_error : {1e-2, 1e-3, 1e-4, 1e-5})
    for (const int n : {16, 32, 64, 128, 256, 512, 1024, 2048})
      circle_file << fmt::format(
          "{},{},{}\n", n, max_error,
          Asdf::build(*frep::make_field(s::circle(1)), square, {2.2 / n, max_error, true})->statistics().leafs);

  std::ofstream cube_file(folder + "/fig_2_6.csv");
  cube_file << "alpha,beta,cells\n";
  const FieldPtr cube = frep::make_field(s::box(1, 1, 1));
  for (int alpha = 0; alpha <= 180; alpha += 9)
    for (int beta = 0; beta <= 180; beta += 9) {
      const FieldPtr turned = rotate(rotate(cube, Vec3::UnitZ(), alpha * std::numbers::pi / 180), Vec3::UnitX(),
                                     beta * std::numbers::pi / 180);
      cube_file << fmt::format(
          "{},{},{}\n", alpha, beta,
          Asdf::build(*turned, {Vec3::Constant(-1), Vec3::Constant(1)}, {1.0 / 128, -1, true})->statistics().cells());
    }
  return 0;
}
