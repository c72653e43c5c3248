// Prefix math strings (Keeter Appendix A).
#include <array>
#include <utility>

#include "fieldfab/frep/text.h"
#include "text_source.h"

namespace fieldfab::frep {
namespace {

/// Returns the operation of each letter; `constant` for letters without one.
std::array<Opcode, 128> find_letters() {
  std::array<Opcode, 128> letters;
  letters.fill(Opcode::constant);
  for (int op = static_cast<int>(Opcode::x); op < opcode_count; ++op)
    letters[static_cast<unsigned char>(info(static_cast<Opcode>(op)).math)] = static_cast<Opcode>(op);
  return letters;
}

/// Parses a math string with explicit stacks, so that depth costs memory only.
class MathParser {
 public:
  MathParser(std::string_view text, std::string_view name) : source_(text, name) {}

  Expression parse() {
    const std::string_view text = source_.text();
    while (!done_) {
      if (at_ >= text.size()) source_.fail(at_, waiting_.empty() ? "the expression is empty" : missing_argument());
      read_token(text[at_]);
    }
    for (; at_ < text.size(); ++at_)
      if (std::string_view(" \t\r\n").find(text[at_]) == std::string_view::npos)
        source_.fail(at_, fmt::format("the expression ends here, but {} follows", source_.shown(at_)));
    return result_;
  }

 private:
  enum class Expects : std::uint8_t { first, second, map_x, map_y, map_z, map_body };
  struct Waiting {
    Opcode op;
    Expects expects;
  };
  struct Coordinates {
    Expression x, y, z;
  };

  void read_token(char c) {
    static const std::array<Opcode, 128> letters = find_letters();
    if (c == 'f') {
      ++at_;
      deliver(source_.number(at_));
      return;
    }
    if (c == ' ' && !waiting_.empty() && waiting_.back().expects >= Expects::map_x &&
        waiting_.back().expects <= Expects::map_z) {
      ++at_;
      const Expects which = waiting_.back().expects;
      deliver(which == Expects::map_x ? now_.x : which == Expects::map_y ? now_.y : now_.z);
      return;
    }
    if (c == 'm') {
      waiting_.push_back({Opcode::constant, Expects::map_x});
      ++at_;
      return;
    }
    const Opcode op = c > 0 ? letters[static_cast<unsigned char>(c)] : Opcode::constant;
    if (op == Opcode::constant) source_.fail(at_, fmt::format("unknown operation {}", source_.shown(at_)));
    ++at_;
    if (op == Opcode::x || op == Opcode::y || op == Opcode::z)
      deliver(op == Opcode::x ? now_.x : op == Opcode::y ? now_.y : now_.z);
    else
      waiting_.push_back({op, Expects::first});
  }

  /// Passes a finished value to the operation that waits for it, and then the result of that
  /// operation to the next one.
  void deliver(Expression value) {
    while (!waiting_.empty()) {
      Waiting& top = waiting_.back();
      switch (top.expects) {
        case Expects::first:
          if (info(top.op).arity == 2) {
            firsts_.push_back(std::move(value));
            top.expects = Expects::second;
            return;
          }
          value = Expression::make(top.op, value);
          break;
        case Expects::second:
          value = Expression::make(top.op, firsts_.back(), value);
          firsts_.pop_back();
          break;
        case Expects::map_x:
        case Expects::map_y:
          firsts_.push_back(std::move(value));
          top.expects = top.expects == Expects::map_x ? Expects::map_y : Expects::map_z;
          return;
        case Expects::map_z: {
          Expression y = std::move(firsts_.back());
          firsts_.pop_back();
          Expression x = std::move(firsts_.back());
          firsts_.pop_back();
          outer_.push_back(std::exchange(now_, Coordinates{std::move(x), std::move(y), std::move(value)}));
          top.expects = Expects::map_body;
          return;
        }
        case Expects::map_body:
          now_ = std::move(outer_.back());
          outer_.pop_back();
          break;
      }
      waiting_.pop_back();
      if (++operations_ > most_operations) source_.fail(at_, fmt::format("more than {} operations", most_operations));
    }
    result_ = std::move(value);
    done_ = true;
  }

  [[nodiscard]] std::string missing_argument() const {
    const Waiting& top = waiting_.back();
    if (top.expects >= Expects::map_x) return "the map operation 'm' lacks an argument";
    return fmt::format("operation '{}' lacks an argument", info(top.op).math);
  }

  TextSource source_;
  std::size_t at_ = 0, operations_ = 0;
  std::vector<Waiting> waiting_;
  std::vector<Expression> firsts_;  ///< finished arguments of operations that wait for more
  Coordinates now_{Expression::x(), Expression::y(), Expression::z()};
  std::vector<Coordinates> outer_;
  Expression result_ = 0.0;
  bool done_ = false;
};

}  // namespace

Expression parse_math(std::string_view text, std::string_view name) { return MathParser(text, name).parse(); }

std::string print_math(const Expression& expression) {
  // A shared part is written at each use; so the length is computed first.
  require_no_opened(expression);
  const Flat flat = flatten(expression);
  constexpr double most_bytes = 64e6;
  std::vector<double> bytes(flat.order.size());
  for (std::size_t i = 0; i < flat.order.size(); ++i) {
    const Flat::Entry& entry = flat.order[i];
    const int arity = info(entry.op).arity;
    bytes[i] = 1 + (arity >= 1 ? bytes[entry.a] : 0) + (arity == 2 ? bytes[entry.b] : 0);
  }
  if (bytes.back() > most_bytes)
    throw Error(ErrorKind::too_large, "",
                "as a math string this expression would be larger than 64 MB, since shared parts are repeated; write "
                ".vm or .frep");

  std::string text;
  std::vector<std::uint32_t> stack{static_cast<std::uint32_t>(flat.order.size() - 1)};
  while (!stack.empty()) {
    const Flat::Entry& entry = flat.order[stack.back()];
    stack.pop_back();
    text += info(entry.op).math;
    if (entry.op == Opcode::constant) text += number_text(entry.constant);
    if (info(entry.op).arity == 2) stack.push_back(entry.b);
    if (info(entry.op).arity >= 1) stack.push_back(entry.a);
  }
  return text;
}

}  // namespace fieldfab::frep
