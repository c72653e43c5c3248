/// CAM jobs: a part, a machine, tools and operations, read from a TOML file (docs/cam.md).
#pragma once

#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "fieldfab/cam/job/stage.h"
#include "fieldfab/cam/machine/machine.h"
#include "fieldfab/cam/plan/feeds.h"
#include "fieldfab/cam/plan/program.h"
#include "fieldfab/cam/stock/stock.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/solid/formats.h"

namespace fieldfab::cam {

/// A planned operation.
struct PlannedOperation {
  std::string name;                  ///< "1 pocket", or the name given in the job
  std::vector<const Stage*> stages;  ///< chain of stages from the input to the operation, not owned
  Values values;
  Tool tool;
  Plane plane;
  std::optional<Artifact> own_input = std::nullopt;  ///< own model of the operation, if it has one
};

/// Result of an operation.
struct OperationReport {
  std::string name;
  /// number of paths
  std::size_t paths = 0;
  AirTravel air;
  Lengths length;
  /// machining time, seconds
  double seconds = 0;
  /// with adjusted feeds: time with the planned ones, seconds
  std::optional<double> planned_seconds;
};

/// A validated job with its results.
class Job {
 public:
  /// Reads a job file and the models it names, in any format of `formats`. Throws Error(bad_input) with FILE:LINE,
  /// Error(io), Error(cancelled).
  static Job read(const std::filesystem::path& path, Progress& progress = Progress::none(),
                  const Formats& formats = kernel_formats());
  /// Parses the text of a job file. `path` appears in messages; file names in the job are relative to its folder. If
  /// `part` is given, [input] names no model, but may scale, rotate and move the part. Throws as read().
  static Job parse(std::string_view toml, const std::filesystem::path& path, FieldPtr part = nullptr,
                   Progress& progress = Progress::none(), const Formats& formats = kernel_formats());

  /// Returns the chains of stages with all settings and their origins, for people.
  [[nodiscard]] std::string plan() const;
  /// Has run() adjust feeds to the material that each move removes; [feeds] in a job file does the same.
  /// Throws Error(bad_input) for limits that mean nothing.
  void adjust_feeds(const FeedLimits& limits) {
    require_possible(limits);
    feed_limits_ = limits;
  }
  /// Whether it does.
  [[nodiscard]] bool adjusts_feeds() const { return feed_limits_.has_value(); }
  /// Plans all paths. Throws Error(bad_input), Error(cancelled).
  void run(Progress& progress = Progress::none());
  /// Writes the program, or the picture or mesh that the machine takes, completely or not at all. Precondition: run().
  /// Throws Error(io), Error(bad_input), Error(cancelled).
  void write(const std::filesystem::path& path, Progress& progress = Progress::none()) const;

  [[nodiscard]] const Program& program() const { return program_; }
  [[nodiscard]] const Machine& machine() const { return machine_; }
  [[nodiscard]] const Values& machine_values() const { return machine_values_; }
  [[nodiscard]] const std::vector<PlannedOperation>& operations() const { return operations_; }
  [[nodiscard]] const std::vector<OperationReport>& reports() const { return reports_; }
  [[nodiscard]] const std::vector<std::string>& notes() const { return notes_; }
  /// The part if it is a solid, otherwise null; owned by the job.
  [[nodiscard]] const Solid* solid() const { return std::get_if<Solid>(&input_); }
  /// Box of the material in part coordinates, mm.
  [[nodiscard]] const Box& stock() const { return stock_; }
  /// Remaining stock from a file; null: the whole box.
  [[nodiscard]] const std::shared_ptr<const Stock>& saved_stock() const { return saved_stock_; }
  /// Position of the program's zero in model coordinates (after the scaling and rotation of [input]), mm.
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
  std::optional<FeedLimits> feed_limits_;
  Program program_;
  std::vector<OperationReport> reports_;
  std::vector<std::string> notes_;
};

}  // namespace fieldfab::cam
