// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/contacts.h"

#include <algorithm>

#include "strategy.h"

namespace tricover {
namespace {

/// Where two edges that meet do so, rounded: their lines' crossing, held to the first edge; for parallel ones the end
/// of one that is nearest to the other's middle stands in.
Vec2 meetingPoint(const Vec2& v, const Vec2& w, const Vec2& p, const Vec2& q) {
  const Vec2 u = w - v, d = q - p, from = p - v;
  const double area = u.x() * d.y() - u.y() * d.x();
  if (area != 0) {
    const double s = (from.x() * d.y() - from.y() * d.x()) / area;
    if (s >= 0 && s <= 1) return v + s * u;
  }
  const Vec2 ends[] = {v, w, p, q};
  const Vec2 middle = 0.25 * v + 0.25 * w + 0.25 * p + 0.25 * q;
  return *std::min_element(ends, ends + 4, [&](const Vec2& s, const Vec2& t) {
    return (s - middle).lpNorm<1>() < (t - middle).lpNorm<1>();
  });
}

}  // namespace

std::optional<Contact> contact(const Polygon& a, const Pose& pose_a, const Polygon& b, const Pose& pose_b) {
  checkPose(pose_a, "pose_a");
  checkPose(pose_b, "pose_b");
  const detail::PosedPair pair(a.data(), pose_a, b.data(), pose_b);
  const detail::Outcome outcome = detail::collideByHierarchy(pair, {}, 0, detail::Wanted::Edges);
  if (!outcome.collides) return std::nullopt;

  Contact contact{Vec2::Zero(), -1, -1};
  const auto number = [](const detail::PolygonData& polygon, std::ptrdiff_t position) {
    return position < 0 ? position
                        : static_cast<std::ptrdiff_t>(polygon.edgeNumber(static_cast<std::size_t>(position)));
  };
  contact.edge_a = number(a.data(), outcome.edge_a);
  contact.edge_b = number(b.data(), outcome.edge_b);
  const auto at = [](const detail::PolygonData& polygon, const Pose& pose, std::ptrdiff_t position) {
    return Vec2(pose * polygon.path[static_cast<std::size_t>(position)]);
  };
  if (outcome.edge_a < 0)
    contact.point = at(b.data(), pose_b, outcome.edge_b);
  else if (outcome.edge_b < 0)
    contact.point = at(a.data(), pose_a, outcome.edge_a);
  else
    contact.point = meetingPoint(at(a.data(), pose_a, outcome.edge_a), at(a.data(), pose_a, outcome.edge_a + 1),
                                 at(b.data(), pose_b, outcome.edge_b), at(b.data(), pose_b, outcome.edge_b + 1));
  return contact;
}

}  // namespace tricover
