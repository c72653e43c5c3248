/// A table of a TOML file that knows its place and the keys that were read. toml++ is included in
/// toml_table.cpp only.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/cam/base/setting.h"

namespace fieldfab::cam {

class TomlTable {
 public:
  /// Throws Error(bad_input) with FILE:LINE.
  static TomlTable parse(std::string_view text, const std::string& file);

  [[nodiscard]] std::vector<std::string> keys() const;
  [[nodiscard]] bool has(const std::string& key) const;
  /// FILE:LINE of a key, or of the table for "".
  [[nodiscard]] std::string place(const std::string& key = "") const;
  /// Value of a key; std::nullopt if missing. Throws Error(bad_input) for a type that no setting
  /// has.
  [[nodiscard]] std::optional<Value> value(const std::string& key) const;
  /// Value of a key with a required type.
  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const;
  [[nodiscard]] std::optional<bool> flag(const std::string& key) const;
  [[nodiscard]] std::optional<std::vector<double>> list(const std::string& key) const;
  /// A list of texts; empty if missing.
  [[nodiscard]] std::vector<std::string> texts(const std::string& key) const;
  /// A list of points [[x, y], ...].
  [[nodiscard]] std::vector<std::vector<double>> rows(const std::string& key) const;
  /// A nested table; std::nullopt if missing. Throws Error(bad_input) for any other type.
  [[nodiscard]] std::optional<TomlTable> table(const std::string& key) const;
  /// The tables of [[key]].
  [[nodiscard]] std::vector<TomlTable> tables(const std::string& key) const;
  /// Throws Error(bad_input) for the first key that is not in `known`, with the nearest known one.
  void only(const std::vector<std::string>& known) const;

 private:
  struct Node;
  explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  template <class T>
  [[nodiscard]] std::optional<T> typed(const std::string& key, const char* what) const;
  std::shared_ptr<const Node> node_;
};

}  // namespace fieldfab::cam
