// SPDX-License-Identifier: BSD-3-Clause
#include <algorithm>
#include <cstddef>
#include <functional>
#include <limits>

#include "exact_depth.h"
#include "exact_plane.h"

namespace tricover::exact {
namespace {

constexpr Real kRounding = 0x1p-58L;

/// A border's vertex or line.
struct Feature {
  bool is_line;
  Spot at, normal;
};

/// Calls with the roots of a t^2 + b t + c = 0.
void eachRoot(Real a, Real b, Real c, const std::function<void(Real)>& call) {
  const Real root = b * b - 4 * a * c;
  if (root < 0) return;
  const Real q = -(b + (b < 0 ? -std::sqrt(root) : std::sqrt(root))) / 2;
  if (a != 0) call(q / a);
  if (q != 0) call(c / q);
}

class Candidates {
 public:
  explicit Candidates(const RealOverlay& plane) : plane_(plane) {
    for (const Segment& s : plane.border) {
      for (const Spot& p : {s.v, s.w}) addPoint(p);
      const Real length = norm(s.w - s.v);
      if (length > 0) features_.push_back({true, s.v, (1 / length) * Spot{s.v.y - s.w.y, s.w.x - s.v.x}});
    }
  }

  Real largest() {
    for (const auto& c : plane_.cells) {
      for (const Spot& p : c) most_ = std::max(most_, distanceAt(p));
      if (norm(c[2] - c[1]) == 0 && norm(c[1] - c[0]) > 0) alongPiece(c[0], c[1]);
    }
    for (std::size_t i = 0; i < features_.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        for (std::size_t k = 0; k < j; ++k) ofThree({features_[i], features_[j], features_[k]});
    return most_;
  }

 private:
  void addPoint(const Spot& p) {
    for (const Feature& f : features_)
      if (!f.is_line && f.at.x == p.x && f.at.y == p.y) return;
    features_.push_back({false, p, {}});
  }

  Real distanceAt(const Spot& p) const {
    Real least = std::numeric_limits<Real>::infinity();
    for (const Segment& s : plane_.border) least = std::min(least, distanceFrom(s, p));
    return least;
  }

  /// The squared distance along p + t u as a polynomial.
  static void addSquare(const Feature& f, Real sign, const Spot& p, const Spot& u, Real (&sum)[3]) {
    const Spot off = p - f.at;
    const Real along = f.is_line ? dot(f.normal, u) : 0, at = f.is_line ? dot(f.normal, off) : 0;
    sum[0] += sign * (f.is_line ? at * at : dot(off, off));
    sum[1] += sign * 2 * (f.is_line ? at * along : dot(off, u));
    sum[2] += sign * (f.is_line ? along * along : dot(u, u));
  }
  static Real farAway(const Feature& f, const Spot& p) {
    return f.is_line ? std::abs(dot(f.normal, p - f.at)) : norm(p - f.at);
  }

  /// Squares lose half of a short distance's digits: Newton's steps bring them back.
  static Real polished(const Feature& f, const Feature& g, const Spot& p, const Spot& u, Real t) {
    const auto slope = [&](const Feature& h, const Spot& at) -> Real {
      const Spot off = at - h.at;
      if (h.is_line) return dot(h.normal, off) < 0 ? -dot(h.normal, u) : dot(h.normal, u);
      return norm(off) > 0 ? dot(off, u) / norm(off) : 0;
    };
    for (int step = 0; step < 3; ++step) {
      const Spot at = p + t * u;
      const Real turn = slope(f, at) - slope(g, at);
      if (turn == 0) return t;
      t -= (farAway(f, at) - farAway(g, at)) / turn;
    }
    return t;
  }

  void alongPiece(const Spot& v, const Spot& w) {
    for (const Feature& f : features_)
      for (const Feature& g : features_) {
        if (&f == &g) break;
        Real square[3] = {};
        addSquare(f, 1, v, w - v, square);
        addSquare(g, -1, v, w - v, square);
        eachRoot(square[2], square[1], square[0], [&](Real t) {
          for (const Real at : {t, polished(f, g, v, w - v, t)})
            if (0 <= at && at <= 1) most_ = std::max(most_, distanceAt(v + at * (w - v)));
        });
      }
  }

  void tryAt(const Spot& p) {
    const Real distance = distanceAt(p);
    if (!(distance > most_) || !(distance < 8)) return;
    for (const auto& c : plane_.cells) {
      const Real area = cross(c[1] - c[0], c[2] - c[0]), turn = area < 0 ? -1 : 1;
      bool is_in = area != 0;
      for (std::size_t i = 0; i < 3; ++i) {
        const Spot side = c[(i + 1) % 3] - c[i];
        is_in = is_in && turn * cross(side, p - c[i]) >= -kRounding * norm(side);
      }
      if (!is_in) continue;
      most_ = distance;
      return;
    }
  }

  /// Points equally far from two of three lie on a line p + t u, of which two run through where they are equally far
  /// for two lines; on a parabola otherwise, beside the third.
  void ofThree(std::array<Feature, 3> f) {
    std::sort(f.begin(), f.end(), [](const Feature& p, const Feature& q) { return p.is_line > q.is_line; });
    const auto along = [&](const Spot& p, const Spot& u, const Feature& g, const Feature& h) {
      Real square[3] = {};
      addSquare(g, 1, p, u, square);
      addSquare(h, -1, p, u, square);
      eachRoot(square[2], square[1], square[0], [&](Real t) { tryAt(p + t * u); });
    };
    if (!f[1].is_line) {  // two points at least
      const Spot between = f[2].at - f[1].at;
      return along(0.5L * (f[1].at + f[2].at), {-between.y, between.x}, f[0], f[1]);
    }
    const Feature &e = f[0], &g = f[1];
    const Real slant = cross(e.normal, g.normal);
    for (const Real sign : {1.0L, -1.0L}) {
      // (e.normal - sign g.normal) . p = offset
      const Spot normal = e.normal - sign * g.normal;
      const Real square = dot(normal, normal), offset = dot(e.normal, e.at) - sign * dot(g.normal, g.at);
      if (square < 1e-30L) continue;
      const Spot at = std::abs(slant) < 1e-12L
                          ? (offset / square) * normal
                          : (1 / slant) * Spot{dot(e.normal, e.at) * g.normal.y - dot(g.normal, g.at) * e.normal.y,
                                               e.normal.x * dot(g.normal, g.at) - g.normal.x * dot(e.normal, e.at)};
      along(at, {-normal.y, normal.x}, f[2], e);
    }
  }

  const RealOverlay& plane_;
  std::vector<Feature> features_;
  Real most_ = 0;
};

Real largest(const Overlay& exact) {
  if (exact.is_infinite) return std::numeric_limits<Real>::infinity();
  if (exact.cells.empty()) return 0;
  const RealOverlay plane(exact);
  return std::ldexp(Candidates(plane).largest(), plane.exponent);
}

}  // namespace

Real excessByCandidates(const Polygon& part, const Pose& pose_part, const Polygon& area, const Pose& pose_area) {
  return largest(overlay(part, pose_part, area, pose_area, Target::Region));
}

Real depthByCandidates(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  return std::max(largest(overlay(a, pose_a, b, pose_b, Target::Outside)),
                  largest(overlay(b, pose_b, a, pose_a, Target::Outside)));
}

}  // namespace tricover::exact
