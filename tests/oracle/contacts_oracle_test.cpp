// SPDX-License-Identifier: BSD-3-Clause
// crossings() against all pairs of edges, contacts() against collisions, components and translations, on exact numbers.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <numeric>
#include <set>

#include "contact_laws.h"
#include "exact_reference.h"
#include "families.h"
#include "random.h"
#include "reproduction.h"
#include "shapes.h"
#include "test_scale.h"
#include "tricover/contacts.h"

namespace tricover::support {
namespace {

using Pairs = std::vector<std::pair<std::ptrdiff_t, std::ptrdiff_t>>;

Pairs pairsOf(const std::vector<Crossing>& crossings, bool swapped) {
  Pairs pairs;
  for (const Crossing& c : crossings) pairs.emplace_back(swapped ? c.edge_b : c.edge_a, swapped ? c.edge_a : c.edge_b);
  std::sort(pairs.begin(), pairs.end());
  return pairs;
}

bool isEdge(const Polygon& polygon, std::ptrdiff_t edge) { return edge >= 0 && edge < polygon.edgeCount(); }

/// What is wrong with a pair's contacts whatever their number; empty if nothing is.
std::string wrongContacts(const Case& c, const std::vector<Contact>& found, bool crossed) {
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Contact& contact = found[i];
    if (!(std::abs(contact.normal.norm() - 1) <= 1e-12)) return "a normal that isn't unit";
    if (!(contact.depth >= 0 && std::isfinite(contact.depth))) return "a depth";
    if (!contact.point.allFinite()) return "a point";
    if (i > 0 && contact.depth > found[i - 1].depth) return "the order";
    const bool of_a = isEdge(c.a, contact.edge_a), of_b = isEdge(c.b, contact.edge_b);
    if (!of_a && !(contact.edge_a == -1 && of_b)) return "edge_a";
    if (!of_b && !(contact.edge_b == -1 && of_a)) return "edge_b";
    if (!crossed && of_a && of_b) return "an edge of what holds the other";
    if (crossed && found.size() == 1 && !(of_a && of_b)) return "no edge, where edges cross";
  }
  return {};
}

std::vector<Contact> contactsOf(const Case& c, ContactDetail detail) {
  ContactOptions options;
  options.detail = detail;
  return contacts(c.a, c.pose_a, c.b, c.pose_b, options);
}

/// What is wrong with contacts of parts that told nothing but points; empty if nothing is.
std::string wrongPoints(const Case& c, const std::vector<Contact>& points, const Pairs& pairs) {
  for (const Contact& contact : points) {
    if (contact.depth != 0 || contact.normal != Vec2::Zero()) return "a depth of a point";
    const bool crosses = contact.edge_a >= 0 && contact.edge_b >= 0;
    if (crosses ? !std::binary_search(pairs.begin(), pairs.end(), std::pair(contact.edge_a, contact.edge_b))
                : !isEdge(c.a, contact.edge_a) && !isEdge(c.b, contact.edge_b))
      return "a point's edges";
  }
  return {};
}

/// What is wrong with contacts of less detail, given all pairs of edges that meet; empty if nothing is.
std::string wrongDetail(const Case& c, const std::vector<Contact>& found, const Pairs& pairs) {
  const std::vector<Contact> points = contactsOf(c, ContactDetail::Points),
                             local = contactsOf(c, ContactDetail::LocalDepth);
  if (points.size() != found.size() || local.size() != found.size()) return "how many there are by less detail";
  // Of convex polygons all is told.
  const std::string wrong_points = same(points, found) ? "" : wrongPoints(c, points, pairs);
  if (!wrong_points.empty()) return wrong_points;
  const std::string wrong = wrongContacts(c, local, !pairs.empty());
  if (!wrong.empty()) return wrong + ", local";
  const double error = 4 * rounding(c);
  if (local.size() != 1 || !(local[0].depth > 1e3 * error && std::isfinite(local[0].depth + 1e3 * error))) return {};
  // What crosses now doesn't when b has gone its way out of this part.
  Case moved = c;
  moved.pose_b.translation() += (local[0].depth * (1 + 1e-9) + error) * local[0].normal;
  const Pairs left = exact::meetingEdges(moved.a, moved.pose_a, moved.b, moved.pose_b);
  return std::find_first_of(pairs.begin(), pairs.end(), left.begin(), left.end()) == pairs.end()
             ? ""
             : "edges that still cross beyond the local depth";
}

std::string wrongWay(const Case& c, bool truth) {
  const Pairs pairs = exact::meetingEdges(c.a, c.pose_a, c.b, c.pose_b);
  if (pairsOf(crossings(c.a, c.pose_a, c.b, c.pose_b), false) != pairs) return "crossings";
  if (pairsOf(crossings(c.b, c.pose_b, c.a, c.pose_a), true) != pairs) return "crossings, swapped";
  const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
  if (found.empty() == truth) return "contacts";
  const std::vector<Contact> swapped = contacts(c.b, c.pose_b, c.a, c.pose_a);
  if (swapped.size() != found.size()) return "contacts, swapped";
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Contact &p = found[i], &q = swapped[i];
    if (p.point != q.point || p.normal != -q.normal || p.depth != q.depth || p.edge_a != q.edge_b ||
        p.edge_b != q.edge_a)
      return "a contact, swapped";
  }
  const std::string wrong = wrongContacts(c, found, !pairs.empty());
  return wrong.empty() ? wrongDetail(c, found, pairs) : wrong;
}

