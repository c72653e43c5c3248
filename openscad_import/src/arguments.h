/// Arguments of a node, by name.
#pragma once

#include <optional>
#include <string>

#include "fieldfab/openscad/tree.h"
#include "flat.h"

namespace fieldfab::openscad {

/// Reads arguments. A missing or undef argument gets its default; one of the wrong type throws an
/// error with its line.
class Arguments {
 public:
  Arguments(const Tree& tree, const Node& node) : tree_(tree), node_(node) {}

  [[nodiscard]] const Value* find(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name, double fallback) const;
  [[nodiscard]] bool truth(std::string_view name, bool fallback) const;
  [[nodiscard]] std::string text(std::string_view name, const std::string& fallback) const;
  /// Returns as many numbers as `fallback` has; a single number applies to all of them.
  [[nodiscard]] std::vector<double> numbers(std::string_view name, std::vector<double> fallback) const;
  /// Returns the numbers of a list; throws if an element is not a number.
  [[nodiscard]] std::vector<double> list_of_numbers(const Value& value, std::string_view name) const;
  /// Returns points with that number of coordinates.
  [[nodiscard]] std::vector<std::vector<double>> points(std::string_view name, std::size_t coordinates) const;
  /// Returns lists of indices into a list of `count` points; a flat list counts as one such list.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> paths(std::string_view name, std::size_t count) const;
  /// Number of sides of a circle of that radius, from $fn, $fa and $fs.
  [[nodiscard]] double fragments(double radius) const;
  [[nodiscard]] Eigen::Matrix4d matrix() const;

  [[noreturn]] void fail(const std::string& message) const;
  [[nodiscard]] std::string place() const { return tree_.place(node_); }

 private:
  const Tree& tree_;
  const Node& node_;
};

}  // namespace fieldfab::openscad
