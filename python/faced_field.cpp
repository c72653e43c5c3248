#include "faced_field.h"

namespace fieldfab::python {
namespace {

class FacedField final : public Field {
 public:
  FacedField(FieldPtr field, MakeFaces make, std::optional<double> thickness)
      : field_(std::move(field)), make_(std::move(make)), thickness_(thickness) {}
  [[nodiscard]] std::optional<TriangleMesh> faces(Progress& progress) const { return make_(thickness_, progress); }

  void values(const Points& points, float* out) const noexcept override { field_->values(points, out); }
  void gradients(const Points& points, float* out, const Gradients& slopes) const noexcept override {
    field_->gradients(points, out, slopes);
  }
  [[nodiscard]] Interval interval(const Box& box) const noexcept override { return field_->interval(box); }
  void slopes(const Box& box, std::span<const Vec3> directions, std::span<Interval> out) const noexcept override {
    field_->slopes(box, directions, out);
  }
  void restrict_all(std::span<const Box> boxes, Purpose purpose, std::span<Restriction> out) const override {
    field_->restrict_all(boxes, purpose, out);
  }
  [[nodiscard]] Box known_bounds() const noexcept override { return field_->known_bounds(); }
  [[nodiscard]] Framed framed(Purpose purpose) const override { return field_->framed(purpose); }
  [[nodiscard]] bool affine() const noexcept override { return field_->affine(); }
  [[nodiscard]] bool sampled() const noexcept override { return field_->sampled(); }
  [[nodiscard]] bool smooth() const noexcept override { return field_->smooth(); }
  [[nodiscard]] std::size_t cost() const noexcept override { return field_->cost(); }

 private:
  FieldPtr field_;
  MakeFaces make_;
  std::optional<double> thickness_;
};

}  // namespace

FieldPtr with_faces(FieldPtr field, MakeFaces make, std::optional<double> thickness) {
  if (!make) return field;
  return std::make_shared<FacedField>(std::move(field), std::move(make), thickness);
}

std::optional<TriangleMesh> faces_of(const Field& field, Progress& progress) {
  const auto* const faced = dynamic_cast<const FacedField*>(&field);
  return faced != nullptr ? faced->faces(progress) : std::nullopt;
}

}  // namespace fieldfab::python
