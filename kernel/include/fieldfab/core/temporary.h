/// Temporary files and folders, removed whenever the process ends, except by SIGKILL.
#pragma once

#include <filesystem>

namespace fieldfab {

/// Owner of a temporary file or folder. The destructor removes it, a folder with all that it contains;
/// remove_temporaries() does so if the process ends without unwinding the stack. A removal that fails is not reported.
/// Different objects may be created, released and destroyed by several threads.
class Temporary {
 public:
  /// Takes ownership of the file or folder `path`, which need not exist yet. Allocates no memory except for the path.
  explicit Temporary(std::filesystem::path path);
  ~Temporary();
  Temporary(const Temporary&) = delete;
  Temporary& operator=(const Temporary&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }
  /// Gives up ownership, for example after a rename: the file is kept.
  void release() noexcept;

 private:
  friend void remove_temporaries() noexcept;
  void remove() const noexcept;
  std::filesystem::path path_;
  Temporary *next_ = nullptr, *before_ = nullptr;  ///< neighbours in the list of all Temporaries
  bool listed_ = false;
};

/// Removes all Temporaries of the process. Called immediately before an exit without stack unwinding.
void remove_temporaries() noexcept;

}  // namespace fieldfab
