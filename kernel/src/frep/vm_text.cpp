// .vm programs: one instruction per line, in the format of the Prospero challenge.
#include <iterator>
#include <optional>
#include <unordered_map>

#include "fieldfab/frep/text.h"
#include "text_source.h"

namespace fieldfab::frep {
namespace {

std::optional<Opcode> opcode_of(std::string_view word) {
  static const auto words = [] {
    std::unordered_map<std::string_view, Opcode> table;
    for (int op = 0; op < opcode_count; ++op) table.emplace(info(static_cast<Opcode>(op)).vm, static_cast<Opcode>(op));
    return table;
  }();
  const auto found = words.find(word);
  return found == words.end() ? std::nullopt : std::optional(found->second);
}

}  // namespace

Expression parse_vm(std::string_view text, std::string_view name) {
  const TextSource source(text, name);
  std::unordered_map<std::string_view, Expression> values;
  std::optional<Expression> last;

  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string_view words[5];
    std::size_t count = 0;
    while (at < end) {
      const char c = text[at];
      if (c == ' ' || c == '\t' || c == '\r') {
        ++at;
        continue;
      }
      if (c == '#') break;
      const std::size_t start = at;
      while (at < end && text[at] != ' ' && text[at] != '\t' && text[at] != '\r') {
        if (static_cast<unsigned char>(text[at]) < 32)
          source.fail(at, fmt::format("{} in a name: this is not a .vm program", source.shown(at)));
        ++at;
      }
      if (count == std::size(words)) source.fail(start, "too many words: expected NAME OP ARGUMENTS");
      words[count++] = text.substr(start, at - start);
    }
    const auto place = [&](std::size_t word) {
      return word < count ? static_cast<std::size_t>(words[word].data() - text.data()) : end;
    };
    at = end + 1;
    if (count == 0) continue;
    if (count == 1) source.fail(place(1), fmt::format("expected an operation after the name {:.40}", words[0]));

    const auto op = opcode_of(words[1]);
    if (!op) source.fail(place(1), fmt::format("unknown operation {:.40}", words[1]));
    const std::size_t arguments = *op == Opcode::constant ? 1 : static_cast<std::size_t>(info(*op).arity);
    if (count != arguments + 2)
      source.fail(place(std::min(count, arguments + 2)),
                  fmt::format("{} takes {} {}, found {}", words[1], arguments,
                              arguments == 1 ? "argument" : "arguments", count - 2));
    const auto argument = [&](std::size_t word) -> const Expression& {
      const auto found = values.find(words[word]);
      if (found == values.end()) source.fail(place(word), fmt::format("unknown name {:.40}", words[word]));
      return found->second;
    };
    Expression value = 0.0;
    if (*op == Opcode::constant) {
      std::size_t number_at = place(2);
      value = source.number(number_at);
      if (number_at != place(2) + words[2].size())
        source.fail(number_at, fmt::format("{:.40} is not a number", words[2]));
    } else {
      value = *op == Opcode::x   ? Expression::x()
              : *op == Opcode::y ? Expression::y()
              : *op == Opcode::z ? Expression::z()
              : arguments == 1   ? Expression::make(*op, argument(2))
                                 : Expression::make(*op, argument(2), argument(3));
    }
    if (!values.emplace(words[0], value).second)
      source.fail(place(0), fmt::format("the name {:.40} is given twice", words[0]));
    if (values.size() > most_operations) source.fail(place(0), fmt::format("more than {} operations", most_operations));
    last = std::move(value);
  }
  if (!last) source.fail(text.size(), "the program is empty");
  return *last;
}

std::string print_vm(const Expression& expression) {
  require_no_opened(expression);
  const Flat flat = flatten(expression);
  fmt::memory_buffer out;
  for (std::size_t i = 0; i < flat.order.size(); ++i) {
    const Flat::Entry& entry = flat.order[i];
    const OpcodeInfo& op = info(entry.op);
    fmt::format_to(std::back_inserter(out), "_{:x} {}", i, op.vm);
    if (entry.op == Opcode::constant) fmt::format_to(std::back_inserter(out), " {}", number_text(entry.constant));
    if (op.arity >= 1) fmt::format_to(std::back_inserter(out), " _{:x}", entry.a);
    if (op.arity == 2) fmt::format_to(std::back_inserter(out), " _{:x}", entry.b);
    out.push_back('\n');
  }
  return fmt::to_string(out);
}

}  // namespace fieldfab::frep
