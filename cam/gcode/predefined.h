// Parameters that report the control's state.
#pragma once

#include "flow.h"
#include "motion_stream.h"

namespace fieldfab::cam::gcode {

/// #5400 to #5428 and names such as #<_x>. May be constructed before the objects that it refers to.
class ControlParameters final : public PredefinedParameters {
 public:
  ControlParameters(Control& control, const MotionStream& stream, const Flow& flow)
      : control_(control), stream_(stream), flow_(flow) {}

  [[nodiscard]] double numbered(int number) const override;
  [[nodiscard]] std::optional<double> named(std::string_view name) const override;

 private:
  [[nodiscard]] std::optional<double> position(std::string_view name) const;
  [[nodiscard]] std::optional<double> mode(std::string_view name) const;
  [[nodiscard]] std::optional<double> state(std::string_view name) const;

  Control& control_;  // a query of a parameter may add a note
  const MotionStream& stream_;
  const Flow& flow_;
};

}  // namespace fieldfab::cam::gcode
