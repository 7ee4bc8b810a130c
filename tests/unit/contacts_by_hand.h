// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "contact_laws.h"
#include "shapes.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"

namespace tricover::support {

inline const Pose kHere = Pose::Identity();

inline bool alike(const Contact& p, const Contact& q, double size) {
  return std::abs(p.depth - q.depth) <= 1e-12 * size && ((p.point - q.point) / size).norm() <= 1e-12 &&
         (p.normal - q.normal).norm() <= 1e-9 && p.edge_a == q.edge_a && p.edge_b == q.edge_b && p.count == q.count;
}

/// Whether two polygons have the same edges, wherever their rings begin and whichever way they run.
inline bool haveEqualEdges(const Polygon& a, const Polygon& b) {
  const auto edgesOf = [](const Polygon& polygon) {
    std::vector<std::array<double, 4>> edges;
    for (EdgeIndex e = 0; e < polygon.edgeCount(); ++e) {
      const Vec2 v = polygon.edgeStart(e), w = polygon.edgeEnd(e);
      edges.push_back(std::min(std::array<double, 4>{v.x(), v.y(), w.x(), w.y()},
                               std::array<double, 4>{w.x(), w.y(), v.x(), v.y()}));
    }
    std::sort(edges.begin(), edges.end());
    return edges;
  };
  return edgesOf(a) == edgesOf(b);
}

/// Asks in both orders, and looks at what holds for all contacts.
inline std::vector<Contact> ask(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  const std::vector<Contact> found = contacts(a, pose_a, b, pose_b, globally());
  std::vector<Contact> swapped = contacts(b, pose_b, a, pose_a, globally());
  EXPECT_EQ(found.empty(), !collide(a, pose_a, b, pose_b));
  EXPECT_EQ(found.size(), swapped.size());
  const double size = 2 * a.radius() + 2 * b.radius();
  for (std::size_t i = 0; i < std::min(found.size(), swapped.size()); ++i) {
    std::swap(swapped[i].edge_a, swapped[i].edge_b);
    swapped[i].normal = -swapped[i].normal;
    // Equal regions are interchangeable: nothing tells which one the normal leads from.
    EXPECT_TRUE(haveEqualEdges(a, b) || alike(found[i], swapped[i], size)) << i;
    EXPECT_NEAR(found[i].normal.norm(), 1, 1e-12);
    EXPECT_GE(found[i].depth, 0);
    EXPECT_TRUE(i == 0 || found[i].depth <= found[i - 1].depth);
    EXPECT_TRUE(found[i].edge_a >= 0 || found[i].edge_b >= 0);
    EXPECT_LT(found[i].edge_a, a.edgeCount());
    EXPECT_LT(found[i].edge_b, b.edgeCount());
  }
  return found;
}

inline std::vector<Contact> ask(const std::vector<Ring>& a, const std::vector<Ring>& b) {
  return ask(Polygon(a), kHere, Polygon(b), kHere);
}

inline void expectContact(const Contact& contact, const Vec2& point, const Vec2& normal, double depth,
                          double size = 1) {
  EXPECT_LE(((contact.point - point) / size).norm(), 1e-12) << contact.point.transpose();
  EXPECT_LE((contact.normal - normal).norm(), 1e-9) << contact.normal.transpose();
  EXPECT_NEAR(contact.depth, depth, 1e-12 * size);
}

}  // namespace tricover::support
