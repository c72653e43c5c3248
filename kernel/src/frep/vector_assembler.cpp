#include "vector_assembler.h"

#include <bit>
#include <cstddef>
#include <cstring>
#include <vector>

namespace fieldfab::frep {

namespace x86 = asmjit::x86;

VectorAssembler::VectorAssembler(std::size_t lanes) : lanes_(lanes), wide_(lanes == 16) {
  failures_.any = holder_.init(asmjit::Environment::host()) != asmjit::kErrorOk;
  holder_.setErrorHandler(&failures_);
  if (holder_.attach(&code) != asmjit::kErrorOk) failures_.any = true;
  constants_ = code.newLabel();
  loop_ = code.newLabel();
  done_ = code.newLabel();
}

x86::Mem VectorAssembler::constant(float number) {
  const auto [place, is_new] =
      constant_places_.try_emplace(std::bit_cast<std::uint32_t>(number), constant_places_.size());
  return x86::ptr(constants_, place->second * vector_bytes());
}

void VectorAssembler::begin(int inputs) {
  for (const x86::Gp& kept : {x86::rbx, x86::rbp, x86::r12, x86::r15}) code.push(kept);
  code.sub(x86::rsp, 8);  // aligns the stack for calls
  code.mov(x86::rbx, x86::rdi);
  code.mov(x86::r12, x86::ptr(x86::rbx, offsetof(Arguments, choices)));
  code.mov(x86::rbp, x86::ptr(x86::rbx, offsetof(Arguments, frame)));
  code.xor_(x86::r15d, x86::r15d);
  code.bind(loop_);
  code.cmp(x86::r15, x86::ptr(x86::rbx, offsetof(Arguments, bytes)));
  code.jae(done_);
  for (int input = 0; input < inputs; ++input) {
    code.mov(x86::rax, x86::ptr(x86::rbx, static_cast<int>(offsetof(Arguments, in)) + input * 8));
    code.vmovups(vector(registers() - 1), x86::ptr(x86::rax, x86::r15));
    store(frame(input), vector(registers() - 1));
  }
}

void VectorAssembler::store_out(int which, const Vec& value) {
  code.mov(x86::rax, x86::ptr(x86::rbx, static_cast<int>(offsetof(Arguments, out)) + which * 8));
  code.vmovups(x86::ptr(x86::rax, x86::r15), value);
}

void VectorAssembler::end() {
  code.add(x86::r15, vector_bytes());
  code.add(x86::r12, static_cast<int>(lanes_ / 8));  // bits of the next lanes
  code.jmp(loop_);
  code.bind(done_);
  code.vzeroupper();
  code.add(x86::rsp, 8);
  for (const x86::Gp& kept : {x86::r15, x86::r12, x86::rbp, x86::rbx}) code.pop(kept);
  code.ret();
}

void VectorAssembler::load(const Vec& to, const asmjit::Operand& from) {
  if (from.isMem())
    code.vmovups(to, from.as<Mem>());
  else if (from.as<Vec>().id() != to.id())
    code.vmovaps(to, from.as<Vec>());
}

void VectorAssembler::magnitude(const Vec& to, const Vec& from) {
  code.emit(x86::Inst::kIdVandps, to, from, constant(std::bit_cast<float>(0x7fffffffU)));
}

void VectorAssembler::round(const Vec& to, const Vec& from, int how) {
  if (wide_)
    code.vrndscaleps(to, from, how);
  else
    code.vroundps(to, from, how);
}

void VectorAssembler::extreme(x86::Inst::Id instruction, const Vec& to, const Vec& a, const Vec& b, const Vec& scratch,
                              const Mask& mask) {
  // The instruction returns its second operand on a tie and if either is NaN. That is wrong only if
  // b alone is NaN. (If b is a, and also the mask's vector, its lanes of ones are NaN.)
  code.emit(instruction, scratch, b, a);
  compare(mask, b, b, unordered);
  select(to, mask, b, scratch);
}

void VectorAssembler::compare(const Mask& to, const Vec& a, const asmjit::Operand& b, Predicate predicate) {
  if (wide_)
    code.emit(x86::Inst::kIdVcmpps, to.bits, a, b, asmjit::Imm(predicate));
  else
    code.emit(x86::Inst::kIdVcmpps, to.vector, a, b, asmjit::Imm(predicate));
}

void VectorAssembler::both(const Mask& to, const Mask& a, const Mask& b) {
  if (wide_)
    code.kandw(to.bits, a.bits, b.bits);
  else
    code.vandps(to.vector, a.vector, b.vector);
}

void VectorAssembler::either(const Mask& to, const Mask& a, const Mask& b) {
  if (wide_)
    code.korw(to.bits, a.bits, b.bits);
  else
    code.vorps(to.vector, a.vector, b.vector);
}

void VectorAssembler::mark(const Vec& to, const Mask& mask) {
  if (wide_)
    code.k(mask.bits).vmovups(to, constant(std::bit_cast<float>(0xffffffffU)));
  else
    code.vorps(to, to, mask.vector);
}

void VectorAssembler::choose(std::size_t clause, bool second, const Mask& mask) {
  const auto place =
      static_cast<int>(clause * sizeof(Choice) + (second ? offsetof(Choice, second) : offsetof(Choice, first)));
  if (wide_) {
    code.kmovw(x86::eax, mask.bits);
    code.mov(x86::word_ptr(x86::r12, place), x86::ax);
  } else {
    code.vmovmskps(x86::eax, mask.vector);
    code.mov(x86::byte_ptr(x86::r12, place), x86::al);
  }
}

void VectorAssembler::select(const Vec& to, const Mask& mask, const Vec& if_so, const Vec& if_not) {
  if (wide_)
    code.k(mask.bits).vblendmps(to, if_not, if_so);
  else
    code.vblendvps(to, if_not, if_so, mask.vector);
}

void VectorAssembler::keep(const Vec& to, const Mask& mask, const Vec& value) {
  if (wide_)
    code.k(mask.bits).z().vmovaps(to, value);
  else
    code.vandps(to, value, mask.vector);
}

void VectorAssembler::call(RegisterFunction function, const Vec& a, const Vec& b) {
  load(vector(1), b);
  load(vector(0), a);
  code.mov(x86::rax, reinterpret_cast<std::uint64_t>(function));
  code.call(x86::rax);
}

void VectorAssembler::call(LaneOperation function, int in, int out) {
  code.lea(x86::rdi, frame(in));
  code.lea(x86::rsi, frame(out));
  code.vzeroupper();
  code.mov(x86::rax, reinterpret_cast<std::uint64_t>(function));
  code.call(x86::rax);
}

std::unique_ptr<CodeMemory> VectorAssembler::finish() {
  code.align(asmjit::AlignMode::kData, 64);
  code.bind(constants_);
  std::vector<std::uint32_t> table(constant_places_.size() * lanes_);
  for (const auto& [bits, place] : constant_places_)
    for (std::size_t lane = 0; lane < lanes_; ++lane) table[static_cast<std::size_t>(place) * lanes_ + lane] = bits;
  code.embed(table.data(), table.size() * sizeof(std::uint32_t));
  if (failures_.any || holder_.flatten() != asmjit::kErrorOk || holder_.resolveUnresolvedLinks() != asmjit::kErrorOk)
    return nullptr;
  std::unique_ptr<CodeMemory> memory = CodeMemory::reserve(holder_.codeSize());
  if (!memory || holder_.relocateToBase(reinterpret_cast<std::uint64_t>(memory->data())) != asmjit::kErrorOk)
    return nullptr;
  if (holder_.copyFlattenedData(memory->data(), holder_.codeSize()) != asmjit::kErrorOk) return nullptr;
  return memory->seal() ? std::move(memory) : nullptr;
}

}  // namespace fieldfab::frep
