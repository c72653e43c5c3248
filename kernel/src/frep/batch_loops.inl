// Loops of the batch evaluators. batch_portable.cpp, batch_avx2.cpp and batch_avx512.cpp include
// this file, each compiled for its own instruction set. The compiler vectorises plain loops;
// everything has internal linkage or is called out of line.
#include "batch.h"
#include "derivative.h"
#include "function_loops.inl"
#include "functions.h"

namespace fieldfab::frep {
namespace {

constexpr float quiet_nan = __builtin_nanf("");

// Overlapping arrays are identical, so no element depends on another one, and the compiler needs no
// second version of a loop.
#ifdef __clang__
#define FIELDFAB_EACH _Pragma("clang loop vectorize(assume_safety)")
#else
#define FIELDFAB_EACH _Pragma("GCC ivdep")
#endif

/// An argument of a clause: an array, or one number for all points.
struct Argument {
  const float* array;  // null: `number`
  float number;
};

inline Argument argument(const BatchRun& run, Operand operand, std::size_t stride) {
  if (is_constant(operand)) return {nullptr, run.constants[operand & ~constant_bit]};
  if (operand == 0) return {run.x, 0};
  if (operand == 1) return {run.y, 0};
  if (operand == 2) return {run.z, 0};
  return {run.scratch + run.code[operand - first_value].slot * stride, 0};
}

// One loop for each combination of arrays and numbers; `a` and `b` are the numbers in `expression`.
#define FIELDFAB_UNARY(expression)                       \
  {                                                      \
    const float* pa = first.array;                       \
    if (pa == nullptr) {                                 \
      const float a = first.number;                      \
      const float same = (expression);                   \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) out[i] = same; \
    } else {                                             \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float a = pa[i];                           \
        out[i] = (expression);                           \
      }                                                  \
    }                                                    \
    break;                                               \
  }
#define FIELDFAB_BINARY(expression)                      \
  {                                                      \
    const float* pa = first.array;                       \
    const float* pb = second.array;                      \
    if (pa != nullptr && pb != nullptr) {                \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float a = pa[i], b = pb[i];                \
        out[i] = (expression);                           \
      }                                                  \
    } else if (pa != nullptr) {                          \
      const float b = second.number;                     \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float a = pa[i];                           \
        out[i] = (expression);                           \
      }                                                  \
    } else if (pb != nullptr) {                          \
      const float a = first.number;                      \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float b = pb[i];                           \
        out[i] = (expression);                           \
      }                                                  \
    } else {                                             \
      const float a = first.number, b = second.number;   \
      const float same = (expression);                   \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) out[i] = same; \
    }                                                    \
    break;                                               \
  }

/// Returns an argument for functions; fills `space` with a number.
inline LaneArgument lane_argument(const Argument& argument, float* space) {
  if (argument.array != nullptr) return {argument.array, true};
  for (std::size_t i = 0; i < float_lanes; ++i) space[i] = argument.number;
  return {space, false};
}

void run_function(Opcode op, const Argument& first, const Argument& second, float* out, std::size_t n) {
  float a[float_lanes], b[float_lanes];
  run_function(op, lane_argument(first, a), lane_argument(second, b), out, n);
}

/// out[i] = op(first[i], second[i]). An array may be `out` itself: each element is read before it
/// is written.
void run_clause(Opcode op, Argument first, Argument second, float* out, std::size_t n) {
  switch (op) {
    case Opcode::absolute: FIELDFAB_UNARY(__builtin_fabsf(a))
    case Opcode::square: FIELDFAB_UNARY(a * a)
    case Opcode::square_root: FIELDFAB_UNARY(__builtin_sqrtf(a))
    case Opcode::negate: FIELDFAB_UNARY(-a)
    case Opcode::floor: FIELDFAB_UNARY(__builtin_floorf(a))
    case Opcode::ceiling: FIELDFAB_UNARY(__builtin_ceilf(a))
    case Opcode::add: FIELDFAB_BINARY(a + b)
    case Opcode::subtract: FIELDFAB_BINARY(a - b)
    case Opcode::multiply: FIELDFAB_BINARY(a * b)
    case Opcode::divide: FIELDFAB_BINARY(a / b)
    case Opcode::minimum: FIELDFAB_BINARY(a != a ? quiet_nan : (a <= b ? a : b))
    case Opcode::maximum: FIELDFAB_BINARY(a != a ? quiet_nan : (a >= b ? a : b))
    case Opcode::modulo: FIELDFAB_BINARY(a - b * __builtin_floorf(a / b))
    case Opcode::compare: FIELDFAB_BINARY(a != a || b != b ? quiet_nan : (a > b ? 1.0F : (a < b ? -1.0F : 0.0F)))
    default: return run_function(op, first, second, out, n);
  }
}

