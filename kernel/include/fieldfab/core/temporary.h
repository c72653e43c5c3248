/// Files and folders that are removed on every way out of the process, but for SIGKILL.
#pragma once

#include <filesystem>

namespace fieldfab {

/// A file or folder that is removed with this object, or by remove_temporaries() where the process is ended early.
class Temporary {
 public:
  /// Takes charge of what `path` names; allocates no memory but the name's.
  explicit Temporary(std::filesystem::path path);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Leaves it: it was renamed.
  void release() noexcept;

 private:
  friend void remove_temporaries() noexcept;
  void remove() const noexcept;
  std::filesystem::path path_;
  Temporary *next_ = nullptr, *before_ = nullptr;  ///< of the list of all that there are
  bool listed_ = false;
};

/// Removes all Temporaries of the process. Called right before it is ended without unwinding.
void remove_temporaries() noexcept;

}  // namespace fieldfab
