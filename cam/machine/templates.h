/// Templates of a machine's data file (docs/machines.md).
#pragma once

#include <fmt/format.h>

#include <cmath>
#include <map>
#include <string>
#include <utility>

#include "fieldfab/cam/machine/machine.h"
#include "writers.h"

namespace fieldfab::cam {

/// Expands templates. {name} is a value. Text in [brackets] is omitted unless one of its values has
/// changed since it was written last. {name*factor:i} is an integer, :d4 has four digits, :u8 and
/// :u16 are bytes, most significant byte first.
class Templates {
 public:
  explicit Templates(const Machine& machine) : machine_(machine) {}

  void set(const std::string& name, double value) {
    numbers_[name] = value;
    texts_[name] = number_text(value, machine_.decimals);
  }
  void set_whole(const std::string& name, double value) {
    numbers_[name] = value;
    texts_[name] = fmt::format("{}", std::llround(value));
  }
  void set_text(const std::string& name, std::string value) { texts_[name] = std::move(value); }
  [[nodiscard]] const std::string& text(const std::string& name) const { return texts_.at(name); }

  [[nodiscard]] bool has(const std::string& key) const { return machine_.text.contains(key); }
  /// Forgets all written values, so that brackets are written again.
  void forget() { written_.clear(); }
  [[nodiscard]] bool is_written(const std::string& name) const {
    const auto found = written_.find(name);
    return found != written_.end() && found->second == texts_.at(name);
  }
  void set_written(const std::string& name) { written_[name] = texts_.at(name); }
  void forget(const std::string& name) { written_.erase(name); }

  /// The expanded template of that name; empty if the machine has none. Throws Error(bad_input) for an invalid one.
  std::string fill(const std::string& key);

 private:
  [[noreturn]] void refuse(const std::string& key, const std::string& what) const;
  std::string bracket(const std::string& pattern, const std::string& key);
  std::string value(const std::string& pattern, std::size_t& i, const std::string& key);

  const Machine& machine_;
  std::map<std::string, std::string> texts_, written_;
  std::map<std::string, double> numbers_;
};

}  // namespace fieldfab::cam
