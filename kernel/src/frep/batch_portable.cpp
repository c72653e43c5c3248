#include "batch_loops.inl"
#include "interval_loops.inl"

namespace fieldfab::frep {

constinit const Runners portable_runners{run_values,    run_gradients,          run_intervals,
                                         run_operation, run_operation_partials, run_operation_interval};

}  // namespace fieldfab::frep
