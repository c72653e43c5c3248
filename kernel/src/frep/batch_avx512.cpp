#include "batch_loops.inl"
#include "interval_loops.inl"

namespace fieldfab::frep {

constinit const Runners avx512_runners{run_values,       run_gradients,  run_intervals,
                                       &lane_operations, &lane_partials, &lane_intervals};

}  // namespace fieldfab::frep
