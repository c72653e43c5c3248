#include "flow.h"

#include <algorithm>
#include <cmath>

namespace fieldfab::cam::gcode {
namespace {

constexpr std::size_t deepest_call = 100;
constexpr std::size_t deepest_block = 1000;

/// The condition or value in brackets after a keyword.
double condition(const Line& line, const FlowWord& word, const Parameters& parameters) {
  Cursor cursor{line.text, word.rest};
  if (cursor.peek() != '[') refuse("{} needs a condition in brackets", word.keyword);
  const double value = read_value(cursor, parameters);
  if (!cursor.done()) refuse("'{}' is too much behind {}", shown(line.text.substr(cursor.at)), word.keyword);
  return value;
}

}  // namespace

Flow::Flow(std::string_view text, const std::string& file, const std::vector<std::filesystem::path>& folders,
           LineCount& count, Parameters& parameters)
    : count_(count), parameters_(parameters), sources_(text, file, folders, count, parameters) {
  at_.source = &sources_.program();
}

bool Flow::next(Line& line) {
  before_ = at_;
  std::string_view raw;
  if (!read_raw_line(at_, raw)) {
    line_ = at_.line;
    if (!calls_.empty()) refuse("the file ends within subroutine {}", shown(calls_.back().label));
    if (!open_.empty() && open_.back().kind != Kind::condition)
      refuse("the file ends within the loop o{}", shown(open_.back().label));
    return false;
  }
  line_ = at_.line;
  count_.add();
  line.read(raw);
  return true;
}

double Flow::share() const {
  const Position& position = calls_.empty() ? at_ : calls_.front().back;
  const std::size_t size = sources_.program().text.size();
  return size == 0 ? 1 : std::min(1.0, static_cast<double>(position.offset) / static_cast<double>(size));
}

std::string Flow::skip_to(const std::string& label, std::initializer_list<std::string_view> wanted, const char* what) {
  const int from = line_;
  std::string_view raw;
  Line line;
  FlowWord word;
  while (true) {
    before_ = at_;
    if (!read_raw_line(at_, raw)) break;
    count_.add();
    if (raw.find_first_of("oO") == std::string_view::npos) continue;
    line.read(raw);
    if (!read_flow_word(line, parameters_, word, false) || word.label != label) continue;
    if (std::find(wanted.begin(), wanted.end(), word.keyword) == wanted.end()) continue;
    line_ = at_.line;
    return word.keyword + line.text.substr(word.rest);
  }
  line_ = from;
  refuse("{} o{} has no end", what, shown(label));
}

Flow::Open* Flow::find_open(const std::string& label) {
  for (auto open = open_.rbegin(); open != open_.rend(); ++open)
    if (open->label == label) return &*open;
  return nullptr;
}

void Flow::close_to(const std::string& label, Kind kind, const char* what) {
  while (!open_.empty() && !(open_.back().label == label && open_.back().kind == kind)) open_.pop_back();
  if (open_.empty()) refuse("{} o{} where none has begun", what, shown(label));
}

void Flow::carry_out(const Line& line) {
  FlowWord word;
  (void)read_flow_word(line, parameters_, word, true);
  if (open_.size() > deepest_block) refuse("more than {} loops and conditions within each other", deepest_block);
  const std::string& keyword = word.keyword;
  if (keyword == "sub") {
    if (!calls_.empty()) refuse("a subroutine cannot be defined within another one");
    sources_.define_subroutine(word.label, at_);
    skip_to(word.label, {"endsub"}, "sub");
  } else if (keyword == "endsub" || keyword == "return") {
    if (calls_.empty()) refuse("{} o{} where no subroutine was called", keyword, shown(word.label));
    Cursor cursor{line.text, word.rest};
    value_returned_ = !cursor.done();
    value_ = value_returned_ ? condition(line, word, parameters_) : 0;
    leave();
  } else if (keyword == "call") {
    call(line, word);
  } else if (keyword.empty()) {
    sources_.define_program(word.label, at_);  // O1000 alone: the number of a program, for M98
  } else if (keyword == "if" || keyword == "elseif" || keyword == "else" || keyword == "endif") {
    carry_out_condition(line, word);
  } else {
    carry_out_loop(line, word);
  }
}

void Flow::carry_out_condition(const Line& line, const FlowWord& word) {
  const std::string label = word.label;
  if (word.keyword == "if") {
    bool taken = condition(line, word, parameters_) != 0;
    open_.push_back({Kind::condition, label, {}, 0});
    while (!taken) {
      const std::string found = skip_to(label, {"elseif", "else", "endif"}, "if");
      if (found == "endif") {
        open_.pop_back();
        break;
      }
      taken = found == "else";
      if (!taken) {
        Line other;
        other.text = "o1" + found;
        taken = condition(other, FlowWord{label, "elseif", 8}, parameters_) != 0;
      }
    }
  } else {
    close_to(label, Kind::condition, word.keyword.c_str());
    if (word.keyword != "endif") skip_to(label, {"endif"}, "if");  // an earlier branch was executed
    open_.pop_back();
  }
}

void Flow::again(Open& loop) {
  if (loop.kind == Kind::repeat) {
    if (--loop.left > 0) {
      at_ = loop.start;
    } else {
      const std::string label = loop.label;
      skip_to(label, {"endrepeat"}, "repeat");
      open_.pop_back();
    }
  } else if (loop.kind == Kind::loop) {
    at_ = loop.start;  // before WHILE, whose condition is evaluated again
    open_.pop_back();
  } else {
    skip_to(loop.label, {"while"}, "do");  // its condition decides on another round
    at_ = before_;
  }
}

void Flow::carry_out_loop(const Line& line, const FlowWord& word) {
  const std::string label = word.label;
  const std::string& keyword = word.keyword;
  if (keyword == "do") {
    open_.push_back({Kind::do_loop, label, at_, 0});
  } else if (keyword == "while") {
    Open* const open = find_open(label);
    if (open != nullptr && open->kind == Kind::do_loop) {
      const bool more = condition(line, word, parameters_) != 0;
      close_to(label, Kind::do_loop, "while");
      if (more)
        at_ = open_.back().start;
      else
        open_.pop_back();
    } else if (condition(line, word, parameters_) != 0) {
      open_.push_back({Kind::loop, label, before_, 0});
    } else {
      skip_to(label, {"endwhile"}, "while");
    }
  } else if (keyword == "endwhile") {
    close_to(label, Kind::loop, "endwhile");
    again(open_.back());
  } else if (keyword == "repeat") {
    const double times = std::round(condition(line, word, parameters_));
    if (times > 9e15) refuse("{} repeats", times);
    if (times >= 1)
      open_.push_back({Kind::repeat, label, at_, static_cast<std::int64_t>(times)});
    else
      skip_to(label, {"endrepeat"}, "repeat");
  } else if (keyword == "endrepeat") {
    close_to(label, Kind::repeat, "endrepeat");
    if (--open_.back().left > 0)
      at_ = open_.back().start;
    else
      open_.pop_back();
  } else {
    const Open* const open = find_open(label);
    if (open == nullptr || open->kind == Kind::condition)
      refuse("{} o{} outside of such a loop", keyword, shown(label));
    close_to(label, open->kind, keyword.c_str());
    if (keyword == "continue") return again(open_.back());
    const Kind kind = open_.back().kind;
    skip_to(label, {kind == Kind::do_loop ? "while" : kind == Kind::loop ? "endwhile" : "endrepeat"}, "loop");
    open_.pop_back();
  }
}

void Flow::call(const Line& line, const FlowWord& word) {
  std::vector<double> arguments;
  Cursor cursor{line.text, word.rest};
  while (!cursor.done()) {
    if (cursor.peek() != '[')
      refuse("'{}' found where an argument in brackets should be", shown(line.text.substr(cursor.at)));
    arguments.push_back(read_value(cursor, parameters_));
    if (arguments.size() > 30) refuse("more than 30 arguments");
  }
  enter(word.label, sources_.subroutine(word.label, at_), arguments, true, 1);
}

void Flow::enter(const std::string& label, const Position& start, const std::vector<double>& arguments,
                 bool own_numbers, int repeats) {
  if (calls_.size() >= deepest_call) refuse("more than {} subroutines within each other", deepest_call);
  parameters_.enter(arguments, own_numbers);
  calls_.push_back({at_, start, std::move(open_), own_numbers, repeats, label});
  open_.clear();
  at_ = start;
}

void Flow::leave() {
  Call& call = calls_.back();
  parameters_.leave(call.own_numbers);
  at_ = call.back;
  open_ = std::move(call.open);
  calls_.pop_back();
  if (returned_) returned_();
}

void Flow::call_program(int number, int repeats) {
  const Position start = sources_.program(number, at_);
  if (repeats > 0) enter(std::to_string(number), start, {}, false, repeats);
}

bool Flow::return_program() {
  if (calls_.empty()) return false;
  Call& call = calls_.back();
  if (--call.repeats > 0) {
    at_ = call.start;
    open_.clear();
  } else {
    leave();
  }
  return true;
}

}  // namespace fieldfab::cam::gcode
