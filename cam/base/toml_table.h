/// A table of a TOML file that knows where it stands and which keys have been looked at; toml++ stays in toml_table.cpp.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "fieldfab/cam/base/setting.h"

namespace fieldfab::cam {

class TomlTable {
 public:
  /// Throws bad_input with FILE:LINE.
  static TomlTable parse(std::string_view text, const std::string& file);

  [[nodiscard]] std::vector<std::string> keys() const;
  [[nodiscard]] bool has(const std::string& key) const;
  /// FILE:LINE of a key, or of the table for "".
  [[nodiscard]] std::string place(const std::string& key = "") const;
  /// The value of a key; throws bad_input for a type no setting has. Nothing where it is missing.
  [[nodiscard]] std::optional<Value> value(const std::string& key) const;
  /// The same with a type demanded.
  [[nodiscard]] std::optional<double> number(const std::string& key) const;
  [[nodiscard]] std::optional<std::string> text(const std::string& key) const;
  [[nodiscard]] std::optional<bool> flag(const std::string& key) const;
  [[nodiscard]] std::optional<std::vector<double>> list(const std::string& key) const;
  /// A list of texts; empty where it is missing.
  [[nodiscard]] std::vector<std::string> texts(const std::string& key) const;
  /// A list of points [[x, y], ...].
  [[nodiscard]] std::vector<std::vector<double>> rows(const std::string& key) const;
  /// A table within it; nothing where it is missing. Throws bad_input for something else.
  [[nodiscard]] std::optional<TomlTable> table(const std::string& key) const;
  /// The tables of [[key]].
  [[nodiscard]] std::vector<TomlTable> tables(const std::string& key) const;
  /// Throws bad_input for the first key that is not in `known`, with the nearest one.
  void only(const std::vector<std::string>& known) const;

 private:
  struct Node;
  explicit TomlTable(std::shared_ptr<const Node> node) : node_(std::move(node)) {}
  template <class T>
  [[nodiscard]] std::optional<T> typed(const std::string& key, const char* what) const;
  std::shared_ptr<const Node> node_;
};

}  // namespace fieldfab::cam
