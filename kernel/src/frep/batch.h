/// Running a tape over a batch of points. One implementation, compiled for several instruction sets.
#pragma once

#include <cstddef>
#include <cstdint>

#include "clause.h"

namespace fieldfab::frep {

/// A tape and the memory to run it in, as plain pointers: the files compiled for AVX must not instantiate anything that the
/// linker could share with code meant for other processors.
struct BatchRun {
  const Clause* code;
  const std::uint32_t* slot;
  std::size_t clauses;
  const float* constants;
  Operand root;
  const float* x;
  const float* y;
  const float* z;
  std::size_t count;   ///< points, at most `stride`
  float* scratch;      ///< slots * stride floats; for gradients 4 * slots * stride
  std::size_t stride;  ///< floats between slots
};

using RunValues = void (*)(const BatchRun&, float* out);
using RunGradients = void (*)(const BatchRun&, float* out, float* dx, float* dy, float* dz);

void run_values_reference(const BatchRun& run, float* out);
void run_values_portable(const BatchRun& run, float* out);
void run_values_avx2(const BatchRun& run, float* out);
void run_values_avx512(const BatchRun& run, float* out);
void run_gradients_portable(const BatchRun& run, float* out, float* dx, float* dy, float* dz);
void run_gradients_avx2(const BatchRun& run, float* out, float* dx, float* dy, float* dz);
void run_gradients_avx512(const BatchRun& run, float* out, float* dx, float* dy, float* dz);

}  // namespace fieldfab::frep
