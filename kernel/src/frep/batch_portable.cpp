#include "batch_loops.inl"
#include "interval_loops.inl"

namespace fieldfab::frep {

constinit const Runners portable_runners{run_values,         run_gradients, run_intervals,
                                         register_operation, lane_partials, lane_interval};

}  // namespace fieldfab::frep
