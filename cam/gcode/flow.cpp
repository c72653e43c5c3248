#include "flow.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "fieldfab/core/error.h"
#include "fieldfab/core/file.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr std::size_t deepest_call = 100;
constexpr std::size_t deepest_block = 1000;
constexpr std::uintmax_t largest_file = 64U << 20;

// A keyword must precede its own prefixes.
constexpr std::array<std::string_view, 15> keywords{"endsub", "sub",       "call",   "return",   "elseif",
                                                    "else",   "endif",     "if",     "endwhile", "while",
                                                    "do",     "endrepeat", "repeat", "break",    "continue"};

}  // namespace

Flow::Flow(std::string_view text, const std::string& file, const std::vector<std::filesystem::path>& folders,
           std::uint64_t most_lines, Parameters& parameters)
    : parameters_(parameters), most_lines_(most_lines) {
  main_.name = file;
  main_.text = text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
  folders_.push_back(std::filesystem::path(file).parent_path());
  folders_.insert(folders_.end(), folders.begin(), folders.end());
  at_.source = &main_;
}

bool Flow::raw_line(Position& position, std::string_view& raw) const {
  const std::string_view text = position.source->text;
  if (position.offset >= text.size()) return false;
  const std::size_t end = std::min(text.find('\n', position.offset), text.size());
  raw = text.substr(position.offset, end - position.offset);
  position.offset = end + 1;
  ++position.line;
  return true;
}

void Flow::count() {
  if (++lines_ > most_lines_) refuse("more than {} blocks: this program seems to have no end", most_lines_);
}

bool Flow::next(Line& line) {
  before_ = at_;
  std::string_view raw;
  if (!raw_line(at_, raw)) {
    line_ = at_.line;
    if (!calls_.empty()) refuse("the file ends within subroutine {}", shown(calls_.back().label));
    if (!open_.empty() && open_.back().kind != Kind::condition)
      refuse("the file ends within the loop o{}", shown(open_.back().label));
    return false;
  }
  line_ = at_.line;
  count();
  line.read(raw);
  return true;
}

double Flow::share() const {
  const Position& position = calls_.empty() ? at_ : calls_.front().back;
  return main_.text.empty()
             ? 1
             : std::min(1.0, static_cast<double>(position.offset) / static_cast<double>(main_.text.size()));
}

bool Flow::is_flow(const Line& line) {
  std::size_t i = 0;
  if (i < line.text.size() && line.text[i] == 'n')
    for (++i; i < line.text.size() && ((line.text[i] >= '0' && line.text[i] <= '9') || line.text[i] == '.');) ++i;
  return i < line.text.size() && line.text[i] == 'o';
}

bool Flow::take_apart(const Line& line, Word& word, bool strict) const {
  if (!is_flow(line)) return false;
  Cursor cursor{line.text};
  skip_line_number(cursor);
  ++cursor.at;
  if (cursor.take('<')) {
    word.label = std::string(read_name(cursor));
  } else if (strict || (cursor.peek() >= '0' && cursor.peek() <= '9')) {
    word.label = std::to_string(read_whole(cursor, parameters_));
  } else {  // a computed label in a skipped range
    try {
      word.label = std::to_string(read_whole(cursor, parameters_));
    } catch (const Refusal&) {
      return false;
    }
  }
  word.keyword.clear();
  for (const std::string_view keyword : keywords)
    if (cursor.take(keyword)) {
      word.keyword = keyword;
      break;
    }
  word.rest = cursor.at;
  if (word.keyword.empty() && !cursor.done()) {
    if (strict) refuse("'{}' is not known behind an O-word", shown(line.text.substr(cursor.at)));
    return false;
  }
  return true;
}

double Flow::condition(const Line& line, const Word& word) const {
  Cursor cursor{line.text, word.rest};
  if (cursor.peek() != '[') refuse("{} needs a condition in brackets", word.keyword);
  const double value = read_value(cursor, parameters_);
  if (!cursor.done()) refuse("'{}' is too much behind {}", shown(line.text.substr(cursor.at)), word.keyword);
  return value;
}

