// SPDX-License-Identifier: BSD-3-Clause
#include "exact_overlay.h"

#include <algorithm>
#include <cstddef>
#include <map>
#include <utility>

namespace tricover::exact {
namespace {

/// The sweep goes along u = x + shear * y, in which no edge is upright. The other coordinate is y.
struct Swept {
  mpq_class u, y;
};

struct Edge {
  Swept v, w;  ///< v.u <= w.u
  int turn;    ///< What crossing the edge upwards adds to the winding number.
  bool is_point, of_part;
};

mpq_class heightAt(const Edge& e, const mpq_class& u) {
  return e.v.y + (u - e.v.u) * (e.w.y - e.v.y) / (e.w.u - e.v.u);
}

class Sweep {
 public:
  Sweep(const Polygon& part, const Pose& pose_part, const Polygon& region, const Pose& pose_region, Target target)
      : part_fill_(part.fillRule()),
        region_fill_(region.fillRule()),
        region_is_complement_(region.isComplement()),
        target_(target) {
    std::vector<WorldSegment> of_part = edgesOf(part, pose_part), of_region = edgesOf(region, pose_region);
    is_infinite_ = part.isComplement() && !isTarget(0);
    if (is_infinite_) return;
    // Beyond all edges everything is target.
    if (part.isComplement()) addFrame(of_part, of_region);
    while (hasUpright(of_part) || hasUpright(of_region)) shear_ = (shear_ + 1) / 3;
    add(of_part, true);
    add(of_region, false);
  }

  Overlay result() {
    Overlay all;
    all.is_infinite = is_infinite_;
    if (is_infinite_) return all;
    const std::vector<mpq_class> breaks = breaksOf();
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) walk(breaks[i], breaks[i + 1], all);
    for (const auto& [edge, piece] : open_) close(edge, piece, all);
    addPoints(all);
    return all;
  }

 private:
  using Piece = std::pair<mpq_class, mpq_class>;  // of an edge, by its ends' u

  static std::vector<WorldSegment> edgesOf(const Polygon& polygon, const Pose& pose) {
    const auto& m = pose.matrix();
    const auto at = [&](const Vec2& p) {
      return WorldPoint{mpq_class(m(0, 0)) * p.x() + mpq_class(m(0, 1)) * p.y() + mpq_class(m(0, 2)),
                        mpq_class(m(1, 0)) * p.x() + mpq_class(m(1, 1)) * p.y() + mpq_class(m(1, 2))};
    };
    std::vector<WorldSegment> edges;
    for (const Ring& ring : polygon.rings())
      for (std::size_t i = 0; i < ring.size(); ++i) edges.push_back({at(ring[i]), at(ring[(i + 1) % ring.size()])});
    return edges;
  }

  /// A complement's rings count as even-odd: with a ring around all, they bound its part in there.
  static void addFrame(std::vector<WorldSegment>& of_part, const std::vector<WorldSegment>& of_region) {
    WorldPoint low = of_part[0].v, high = low;
    for (const auto* edges : {&std::as_const(of_part), &of_region})
      for (const WorldSegment& e : *edges) {
        low = {std::min(low.x, e.v.x), std::min(low.y, e.v.y)};
        high = {std::max(high.x, e.v.x), std::max(high.y, e.v.y)};
      }
    const mpq_class room = (high.x - low.x) + (high.y - low.y);
    low = {low.x - room, low.y - room}, high = {high.x + room, high.y + room};
    const WorldPoint corners[] = {low, {high.x, low.y}, high, {low.x, high.y}};
    for (int i = 0; i < 4; ++i) of_part.push_back({corners[i], corners[(i + 1) % 4]});
  }

  mpq_class along(const WorldPoint& p) const { return p.x + shear_ * p.y; }
  WorldPoint world(const Edge& e, const mpq_class& u) const {
    const mpq_class y = heightAt(e, u);
    return {u - shear_ * y, y};
  }

  bool hasUpright(const std::vector<WorldSegment>& edges) const {
    return std::any_of(edges.begin(), edges.end(),
                       [&](const WorldSegment& e) { return !(e.v == e.w) && along(e.v) == along(e.w); });
  }

  void add(const std::vector<WorldSegment>& edges, bool of_part) {
    for (const WorldSegment& e : edges) {
      const Swept v{along(e.v), e.v.y}, w{along(e.w), e.w.y};
      const bool ahead = v.u <= w.u;
      edges_.push_back({ahead ? v : w, ahead ? w : v, ahead ? 1 : -1, e.v == e.w, of_part});
    }
  }

  static bool isWound(FillRule fill, int winding) {
    return fill == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
  }
  bool isTarget(int winding) const {
    const bool is_region = isWound(region_fill_, winding) != region_is_complement_;
    return is_region == (target_ == Target::Region);
  }

