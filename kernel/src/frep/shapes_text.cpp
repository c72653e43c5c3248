// Text in a stroke font. Each glyph consists of a few lines with round ends, so that its distance
// is exact and any weight looks right.
#include <algorithm>
#include <string>
#include <unordered_map>
#include <vector>

#include "fieldfab/core/error.h"
#include "shapes_common.h"

namespace fieldfab::frep::shapes {
namespace {

/// Lines through points "xy", one digit each: x from 0 to 4; y is 0 for descenders, 2 for the base
/// line, 6 for the x-height and 8 for capitals. A line of one point is a dot.
const std::unordered_map<char, const char*>& glyphs() {
  static const std::unordered_map<char, const char*> table{
      {'A', "02 06 18 38 46 42, 05 45"},
      {'B', "02 08 38 47 46 35 05, 35 44 43 32 02"},
      {'C', "47 38 18 07 03 12 32 43"},
      {'D', "02 08 28 46 44 22 02"},
      {'E', "42 02 08 48, 05 35"},
      {'F', "02 08 48, 05 35"},
      {'G', "47 38 18 07 03 12 32 43 45 25"},
      {'H', "02 08, 42 48, 05 45"},
      {'I', "12 32, 18 38, 22 28"},
      {'J', "03 12 32 43 48"},
      {'K', "02 08, 48 05 42"},
      {'L', "08 02 42"},
      {'M', "02 08 25 48 42"},
      {'N', "02 08 42 48"},
      {'O', "12 32 43 47 38 18 07 03 12"},
      {'P', "02 08 38 47 46 35 05"},
      {'Q', "12 32 43 47 38 18 07 03 12, 24 42"},
      {'R', "02 08 38 47 46 35 05, 25 42"},
      {'S', "47 38 18 07 06 15 35 44 43 32 12 03"},
      {'T', "08 48, 28 22"},
      {'U', "08 03 12 32 43 48"},
      {'V', "08 22 48"},
      {'W', "08 12 25 32 48"},
      {'X', "02 48, 08 42"},
      {'Y', "08 25 48, 25 22"},
      {'Z', "08 48 02 42"},
      {'a', "16 36 45 42, 44 14 03 12 32 43"},
      {'b', "08 02, 05 16 36 45 43 32 12 03"},
      {'c', "45 36 16 05 03 12 32 43"},
      {'d', "48 42, 45 36 16 05 03 12 32 43"},
      {'e', "04 44 45 36 16 05 03 12 32 43"},
      {'f', "12 17 28 38, 06 36"},
      {'g', "46 41 30 10 01, 45 36 16 05 03 12 32 43"},
      {'h', "02 08, 05 16 36 45 42"},
      {'i', "16 26 22, 12 32, 28"},
      {'j', "26 36 31 20 10 01, 38"},
      {'k', "02 08, 46 04 42"},
      {'l', "18 28 22, 12 32"},
      {'m', "02 06, 05 16 25 22, 25 36 45 42"},
      {'n', "02 06, 05 16 36 45 42"},
      {'o', "16 36 45 43 32 12 03 05 16"},
      {'p', "00 06, 05 16 36 45 43 32 12 03"},
      {'q', "40 46, 45 36 16 05 03 12 32 43"},
      {'r', "02 06, 05 16 36 45"},
      {'s', "45 36 16 05 14 34 43 32 12 03"},
      {'t', "18 13 22 32 43, 06 36"},
      {'u', "06 03 12 32 43, 46 42"},
      {'v', "06 22 46"},
      {'w', "06 12 24 32 46"},
      {'x', "02 46, 06 42"},
      {'y', "06 03 12 32 43, 46 41 30 10 01"},
      {'z', "06 46 02 42"},
      {'0', "12 32 43 47 38 18 07 03 12, 13 37"},
      {'1', "17 28 22, 12 32"},
      {'2', "07 18 38 47 46 02 42"},
      {'3', "07 18 38 47 46 35 25, 35 44 43 32 12 03"},
      {'4', "32 38 04 44"},
      {'5', "48 08 05 35 44 43 32 12 03"},
      {'6', "47 38 18 07 03 12 32 43 44 35 15 04"},
      {'7', "08 48 12"},
      {'8', "15 06 07 18 38 47 46 35 15 04 03 12 32 43 44 35"},
      {'9', "03 12 32 43 47 38 18 07 06 15 35 46"},
      {'.', "22"},
      {',', "22 11"},
      {'!', "28 24, 22"},
      {'?', "07 18 38 47 46 25 24, 22"},
      {'-', "15 35"},
      {'+', "23 27, 05 45"},
      {'=', "04 44, 06 46"},
      {':', "23, 26"},
      {';', "26, 23 12"},
      {'/', "02 48"},
      {'\\', "08 42"},
      {'|', "28 20"},
      {'(', "38 27 23 32"},
      {')', "18 27 23 12"},
      {'[', "38 28 22 32"},
      {']', "18 28 22 12"},
      {'{', "38 27 26 15 24 23 32"},
      {'}', "18 27 26 35 24 23 12"},
      {'<', "37 15 33"},
      {'>', "17 35 13"},
      {'_', "01 41"},
      {'\'', "28 26"},
      {'"', "18 16, 38 36"},
      {'`', "18 27"},
      {'^', "16 28 36"},
      {'~', "05 16 34 45"},
      {'*', "23 27, 06 44, 04 46"},
      {'#', "13 17, 33 37, 04 44, 06 46"},
      {'%', "02 48, 07, 43"},
      {'&', "42 06 07 18 28 37 04 03 12 22 44"},
      {'@', "42 12 03 07 18 38 47 44 34 25 26 36 37 34"},
      {'$', "47 38 18 07 06 15 35 44 43 32 12 03, 28 22"},
  };
  return table;
}

constexpr const char* box_glyph = "02 42 48 08 02";
constexpr double advance = 6, line_height = 11;  // units of the grid; a capital is six high

/// Adds the lines of a glyph with its lower left corner at (left, base).
void add_strokes(const char* glyph, double left, double base, double unit, double weight, std::vector<E>& strokes) {
  double before[2] = {0, 0};
  bool first = true;
  for (const char* at = glyph; *at != 0;) {
    const double px = left + unit * (at[0] - '0'), py = base + unit * (at[1] - '2');
    at += 2;
    const bool ends = *at == 0 || *at == ',';
    if (!first)
      strokes.push_back(stroke(before[0], before[1], px, py, weight));
    else if (ends)
      strokes.push_back(move(circle(weight / 2), px, py, 0.0));
    before[0] = px, before[1] = py;
    first = ends;
    while (*at == ',' || *at == ' ') ++at;
  }
}

E united(const std::vector<E>& parts, std::size_t first, std::size_t count) {
  if (count == 1) return parts[first];
  return min(united(parts, first, count / 2), united(parts, first + count / 2, count - count / 2));
}

}  // namespace

E text(std::string_view words, double height, double weight) {
  if (!(height > 0) || !(weight > 0)) throw Error(ErrorKind::bad_input, "text", "height and weight must be above 0 mm");
  if (words.size() > 100000) throw Error(ErrorKind::too_large, "text", "more than 100000 characters");
  const double unit = height / 6;
  std::vector<E> strokes;
  double left = 0, base = 0;
  for (const char letter : words) {
    if (letter == '\n') {
      left = 0, base -= line_height * unit;
      continue;
    }
    const auto found = glyphs().find(letter);
    if (letter != ' ')
      add_strokes(found != glyphs().end() ? found->second : box_glyph, left, base, unit, weight, strokes);
    left += advance * unit;
  }
  if (strokes.empty()) throw Error(ErrorKind::bad_input, "text", "has nothing to show");
  return united(strokes, 0, strokes.size());
}

}  // namespace fieldfab::frep::shapes
