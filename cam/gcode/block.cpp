#include "block.h"

#include <cmath>

#include "dialect.h"
#include "refusal.h"

namespace fieldfab::cam::gcode {
namespace {

enum class Letter : std::uint8_t { plain, space, open, semicolon };

constexpr std::array<Letter, 256> letter_kinds() {
  std::array<Letter, 256> kinds{};
  for (const char c : {' ', '\t', '\r', '\n', '\v', '\f', '\0'}) kinds[static_cast<unsigned char>(c)] = Letter::space;
  kinds['('] = Letter::open;
  kinds[';'] = Letter::semicolon;
  return kinds;
}
constexpr std::array<Letter, 256> kinds = letter_kinds();

constexpr std::size_t g_codes = 1000;  // times ten

/// The modal group of each G code.
constexpr auto g_groups = [] {
  std::array<std::int8_t, g_codes> groups{};
  for (std::int8_t& group : groups) group = Block::none;
  const auto add = [&](GGroup group, std::initializer_list<std::size_t> codes) {
    for (const std::size_t code : codes) groups[code] = static_cast<std::int8_t>(group);
  };
  add(GGroup::action, {40, 100, 280, 281, 300, 301, 520, 920, 921, 922, 923});
  add(GGroup::motion, {0,   10,  20,  30,  50,  51,  52,  53,  330, 331, 382, 383, 384, 385,
                       730, 740, 760, 800, 810, 820, 830, 840, 850, 860, 870, 880, 890});
  add(GGroup::plane, {170, 180, 190});
  add(GGroup::distance, {900, 910});
  add(GGroup::arc_distance, {901, 911});
  add(GGroup::feed_mode, {930, 940, 950});
  add(GGroup::units, {200, 210});
  add(GGroup::compensation, {400, 410, 411, 420, 421});
  add(GGroup::length, {430, 431, 432, 434, 490});
  add(GGroup::retract, {980, 990});
  add(GGroup::system, {540, 550, 560, 570, 580, 590, 591, 592, 593});
  add(GGroup::path, {610, 611, 640});
  add(GGroup::spindle_mode, {960, 970});
  add(GGroup::lathe, {70, 80});
  add(GGroup::rotation, {680, 690});
  return groups;
}();

int g_group(int code) {
  const auto at = static_cast<std::size_t>(code);  // beyond the codes if below 0
  return at < g_codes ? g_groups[at] : Block::none;
}

int m_group(int code) {
  switch (code) {
    case 0:
    case 1:
    case 2:
    case 30:
    case 60:
    case 98:
    case 99: return static_cast<int>(MGroup::stop);
    case 62:
    case 63:
    case 64:
    case 65:
    case 66:
    case 67:
    case 68: return static_cast<int>(MGroup::in_out);
    case 6:
    case 61: return static_cast<int>(MGroup::tool);
    case 3:
    case 4:
    case 5:
    case 19: return static_cast<int>(MGroup::spindle);
    case 7:
    case 8:
    case 9: return static_cast<int>(MGroup::coolant);
    case 48:
    case 49:
    case 50:
    case 51:
    case 52:
    case 53: return static_cast<int>(MGroup::override_);
    case 70:
    case 71:
    case 72:
    case 73: return static_cast<int>(MGroup::state);
    case 428:
    case 429:
    case 430: return static_cast<int>(MGroup::kinematics);
    default: return code >= 100 ? static_cast<int>(MGroup::user) : Block::none;
  }
}

int read_g_code(double value) {
  if (value < 0) refuse("G{} is below 0", value);
  const double tenfold = std::round(value * 10);
  if (!(std::abs(value * 10 - tenfold) <= 0.001) || tenfold > 9999) refuse("there is no G{}", value);
  return static_cast<int>(tenfold);
}

}  // namespace

void Line::read(std::string_view raw) {
  text.clear();
  comment = {};
  deleted = false;
  closed = true;
  for (std::size_t i = 0; i < raw.size(); ++i) {
    const char c = raw[i];
    switch (kinds[static_cast<unsigned char>(c)]) {
      case Letter::plain:
        if (c == '/' && text.empty())
          deleted = true;
        else
          text.push_back(c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c);
        break;
      case Letter::space: break;
      case Letter::open: {
        const std::size_t end = raw.find(')', i);
        closed = end != std::string_view::npos;
        comment = raw.substr(i + 1, closed ? end - i - 1 : raw.size());
        i = closed ? end : raw.size();
        break;
      }
      case Letter::semicolon:
        comment = raw.substr(i + 1);
        i = raw.size();
        break;
    }
  }
}

void Block::clear() {
  g.fill(none);
  m.fill(none);
  words = 0;
  has_radius = has_angle = machine_coordinates = passed_over = false;
  spindle = none;
}

std::string g_name(int code) {
  return code % 10 == 0 ? fmt::format("G{}", code / 10) : fmt::format("G{}.{}", code / 10, code % 10);
}

void skip_line_number(Cursor& cursor) {
  if (!cursor.take('n')) return;
  const std::size_t begin = cursor.at;
  while (cursor.peek() >= '0' && cursor.peek() <= '9') ++cursor.at;
  if (cursor.at == begin) refuse("N without its number");
  if (cursor.take('.'))
    while (cursor.peek() >= '0' && cursor.peek() <= '9') ++cursor.at;
}

void BlockReader::read(std::string_view text, Block& block) {
  block.clear();
  settings_.clear();
  Cursor cursor{text};
  skip_line_number(cursor);
  while (!cursor.done()) {
    const char c = cursor.peek();
    if (c >= 'a' && c <= 'z') {
      read_word(cursor, block);
    } else if (cursor.take('#')) {
      read_setting(cursor);
    } else if (cursor.take('@')) {
      if (std::exchange(block.has_radius, true)) refuse("two @ words in one block");
      block.radius = read_value(cursor, parameters_);
    } else if (cursor.take('^')) {
      if (std::exchange(block.has_angle, true)) refuse("two ^ words in one block");
      block.angle = read_value(cursor, parameters_);
    } else if (cursor.take('$')) {
      if (block.spindle != Block::none) refuse("two $ words in one block");
      block.spindle = read_whole(cursor, parameters_);
    } else {
      refuse("'{}' cannot begin a word", shown(text.substr(cursor.at)));
    }
  }
  for (const auto& [parameter, value] : settings_) {
    if (const int* const numbered = std::get_if<int>(&parameter))
      parameters_.set(*numbered, value);
    else
      parameters_.set(std::get<std::string>(parameter), value);
  }
}

void BlockReader::read_word(Cursor& cursor, Block& block) {
  const char letter = cursor.peek();
  ++cursor.at;
  if (letter == 'g') {
    read_g(read_g_code(read_value(cursor, parameters_)), block);
  } else if (letter == 'm') {
    read_m(read_whole(cursor, parameters_), block);
  } else if (letter == 'n' || letter == 'o') {
    refuse("{} may only stand at a block's beginning", letter == 'n' ? 'N' : 'O');
  } else {
    const unsigned bit = static_cast<unsigned>(letter - 'a');
    if ((block.words >> bit & 1U) != 0) refuse("two {} words in one block", static_cast<char>(letter - 32));
    block.words |= 1U << bit;
    block.values[bit] = read_value(cursor, parameters_);
  }
}

void BlockReader::read_g(int code, Block& block) {
  if (code == 530) {
    if (std::exchange(block.machine_coordinates, true)) refuse("two G53 in one block");
    return;
  }
  if (const auto what = passed_over_g(dialect_, code)) {
    note_(fmt::format("{} ({}) is passed over", g_name(code), *what));
    block.passed_over = true;
    return;
  }
  const int group = g_group(code);
  if (group == Block::none) refuse("{} is not known here", g_name(code));
  int& place = block.g[static_cast<std::size_t>(group)];
  if (place == Block::none) {
    place = code;
    return;
  }
  if (dialect_ == Dialect::linuxcnc || group == static_cast<int>(GGroup::action))
    refuse("{} and {} exclude each other in one block", g_name(place), g_name(code));
  constexpr int end_of_cycles = 800;
  if (place != end_of_cycles && code != end_of_cycles && place != code)
    note_(fmt::format("{} and {} in one block: the last one holds", g_name(place), g_name(code)));
  if (code != end_of_cycles) place = code;
}

void BlockReader::read_m(int code, Block& block) {
  int group = code < 0 ? Block::none : m_group(code);
  // M70 to M73 save LinuxCNC's modal state. On other controls they are machine functions.
  if (group == static_cast<int>(MGroup::state) && dialect_ != Dialect::linuxcnc) group = Block::none;
  if (group == static_cast<int>(MGroup::user) && dialect_ != Dialect::linuxcnc) group = Block::none;
  if (group == Block::none && passes_over_m(dialect_, code)) {
    note_(fmt::format("M{} has no meaning here: passed over", code));
    block.passed_over = true;
    return;
  }
  if (group == Block::none) refuse("M{} is not known here", code);
  int& place = block.m[static_cast<std::size_t>(group)];
  if (place != Block::none && place != code) {
    if (dialect_ == Dialect::linuxcnc) refuse("M{} and M{} exclude each other in one block", place, code);
    note_(fmt::format("M{} and M{} in one block: the last one holds", place, code));
  } else if (place == code && dialect_ == Dialect::linuxcnc) {
    refuse("M{} and M{} exclude each other in one block", place, code);
  }
  place = code;
}

void BlockReader::read_setting(Cursor& cursor) {
  std::variant<int, std::string> parameter;
  if (cursor.take('<'))
    parameter = std::string(read_name(cursor));
  else
    parameter = read_whole(cursor, parameters_);
  if (!cursor.take('=')) refuse("'=' is missing behind a parameter that begins a word");
  settings_.emplace_back(std::move(parameter), read_value(cursor, parameters_));
}

}  // namespace fieldfab::cam::gcode
