/// A filter independent of MeshLab: parameters with defaults computed from the layers, and a
/// function that returns results. This header does not depend on MeshLab's interface; the folder
/// host translates.
#pragma once

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "fieldfab/core/colour.h"
#include "fieldfab/core/progress.h"
#include "fieldfab/mesh/triangle_mesh.h"

namespace fieldfab::meshlab {

/// A layer of MeshLab, in mm, with its transform applied. The mesh may be open, inverted, or have
/// NaN coordinates.
struct Layer {
  std::string name;
  TriangleMesh mesh;
  std::vector<Colour> colours = {};  ///< one per vertex; empty if the layer has no colours of its own
};

/// Data for the computation of defaults.
struct Document {
  struct Entry {
    std::string name;
    Box bounds;  ///< of the finite vertices; not valid() if there are none
    std::size_t triangles = 0;
    double area = 0;  ///< mm2
  };
  std::vector<Entry> layers;
  std::size_t current = 0;  ///< index of the chosen layer; meaningless without layers

  /// The chosen layer; without layers an entry without triangles.
  [[nodiscard]] Entry chosen() const { return current < layers.size() ? layers[current] : Entry{}; }
};

/// One row of a dialog. The value is a text or a number: a length, another number, 0 or 1, or the
/// index of a choice or a layer.
struct Parameter {
  enum class Kind { length, number, whole, yes_no, choice, layer, text, file };
  std::string name;   ///< in scripts: a word
  std::string label;  ///< in the dialog, with the unit
  std::string help;   ///< one or two sentences
  Kind kind = Kind::number;
  std::variant<double, std::string> value = 0.0;
  double least = 0, most = 0;        ///< of a length: ends of its slider, mm
  std::vector<std::string> choices;  ///< of a choice: its options; of a file: extensions with an asterisk
};

/// Values chosen by a user, and the layers they refer to.
class Values {
 public:
  Values(std::vector<Parameter> parameters, std::map<std::size_t, std::shared_ptr<const Layer>> layers,
         std::size_t current)
      : parameters_(std::move(parameters)), layers_(std::move(layers)), current_(current) {}

  [[nodiscard]] double number(const std::string& name) const { return std::get<double>(find(name).value); }
  [[nodiscard]] int whole(const std::string& name) const { return static_cast<int>(number(name)); }
  [[nodiscard]] bool flag(const std::string& name) const { return number(name) != 0; }
  [[nodiscard]] const std::string& text(const std::string& name) const {
    return std::get<std::string>(find(name).value);
  }
  /// Returns a finite length or number above 0 (positive) or not below 0 (not_negative). Throws
  /// bad_input otherwise.
  [[nodiscard]] double positive(const std::string& name) const;
  [[nodiscard]] double not_negative(const std::string& name) const;
  /// Returns the chosen layer, or that of a parameter. Throws bad_input if there is none.
  [[nodiscard]] const Layer& layer() const;
  [[nodiscard]] const Layer& layer(const std::string& name) const;
  [[nodiscard]] std::size_t current() const { return current_; }

 private:
  [[nodiscard]] const Parameter& find(const std::string& name) const;
  std::vector<Parameter> parameters_;
  std::map<std::size_t, std::shared_ptr<const Layer>> layers_;
  std::size_t current_;
};

/// Result of a filter. The input layers stay unchanged, except for the colours of the chosen one.
struct Result {
  /// New layers; empty if a filter only reports.
  std::vector<Layer> layers;
  /// Per vertex of the chosen layer, if the filter computes them: MeshLab's quality, and red,
  /// green, blue.
  std::vector<float> quality;
  std::vector<Colour> colours;
  std::vector<std::string> log;  ///< for people, one line each

  /// Adds a new layer, and its size to the log.
  void add(Layer layer);
};

struct Filter {
  enum class Group { remeshing, creation, quality, measure };
  std::string name;  ///< in the menu and in scripts
  std::string help;  ///< HTML, a paragraph
  Group group = Group::remeshing;
  bool needs_layer = true;
  bool colours = false;  ///< changes only quality and colours of the chosen layer
  std::function<std::vector<Parameter>(const Document&)> parameters;
  /// Runs on any thread. Throws Error.
  std::function<Result(const Values&, Progress&)> run;
};

/// Returns all filters, in the order of the menu.
const std::vector<Filter>& filters();

}  // namespace fieldfab::meshlab
