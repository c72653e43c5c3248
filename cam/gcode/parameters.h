// Parameters of a G-code program: #1 to #5602, #<local>, #<_global>, and those that report the
// interpreter's state.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fieldfab::cam::gcode {

/// Values of parameters that are not stored but computed from the interpreter's state.
class PredefinedParameters {
 public:
  virtual ~PredefinedParameters() = default;
  /// #5400 to #5413 and #5420 to #5428.
  [[nodiscard]] virtual double numbered(int number) const = 0;
  /// Value of names such as "_x" or "_metric", in lower case; std::nullopt for an unknown name.
  [[nodiscard]] virtual std::optional<double> named(std::string_view name) const = 0;
};

/// Numbers of stored parameters with a meaning.
namespace number {
constexpr int probe_result = 5061, probe_success = 5070, first_home = 5161, second_home = 5181, offset_active = 5210,
              axis_offset = 5211, coordinate_system = 5220, first_system = 5221, input_value = 5399, tool = 5400,
              count = 5603;
/// First parameter of the coordinate system `index` (1 is G54, 9 is G59.3): origins of nine axes,
/// then the rotation about z.
constexpr int system_start(int index) { return first_system + 20 * (index - 1); }
}  // namespace number

/// All parameters of one run. Functions throw Refusal for numbers and names that do not exist.
class Parameters {
 public:
  explicit Parameters(const PredefinedParameters& predefined) : predefined_(predefined) {}

  [[nodiscard]] double get(int parameter) const;
  void set(int parameter, double value);
  /// Stored parameters only, for the interpreter itself.
  double& stored(int parameter) { return numbered_[static_cast<std::size_t>(parameter)]; }
  [[nodiscard]] double stored(int parameter) const { return numbered_[static_cast<std::size_t>(parameter)]; }

  [[nodiscard]] std::optional<double> find(std::string_view name) const;
  [[nodiscard]] double get(std::string_view name) const;
  void set(std::string_view name, double value);

  /// Starts a subroutine: #1 to #30 are the arguments, 0 if missing; parameters with local names
  /// are its own.
  void enter(const std::vector<double>& arguments, bool numbered);
  /// Ends a subroutine: restores local names and, if `numbered`, #1 to #30 (M98 shares them with
  /// its caller).
  void leave(bool numbered);
  [[nodiscard]] std::size_t depth() const { return frames_.size(); }

 private:
  using Names = std::map<std::string, double, std::less<>>;
  struct Frame {
    std::array<double, 31> numbered{};
    Names names;
  };

  const PredefinedParameters& predefined_;
  std::array<double, number::count> numbered_{};
  Names globals_, locals_;
  std::vector<Frame> frames_;
};

}  // namespace fieldfab::cam::gcode