  /// Where edges end or cross, sorted.
  std::vector<mpq_class> breaksOf() const {
    std::vector<mpq_class> breaks;
    for (const Edge& e : edges_) breaks.insert(breaks.end(), {e.v.u, e.w.u});
    for (std::size_t i = 0; i < edges_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        const Edge &e = edges_[i], &f = edges_[j];
        const mpq_class low = std::max(e.v.u, f.v.u), high = std::min(e.w.u, f.w.u);
        if (e.is_point || f.is_point || low >= high) continue;
        const mpq_class first = heightAt(e, low) - heightAt(f, low), last = heightAt(e, high) - heightAt(f, high);
        if (sgn(first) * sgn(last) < 0) breaks.push_back(low + (high - low) * first / (first - last));
      }
    std::sort(breaks.begin(), breaks.end());
    breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
    return breaks;
  }

  /// The edges that lie on one line between two breaks.
  struct Level {
    mpq_class y;
    std::vector<std::size_t> edges;
  };
  std::vector<Level> levelsAt(const mpq_class& u) const {
    std::vector<std::pair<mpq_class, std::size_t>> heights;
    for (std::size_t i = 0; i < edges_.size(); ++i)
      if (edges_[i].v.u < u && u < edges_[i].w.u) heights.emplace_back(heightAt(edges_[i], u), i);
    std::sort(heights.begin(), heights.end());
    std::vector<Level> levels;
    for (auto& [y, i] : heights) {
      if (levels.empty() || levels.back().y != y) levels.push_back({y, {}});
      levels.back().edges.push_back(i);
    }
    return levels;
  }

  void walk(const mpq_class& u, const mpq_class& v, Overlay& all) {
    const std::vector<Level> levels = levelsAt((u + v) / 2);
    int of_part = 0, of_region = 0;
    for (std::size_t i = 0; i < levels.size(); ++i) {
      const std::vector<std::size_t>& on = levels[i].edges;
      const bool below = isTarget(of_region);
      bool has_part = false, has_region = false;
      std::size_t first_of_region = 0;
      for (const std::size_t k : on) {
        const Edge& e = edges_[k];
        if (!e.of_part && !has_region) first_of_region = k;
        (e.of_part ? has_part : has_region) = true;
        (e.of_part ? of_part : of_region) += e.turn;
      }
      const bool above = isTarget(of_region), is_border = target_ == Target::Region ? has_region : below != above;
      if (is_border) extend(first_of_region, u, v, all);
      const Edge& e = edges_[on[0]];
      if (has_part && !below && !above && !is_border) all.cells.push_back({world(e, u), world(e, v), world(e, v)});
      if (i + 1 == levels.size() || !isWound(part_fill_, of_part) || above) continue;
      const Edge& f = edges_[levels[i + 1].edges[0]];
      all.cells.push_back({world(e, u), world(e, v), world(f, v)});
      all.cells.push_back({world(e, u), world(f, v), world(f, u)});
    }
  }

  /// Pieces of one edge that follow each other are one.
  void extend(std::size_t edge, const mpq_class& u, const mpq_class& v, Overlay& all) {
    const auto at = open_.find(edge);
    if (at != open_.end() && at->second.second == u) {
      at->second.second = v;
      return;
    }
    if (at != open_.end()) close(edge, at->second, all);
    open_[edge] = {u, v};
  }
  void close(std::size_t edge, const Piece& piece, Overlay& all) const {
    all.border.push_back({world(edges_[edge], piece.first), world(edges_[edge], piece.second)});
  }

  static bool isOn(const Swept& p, const Edge& e) {
    if (e.is_point) return p.u == e.v.u && p.y == e.v.y;
    return e.v.u <= p.u && p.u <= e.w.u && heightAt(e, p.u) == p.y;
  }

  /// Vertices that are said twice, and polygons that are points.
  void addPoints(Overlay& all) const {
    for (const Edge& e : edges_) {
      const WorldPoint p{e.v.u - shear_ * e.v.y, e.v.y};
      if (e.is_point && !e.of_part && target_ == Target::Region) all.border.push_back({p, p});
      if (e.is_point && e.of_part && !isTargetAt(e.v, all)) all.cells.push_back({p, p, p});
    }
  }
  /// Beside no border one side is as good as the other.
  bool isTargetAt(const Swept& p, const Overlay& all) const {
    for (const WorldSegment& s : all.border) {
      const Swept v{along(s.v), s.v.y}, w{along(s.w), s.w.y};
      if (isOn(p, v.u <= w.u ? Edge{v, w, 1, s.v == s.w, false} : Edge{w, v, 1, false, false})) return true;
    }
    int winding = 0;
    for (const Edge& e : edges_)
      if (!e.of_part && e.v.u <= p.u && p.u < e.w.u && heightAt(e, p.u) <= p.y) winding += e.turn;
    return isTarget(winding);
  }

  std::vector<Edge> edges_;
  std::map<std::size_t, Piece> open_;
  mpq_class shear_{1, 7};
  FillRule part_fill_, region_fill_;
  bool region_is_complement_, is_infinite_ = false;
  Target target_;
};

}  // namespace

bool operator==(const WorldPoint& p, const WorldPoint& q) { return p.x == q.x && p.y == q.y; }

Overlay overlay(const Polygon& part, const Pose& pose_part, const Polygon& region, const Pose& pose_region,
                Target target) {
  return Sweep(part, pose_part, region, pose_region, target).result();
}

}  // namespace tricover::exact
