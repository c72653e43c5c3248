#include "arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "fieldfab/core/error.h"

namespace fieldfab::openscad {

void Arguments::fail(const std::string& message) const {
  throw Error(ErrorKind::bad_input, place(), fmt::format("{}: {}", node_.name, message));
}

const Value* Arguments::find(std::string_view name) const {
  for (const Argument& argument : node_.arguments)
    if (argument.name == name) return argument.value.is_undef() ? nullptr : &argument.value;
  return nullptr;
}

double Arguments::number(std::string_view name, double fallback) const {
  const Value* value = find(name);
  if (value == nullptr) return fallback;
  if (const double* number = value->number()) return *number;
  fail(fmt::format("{} must be a number", name));
}

bool Arguments::truth(std::string_view name, bool fallback) const {
  const Value* value = find(name);
  if (value == nullptr) return fallback;
  if (const bool* truth = value->truth()) return *truth;
  if (const double* number = value->number()) return *number != 0;
  fail(fmt::format("{} must be true or false", name));
}

std::string Arguments::text(std::string_view name, const std::string& fallback) const {
  const Value* value = find(name);
  if (value == nullptr) return fallback;
  if (const std::string* text = value->text()) return *text;
  fail(fmt::format("{} must be words in quotes", name));
}

std::vector<double> Arguments::list_of_numbers(const Value& value, std::string_view name) const {
  std::vector<double> numbers;
  if (value.list() == nullptr) fail(fmt::format("{} must be a list of numbers", name));
  for (const Value& item : *value.list()) {
    if (const bool* truth = item.truth())
      numbers.push_back(*truth ? 1 : 0);
    else if (const double* number = item.number())
      numbers.push_back(*number);
    else
      fail(fmt::format("{} must be a list of numbers", name));
  }
  return numbers;
}

std::vector<double> Arguments::numbers(std::string_view name, std::vector<double> fallback) const {
  const Value* value = find(name);
  if (value == nullptr) return fallback;
  if (const double* number = value->number()) {
    std::fill(fallback.begin(), fallback.end(), *number);
    return fallback;
  }
  if (const bool* truth = value->truth()) {
    std::fill(fallback.begin(), fallback.end(), *truth ? 1.0 : 0.0);
    return fallback;
  }
  const std::vector<double> given = list_of_numbers(*value, name);
  if (given.size() < fallback.size())
    fail(fmt::format("{} must have {} numbers, and has {}", name, fallback.size(), given.size()));
  std::copy_n(given.begin(), fallback.size(), fallback.begin());
  return fallback;
}

std::vector<std::vector<double>> Arguments::points(std::string_view name, std::size_t coordinates) const {
  std::vector<std::vector<double>> points;
  const Value* value = find(name);
  if (value == nullptr) return points;
  if (value->list() == nullptr) fail(fmt::format("{} must be a list of points", name));
  for (const Value& item : *value->list()) {
    points.push_back(list_of_numbers(item, name));
    if (points.back().size() < coordinates)
      fail(fmt::format("point {} of {} has {} coordinates, not {}", points.size() - 1, name, points.back().size(),
                       coordinates));
    for (const double number : points.back())
      if (!std::isfinite(number)) fail(fmt::format("point {} of {} is not at a finite place", points.size() - 1, name));
  }
  return points;
}

std::vector<std::vector<std::uint32_t>> Arguments::paths(std::string_view name, std::size_t count) const {
  std::vector<std::vector<std::uint32_t>> paths;
  const Value* value = find(name);
  if (value == nullptr) return paths;
  if (value->list() == nullptr) fail(fmt::format("{} must be a list of lists", name));
  const auto read = [&](const Value& list) {
    std::vector<std::uint32_t> path;
    for (const double number : list_of_numbers(list, name)) {
      if (!(number >= 0) || number >= static_cast<double>(count) || number != std::floor(number))
        fail(fmt::format("{} names point {}, and there are {}", name, number, count));
      path.push_back(static_cast<std::uint32_t>(number));
    }
    paths.push_back(std::move(path));
  };
  const List& list = *value->list();
  if (!list.empty() && list.front().number() != nullptr) {
    read(*value);
  } else {
    for (const Value& item : list) read(item);
  }
  return paths;
}

double Arguments::fragments(double radius) const {
  const double fn = number("$fn", 0), fa = std::max(number("$fa", 12), 0.01), fs = std::max(number("$fs", 2), 0.01);
  constexpr double smallest = 1.0 / (1 << 20);  // mm; OpenSCAD makes a triangle of a smaller circle
  if (radius < smallest || !std::isfinite(fn)) return 3;
  if (fn > 0) return fn >= 3 ? std::floor(fn) : 3;
  return std::ceil(std::max(std::min(360 / fa, radius * 2 * std::numbers::pi / fs), 5.0));
}

Eigen::Matrix4d Arguments::matrix() const {
  const Value* given = nullptr;
  for (const Argument& argument : node_.arguments)
    if (argument.name.empty() || argument.name == "m") given = &argument.value;
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Identity();
  if (given == nullptr || given->list() == nullptr) fail("expected a matrix of 4 rows of 4 numbers");
  const List& rows = *given->list();
  for (std::size_t row = 0; row < std::min<std::size_t>(rows.size(), 4); ++row) {
    const std::vector<double> numbers = list_of_numbers(rows[row], "the matrix");
    for (std::size_t column = 0; column < std::min<std::size_t>(numbers.size(), 4); ++column)
      matrix(static_cast<int>(row), static_cast<int>(column)) = numbers[column];
  }
  if (!matrix.allFinite()) fail("the matrix has numbers that are not finite");
  if (matrix.row(3) != Eigen::RowVector4d(0, 0, 0, matrix(3, 3)) || matrix(3, 3) == 0)
    fail("the last row must be 0, 0, 0, 1");
  return matrix / matrix(3, 3);
}

}  // namespace fieldfab::openscad
