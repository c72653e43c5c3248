#include "prune.h"

#include <bit>

namespace fieldfab::frep {
namespace {

/// Which clauses are needed, a bit each, so that those that are not are passed over by the word.
class Needed {
 public:
  void reset(std::size_t count) { words_.assign((count + 63) / 64, 0); }
  void require(Operand operand) {
    if (is_made(operand)) words_[(operand - first_value) >> 6] |= std::uint64_t{1} << ((operand - first_value) & 63);
  }
  /// Visits them from the last to the first; those that a visit requires, which come before it, are visited, too.
  template <class Visit>
  void backwards(const Visit& visit) {
    for (std::size_t word = words_.size(); word-- > 0;)
      while (words_[word] != 0) {
        const auto bit = static_cast<std::uint32_t>(std::bit_width(words_[word]) - 1);
        words_[word] ^= std::uint64_t{1} << bit;
        visit(static_cast<std::uint32_t>(word * 64 + bit));
      }
  }

 private:
  std::vector<std::uint64_t> words_;
};

/// Memory that each thread keeps.
struct Workspace {
  Needed needed;
  std::vector<std::uint32_t> kept;  ///< clauses, the last one first
  std::vector<Operand> renamed;     ///< by old clause: what it is called in the pruned tape
  std::vector<std::uint32_t> last_use;
};

enum class Way : std::uint8_t { whole, first, second };

Way way(const Clause& clause, const Choice& choice, std::uint16_t bit) {
  if (!has_choice(clause.op)) return Way::whole;
  return (choice.first & bit) != 0 ? Way::first : (choice.second & bit) != 0 ? Way::second : Way::whole;
}

}  // namespace

bool prune(const Tape& tape, const Choice* choices, unsigned lane, Tape& pruned) {
  static thread_local Workspace kept_workspace;
  Workspace& work = kept_workspace;
  const auto bit = static_cast<std::uint16_t>(1U << lane);
  const Clause* const code = tape.code.data();

  // From the root down: what is needed.
  bool chosen = false;
  work.kept.clear();
  work.needed.reset(tape.code.size());
  work.needed.require(tape.root);
  work.needed.backwards([&](std::uint32_t i) {
    const Clause& clause = code[i];
    const Way taken = way(clause, choices[i], bit);
    chosen |= taken != Way::whole;
    if (taken != Way::second || clause.op == Opcode::absolute) work.needed.require(clause.a);
    if (taken != Way::first) work.needed.require(clause.b);
    work.kept.push_back(i);
  });
  if (!chosen && work.kept.size() == tape.code.size()) return false;

  // From the leaves up: what is left, under its new names.
  work.renamed.resize(tape.code.size());
  work.last_use.resize(work.kept.size());
  pruned.code.resize(work.kept.size());
  std::uint32_t made = 0;
  const auto renamed = [&](Operand operand) { return is_made(operand) ? work.renamed[operand - first_value] : operand; };
  const auto emit = [&](Opcode op, bool only_sign_matters, Operand a, Operand b) {
    pruned.code[made] = {op, only_sign_matters, 0, a, b};
    if (is_made(a)) work.last_use[a - first_value] = made;
    if (is_made(b)) work.last_use[b - first_value] = made;
    work.last_use[made] = ~0U;
    return first_value + made++;
  };
  for (auto place = work.kept.rbegin(); place != work.kept.rend(); ++place) {
    const Clause& clause = code[*place];
    const Way taken = way(clause, choices[*place], bit);
    const Operand a = renamed(clause.a);
    Operand& name = work.renamed[*place];
    if (taken == Way::first)
      name = a;
    else if (taken == Way::second)  // the absolute value of a negative number is its negative
      name = clause.op == Opcode::absolute ? emit(Opcode::negate, clause.only_sign_matters, a, a) : renamed(clause.b);
    else
      name = emit(clause.op, clause.only_sign_matters, a, renamed(clause.b));
  }
  pruned.code.resize(made);
  pruned.constants = tape.constants;
  pruned.root = renamed(tape.root);
  assign_slots(pruned, work.last_use);
  return true;
}

}  // namespace fieldfab::frep
