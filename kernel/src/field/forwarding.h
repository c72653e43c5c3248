/// A Field that forwards to another one: base of Fields with additional knowledge.
#pragma once

#include "fieldfab/field/field.h"

namespace fieldfab {

class Forwarding : public Field {
 public:
  explicit Forwarding(FieldPtr field) : field_(std::move(field)) {}

  void values(const Points& points, float* out) const noexcept override { field_->values(points, out); }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    field_->gradients(points, out, slopes);
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return field_->interval(box); }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    field_->slopes(box, directions, out);
  }
  [[nodiscard]] bool faceted() const noexcept override { return field_->faceted(); }
  bool facing(const Box& box, std::vector<Eigen::Vector3f>& directions) const noexcept override {
    return field_->facing(box, directions);
  }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    field_->restrict_all(boxes, purpose, out);
  }
  [[nodiscard]] Box known_bounds() const noexcept override { return field_->known_bounds(); }
  using Field::framed;
  [[nodiscard]] Framed framed(Purpose purpose) const override { return field_->framed(purpose); }
  [[nodiscard]] bool affine() const noexcept override { return field_->affine(); }
  [[nodiscard]] unsigned unread_axes() const noexcept override { return field_->unread_axes(); }
  [[nodiscard]] bool sampled() const noexcept override { return field_->sampled(); }
  [[nodiscard]] std::optional<Sampling> sampling() const noexcept override { return field_->sampling(); }
  [[nodiscard]] bool corners_tell(const Box& box) const noexcept override { return field_->corners_tell(box); }
  [[nodiscard]] bool smooth() const noexcept override { return field_->smooth(); }
  [[nodiscard]] std::size_t cost() const noexcept override { return field_->cost(); }

 private:
  FieldPtr field_;
};

}  // namespace fieldfab