#undef FIELDFAB_UNARY
#undef FIELDFAB_BINARY

void copy_root(const Argument& root, float* out, std::size_t n) {
  if (root.array == nullptr) FIELDFAB_EACH
  for (std::size_t i = 0; i < n; ++i) out[i] = root.number;
  else FIELDFAB_EACH for (std::size_t i = 0; i < n; ++i) out[i] = root.array[i];
}

void run_values(const BatchRun& run, float* out) {
  for (std::size_t i = 0; i < run.clauses; ++i) {
    const Clause& clause = run.code[i];
    run_clause(clause.op, argument(run, clause.a, run.stride), argument(run, clause.b, run.stride),
               run.scratch + clause.slot * run.stride, run.count);
  }
  copy_root(argument(run, run.root, run.stride), out, run.count);
}

constexpr std::size_t gradient_points = 64;

/// Returns an argument as an array; fills `space` with a number.
const float* as_array(const Argument& argument, float* space, std::size_t n) {
  if (argument.array != nullptr) return argument.array;
  FIELDFAB_EACH
  for (std::size_t i = 0; i < n; ++i) space[i] = argument.number;
  return space;
}

/// Partial derivatives of one operation at n points; one loop per operation, for vectorisation.
template <Opcode op>
void partial_loop(const float* a, const float* b, const float* value, float* da, float* db, std::size_t n) {
  FIELDFAB_EACH
  for (std::size_t i = 0; i < n; ++i) {
    const Partials d = partials(op, a[i], b[i], value[i]);
    da[i] = d.a;
    db[i] = d.b;
  }
}

void run_partials(Opcode op, const float* a, const float* b, const float* value, float* da, float* db, std::size_t n) {
#define FIELDFAB_PARTIALS(name) \
  case Opcode::name: return partial_loop<Opcode::name>(a, b, value, da, db, n);
  switch (op) {
    // derivative.h has the same for one point.
    case Opcode::sine:
    case Opcode::cosine: {
      run_clause(op == Opcode::sine ? Opcode::cosine : Opcode::sine, {a, 0}, {a, 0}, da, n);
      const float sign = op == Opcode::sine ? 1.0F : -1.0F;
      for (std::size_t i = 0; i < n; ++i) da[i] *= sign, db[i] = 0;
      return;
    }
    case Opcode::power:
      for (std::size_t i = 0; i < n; ++i) db[i] = b[i] - 1;
      run_clause(Opcode::power, {a, 0}, {db, 0}, da, n);
      run_clause(Opcode::logarithm, {a, 0}, {a, 0}, db, n);
      FIELDFAB_EACH
      for (std::size_t i = 0; i < n; ++i) {
        da[i] = b[i] == 0 ? 0.0F : b[i] * da[i];
        db[i] = a[i] > 0 ? value[i] * db[i] : 0.0F;
      }
      return;
      FIELDFAB_PARTIALS(tangent)
      FIELDFAB_PARTIALS(arcsine)
      FIELDFAB_PARTIALS(arccosine)
      FIELDFAB_PARTIALS(arctangent)
      FIELDFAB_PARTIALS(absolute)
      FIELDFAB_PARTIALS(square)
      FIELDFAB_PARTIALS(square_root)
      FIELDFAB_PARTIALS(negate)
      FIELDFAB_PARTIALS(exponential)
      FIELDFAB_PARTIALS(logarithm)
      FIELDFAB_PARTIALS(divide)
      FIELDFAB_PARTIALS(arctangent2)
      FIELDFAB_PARTIALS(modulo)
    default: return partial_loop<Opcode::floor>(a, b, value, da, db, n);
  }
#undef FIELDFAB_PARTIALS
}

/// A value and its slopes along x, y and z, `n` floats each.
struct Dual {
  const float* value;
  const float* slope[3];
};

