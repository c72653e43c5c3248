#include "fieldfab/cam/stock/cuts.h"

namespace fieldfab::cam {

std::uint32_t Cuts::add(const CutMove& move) {
  moves_.push_back(move);
  return cut_number(static_cast<std::uint32_t>(size() - parts), ToolRole::cutting);
}

Cut Cuts::operator[](std::uint32_t number) const {
  if (number == 0 || number >= size()) return {};
  constexpr CutBy by[parts]{CutBy::tip, CutBy::shank, CutBy::holder};
  return {by[(number - 1) % parts], moves_[(number - 1) / parts]};
}

}  // namespace fieldfab::cam