class ContactsOracle : public testing::TestWithParam<Family> {};

TEST_P(ContactsOracle, AgreesWithExactRationals) {
  const int cases = scaledCount(1500);
  int hits = 0, many = 0, disagreements = 0;
  for (int i = 0; i < cases; ++i) {
    const auto seed = static_cast<std::uint64_t>(i);
    const Case c = GetParam().make(seed);
    const bool truth = exact::collide(c.a, c.pose_a, c.b, c.pose_b);
    hits += truth;
    many += contacts(c.a, c.pose_a, c.b, c.pose_b).size() > 1;
    const std::string wrong = wrongWay(c, truth);
    if (!wrong.empty() && ++disagreements <= 3)
      ADD_FAILURE() << GetParam().name << " seed " << seed << ": " << wrong << "\n" << reproduction(c);
  }
  std::printf("%-22s %6d cases %6d hits %6d with several contacts\n", GetParam().name, cases, hits, many);
  EXPECT_EQ(disagreements, 0);
  if (cases >= 100) {
    EXPECT_GE(hits, 0.15 * cases);
    EXPECT_LE(hits, 0.85 * cases);
  }
}

std::string familyName(const testing::TestParamInfo<Family>& family) { return family.param.name; }

INSTANTIATE_TEST_SUITE_P(Families, ContactsOracle, testing::ValuesIn(families()), familyName);

constexpr int kCells = 12, kFine = 2 * kCells + 1;

/// A ring whose edges run along the axes from grid point to grid point, crossing and covering each other at will.
Ring rectilinear(Random& random, int corners) {
  Ring ring;
  int x = random.integer(0, kCells), y = random.integer(0, kCells);
  const int first_x = x;
  for (int i = 0; i < corners; ++i) {
    ring.emplace_back(x, y);
    x = i + 1 < corners ? random.integer(0, kCells) : first_x;
    ring.emplace_back(x, y);
    y = random.integer(0, kCells);
  }
  ring.back().x() = first_x;
  ring.emplace_back(first_x, ring.front().y());
  return ring;
}

/// A ring without area: there and back along the grid, or one point.
Ring withoutArea(Random& random) {
  const Vec2 p(random.integer(0, kCells), random.integer(0, kCells));
  Vec2 q = p;
  (random.coin() ? q.x() : q.y()) = random.integer(0, kCells);
  if (random.oneIn(4)) return {p, q, p, Vec2(p.x(), random.integer(0, kCells))};
  return random.coin() ? Ring{p, q, q} : Ring{p, q, p};
}

Polygon anyRectilinear(Random& random) {
  std::vector<Ring> rings;
  // Beside others, or alone.
  if (random.oneIn(3))
    for (int i = random.integer(1, 3); i > 0; --i) rings.push_back(withoutArea(random));
  if (!rings.empty() && random.oneIn(4)) return Polygon(rings);
  for (int i = random.integer(1, 4); i > 0; --i) {
    const int x = random.integer(0, kCells - 1), y = random.integer(0, kCells - 1);
    rings.push_back(random.oneIn(3) ? rectilinear(random, random.integer(2, 4))
                                    : rectangle(x, y, random.integer(x + 1, kCells), random.integer(y + 1, kCells)));
  }
  return Polygon(redirected(random, std::move(rings)), random.coin() ? FillRule::EvenOdd : FillRule::NonZero);
}

/// Where the point (x, y) / 2 lies in a polygon on the grid: on an edge, or by the winding number along a ray to the
/// right, a little above.
Location place(const Polygon& polygon, int x, int y) {
  int winding = 0;
  for (const Ring& ring : polygon.rings()) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 v = 2 * ring[i], w = 2 * ring[(i + 1) % ring.size()];
      const double low_x = std::min(v.x(), w.x()), high_x = std::max(v.x(), w.x());
      const double low_y = std::min(v.y(), w.y()), high_y = std::max(v.y(), w.y());
      if (low_x <= x && x <= high_x && low_y <= y && y <= high_y) return Location::Boundary;
      if (v.x() == w.x() && v.x() > x && low_y <= y && y < high_y) winding += v.y() < w.y() ? 1 : -1;
    }
  }
  const bool inside = polygon.fillRule() == FillRule::EvenOdd ? winding % 2 != 0 : winding != 0;
  return inside ? Location::Inside : Location::Outside;
}

