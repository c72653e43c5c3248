#include "sources.h"

#include <algorithm>
#include <array>

#include "fieldfab/core/file.h"

namespace fieldfab::cam::gcode {
namespace {

constexpr std::uintmax_t largest_file = 64U << 20;

// A keyword must precede its own prefixes.
constexpr std::array<std::string_view, 15> keywords{"endsub", "sub",       "call",   "return",   "elseif",
                                                    "else",   "endif",     "if",     "endwhile", "while",
                                                    "do",     "endrepeat", "repeat", "break",    "continue"};

}  // namespace

bool read_raw_line(Position& position, std::string_view& raw) {
  const std::string_view text = position.source->text;
  if (position.offset >= text.size()) return false;
  const std::size_t end = std::min(text.find('\n', position.offset), text.size());
  raw = text.substr(position.offset, end - position.offset);
  position.offset = end + 1;
  ++position.line;
  return true;
}

bool is_flow(const Line& line) {
  std::size_t i = 0;
  if (i < line.text.size() && line.text[i] == 'n')
    for (++i; i < line.text.size() && ((line.text[i] >= '0' && line.text[i] <= '9') || line.text[i] == '.');) ++i;
  return i < line.text.size() && line.text[i] == 'o';
}

bool read_flow_word(const Line& line, const Parameters& parameters, FlowWord& word, bool strict) {
  if (!is_flow(line)) return false;
  Cursor cursor{line.text};
  skip_line_number(cursor);
  ++cursor.at;
  if (cursor.take('<')) {
    word.label = std::string(read_name(cursor));
  } else if (strict || (cursor.peek() >= '0' && cursor.peek() <= '9')) {
    word.label = std::to_string(read_whole(cursor, parameters));
  } else {  // a computed label in a skipped range
    try {
      word.label = std::to_string(read_whole(cursor, parameters));
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

Sources::Sources(std::string_view text, const std::string& file, const std::vector<std::filesystem::path>& folders,
                 LineCount& count, const Parameters& parameters)
    : count_(count), parameters_(parameters) {
  program_.name = file;
  program_.text = text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text;
  folders_.push_back(std::filesystem::path(file).parent_path());
  folders_.insert(folders_.end(), folders.begin(), folders.end());
}

std::optional<Position> Sources::find(Position from, const std::string& label, bool program) {
  std::string_view raw;
  Line line;
  FlowWord word;
  while (read_raw_line(from, raw)) {
    count_.add();
    if (raw.find_first_of("oO") == std::string_view::npos) continue;
    line.read(raw);
    if (!read_flow_word(line, parameters_, word, false) || word.label != label) continue;
    if (word.keyword == "sub" || (program && word.keyword.empty())) return from;
  }
  return std::nullopt;
}

const Source* Sources::open_file(const std::string& label) {
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

Position Sources::subroutine(const std::string& label, const Position& from) {
  if (const auto known = places_.find(label); known != places_.end()) return known->second;
  auto found = find(from, label, false);
  if (!found) {
    if (const Source* const source = open_file(label)) {
      found = find({source}, label, false);
      if (!found) refuse("{} does not define o<{}> sub", source->name, shown(label));
    }
  }
  if (!found) refuse("there is no subroutine o<{}>, here or in a file {}.ngc", shown(label), shown(label));
  return places_.emplace(label, *found).first->second;
}

Position Sources::program(int number, const Position& from) {
  const std::string label = std::to_string(number);
  if (const auto known = places_.find(label); known != places_.end()) return known->second;
  auto found = find(from, label, true);
  if (!found) found = find({from.source}, label, true);
  if (!found)
    if (const Source* const source = open_file(label)) found = find({source}, label, true);
  if (!found) refuse("there is no program O{}, here or in a file {}.ngc", number, number);
  return places_.emplace(label, *found).first->second;
}

}  // namespace fieldfab::cam::gcode
