#include "batch_loops.inl"

namespace fieldfab::frep {

void run_values_portable(const BatchRun& run, float* out) { run_values(run, out); }
void run_gradients_portable(const BatchRun& run, float* out, float* dx, float* dy, float* dz) {
  run_gradients(run, out, dx, dy, dz);
}

}  // namespace fieldfab::frep