struct Components {
  std::size_t all = 0;
  std::size_t with_cells = 0;  ///< with an area
  std::size_t entering = 0;  ///< with those, and those where an edge that has no area beside it enters the other region
  std::vector<std::size_t> part = std::vector<std::size_t>(kFine * kFine);  ///< of the grid twice as fine; 0 is none

  /// The component that a point of the grid's plane is in; 0 if it is in none. The point is rounded.
  std::size_t partAt(const Vec2& point) const {
    for (const double y : {point.y(), point.y() - 1e-9, point.y() + 1e-9})
      for (const double x : {point.x(), point.x() - 1e-9, point.x() + 1e-9})
        if (const std::size_t found = part[static_cast<std::size_t>(fine(y) * kFine + fine(x))]) return found;
    return 0;
  }

 private:
  /// Grid lines are even, what is between them odd.
  static int fine(double coordinate) {
    const double line = std::round(coordinate);
    const double index = std::abs(coordinate - line) < 1e-10 ? 2 * line : 2 * std::floor(coordinate) + 1;
    return std::clamp(static_cast<int>(index), 0, kFine - 1);
  }
};

/// The components of the overlap by flooding the grid's points, sides and cells, which are the points of a grid twice
/// as fine.
Components countByFlooding(const Polygon& a, const Polygon& b) {
  constexpr int n = kFine;
  enum Wet : char { None, Touching, Entering };
  std::vector<char> wet(n * n);
  const auto at = [&](int x, int y) -> char& { return wet[static_cast<std::size_t>(y * n + x)]; };
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      const Location in_a = place(a, x, y), in_b = place(b, x, y);
      if (in_a == Location::Outside || in_b == Location::Outside) continue;
      at(x, y) = in_a == Location::Inside || in_b == Location::Inside ? Entering : Touching;
    }
  }
  Components count;
  std::vector<std::pair<int, int>> front;
  for (int y = 0; y < n; ++y) {
    for (int x = 0; x < n; ++x) {
      if (at(x, y) == None) continue;
      bool has_cells = false, enters = false;
      const auto take = [&](int i, int j) {
        has_cells = has_cells || (i % 2 == 1 && j % 2 == 1);
        enters = enters || at(i, j) == Entering;
        at(i, j) = None;
        count.part[static_cast<std::size_t>(j * n + i)] = count.all + 1;
        front.emplace_back(i, j);
      };
      take(x, y);
      while (!front.empty()) {
        const auto [p, q] = front.back();
        front.pop_back();
        for (const auto& [i, j] : {std::pair{p - 1, q}, {p + 1, q}, {p, q - 1}, {p, q + 1}})
          if (i >= 0 && j >= 0 && i < n && j < n && at(i, j) != None) take(i, j);
      }
      ++count.all;
      count.with_cells += has_cells;
      count.entering += enters;
    }
  }
  return count;
}

TEST(ContactsOracleGrid, AreAsManyAsTheOverlapHasComponents) {
  const int cases = scaledCount(20000);
  int several = 0, touching = 0, none = 0, wrong = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const Polygon a = anyRectilinear(random), b = anyRectilinear(random);
    const Components count = countByFlooding(a, b);
    several += count.all > 1;
    touching += count.entering < count.all;
    none += count.all == 0;
    // The same map for both, which leaves the collinear collinear, exactly, whatever rounding does to it.
    Pose both = randomPose(random, 9);
    if (random.oneIn(3)) both.linear().setIdentity();
    if (random.oneIn(3)) both = mirrored(both);
    // Points and local depths are told as they are of several parts.
    const ContactDetail detail = random.oneIn(3) ? ContactDetail::Points : ContactDetail::LocalDepth;
    const std::vector<Contact> found = contacts(a, both, b, both), other = contactsOf({a, both, b, both}, detail);
    std::set<std::size_t> other_parts;
    for (const Contact& contact : other) other_parts.insert(count.partAt(both.inverse() * contact.point));
    const auto deep = static_cast<std::size_t>(
        std::count_if(found.begin(), found.end(), [](const Contact& contact) { return contact.depth > 0; }));
    std::set<std::size_t> parts;
    for (const Contact& contact : found) parts.insert(count.partAt(both.inverse() * contact.point));
    const bool counted = found.size() == count.all && deep >= count.with_cells && deep <= count.entering;
    const bool placed = parts.size() == found.size() && parts.count(0) == 0 && other_parts == parts;
    if (!(counted && placed) && ++wrong <= 3)
      ADD_FAILURE() << "seed " << i << ": " << found.size() << " contacts, " << deep << " of them deep, not "
                    << count.all << " and " << count.with_cells << " to " << count.entering << ", their points in "
                    << parts.size() << " parts" << (parts.count(0) ? ", some outside" : "") << "\n"
                    << reproduction({a, both, b, both});
  }
  std::printf("%d cases, %d with several components, %d with some that only touch, %d with none, %d wrong\n", cases,
              several, touching, none, wrong);
  EXPECT_EQ(wrong, 0);
  if (cases >= 100) {
    EXPECT_GE(several, 0.15 * cases);
    EXPECT_GE(touching, 0.1 * cases);
    EXPECT_GE(none, 0.01 * cases);
  }
}

