/// Deviation of a surface from a solid, measured piece by piece.
#pragma once

#include <map>
#include <mutex>
#include <span>
#include <vector>

#include "fieldfab/cam/stock/cuts.h"
#include "fieldfab/cam/stock/deviation.h"
#include "surface_pieces.h"

namespace fieldfab::cam {

/// Several pieces may be measured, examined and released concurrently. The result does not depend
/// on their order.
class DeviationGauge {
 public:
  /// The point with the greatest deviation of its kind.
  struct Spot {
    float deviation = 0;
    std::uint32_t cut = 0;
    SurfacePiece::Place place{};
  };

  /// Deviations below the height `floor` count as 0. Those below -`gouge` are recorded by pass,
  /// except those cut by a shank. `fine`: difference of deviations that alike() tolerates, mm.
  DeviationGauge(const Field& target, double floor, double gouge, const Cuts& cuts, double fine)
      : target_(target), floor_(floor), gouge_(gouge), cuts_(cuts), fine_(fine) {}

  /// Sets the number of pieces, before any is measured.
  void begin(std::size_t pieces) { at_.resize(pieces), sums_.resize(pieces); }
  /// Appends the signed distances of points to those of a piece.
  void measure(std::size_t piece, std::span<const SurfacePiece::Place> places);
  /// Signed distances of a piece's vertices measured so far, mm.
  [[nodiscard]] const std::vector<float>& at(std::size_t piece) const { return at_[piece]; }
  /// Accounts for a piece's vertices and triangles. Requires that they, and the vertices of the
  /// pieces after it, are measured.
  void look(std::size_t piece, const SurfacePieces& pieces);
  /// Signed distances of points that belong to no piece, mm; they count for no sum and no gouge.
  [[nodiscard]] std::vector<float> distances(std::span<const SurfacePiece::Place> places) const;
  void forget(std::size_t piece) { at_[piece] = {}; }
  /// Whether one deviation may represent a range of deviations: the range is at most `fine`, or
  /// small relative to the excess.
  [[nodiscard]] bool alike(float lowest, float highest) const {
    return highest - lowest <= fine_ + 0.5 * std::max(lowest, 0.0F);
  }

  /// Result for all pieces, without `at_vertex`.
  [[nodiscard]] Deviation result() const;
  /// The gouge of one pass: its deepest point and the first and last program line that cause it.
  struct Gouge {
    Spot deepest;
    int first_line = 0, last_line = 0;
    void add(const Gouge& other);
  };
  /// Gouges by pass; 0 is the stock's first surface.
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
