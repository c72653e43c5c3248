// Expressions and parts as .frep text.
#include <algorithm>

#include "fieldfab/frep/text.h"
#include "text_source.h"

namespace fieldfab::frep {
namespace {

/// An expression as lines of definitions, and its result in terms of them.
struct Printed {
  std::string bindings, result;
};

std::string text_of(const Source& source, const std::filesystem::path& folder) {
  if (source.path.empty())
    throw Error(ErrorKind::bad_input, "",
                "a solid that was made in memory has no text: save it as a file, and open that");
  std::filesystem::path path = source.path;
  if (!folder.empty())
    if (const auto inner = path.lexically_relative(folder); !inner.empty() && *inner.begin() != "..") path = inner;
  return fmt::format("open({}{}{})", in_quotes(path.generic_string()), source.options.empty() ? "" : ", ",
                     source.options);
}

Printed printed(const Expression& expression, const std::filesystem::path& folder) {
  const Flat flat = flatten(expression);
  const std::size_t count = flat.order.size();
  std::vector<std::uint32_t> uses(count), height(count);
  for (const Flat::Entry& entry : flat.order) {
    if (info(entry.op).arity >= 1) ++uses[entry.a];
    if (info(entry.op).arity >= 2) ++uses[entry.b];
    if (info(entry.op).arity == 3) ++uses[entry.c];
  }
  // Subexpressions that are used more than once, or that would nest too deep to read, get a name.
  constexpr std::uint32_t deepest = 12;
  std::string bindings;
  std::vector<std::string> text(count);
  std::vector<bool> atom(count);
  for (std::size_t i = 0; i < count; ++i) {
    const Flat::Entry& entry = flat.order[i];
    const OpcodeInfo& op = info(entry.op);
    const auto take = [&](std::uint32_t argument, bool bare) {
      std::string part = uses[argument] == 1 ? std::move(text[argument]) : text[argument];
      return bare || atom[argument] ? part : "(" + part + ")";
    };
    switch (op.arity) {
      case 0:
        text[i] = entry.op == Opcode::constant ? number_text(entry.constant) : std::string(op.infix);
        atom[i] = entry.op != Opcode::constant || entry.constant >= 0;
        break;
      case 1:
        height[i] = height[entry.a] + 1;
        atom[i] = entry.op != Opcode::negate;
        text[i] = entry.op == Opcode::negate ? "-(" + take(entry.a, true) + ")"
                                             : fmt::format("{}({})", op.infix, take(entry.a, true));
        break;
      case 3: {
        height[i] = std::max({height[entry.a], height[entry.b], height[entry.c]}) + 1;
        atom[i] = true;
        const std::string file = text_of(*entry.source, folder), x = take(entry.a, true), y = take(entry.b, true);
        const std::string z = take(entry.c, true);
        text[i] = x == "x" && y == "y" && z == "z" ? fmt::format("value({})", file)
                                                   : fmt::format("value(map({}, {}, {}, {}))", file, x, y, z);
        break;
      }
      default:
        height[i] = std::max(height[entry.a], height[entry.b]) + 1;
        if (op.infix.size() == 1) {
          text[i] = take(entry.a, false);
          text[i] += fmt::format(" {} {}", op.infix, take(entry.b, false));
        } else {
          text[i] = fmt::format("{}({}", op.infix, take(entry.a, true));
          text[i] += fmt::format(", {})", take(entry.b, true));
          atom[i] = true;
        }
    }
    if (op.arity > 0 && i + 1 < count && (uses[i] > 1 || height[i] >= deepest)) {
      const std::string bound = fmt::format("t{}", i);
      bindings += bound + " = " + text[i] + "\n";
      text[i] = bound;
      atom[i] = true;
      height[i] = 0;
    }
  }
  return {std::move(bindings), std::move(text.back())};
}

/// "part 3", with primes appended while another part has that name.
std::string free_name(std::ptrdiff_t number, std::span<const TextPart> parts) {
  std::string name = fmt::format("part {}", number);
  while (std::ranges::any_of(parts, [&](const TextPart& other) { return other.name == name; })) name += '\'';
  return name;
}

}  // namespace

std::string in_quotes(std::string_view words) {
  std::string text = "\"";
  for (const char c : words) {
    if (c == '"' || c == '\\' || c == '\n') text += '\\';
    text += c == '\n' ? 'n' : c;
  }
  return text + '"';
}

std::string print_infix(const Expression& expression, const std::filesystem::path& folder) {
  const Printed all = printed(expression, folder);
  return all.bindings + all.result + "\n";
}

std::string print_parts(std::span<const TextPart> parts, const std::filesystem::path& folder) {
  std::string out;
  for (const TextPart& part : parts) {
    const Printed shape = printed(part.shape, folder);
    std::string name = part.name;
    if (name.empty() && (parts.size() > 1 || part.colour)) name = free_name(&part - parts.data() + 1, parts);
    const std::string colour = part.colour ? ", " + in_quotes(text_of(*part.colour)) : "";
    out += shape.bindings +
           (name.empty() ? shape.result : fmt::format("part({}, {}{})", shape.result, in_quotes(name), colour)) + "\n";
  }
  return out;
}

}  // namespace fieldfab::frep
