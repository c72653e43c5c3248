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

int g_group(int code) {
  switch (code) {
    case 40:
    case 100:
    case 280:
    case 281:
    case 300:
    case 301:
    case 520:
    case 920:
    case 921:
    case 922:
    case 923: return static_cast<int>(GGroup::action);
    case 0:
    case 10:
    case 20:
    case 30:
    case 50:
    case 51:
    case 52:
    case 53:
    case 330:
    case 331:
    case 382:
    case 383:
    case 384:
    case 385:
    case 730:
    case 740:
    case 760:
    case 800:
    case 810:
    case 820:
    case 830:
    case 840:
    case 850:
    case 860:
    case 870:
    case 880:
    case 890: return static_cast<int>(GGroup::motion);
    case 170:
    case 180:
    case 190: return static_cast<int>(GGroup::plane);
    case 900:
    case 910: return static_cast<int>(GGroup::distance);
    case 901:
    case 911: return static_cast<int>(GGroup::arc_distance);
    case 930:
    case 940:
    case 950: return static_cast<int>(GGroup::feed_mode);
    case 200:
    case 210: return static_cast<int>(GGroup::units);
    case 400:
    case 410:
    case 411:
    case 420:
    case 421: return static_cast<int>(GGroup::compensation);
    case 430:
    case 431:
    case 432:
    case 434:
    case 490: return static_cast<int>(GGroup::length);
    case 980:
    case 990: return static_cast<int>(GGroup::retract);
    case 540:
    case 550:
    case 560:
    case 570:
    case 580:
    case 590:
    case 591:
    case 592:
    case 593: return static_cast<int>(GGroup::system);
    case 610:
    case 611:
    case 640: return static_cast<int>(GGroup::path);
    case 960:
    case 970: return static_cast<int>(GGroup::spindle_mode);
    case 70:
    case 80: return static_cast<int>(GGroup::lathe);
    case 680:
    case 690: return static_cast<int>(GGroup::rotation);
    default: return Block::none;
  }
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