/// By all faces of both against all vertices.
double depthBySeparatingAxes(const Case& c) {
  std::vector<Vec2> points[2];
  for (const Vec2& p : c.a.rings()[0]) points[0].push_back(c.pose_a * p);
  for (const Vec2& p : c.b.rings()[0]) points[1].push_back(c.pose_b * p);
  double least = std::numeric_limits<double>::infinity();
  for (const int side : {0, 1}) {
    const std::vector<Vec2>&of = points[side], &behind = points[1 - side];
    for (std::size_t i = 0; i < of.size(); ++i) {
      const Vec2 way = (of[(i + 1) % of.size()] - of[i]).normalized();
      for (const Vec2& normal : {Vec2(way.y(), -way.x()), Vec2(-way.y(), way.x())}) {
        double other = std::numeric_limits<double>::infinity(), own = -other;
        for (const Vec2& p : of) own = std::max(own, normal.dot(p));
        for (const Vec2& p : behind) other = std::min(other, normal.dot(p));
        least = std::min(least, own - other);
      }
    }
  }
  return least;
}

/// By how much a point is outside of a convex polygon, in plain doubles.
double outside(const Polygon& polygon, const Pose& pose, const Vec2& point) {
  const Ring& ring = polygon.rings()[0];
  double most = 0;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const Vec2 v = pose * ring[i], way = pose * ring[(i + 1) % ring.size()] - v;
    const Vec2 normal = Vec2(way.y(), -way.x()).normalized() * (pose.linear().determinant() < 0 ? -1 : 1);
    most = std::max(most, normal.dot(point - v));
  }
  return most;
}

TEST(ContactsOracleConvex, DepthAndNormalPartThemAndNothingLessDoes) {
  const int cases = scaledCount(4000);
  int hits = 0, contained = 0, wrong = 0;
  for (int i = 0; i < cases; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double size = random.coin() ? 0.2 : 1, reach = random.oneIn(4) ? 1e3 : 1;
    Case c{Polygon({anyConvex(random, 1, 12)}), randomPose(random, reach), Polygon({anyConvex(random, size, 12)}),
           randomPose(random, 1)};
    c.pose_b.translation() = c.pose_a.translation() + Vec2(random.real(-1.5, 1.5), random.real(-1.5, 1.5));
    if (random.oneIn(5)) c.pose_a = mirrored(c.pose_a);
    if (random.oneIn(5)) c.pose_b = throughFloat(c.pose_b);
    const std::vector<Contact> found = contacts(c.a, c.pose_a, c.b, c.pose_b);
    if (found.empty()) continue;
    ++hits;
    contained += found[0].edge_a < 0 || found[0].edge_b < 0;
    const auto collidesAfter = [&](double way) {
      Pose moved = c.pose_b;
      moved.translation() += way * found[0].normal;
      return exact::collide(c.a, c.pose_a, c.b, moved);
    };
    const double depth = found[0].depth, rounding = 1e-15 * (4 + 2 * reach);
    const bool right = found.size() == 1 && !collidesAfter(depth * (1 + 1e-9) + rounding) &&
                       (depth < 200 * rounding || collidesAfter(0.99 * depth)) &&
                       std::abs(depth - depthBySeparatingAxes(c)) <= 2 * rounding &&
                       outside(c.a, c.pose_a, found[0].point) <= 8 * rounding &&
                       outside(c.b, c.pose_b, found[0].point) <= 8 * rounding;
    if (!right && ++wrong <= 3)
      ADD_FAILURE() << "seed " << i << ": " << found.size() << " contacts, depth " << depth << ", by separating axes "
                    << depthBySeparatingAxes(c) << "\n"
                    << reproduction(c);
  }
  std::printf("%d cases, %d hits, %d of them containments, %d wrong\n", cases, hits, contained, wrong);
  EXPECT_EQ(wrong, 0);
  if (cases >= 100) {
    EXPECT_GE(hits, 0.3 * cases);
    EXPECT_GE(contained, 0.02 * cases);
  }
}

}  // namespace
}  // namespace tricover::support
