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

/// op(a, b) for the operations that need no function.
template <Opcode op>
[[gnu::always_inline]] inline float value_at(float a, float b) {
  switch (op) {
    case Opcode::absolute: return __builtin_fabsf(a);
    case Opcode::square: return a * a;
    case Opcode::square_root: return __builtin_sqrtf(a);
    case Opcode::negate: return -a;
    case Opcode::floor: return __builtin_floorf(a);
    case Opcode::ceiling: return __builtin_ceilf(a);
    case Opcode::add: return a + b;
    case Opcode::subtract: return a - b;
    case Opcode::multiply: return a * b;
    case Opcode::divide: return a / b;
    case Opcode::minimum: return a != a ? quiet_nan : (a <= b ? a : b);
    case Opcode::maximum: return a != a ? quiet_nan : (a >= b ? a : b);
    case Opcode::modulo: return a - b * __builtin_floorf(a / b);
    default: return a != a || b != b ? quiet_nan : (a > b ? 1.0F : (a < b ? -1.0F : 0.0F));  // compare
  }
}

// One loop for each combination of arrays and numbers.
#define FIELDFAB_UNARY(name)                             \
  case Opcode::name: {                                   \
    const float* pa = first.array;                       \
    if (pa == nullptr) {                                 \
      const float a = first.number;                      \
      const float same = value_at<Opcode::name>(a, a);   \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) out[i] = same; \
    } else {                                             \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float a = pa[i];                           \
        out[i] = value_at<Opcode::name>(a, a);           \
      }                                                  \
    }                                                    \
    break;                                               \
  }
#define FIELDFAB_BINARY(name)                            \
  case Opcode::name: {                                   \
    const float* pa = first.array;                       \
    const float* pb = second.array;                      \
    if (pa != nullptr && pb != nullptr) {                \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float a = pa[i], b = pb[i];                \
        out[i] = value_at<Opcode::name>(a, b);           \
      }                                                  \
    } else if (pa != nullptr) {                          \
      const float b = second.number;                     \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float a = pa[i];                           \
        out[i] = value_at<Opcode::name>(a, b);           \
      }                                                  \
    } else if (pb != nullptr) {                          \
      const float a = first.number;                      \
      FIELDFAB_EACH                                      \
      for (std::size_t i = 0; i < n; ++i) {              \
        const float b = pb[i];                           \
        out[i] = value_at<Opcode::name>(a, b);           \
      }                                                  \
    } else {                                             \
      const float a = first.number, b = second.number;   \
      const float same = value_at<Opcode::name>(a, b);   \
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
    FIELDFAB_UNARY(absolute)
    FIELDFAB_UNARY(square)
    FIELDFAB_UNARY(square_root)
    FIELDFAB_UNARY(negate)
    FIELDFAB_UNARY(floor)
    FIELDFAB_UNARY(ceiling)
    FIELDFAB_BINARY(add)
    FIELDFAB_BINARY(subtract)
    FIELDFAB_BINARY(multiply)
    FIELDFAB_BINARY(divide)
    FIELDFAB_BINARY(minimum)
    FIELDFAB_BINARY(maximum)
    FIELDFAB_BINARY(modulo)
    FIELDFAB_BINARY(compare)
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

/// The slope of op(a, b) along an axis, from those of a and b. The most frequent operations need no product, and have
/// the same bits as chain().
template <Opcode op>
[[gnu::always_inline]] inline float slope_at(float a, float b, float value, float ga, float gb) {
  if (op == Opcode::add) return ga + gb;
  if (op == Opcode::subtract) return ga - gb;
  if (op == Opcode::minimum) return (a <= b ? ga : gb) + 0.0F;
  if (op == Opcode::maximum) return (a >= b ? ga : gb) + 0.0F;
  const Partials d = partials(op, a, b, value);
  return chain(d.a, ga, d.b, gb);
}

/// Writes op(a, b) and its slopes for n points, `stride` floats between them. The result may be `a` or `b` itself: all
/// of a point is read before it is written.
template <Opcode op, std::size_t n>
void differentiate(const Dual& a, const Dual& b, float* made, std::size_t stride) {
  const float *const va = a.value, *const vb = b.value;
  const float *const ax = a.slope[0], *const ay = a.slope[1], *const az = a.slope[2];
  const float *const bx = b.slope[0], *const by = b.slope[1], *const bz = b.slope[2];
  float *const x = made + stride, *const y = x + stride, *const z = y + stride;
  FIELDFAB_EACH
  for (std::size_t i = 0; i < n; ++i) {
    const float value = value_at<op>(va[i], vb[i]);
    const float dx = slope_at<op>(va[i], vb[i], value, ax[i], bx[i]),
                dy = slope_at<op>(va[i], vb[i], value, ay[i], by[i]),
                dz = slope_at<op>(va[i], vb[i], value, az[i], bz[i]);
    made[i] = value, x[i] = dx, y[i] = dy, z[i] = dz;
  }
}

/// The same for any operation; the most frequent ones have loops of their own.
template <std::size_t n>
void run_dual(Opcode op, const Dual& a, const Dual& b, float* made, std::size_t stride) {
#define FIELDFAB_OWN_LOOP(name) \
  case Opcode::name: return differentiate<Opcode::name, n>(a, b, made, stride);
  switch (op) {
    FIELDFAB_OWN_LOOP(add)
    FIELDFAB_OWN_LOOP(subtract)
    FIELDFAB_OWN_LOOP(multiply)
    FIELDFAB_OWN_LOOP(divide)
    FIELDFAB_OWN_LOOP(minimum)
    FIELDFAB_OWN_LOOP(maximum)
    FIELDFAB_OWN_LOOP(negate)
    FIELDFAB_OWN_LOOP(absolute)
    FIELDFAB_OWN_LOOP(square)
    FIELDFAB_OWN_LOOP(square_root)
    default: break;
  }
#undef FIELDFAB_OWN_LOOP
  float value[n], da[n], db[n];
  run_clause(op, {a.value, 0}, {b.value, 0}, value, n);
  run_partials(op, a.value, b.value, value, da, db, n);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const float *const ga = a.slope[axis], *const gb = b.slope[axis];
    float* const out = made + (axis + 1) * stride;
    FIELDFAB_EACH
    for (std::size_t i = 0; i < n; ++i) out[i] = chain(da[i], ga[i], db[i], gb[i]);
  }
  FIELDFAB_EACH
  for (std::size_t i = 0; i < n; ++i) made[i] = value[i];
}

