#include "fieldfab/core/progress.h"

#include "fieldfab/core/error.h"

namespace fieldfab {

void Progress::report(double fraction, const std::string& message) {
  if (!listener_) return;
  const std::unique_lock lock(reporting_, std::try_to_lock);
  if (lock.owns_lock()) listener_(fraction, message);
}

void Progress::check() const {
  if (cancelled()) throw Error(ErrorKind::cancelled, "", "cancelled");
}

Progress& Progress::none() {
  static Progress nobody;
  return nobody;
}

}  // namespace fieldfab
