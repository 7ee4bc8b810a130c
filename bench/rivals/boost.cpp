// SPDX-License-Identifier: BSD-3-Clause
#include "boost.h"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/multi_polygon.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <limits>

#include "geos.h"
#include "tricover/collide.h"
#include "tricover/distance.h"

namespace tricover::bench {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using Point = bg::model::d2::point_xy<double>;
using Part = bg::model::polygon<Point>;
using Region = bg::model::multi_polygon<Part>;
using Box = bg::model::box<Point>;
using Segment = bg::model::segment<Point>;
template <class Bounds>
using Tree = bgi::rtree<std::pair<Bounds, std::uint32_t>, bgi::rstar<16>>;

Point pointOf(const Vec2& v) { return {v.x(), v.y()}; }
Box boxOf(const Eigen::AlignedBox2d& box) { return {pointOf(box.min()), pointOf(box.max())}; }

Part::ring_type ringOf(const Ring& ring) {
  Part::ring_type result;
  for (const Vec2& v : ring) result.push_back(pointOf(v));
  result.push_back(result.front());
  return result;
}

/// One polygon a part of the region, rings turned the way Boost wants them.
Region regionOf(const Polygon& polygon) {
  const auto region = geosRegion(polygon);
  Region result;
  result.resize(region->getNumGeometries());
  for (std::size_t part = 0; part < result.size(); ++part) {
    const std::vector<Ring> rings = ringsOfPart(*region, part);
    result[part].outer() = ringOf(rings[0]);
    for (std::size_t i = 1; i < rings.size(); ++i) result[part].inners().push_back(ringOf(rings[i]));
  }
  bg::correct(result);
  return result;
}

/// A region whose coordinates are rewritten in place.
class Moved {
 public:
  explicit Moved(const Polygon& polygon) : original_(regionOf(polygon)), moved_(original_) {}

  /// The region where the pose takes it, until the next call.
  const Region& at(const Pose& pose) {
    for (std::size_t part = 0; part < moved_.size(); ++part) {
      const Part& original = original_[part];
      Part& moved = moved_[part];
      transform(original.outer(), pose, moved.outer());
      for (std::size_t k = 0; k < original.inners().size(); ++k)
        transform(original.inners()[k], pose, moved.inners()[k]);
    }
    return moved_;
  }

 private:
  static void transform(const Part::ring_type& from, const Pose& pose, Part::ring_type& to) {
    const Eigen::Matrix2d linear = pose.linear();
    const Vec2 translation = pose.translation();
    for (std::size_t i = 0; i < from.size(); ++i)
      to[i] = pointOf(linear * Vec2(from[i].x(), from[i].y()) + translation);
  }

  Region original_, moved_;
};

bool intersect(const Region& a, const Region& b) {
  return a.size() == 1 && b.size() == 1 ? bg::intersects(a[0], b[0]) : bg::intersects(a, b);
}

Tree<Box> treeOf(const std::vector<Eigen::AlignedBox2d>& boxes) {
  std::vector<std::pair<Box, std::uint32_t>> values;
  values.reserve(boxes.size());
  for (const Eigen::AlignedBox2d& box : boxes)
    values.emplace_back(boxOf(box), static_cast<std::uint32_t>(values.size()));
  return Tree<Box>(values);
}

std::vector<Eigen::AlignedBox2d> boxesOf(const Placement& placement) {
  std::vector<Eigen::AlignedBox2d> boxes;
  boxes.reserve(placement.size());
  for (const Placed& placed : placement) boxes.push_back(boundsOf(placed.polygon, placed.pose));
  return boxes;
}

double cross(const Vec2& v, const Vec2& w) { return v.x() * w.y() - v.y() * w.x(); }

}  // namespace

struct BoostGeometry::Shapes {
  Region still;
  Moved moved;
};

BoostGeometry::BoostGeometry(const Polygon& fixed, const Polygon& moving)
    : fixed_is_still_(fixed.vertexCount() >= moving.vertexCount()) {
  const Polygon &still = fixed_is_still_ ? fixed : moving, &moved = fixed_is_still_ ? moving : fixed;
  shapes_ = std::make_shared<Shapes>(Shapes{regionOf(still), Moved(moved)});
}

void BoostGeometry::prepare(const std::vector<Pose>& poses) {
  poses_ = poses;
  if (fixed_is_still_) return;
  for (Pose& pose : poses_) pose = pose.inverse(Eigen::Isometry);
}

bool BoostGeometry::collide(std::size_t i) { return intersect(shapes_->still, shapes_->moved.at(poses_[i])); }

