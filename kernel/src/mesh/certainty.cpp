#include "fieldfab/mesh/certainty.h"

#include <fmt/format.h>

namespace fieldfab {

std::string Certainty::text() const {
  if (certain()) return "certain";
  const char* why = "";
  switch (doubt) {
    case Doubt::none: break;
    case Doubt::not_looked: return "not certain, since it was not looked whether anything is missing";
    case Doubt::finest_size: why = "the smallest cells"; break;
    case Doubt::not_proved: why = "nothing is seen to be missing, but its slopes there are too roughly known for a proof"; break;
    case Doubt::too_many: why = "the limit of divided cells was reached"; break;
    case Doubt::slopes_unknown: why = "this kind of solid does not tell its slopes"; break;
  }
  return fmt::format("not certain at {} place{}, the largest {:.3g} mm: parts thinner than {:.3g} mm may be missing there ({})",
                     count, count == 1 ? "" : "s", largest, thickness, why);
}

}  // namespace fieldfab