/// Slopes of op(a, b) along one axis. The most frequent operations have their own loops, with the
/// same bits as chain().
void run_slopes(Opcode op, const Dual& a, const Dual& b, const float* da, const float* db, int axis, float* out,
                std::size_t n) {
  const float* ga = a.slope[axis];
  const float* gb = b.slope[axis];
  const float* va = a.value;
  const float* vb = b.value;
  switch (op) {
    case Opcode::add:
      FIELDFAB_EACH
      for (std::size_t i = 0; i < n; ++i) out[i] = ga[i] + gb[i];
      break;
    case Opcode::subtract:
      FIELDFAB_EACH
      for (std::size_t i = 0; i < n; ++i) out[i] = ga[i] - gb[i];
      break;
    case Opcode::minimum:
      FIELDFAB_EACH
      for (std::size_t i = 0; i < n; ++i) out[i] = (va[i] <= vb[i] ? ga[i] : gb[i]) + 0.0F;
      break;
    case Opcode::maximum:
      FIELDFAB_EACH
      for (std::size_t i = 0; i < n; ++i) out[i] = (va[i] >= vb[i] ? ga[i] : gb[i]) + 0.0F;
      break;
    case Opcode::multiply:
      FIELDFAB_EACH
      for (std::size_t i = 0; i < n; ++i) out[i] = chain(vb[i], ga[i], va[i], gb[i]);
      break;
    default:
      FIELDFAB_EACH
      for (std::size_t i = 0; i < n; ++i) out[i] = chain(da[i], ga[i], db[i], gb[i]);
  }
}

constexpr bool needs_partials(Opcode op) {
  return op != Opcode::add && op != Opcode::subtract && op != Opcode::minimum && op != Opcode::maximum &&
         op != Opcode::multiply;
}

/// Forward differentiation: each slot holds a value and three slopes, `stride` floats each.
void run_gradients(const BatchRun& run, float* out, float* dx, float* dy, float* dz) {
  const std::size_t stride = run.stride, n = run.count;
  float da[gradient_points], db[gradient_points], value[gradient_points], a_space[gradient_points],
      b_space[gradient_points];
  float zeros[gradient_points], ones[gradient_points];
  for (std::size_t i = 0; i < gradient_points; ++i) zeros[i] = 0, ones[i] = 1;
  const auto slope = [&](Operand operand, int axis) -> const float* {
    if (is_constant(operand)) return zeros;
    if (operand < first_value) return static_cast<int>(operand) == axis ? ones : zeros;
    return run.scratch + (4 * run.code[operand - first_value].slot + static_cast<std::size_t>(axis) + 1) * stride;
  };
  const auto dual = [&](Operand operand, const Argument& argument, float* space) -> Dual {
    return {as_array(argument, space, n), {slope(operand, 0), slope(operand, 1), slope(operand, 2)}};
  };
  for (std::size_t c = 0; c < run.clauses; ++c) {
    const Clause& clause = run.code[c];
    const Argument first = argument(run, clause.a, 4 * stride), second = argument(run, clause.b, 4 * stride);
    run_clause(clause.op, first, second, value, n);
    const Dual a = dual(clause.a, first, a_space), b = dual(clause.b, second, b_space);
    if (needs_partials(clause.op)) run_partials(clause.op, a.value, b.value, value, da, db, n);
    float* made = run.scratch + 4 * clause.slot * stride;
    for (int axis = 0; axis < 3; ++axis)
      run_slopes(clause.op, a, b, da, db, axis, made + static_cast<std::size_t>(axis + 1) * stride, n);
    FIELDFAB_EACH
    for (std::size_t i = 0; i < n; ++i) made[i] = value[i];
  }
  copy_root(argument(run, run.root, 4 * stride), out, n);
  copy_root({slope(run.root, 0), 0}, dx, n);
  copy_root({slope(run.root, 1), 0}, dy, n);
  copy_root({slope(run.root, 2), 0}, dz, n);
}

/// One operation for machine code (see RegisterFunction).
struct RegisterOperation {
  template <Opcode op>
  static Vector run(Vector a, Vector b) {
    if constexpr (is_function(op)) {
      Vector out = value_of<op>(a, b);
      if constexpr (is_wave(op)) mend_far_waves<op>(a, out);
      return out;
    } else {
      float in[2 * float_lanes];
      store(in, a), store(in + float_lanes, b);
      run_clause(op, {in, 0}, {in + float_lanes, 0}, in, float_lanes);
      return load(in);
    }
  }
};
/// Partial derivatives for machine code (see LaneOperation).
struct LanePartials {
  template <Opcode op>
  static void run(const float* in, float* out) {
    run_partials(op, in, in + float_lanes, in + 2 * float_lanes, out, out + float_lanes, float_lanes);
  }
};

RegisterFunction register_operation(Opcode op) {
  return reinterpret_cast<RegisterFunction>(instance_of<RegisterOperation>(op));
}
LaneOperation lane_partials(Opcode op) { return instance_of<LanePartials>(op); }

}  // namespace
}  // namespace fieldfab::frep
