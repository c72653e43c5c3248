/// A job: a part, a machine, tools and operations, as a TOML file says (docs/cam.md).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/job/stage.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/solid/formats.h"

namespace fieldfab::cam {

/// One operation as it will be done.
struct PlannedOperation {
  std::string name;                  ///< "1 pocket" or as the job calls it
  std::vector<const Stage*> stages;  ///< from the input on, the operation last
  Values values;
  Tool tool;
  Plane plane;
  std::optional<Artifact> own_input = std::nullopt;  ///< where it works on a model of its own
};

/// What an operation came to.
struct OperationReport {
  std::string name;
  std::size_t paths = 0;
  AirTravel air;
  Lengths length;
  double seconds = 0;
};

/// A job read and checked, and all of its results.
class Job {
 public:
  /// Reads a job file and what it names, models in any of the formats. Throws bad_input with FILE:LINE, io, cancelled.
  static Job read(const std::filesystem::path& path, Progress& progress = Progress::none(),
                  const Formats& formats = kernel_formats());
  /// The same of a file's text. `path` is what messages call it, and beside it are the files that it names. Where a part is
  /// given, [input] names no model; it may scale, turn and move the part.
  static Job parse(std::string_view toml, const std::filesystem::path& path, FieldPtr part = nullptr,
                   Progress& progress = Progress::none(), const Formats& formats = kernel_formats());

  /// The chains of stages with all settings and where each comes from, for people.
  [[nodiscard]] std::string plan() const;
  /// Plans all paths. Throws bad_input, cancelled.
  void run(Progress& progress = Progress::none());
  /// Writes the program, or the picture or mesh the machine takes, to `path`, whole or not at all. After run().
  void write(const std::filesystem::path& path, Progress& progress = Progress::none()) const;

  [[nodiscard]] const Program& program() const { return program_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] const Values& machine_values() const { return machine_values_; }
  [[nodiscard]] const std::vector<PlannedOperation>& operations() const { return operations_; }
  [[nodiscard]] const std::vector<OperationReport>& reports() const { return reports_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  [[nodiscard]] const Solid* solid() const { return std::get_if<Solid>(&input_); }
  /// The material, in the part's coordinates, mm.
  [[nodiscard]] const Box& stock() const { return stock_; }
  /// What is left of it where a file says so; null: all of it.
  [[nodiscard]] const std::shared_ptr<const Stock>& saved_stock() const { return saved_stock_; }
  /// Where the program's zero lies in the model's coordinates (scaled and turned as [input] says), mm.
  [[nodiscard]] const Vec3& zero() const { return zero_; }
  [[nodiscard]] const std::string& name() const { return program_.name; }
  [[nodiscard]] const std::string& material() const { return material_; }

 private:
  friend class JobReader;
  friend class JobRunner;
  Machine machine_;
  Values machine_values_;
  std::string material_;
  std::string file_, machine_place_;
  Artifact input_;
  Box stock_;
  std::shared_ptr<const Stock> saved_stock_;
  Vec3 zero_ = Vec3::Zero();
  std::vector<PlannedOperation> operations_;
  Program program_;
  std::vector<OperationReport> reports_;
  std::vector<std::string> notes_;
};

}  // namespace fieldfab::cam
