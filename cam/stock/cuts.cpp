#include "fieldfab/cam/stock/cuts.h"

namespace fieldfab::cam {

std::uint32_t Cuts::add(int line, int tool) {
  moves_.push_back({line, tool});
  return cut_number(static_cast<std::uint32_t>(size() - parts), ToolRole::cutting);
}

Cut Cuts::operator[](std::uint32_t number) const {
  if (number == 0 || number >= size()) return {};
  const Move& move = moves_[(number - 1) / parts];
  constexpr CutBy by[parts]{CutBy::tip, CutBy::shank, CutBy::holder};
  return {by[(number - 1) % parts], move.line, move.tool};
}

}  // namespace fieldfab::cam