std::string Flow::skip_to(const std::string& label, std::initializer_list<std::string_view> wanted, const char* what) {
  const int from = line_;
  std::string_view raw;
  Line line;
  Word word;
  while (true) {
    before_ = at_;
    if (!raw_line(at_, raw)) break;
    count();
    if (raw.find_first_of("oO") == std::string_view::npos) continue;
    line.read(raw);
    if (!take_apart(line, word, false) || word.label != label) continue;
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
  Word word;
  (void)take_apart(line, word, true);
  if (open_.size() > deepest_block) refuse("more than {} loops and conditions within each other", deepest_block);
  const std::string& keyword = word.keyword;
  if (keyword == "sub") {
    if (!calls_.empty()) refuse("a subroutine cannot be defined within another one");
    subroutines_[word.label] = at_;
    skip_to(word.label, {"endsub"}, "sub");
  } else if (keyword == "endsub" || keyword == "return") {
    if (calls_.empty()) refuse("{} o{} where no subroutine was called", keyword, shown(word.label));
    Cursor cursor{line.text, word.rest};
    value_returned_ = !cursor.done();
    value_ = value_returned_ ? condition(line, word) : 0;
    leave();
  } else if (keyword == "call") {
    call(line, word);
  } else if (keyword.empty()) {
    subroutines_.emplace(word.label, at_);  // O1000 alone: the number of a program, for M98
  } else if (keyword == "if" || keyword == "elseif" || keyword == "else" || keyword == "endif") {
    carry_out_condition(line, word);
  } else {
    carry_out_loop(line, word);
  }
}

void Flow::carry_out_condition(const Line& line, const Word& word) {
  const std::string label = word.label;
  if (word.keyword == "if") {
    bool taken = condition(line, word) != 0;
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
        taken = condition(other, Word{label, "elseif", 8}) != 0;
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

void Flow::carry_out_loop(const Line& line, const Word& word) {
  const std::string label = word.label;
  const std::string& keyword = word.keyword;
  if (keyword == "do") {
    open_.push_back({Kind::do_loop, label, at_, 0});
  } else if (keyword == "while") {
    Open* const open = find_open(label);
    if (open != nullptr && open->kind == Kind::do_loop) {
      const bool more = condition(line, word) != 0;
      close_to(label, Kind::do_loop, "while");
      if (more)
        at_ = open_.back().start;
      else
        open_.pop_back();
    } else if (condition(line, word) != 0) {
      open_.push_back({Kind::loop, label, before_, 0});
    } else {
      skip_to(label, {"endwhile"}, "while");
    }
  } else if (keyword == "endwhile") {
    close_to(label, Kind::loop, "endwhile");
    again(open_.back());
  } else if (keyword == "repeat") {
    const double times = std::round(condition(line, word));
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

std::optional<Position> Flow::find(const Source& source, Position from, const std::string& label, bool program) {
  from.source = &source;
  std::string_view raw;
  Line line;
  Word word;
  while (raw_line(from, raw)) {
    count();
    if (raw.find_first_of("oO") == std::string_view::npos) continue;
    line.read(raw);
    if (!take_apart(line, word, false) || word.label != label) continue;
    if (word.keyword == "sub" || (program && word.keyword.empty())) return from;
  }
  return std::nullopt;
}

const Source* Flow::open_file(const std::string& label) {
  const std::string name = label + ".ngc";
  if (const auto found = files_.find(name); found != files_.end()) return found->second.get();
  if (label.find('/') != std::string::npos || label.find('\0') != std::string::npos || label.size() > 200)
    return nullptr;
  for (const std::filesystem::path& folder : folders_) {
    std::error_code error;
    const std::filesystem::path path = folder / name;
    if (!std::filesystem::is_regular_file(path, error)) continue;
    auto source = std::make_unique<Source>();
    source->name = path.string();
    source->kept = read_file(path, largest_file);
    source->text = source->kept;
    return files_.emplace(name, std::move(source)).first->second.get();
  }
  return nullptr;
}

void Flow::call(const Line& line, const Word& word) {
  std::vector<double> arguments;
  Cursor cursor{line.text, word.rest};
  while (!cursor.done()) {
    if (cursor.peek() != '[')
      refuse("'{}' found where an argument in brackets should be", shown(line.text.substr(cursor.at)));
    arguments.push_back(read_value(cursor, parameters_));
    if (arguments.size() > 30) refuse("more than 30 arguments");
  }
  auto known = subroutines_.find(word.label);
  if (known == subroutines_.end()) {
    auto found = find(*at_.source, at_, word.label, false);
    if (!found) {
      if (const Source* const source = open_file(word.label)) {
        found = find(*source, {}, word.label, false);
        if (!found) refuse("{} does not define o<{}> sub", source->name, shown(word.label));
      }
    }
    if (!found) refuse("there is no subroutine o<{}>, here or in a file {}.ngc", shown(word.label), shown(word.label));
    known = subroutines_.emplace(word.label, *found).first;
  }
  const Position start = known->second;
  enter(word.label, start, arguments, true, 1);
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
  const std::string label = std::to_string(number);
  auto known = subroutines_.find(label);
  if (known == subroutines_.end()) {
    auto found = find(*at_.source, at_, label, true);
    if (!found) found = find(*at_.source, {}, label, true);
    if (!found)
      if (const Source* const source = open_file(label)) found = find(*source, {}, label, true);
    if (!found) refuse("there is no program O{}, here or in a file {}.ngc", number, number);
    known = subroutines_.emplace(label, *found).first;
  }
  const Position start = known->second;
  if (repeats > 0) enter(label, start, {}, false, repeats);
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
