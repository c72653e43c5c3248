/// What a filter is, to everything but MeshLab: parameters with defaults worked out from the layers, and what it makes of them.
/// Nothing here knows MeshLab's interface; the folder meshlab_2020 translates.
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

/// A layer as MeshLab has it, in mm and where its transform puts it. It may be anything: open, inverted, with places that are
/// NaN.
struct Layer {
  std::string name;
  TriangleMesh mesh;
  std::vector<Colour> colours = {};  ///< of each vertex; empty where they are MeshLab's own
};

/// What defaults are worked out from.
struct Document {
  struct Entry {
    std::string name;
    Box bounds;  ///< of the places that are finite; not valid() without any
    std::size_t triangles = 0;
    double area = 0;  ///< mm2
  };
  std::vector<Entry> layers;
  std::size_t current = 0;  ///< which of them is chosen; without layers it means nothing

  /// The chosen one; one without triangles where there is none.
  [[nodiscard]] Entry chosen() const { return current < layers.size() ? layers[current] : Entry{}; }
};

/// One row of a dialog. The value is a length or other number (also yes or no, the index of a choice or of a layer) or text.
struct Parameter {
  enum class Kind { length, number, whole, yes_no, choice, layer, text, file };
  std::string name;   ///< in scripts: a word
  std::string label;  ///< in the dialog, with the unit
  std::string help;   ///< one or two sentences
  Kind kind = Kind::number;
  std::variant<double, std::string> value = 0.0;
  double least = 0, most = 0;        ///< of a length: the ends of its slider, mm
  std::vector<std::string> choices;  ///< of a choice, what can be chosen; of a file, its extensions with an asterisk
};

/// What a user has chosen, and the layers that are meant.
class Values {
 public:
  Values(std::vector<Parameter> parameters, std::map<std::size_t, std::shared_ptr<const Layer>> layers, std::size_t current)
      : parameters_(std::move(parameters)), layers_(std::move(layers)), current_(current) {}

  [[nodiscard]] double number(const std::string& name) const { return std::get<double>(find(name).value); }
  [[nodiscard]] int whole(const std::string& name) const { return static_cast<int>(number(name)); }
  [[nodiscard]] bool flag(const std::string& name) const { return number(name) != 0; }
  [[nodiscard]] const std::string& text(const std::string& name) const { return std::get<std::string>(find(name).value); }
  /// A length or number that must be finite, and above (or, where told so, not below) 0. Throws bad_input.
  [[nodiscard]] double positive(const std::string& name) const;
  [[nodiscard]] double not_negative(const std::string& name) const;
  /// The chosen layer, or that of a parameter. Throws bad_input where there is none.
  [[nodiscard]] const Layer& layer() const;
  [[nodiscard]] const Layer& layer(const std::string& name) const;
  [[nodiscard]] std::size_t current() const { return current_; }

 private:
  [[nodiscard]] const Parameter& find(const std::string& name) const;
  std::vector<Parameter> parameters_;
  std::map<std::size_t, std::shared_ptr<const Layer>> layers_;
  std::size_t current_;
};

/// What a filter has made. The layers it was given are left as they are, but for the colours of the chosen one.
struct Result {
  /// New layers; none where a filter only tells something.
  std::vector<Layer> layers;
  /// Of each vertex of the chosen layer, where that is what is wanted: MeshLab's quality, and red, green, blue.
  std::vector<float> quality;
  std::vector<Colour> colours;
  std::vector<std::string> log;  ///< for people, one line each

  /// Takes a new layer, and tells its size in the log.
  void add(Layer layer);
};

struct Filter {
  enum class Group { remeshing, creation, quality, measure };
  std::string name;  ///< in the menu and in scripts
  std::string help;  ///< HTML, a paragraph
  Group group = Group::remeshing;
  bool needs_layer = true;
  bool colours = false;  ///< changes the chosen layer's quality and colours, nothing else
  std::function<std::vector<Parameter>(const Document&)> parameters;
  /// Runs on any thread. Throws Error.
  std::function<Result(const Values&, Progress&)> run;
};

/// All of them, in the order of the issue.
const std::vector<Filter>& filters();

}  // namespace fieldfab::meshlab
