/// Vector instructions for tapes, common to AVX2 and AVX-512. Includes asmjit: only for the files
/// that generate code.
#pragma once

#include <asmjit/x86.h>

#include <cstdint>
#include <map>

#include "batch.h"
#include "code_memory.h"

namespace fieldfab::frep {

/// Generates a function `void(const Arguments*)` that processes its points one vector at a time.
///
/// Registers: rbx points to the arguments, r15 is the offset in bytes, r12 points to the choices,
/// rbp points to a frame of vectors (the inputs of these points, then room for calls, then slots).
class VectorAssembler {
 public:
  using Vec = asmjit::x86::Vec;
  using Mem = asmjit::x86::Mem;

  /// Arguments of the function. Arrays hold whole vectors; the function uses as many of `in` and
  /// `out` as it needs.
  struct Arguments {
    const float* in[6];
    float* out[4];
    std::size_t bytes;
    float* frame;
    Choice* choices;
  };
  using Function = void (*)(const Arguments*);

  /// Vectors of the frame.
  static constexpr int frame_call = 6;    ///< eight vectors for calls
  static constexpr int frame_slots = 14;  ///< first vector of the slots

  /// Result of a comparison: a vector for AVX2, a k register for AVX-512.
  struct Mask {
    Vec vector;
    asmjit::x86::KReg bits;
  };

  explicit VectorAssembler(std::size_t lanes);

  [[nodiscard]] int registers() const { return wide_ ? 32 : 16; }
  [[nodiscard]] Vec vector(int number) const {
    const auto id = static_cast<std::uint32_t>(number);
    return wide_ ? Vec(asmjit::x86::zmm(id)) : Vec(asmjit::x86::ymm(id));
  }
  /// Returns vector `number`, or a k register; numbers that differ by less than seven have
  /// different k registers.
  [[nodiscard]] Mask mask(int number) const {
    return {vector(number), asmjit::x86::KReg(static_cast<std::uint32_t>(1 + number % 7))};
  }

  [[nodiscard]] Mem frame(int place) const { return asmjit::x86::ptr(asmjit::x86::rbp, place * vector_bytes()); }
  /// Returns a vector with `number` in all lanes.
  Mem constant(float number);

  void begin(int inputs);                       ///< emits the code up to the load of the inputs into the frame
  void store_out(int which, const Vec& value);  ///< stores a result
  void end();

  void load(const Vec& to, const asmjit::Operand& from);
  void store(const Mem& to, const Vec& from) { code.vmovups(to, from); }
  /// to = a op b, for instructions of that form.
  void binary(asmjit::x86::Inst::Id instruction, const Vec& to, const Vec& a, const asmjit::Operand& b) {
    code.emit(instruction, to, a, b);
  }
  void unary(asmjit::x86::Inst::Id instruction, const Vec& to, const Vec& a) { code.emit(instruction, to, a); }
  void floor(const Vec& to, const Vec& from) { round(to, from, 0x09); }
  void ceiling(const Vec& to, const Vec& from) { round(to, from, 0x0a); }
  void negate(const Vec& to, const Vec& from) { code.emit(asmjit::x86::Inst::kIdVxorps, to, from, constant(-0.0F)); }
  void magnitude(const Vec& to, const Vec& from);
  /// min and max as in apply(): the first on a tie, NaN if either is. `scratch` is neither a nor b;
  /// `mask` may be a.
  void least(const Vec& to, const Vec& a, const Vec& b, const Vec& scratch, const Mask& mask) {
    extreme(asmjit::x86::Inst::kIdVminps, to, a, b, scratch, mask);
  }
  void greatest(const Vec& to, const Vec& a, const Vec& b, const Vec& scratch, const Mask& mask) {
    extreme(asmjit::x86::Inst::kIdVmaxps, to, a, b, scratch, mask);
  }

  enum Predicate { less = 1, less_equal = 2, unordered = 3, not_equal = 4, greater_equal = 13, greater = 14 };
  void compare(const Mask& to, const Vec& a, const asmjit::Operand& b, Predicate predicate);
  void both(const Mask& to, const Mask& a, const Mask& b);
  void select(const Vec& to, const Mask& mask, const Vec& if_so, const Vec& if_not);
  /// Sets all bits of `to` in the lanes of the mask.
  void mark(const Vec& to, const Mask& mask);
  /// Writes the lanes of a mask as bits into the choices of clause `clause`: Choice::second or
  /// Choice::first.
  void choose(std::size_t clause, bool second, const Mask& mask);
  void either(const Mask& to, const Mask& a, const Mask& b);
  /// `value` in the lanes of the mask, otherwise 0.
  void keep(const Vec& to, const Mask& mask, const Vec& value);

  /// Calls a function; the result is in vector(0), all other vector registers are lost. `a` is not
  /// vector(1), and `b` not vector(0).
  void call(RegisterFunction function, const Vec& a, const Vec& b);
  /// Calls function(frame + in, frame + out); all vector registers are lost.
  void call(LaneOperation function, int in, int out);

  /// Returns the function in executable memory; null if there is none.
  std::unique_ptr<CodeMemory> finish();

 private:
  [[nodiscard]] int vector_bytes() const { return static_cast<int>(lanes_ * sizeof(float)); }
  void round(const Vec& to, const Vec& from, int how);
  void extreme(asmjit::x86::Inst::Id instruction, const Vec& to, const Vec& a, const Vec& b, const Vec& scratch,
               const Mask& mask);

  /// Whether asmjit failed at any instruction, as where memory is refused: the code lacks it then, and must not run.
  struct Failures final : asmjit::ErrorHandler {
    bool any = false;
    void handleError(asmjit::Error /*error*/, const char* /*message*/, asmjit::BaseEmitter* /*origin*/) override {
      any = true;
    }
  };

  std::size_t lanes_;
  bool wide_;
  Failures failures_;
  asmjit::CodeHolder holder_;
  asmjit::x86::Assembler code;
  asmjit::Label constants_, loop_, done_;
  std::map<std::uint32_t, int> constant_places_;  ///< by bits
};

}  // namespace fieldfab::frep
