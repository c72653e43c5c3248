/// How a surface deviates from a solid, measured piece by piece.
#pragma once

#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "fieldfab/cam/stock/cuts.h"
#include "fieldfab/cam/stock/deviation.h"
#include "surface_pieces.h"

namespace fieldfab::cam {

/// Several pieces may be measured, looked at and forgotten at a time. What comes out does not depend on their order.
class DeviationGauge {
 public:
  /// A place that is the worst of its kind.
  struct Spot {
    float deviation = 0;
    std::uint32_t cut = 0;
    SurfacePiece::Place place{};
  };

  /// Deviations below the height `floor` count as 0; those below -`gouge` are kept by their passes. What a shank has cut is no
  /// gouge. `fine` is how much deviations that are alike may differ, mm.
  DeviationGauge(const Field& target, double floor, double gouge, const Cuts& cuts, double fine)
      : target_(target), floor_(floor), gouge_(gouge), cuts_(cuts), fine_(fine) {}

  /// Before any piece: how many there are.
  void begin(std::size_t pieces) { at_.resize(pieces), sums_.resize(pieces); }
  /// Appends signed distances of places to a piece's.
  void measure(std::size_t piece, std::span<const SurfacePiece::Place> places);
  /// Of the vertices of a piece so far.
  [[nodiscard]] const std::vector<float>& at(std::size_t piece) const { return at_[piece]; }
  /// Takes note of a piece's vertices and triangles, once they and the vertices of pieces after it are measured.
  void look(std::size_t piece, const SurfacePieces& pieces);
  void forget(std::size_t piece) { at_[piece] = {}; }
  /// Whether one of these and what lies between them may stand for all: they are the same, or what is left over is about the
  /// same.
  [[nodiscard]] bool alike(float lowest, float highest) const { return highest - lowest <= fine_ + 0.5 * std::max(lowest, 0.0F); }

  /// Of all pieces; without `at_vertex`.
  [[nodiscard]] Deviation result() const;
  /// A pass that cuts too deep: its deepest place, and the lines from first to last that do so.
  struct Gouge {
    Spot deepest;
    int first_line = 0, last_line = 0;
    void add(const Gouge& other);
  };
  /// By pass; 0: the stock's first surface.
  [[nodiscard]] std::map<std::uint32_t, Gouge> gouges() const;
  [[nodiscard]] Spot highest() const;

 private:
  struct Sums {
    double area = 0, sum = 0, squares = 0;
    float deepest = 0;
    Spot highest{-std::numeric_limits<float>::infinity(), 0, {}};
    std::map<std::uint32_t, Gouge> gouges;
  };

  const Field& target_;
  double floor_, gouge_;
  const Cuts& cuts_;
  double fine_;
  std::vector<std::vector<float>> at_;
  std::vector<Sums> sums_;
  AreaHistogram areas_;
  std::mutex areas_alone_;
};

}  // namespace fieldfab::cam
