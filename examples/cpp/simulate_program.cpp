// simulate_program SETUP PROGRAM FILE: runs a machine's program on a stock, tells what goes wrong, and writes what is
// left as a mesh.
#include <cstdio>
#include <exception>

#include "fieldfab/cam/simulate/simulate.h"
#include "fieldfab/mesh/triangle_mesh.h"

int main(int argc, char** argv) {
  if (argc != 4) return std::fputs("usage: simulate_program SETUP PROGRAM FILE\n", stderr), 2;
  try {
    const auto result = fieldfab::cam::simulate(fieldfab::cam::read_simulation_setup(argv[1]), argv[2]);
    const fieldfab::cam::SimulationReport& report = result.report();
    for (const auto& event : report.events) std::printf("line %d: %s\n", event.move.line, event.message.c_str());
    std::printf("%.0f mm3 removed in %.0f s\n", report.removed, report.seconds);
    fieldfab::write_mesh(result.surface().mesh, argv[3]);
    return report.good() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "%s\n", error.what());
    return 2;
  }
}