/// run_gradients() for as many points as is rounded up to n, so that loops have no ends of their own: most batches have
/// 8 points, the corners of a box, or 27.
template <std::size_t n>
void run_gradients_of(const BatchRun& run, float* out, float* dx, float* dy, float* dz) {
  const std::size_t stride = run.stride;
  float zeros[n], ones[n], numbers[2][n], padded[3][n];
  const float* coordinates[3] = {run.x, run.y, run.z};
  for (std::size_t i = 0; i < n; ++i) zeros[i] = 0, ones[i] = 1;
  if (run.count < n)
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < n; ++i) padded[axis][i] = coordinates[axis][i < run.count ? i : run.count - 1];
      coordinates[axis] = padded[axis];
    }
  const auto dual = [&](Operand operand, float* space) -> Dual {
    if (is_constant(operand)) {
      const float number = run.constants[operand & ~constant_bit];
      for (std::size_t i = 0; i < n; ++i) space[i] = number;
      return {space, {zeros, zeros, zeros}};
    }
    if (operand < first_value) {
      Dual coordinate{coordinates[operand], {zeros, zeros, zeros}};
      coordinate.slope[operand] = ones;
      return coordinate;
    }
    const float* const slot = run.scratch + 4 * run.code[operand - first_value].slot * stride;
    return {slot, {slot + stride, slot + 2 * stride, slot + 3 * stride}};
  };
  for (std::size_t c = 0; c < run.clauses; ++c) {
    const Clause& clause = run.code[c];
    run_dual<n>(clause.op, dual(clause.a, numbers[0]), dual(clause.b, numbers[1]),
                run.scratch + 4 * clause.slot * stride, stride);
  }
  const Dual root = dual(run.root, numbers[0]);
  copy_root({root.value, 0}, out, run.count);
  copy_root({root.slope[0], 0}, dx, run.count);
  copy_root({root.slope[1], 0}, dy, run.count);
  copy_root({root.slope[2], 0}, dz, run.count);
}

/// Forward differentiation: each slot holds a value and three slopes, `stride` floats each, at least the number of
/// points rounded up to 8, 16, 32 or 64.
void run_gradients(const BatchRun& run, float* out, float* dx, float* dy, float* dz) {
  if (run.count <= 8) return run_gradients_of<8>(run, out, dx, dy, dz);
  if (run.count <= 16) return run_gradients_of<16>(run, out, dx, dy, dz);
  if (run.count <= 32) return run_gradients_of<32>(run, out, dx, dy, dz);
  run_gradients_of<64>(run, out, dx, dy, dz);
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
