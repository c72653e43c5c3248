#include <fmt/format.h>

#include <iterator>

#include "fieldfab/frep/text.h"

namespace fieldfab::frep {

std::string print_dot(const Expression& expression) {
  const Flat flat = flatten(expression);
  std::string out =
      "digraph expression {\n  node [shape=box, style=\"rounded,filled\", fillcolor=white, fontname=\"sans-serif\"];\n";
  for (std::size_t i = 0; i < flat.order.size(); ++i) {
    const Flat::Entry& entry = flat.order[i];
    const OpcodeInfo& op = info(entry.op);
    const char* const colour = entry.op == Opcode::constant ? ", fillcolor=lightyellow"
                               : op.arity == 0              ? ", fillcolor=lightblue"
                                                            : "";
    const std::string label =
        entry.op == Opcode::constant ? fmt::format("{:.6g}", entry.constant) : std::string(op.infix);
    fmt::format_to(std::back_inserter(out), "  n{} [label=\"{}\"{}];\n", i, label, colour);
    if (op.arity >= 1)
      fmt::format_to(std::back_inserter(out), "  n{} -> n{}{};\n", i, entry.a,
                     op.arity >= 2 ? " [taillabel=\"a\"]" : "");
    if (op.arity >= 2) fmt::format_to(std::back_inserter(out), "  n{} -> n{} [taillabel=\"b\"];\n", i, entry.b);
    if (op.arity == 3) fmt::format_to(std::back_inserter(out), "  n{} -> n{} [taillabel=\"c\"];\n", i, entry.c);
  }
  return out + "}\n";
}

}  // namespace fieldfab::frep
