// SPDX-License-Identifier: BSD-3-Clause
#include "boost_tree.h"

#include <algorithm>
#include <boost/geometry/index/rtree.hpp>
#include <limits>

#include "boost_region.h"

namespace tricover::bench {
namespace {

namespace bg = boost::geometry;
namespace bgi = boost::geometry::index;
using Box = bg::model::box<BoostPoint>;
using Segment = bg::model::segment<BoostPoint>;
template <class Bounds>
using Tree = bgi::rtree<std::pair<Bounds, std::uint32_t>, bgi::rstar<16>>;

BoostPoint boostPoint(const Vec2& v) { return {v.x(), v.y()}; }

Tree<Box> treeOf(const std::vector<Eigen::AlignedBox2d>& boxes) {
  std::vector<std::pair<Box, std::uint32_t>> values;
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    values.emplace_back(Box(boostPoint(boxes[i].min()), boostPoint(boxes[i].max())), static_cast<std::uint32_t>(i));
  }
  return Tree<Box>(values);
}

std::vector<Eigen::AlignedBox2d> boxesOf(const Placement& placement) {
  std::vector<Eigen::AlignedBox2d> boxes;
  for (const Placed& placed : placement) boxes.push_back(boundsOf(placed.polygon, placed.pose));
  return boxes;
}

double cross(const Vec2& v, const Vec2& w) { return v.x() * w.y() - v.y() * w.x(); }

}  // namespace

struct BoostTree::Shapes {
  std::vector<BoostRegion> still;
  Tree<Box> tree;
  BoostMoved moved;
};

BoostTree::BoostTree(const Placement& placement, const Polygon& moving)
    : shapes_(std::make_unique<Shapes>(Shapes{{}, treeOf(boxesOf(placement)), BoostMoved(moving)})) {
  for (const Placed& placed : placement) shapes_->still.push_back(boostRegion(posed(placed.polygon, placed.pose)));
}

BoostTree::~BoostTree() = default;

void BoostTree::prepare(std::vector<Pose> poses) { poses_ = std::move(poses); }

bool BoostTree::collide(std::size_t i) {
  const BoostRegion& moved = shapes_->moved.at(poses_[i]);
  const auto meets = [&](const auto& value) { return boostIntersects(shapes_->still[value.second], moved); };
  const Box box = bg::return_envelope<Box>(moved);
  const auto query = bgi::intersects(box) && bgi::satisfies(meets);
  return shapes_->tree.qbegin(query) != shapes_->tree.qend();
}

struct BoostRays::Edges {
  std::vector<std::pair<Vec2, Vec2>> ends;
  Tree<Segment> tree;
};

BoostRays::BoostRays(const Placement& placement, std::vector<Ray> rays)
    : edges_(std::make_unique<Edges>()), rays_(std::move(rays)) {
  std::vector<std::pair<Segment, std::uint32_t>> values;
  for (const Placed& placed : placement) {
    const Polygon polygon = posed(placed.polygon, placed.pose);
    for (const Ring& ring : polygon.rings()) {
      for (std::size_t k = 0; k < ring.size(); ++k) {
        const Vec2 &v = ring[k], &w = ring[(k + 1) % ring.size()];
        values.emplace_back(Segment(boostPoint(v), boostPoint(w)), static_cast<std::uint32_t>(edges_->ends.size()));
        edges_->ends.emplace_back(v, w);
      }
    }
  }
  edges_->tree = Tree<Segment>(values);
}

BoostRays::~BoostRays() = default;

double BoostRays::value(std::size_t i) {
  const auto& [from, to] = rays_[i];
  const Segment ray(boostPoint(from), boostPoint(to));
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
    tree.query(bgi::intersects(Box(boostPoint(boxes[i].min()), boostPoint(boxes[i].max()))), std::back_inserter(found));
    for (const auto& value : found) {
      if (value.second > i) pairs.emplace_back(i, value.second);
    }
  }
  return pairs;
}

}  // namespace tricover::bench
