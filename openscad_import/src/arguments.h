/// The arguments of a node, by their names.
#pragma once

#include <optional>
#include <string>

#include "fieldfab/openscad/tree.h"
#include "flat.h"

namespace fieldfab::openscad {

/// Reads arguments; what is missing or undef has a default, what is of the wrong kind is an error that names the line.
class Arguments {
 public:
  Arguments(const Tree& tree, const Node& node) : tree_(tree), node_(node) {}

  [[nodiscard]] const Value* find(std::string_view name) const;
  [[nodiscard]] double number(std::string_view name, double fallback) const;
  [[nodiscard]] bool truth(std::string_view name, bool fallback) const;
  [[nodiscard]] std::string text(std::string_view name, const std::string& fallback) const;
  /// As many numbers as `fallback` has; one number stands for all.
  [[nodiscard]] std::vector<double> numbers(std::string_view name, std::vector<double> fallback) const;
  /// All numbers of a list; throws where one is none.
  [[nodiscard]] std::vector<double> list_of_numbers(const Value& value, std::string_view name) const;
  /// Points of so many coordinates.
  [[nodiscard]] std::vector<std::vector<double>> points(std::string_view name, std::size_t coordinates) const;
  /// Lists of places in a list of `count`; of one such list where it is not a list of lists.
  [[nodiscard]] std::vector<std::vector<std::uint32_t>> paths(std::string_view name, std::size_t count) const;
  /// Sides of a circle of that radius, by $fn, $fa and $fs.
  [[nodiscard]] double fragments(double radius) const;
  [[nodiscard]] Eigen::Matrix4d matrix() const;

  [[noreturn]] void fail(const std::string& message) const;
  [[nodiscard]] std::string place() const { return tree_.place(node_); }

 private:
  const Tree& tree_;
  const Node& node_;
};

}  // namespace fieldfab::openscad
