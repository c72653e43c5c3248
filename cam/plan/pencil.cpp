// Pencil finishing: along valleys, where a round tool touches both sides.
#include <algorithm>
#include <cmath>
#include <map>

#include "fieldfab/cam/plan/operations.h"
#include "fieldfab/core/error.h"
#include "fieldfab/core/parallel.h"
#include "follower.h"

namespace fieldfab::cam {
namespace {

/// Finds the discontinuities of the tool's contact, from one side of a valley to the other, on the
/// edges of a lattice, and links them to polylines.
class Valleys {
 public:
  Valleys(const TipSurface& tips, const Rectangle& area, double cell, double least_angle)
      : tips_(tips), least_turn_(2 * std::sin(least_angle / 2)) {
    const Vec2 size = area.size() / cell;
    lattice_ = Lattice<Vec3>(static_cast<int>(std::ceil(size.x())) + 1, static_cast<int>(std::ceil(size.y())) + 1, cell,
                             area.lower, Vec3::UnitZ());
  }

  std::vector<std::vector<Vec2>> find(Progress& progress) {
    parallel_for(static_cast<std::size_t>(lattice_.height), [&](std::size_t row) {
      progress.check();
      const int r = static_cast<int>(row);
      for (int c = 0; c < lattice_.width; ++c) lattice_.at(c, r) = normal(lattice_.place(c, r));
      progress.report(static_cast<double>(row) / lattice_.height, "looking for valleys");
    });
    std::vector<std::vector<Edge>> found(static_cast<std::size_t>(lattice_.height));
    parallel_for(found.size(), [&](std::size_t row) {
      const int r = static_cast<int>(row);
      for (int c = 0; c < lattice_.width; ++c) {
        if (c + 1 < lattice_.width) look(c, r, 1, 0, found[row]);
        if (r + 1 < lattice_.height) look(c, r, 0, 1, found[row]);
      }
    });
    for (const auto& list : found)
      for (const Edge& edge : list) leaps_[edge.key] = edge.place;
    return strung();
  }

 private:
  using Key = std::array<int, 3>;  // column, row, 0 along x or 1 along y
  struct Edge {
    Key key;
    Vec2 place;
  };

  /// Surface normal at the contact.
  [[nodiscard]] Vec3 normal(const Vec2& p) const {
    return tips_.corner_normal(p, tips_.contact(p)).value_or(Vec3::UnitZ());
  }

  /// Adds an edge with a jump. A jump persists under bisection of the edge.
  void look(int c, int r, int along_x, int along_y, std::vector<Edge>& found) const {
    Vec3 from = lattice_.at(c, r), to = lattice_.at(c + along_x, r + along_y);
    Vec2 a = lattice_.place(c, r), b = lattice_.place(c + along_x, r + along_y);
    if ((from - to).norm() < least_turn_ || (from - to).head<2>().dot(b - a) <= 0) return;
    for (int i = 0; i < 14; ++i) {
      const Vec2 middle = 0.5 * (a + b);
      const Vec3 n = normal(middle);
      if ((n - from).squaredNorm() < (n - to).squaredNorm())
        a = middle, from = n;
      else
        b = middle, to = n;
    }
    if ((from - to).norm() > 0.7 * least_turn_) found.push_back({{c, r, along_y}, 0.5 * (a + b)});
  }

  /// Joins the jumps on the edges of each square; adjacent squares share the jump on their common
  /// edge.
  std::vector<std::vector<Vec2>> strung() {
    std::map<Key, std::vector<Key>> next;
    const auto join = [&](const Key& a, const Key& b) { next[a].push_back(b), next[b].push_back(a); };
    for (int r = 0; r + 1 < lattice_.height; ++r)
      for (int c = 0; c + 1 < lattice_.width; ++c) {
        std::vector<Key> here;
        for (const Key& key : {Key{c, r, 0}, Key{c, r, 1}, Key{c, r + 1, 0}, Key{c + 1, r, 1}})
          if (leaps_.contains(key)) here.push_back(key);
        // In a square with more jumps, each is joined to its nearest neighbour.
        if (here.size() == 2) join(here[0], here[1]);
        if (here.size() > 2)
          for (std::size_t i = 1; i < here.size(); ++i) join(here[0], here[i]);
      }
    std::vector<std::vector<Vec2>> lines;
    const auto trace = [&](Key at) {
      std::vector<Vec2> line{leaps_[at]};
      while (!next[at].empty()) {
        const Key to = next[at].back();
        next[at].pop_back();
        auto& back = next[to];
        back.erase(std::find(back.begin(), back.end(), at));
        line.push_back(leaps_[to]);
        at = to;
      }
      lines.push_back(std::move(line));
    };
    // polylines from ends and branch points first, then closed ones
    for (const auto& [key, neighbours] : next)
      while (next[key].size() % 2 == 1) trace(key);
    for (const auto& [key, neighbours] : next)
      while (!next[key].empty()) trace(key);
    return lines;
  }

  const TipSurface& tips_;
  double least_turn_;
  Lattice<Vec3> lattice_;
  std::map<Key, Vec2> leaps_;
};

}  // namespace

std::vector<Path> pencil(const TipSurface& tips, const FinishSettings& settings, double cell, double least_angle,
                         Progress& progress) {
  const FlatCornerCone form = tips.profile().closed_form();
  if (!form.valid || !(form.corner > tips.allowance()))
    throw Error(ErrorKind::bad_input, "pencil", "needs a ball, bull-nose or tapered tool");
  std::vector<Path> paths;
  for (const std::vector<Vec2>& line : Valleys(tips, settings.area, cell, least_angle).find(progress)) {
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i) length += (line[i] - line[i - 1]).norm();
    if (length < 2 * cell) continue;
    Follower follower(tips, settings.bottom, settings.tolerance);
    for (const Vec2& p : line) follower.go(p);
    Path path;
    for (const Vec3& p : follower.take()) path.points.push_back({p});
    paths.push_back(std::move(path));
  }
  return paths;
}

}  // namespace fieldfab::cam
