// SPDX-License-Identifier: BSD-3-Clause
// crossings(): which pairs of edges, and where. tests/laws/crossings.cpp has all pairs that share a point.
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "shapes.h"
#include "tricover/contacts.h"
#include "tricover/polygon.h"

namespace tricover::support {
namespace {

const Pose kHere = Pose::Identity();

/// Rings are numbered through; a vertex on an edge is both its edges';
/// collinear edges meet in the middle of what they share; a repeated vertex counts, and is no edge.
TEST(Crossings, NameEdgesAndPoints) {
  const struct {
    const char* name;
    Polygon a, b;
    std::vector<Crossing> expected;
  } table[] = {
      {"two squares", Polygon::box(4, 4), Polygon({rectangle(1, -1, 3, 1)}), {{1, 0, {2, -1}}, {1, 2, {2, 1}}}},
      {"a hole's edge",
       Polygon({rectangle(0, 0, 9, 9), rectangle(3, 3, 6, 6)}),
       Polygon({rectangle(2, 4, 4, 5)}),
       {{7, 0, {3, 4}}, {7, 2, {3, 5}}}},
      {"a vertex on an edge",
       Polygon::box(4, 4),
       Polygon({{{2, 0}, {4, -1}, {4, 1}}}),
       {{1, 0, {2, 0}}, {1, 2, {2, 0}}}},
      {"collinear edges",
       Polygon::box(4, 4),
       Polygon({rectangle(2, -1, 4, 7)}),
       {{1, 0, {2, -1}}, {1, 3, {2, 0.5}}, {2, 3, {2, 2}}}},
      {"a repeated vertex",
       Polygon::box(4, 4),
       Polygon({{{2, 0}, {2, 0}, {4, -1}, {4, 1}}}),
       {{1, 1, {2, 0}}, {1, 3, {2, 0}}}}};
  for (const auto& [name, a, b, expected] : table) {
    SCOPED_TRACE(name);
    std::vector<Crossing> found = crossings(a, kHere, b, kHere);
    std::sort(found.begin(), found.end(), [](const Crossing& p, const Crossing& q) {
      return std::pair(p.edge_a, p.edge_b) < std::pair(q.edge_a, q.edge_b);
    });
    ASSERT_EQ(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i) {
      EXPECT_EQ(std::pair(found[i].edge_a, found[i].edge_b), std::pair(expected[i].edge_a, expected[i].edge_b));
      EXPECT_LE((found[i].point - expected[i].point).norm(), 1e-13) << found[i].point.transpose();
    }
  }
}

TEST(Crossings, RefuseWhatCollideRefuses) {
  const Polygon a({rectangle(0, 0, 4, 4)});
  Pose bad = kHere;
  bad.translation().x() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(crossings(a, bad, a, kHere), std::invalid_argument);
  EXPECT_THROW(crossings(a, kHere, a, bad), std::invalid_argument);
}

TEST(Crossings, WithAMarginAreOfEdgesWithinIt) {
  const Polygon square({rectangle(0, 0, 4, 4)});
  const auto beside = [&](double x, double margin) {
    return crossings(square, Pose::Identity(), square, turnedAndMoved(0, x, 1), {margin});
  };
  EXPECT_TRUE(beside(5, 0.5).empty());
  EXPECT_TRUE(beside(5, nudged(1, -1)).empty());
  const std::vector<Crossing> found = beside(5, 1);
  ASSERT_FALSE(found.empty());
  for (const Crossing& crossing : found) EXPECT_EQ(crossing.point.x(), 4.5);
  EXPECT_EQ(beside(5, 100).size(), 16u);
  EXPECT_EQ(beside(5, 1e300).size(), 16u);
}

}  // namespace
}  // namespace tricover::support