double BoostGeometry::value(std::size_t i) {
  const Region &still = shapes_->still, &moved = shapes_->moved.at(poses_[i]);
  return still.size() == 1 && moved.size() == 1 ? bg::distance(still[0], moved[0]) : bg::distance(still, moved);
}

struct BoostTree::Shapes {
  std::vector<Region> still;
  Tree<Box> tree;
  Moved moved;
};

BoostTree::BoostTree(const Placement& placement, const Polygon& moving)
    : shapes_(std::make_shared<Shapes>(Shapes{{}, treeOf(boxesOf(placement)), Moved(moving)})) {
  for (const Placed& placed : placement) shapes_->still.push_back(regionOf(posed(placed.polygon, placed.pose)));
}

bool BoostTree::collide(std::size_t i) {
  const Region& moved = shapes_->moved.at(poses_[i]);
  const auto meets = [&](const auto& value) { return intersect(shapes_->still[value.second], moved); };
  const Box box = bg::return_envelope<Box>(moved);
  const auto query = bgi::intersects(box) && bgi::satisfies(meets);
  return shapes_->tree.qbegin(query) != shapes_->tree.qend();
}

struct BoostRays::Edges {
  std::vector<std::pair<Vec2, Vec2>> ends;
  Tree<Segment> tree;
};

BoostRays::BoostRays(const Placement& placement, std::vector<Ray> rays)
    : edges_(std::make_shared<Edges>()), rays_(std::move(rays)) {
  std::vector<std::pair<Segment, std::uint32_t>> values;
  for (const Placed& placed : placement) {
    const Polygon polygon = posed(placed.polygon, placed.pose);
    for (EdgeIndex e = 0; e < polygon.edgeCount(); ++e) {
      const Vec2 v = polygon.edgeStart(e), w = polygon.edgeEnd(e);
      values.emplace_back(Segment(pointOf(v), pointOf(w)), static_cast<std::uint32_t>(edges_->ends.size()));
      edges_->ends.emplace_back(v, w);
    }
  }
  edges_->tree = Tree<Segment>(values);
}

double BoostRays::value(std::size_t i) {
  const auto& [from, to] = rays_[i];
  const Segment ray(pointOf(from), pointOf(to));
  double nearest = std::numeric_limits<double>::infinity();
  const auto query = bgi::intersects(ray);
  for (auto it = edges_->tree.qbegin(query); it != edges_->tree.qend(); ++it) {
    const auto& [v, w] = edges_->ends[it->second];
    nearest = std::min(nearest, cross(v - from, w - v) / cross(to - from, w - v));
  }
  return nearest;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> meetingBoxes(const std::vector<Eigen::AlignedBox2d>& boxes,
                                                                  std::size_t first) {
  const Tree<Box> tree = treeOf(boxes);
  std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs;
  std::vector<std::pair<Box, std::uint32_t>> found;
  for (std::uint32_t i = 0; i < first; ++i) {
    found.clear();
    tree.query(bgi::intersects(boxOf(boxes[i])), std::back_inserter(found));
    for (const auto& value : found) {
      if (value.second > i) pairs.emplace_back(i, value.second);
    }
  }
  return pairs;
}

struct BoostMap::Boxes {
  Tree<Box> tree;
};

BoostMap::BoostMap(Placement bodies)
    : bodies_(std::move(bodies)), boxes_(std::make_shared<Boxes>(Boxes{treeOf(boxesOf(bodies_))})) {}

bool BoostMap::collides(const Polygon& polygon, const Pose& pose) const {
  const Tree<Box>& tree = boxes_->tree;
  for (auto at = tree.qbegin(bgi::intersects(boxOf(boundsOf(polygon, pose)))); at != tree.qend(); ++at)
    if (collide(bodies_[at->second].polygon, bodies_[at->second].pose, polygon, pose)) return true;
  return false;
}

double BoostMap::distance(const Polygon& polygon, const Pose& pose) const {
  const Tree<Box>& tree = boxes_->tree;
  const Box box = boxOf(boundsOf(polygon, pose));
  double least = std::numeric_limits<double>::infinity(), reach = -1;
  // As many nearest boxes as it takes: going on one by one, the tree sorts all of them again and again.
  for (unsigned count = 4; reach <= least && count < 2 * bodies_.size(); count *= 4) {
    double farthest = 0;
    for (auto at = tree.qbegin(bgi::nearest(box, count)); at != tree.qend(); ++at) {
      const double gap = bg::distance(box, at->first);
      farthest = std::max(farthest, gap);
      if (gap < reach || gap > least) continue;
      const Placed& body = bodies_[at->second];
      if (const auto found = distanceWithin(polygon, pose, body.polygon, body.pose, least)) least = found->distance;
    }
    if (farthest > least) break;
    reach = farthest;
  }
  return least;
}

}  // namespace tricover::bench
