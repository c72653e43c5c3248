// MeshLab's filters without MeshLab: cancellation at any time, and arbitrary meshes.
// tests/hosts/meshlab_test.py tests their results.
#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <random>
#include <thread>

#include "../family.h"
#include "fieldfab/check/check.h"
#include "fieldfab/contour/contour.h"
#include "fieldfab/core/error.h"
#include "fieldfab/frep/frep_field.h"
#include "fieldfab/frep/shapes.h"
#include "filter.h"

namespace fieldfab::meshlab {
namespace {

using Clock = std::chrono::steady_clock;

std::shared_ptr<const Layer> ball_layer(double voxel) {
  const FieldPtr ball = frep::make_field(frep::shapes::sphere(10));
  return std::make_shared<const Layer>(
      Layer{"ball", contour(*ball, Box{Vec3::Constant(-11), Vec3::Constant(11)}, {voxel})});
}

Document document_of(const std::map<std::size_t, std::shared_ptr<const Layer>>& layers) {
  Document document;
  for (const auto& [index, layer] : layers)
    document.layers.push_back({layer->name, layer->mesh.bounds(), layer->mesh.triangles.size(), layer->mesh.area()});
  return document;
}

Values values_for(const Filter& filter, const std::map<std::size_t, std::shared_ptr<const Layer>>& layers,
                  const std::map<std::string, std::variant<double, std::string>>& given = {}) {
  std::vector<Parameter> parameters = filter.parameters(document_of(layers));
  for (Parameter& row : parameters)
    if (const auto found = given.find(row.name); found != given.end()) row.value = found->second;
  return {parameters, layers, 0};
}

const Filter& named(const std::string& part) {
  for (const Filter& filter : filters())
    if (filter.name.find(part) != std::string::npos) return filter;
  throw std::out_of_range(part);
}

TEST(MeshlabFilters, HaveNamesHelpAndUsableDefaults) {
  for (const Filter& filter : filters()) {
    EXPECT_EQ(filter.name.rfind("Fieldfab: ", 0), 0u) << filter.name;
    EXPECT_GT(filter.help.size(), 60u) << filter.name;
    for (const Document& document : {Document{}, document_of({{0, ball_layer(1)}})})
      for (const Parameter& row : filter.parameters(document)) {
        EXPECT_FALSE(row.help.empty() || row.label.empty()) << row.name;
        if (const auto* number = std::get_if<double>(&row.value)) {
          EXPECT_TRUE(std::isfinite(*number)) << row.name;
        }
        if (row.kind == Parameter::Kind::length) {
          EXPECT_TRUE(row.least <= std::get<double>(row.value) && std::get<double>(row.value) <= row.most) << row.name;
        }
      }
  }
}

TEST(MeshlabFilters, MakeValidSolidsOfAnySoup) {
  std::mt19937 random(7);
  std::uniform_real_distribution<float> place(-10, 10);
  for (int round = 0; round < sample_or_all(2, 6); ++round) {
    Layer soup{"soup", {}};
    if (round % 2 == 0) soup = *ball_layer(2);
    for (int n = 0; n < 40; ++n) {  // random triangles, many of which intersect
      for (int corner = 0; corner < 3; ++corner)
        soup.mesh.vertices.push_back({place(random), place(random), place(random)});
      const auto last = static_cast<std::uint32_t>(soup.mesh.vertices.size() - 1);
      soup.mesh.triangles.push_back({last - 2, last - 1, last});
    }
    const auto layer = std::make_shared<const Layer>(soup);
    const Filter& remesh = named("Remesh");
    try {
      const Result result = remesh.run(values_for(remesh, {{0, layer}}, {{"Voxel", 0.5}}), Progress::none());
      EXPECT_TRUE(inspect(result.layers.front().mesh).valid());
      if (round % 2 == 0) {
        EXPECT_NEAR(result.layers.front().mesh.volume(), 4189, 150);
      }
    } catch (const Error& error) {  // random triangles may enclose no volume, which is a reported error
      EXPECT_EQ(round % 2, 1) << error.what();
      EXPECT_EQ(error.kind(), ErrorKind::bad_input);
    }
  }
}

TEST(MeshlabFilters, StopWithinAMomentWhenCancelled) {
  const auto layer = ball_layer(0.15);
  const std::size_t triangles = layer->mesh.triangles.size();
  // Rounded edges use distances on a lattice. Sharp edges of small triangles delay cancellation.
  for (const auto& [name, edges, seconds] : {std::tuple{"Remesh", 2.0, 1.0},
                                             {"Offset", 2.0, 1.0},
                                             {"Shell", 2.0, 1.0},
                                             {"Boolean", 2.0, 1.0},
                                             {"Lattice", 2.0, 1.0},
                                             {"f-rep", 2.0, 1.0},
                                             {"Remesh", 1.0, 3.0}}) {
    const Filter& filter = named(name);
    for (const int milliseconds : {0, 20, 150, 600}) {
      Progress progress;
      std::thread stopper;
      std::atomic<Clock::rep> cancelled_at{0};
      stopper = std::thread([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(milliseconds));
        cancelled_at = Clock::now().time_since_epoch().count();
        progress.cancel();
      });
      bool stopped = false;
      try {
        filter.run(values_for(filter, {{0, layer}, {1, layer}},
                              {{"Voxel", filter.needs_layer ? 0.07 : 0.025}, {"GapWidth", 0.5}, {"Edges", edges}}),
                   progress);
      } catch (const Error& error) {
        stopped = true;
        EXPECT_EQ(error.kind(), ErrorKind::cancelled) << name << ": " << error.what();
      }
      const auto ended = Clock::now().time_since_epoch().count();
      stopper.join();
      EXPECT_TRUE(stopped) << name << " was faster than " << milliseconds << " ms";
      EXPECT_LT(std::chrono::duration<double>(Clock::duration(ended - cancelled_at)).count(), seconds)
          << name << ' ' << milliseconds;
      EXPECT_EQ(layer->mesh.triangles.size(), triangles);
    }
  }
}

}  // namespace
}  // namespace fieldfab::meshlab
