// SPDX-License-Identifier: BSD-3-Clause
#include "first_methods.h"

#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/CoordinateSequenceFilter.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/geom/prep/PreparedGeometryFactory.h>

#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <cmath>
#include <memory>
#include <utility>

#include "tricover/collide.h"

namespace tricover::bench {
namespace {

void move(const Ring& ring, const Pose& pose, Ring& moved) {
  const Eigen::Matrix2d turn = pose.linear();
  const Vec2 shift = pose.translation();
  moved.resize(ring.size());
  for (std::size_t i = 0; i < ring.size(); ++i) moved[i] = turn * ring[i] + shift;
}

std::size_t askTricover(const FirstAsked& asked) {
  const Polygon fixed(asked.fixed.data(), asked.fixed.size()), moving(asked.moving.data(), asked.moving.size());
  std::size_t hits = 0;
  for (std::size_t i = 0; i < asked.queries; ++i)
    hits += collide(fixed, Pose::Identity(), moving, asked.poses[i]) ? 1 : 0;
  return hits;
}

/// In plain doubles: boxes, edges against edges where their boxes meet, one vertex of each in the other.
class PlainLoop {
 public:
  static bool collide(const Ring& a, const Ring& b) {
    const Box box_a(a), box_b(b);
    if (!box_a.meets(box_b)) return false;
    for (std::size_t i = 0, last = a.size() - 1; i < a.size(); last = i++) {
      const Box edge_a(a[last], a[i]);
      if (!edge_a.meets(box_b)) continue;
      for (std::size_t k = 0, before = b.size() - 1; k < b.size(); before = k++) {
        if (edge_a.meets(Box(b[before], b[k])) && cross(a[last], a[i], b[before], b[k])) return true;
      }
    }
    return holds(a, b[0]) || holds(b, a[0]);
  }

 private:
  struct Box {
    Vec2 low, high;
    Box(const Vec2& p, const Vec2& q) : low(p.cwiseMin(q)), high(p.cwiseMax(q)) {}
    explicit Box(const Ring& ring) : Box(ring[0], ring[0]) {
      for (const Vec2& v : ring) {
        low = low.cwiseMin(v);
        high = high.cwiseMax(v);
      }
    }
    bool meets(const Box& o) const {
      return low.x() <= o.high.x() && o.low.x() <= high.x() && low.y() <= o.high.y() && o.low.y() <= high.y();
    }
  };

  static double side(const Vec2& p, const Vec2& q, const Vec2& r) {
    return (q.x() - p.x()) * (r.y() - p.y()) - (q.y() - p.y()) * (r.x() - p.x());
  }
  static bool cross(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
    return side(p, q, r) * side(p, q, s) <= 0 && side(r, s, p) * side(r, s, q) <= 0;
  }
  static bool holds(const Ring& ring, const Vec2& point) {
    bool inside = false;
    for (std::size_t i = 0, last = ring.size() - 1; i < ring.size(); last = i++) {
      const Vec2 &p = ring[last], &q = ring[i];
      if ((p.y() <= point.y()) != (q.y() <= point.y()) && (side(p, q, point) > 0) == (q.y() > p.y())) inside = !inside;
    }
    return inside;
  }
};

std::size_t askPlainLoop(const FirstAsked& asked) {
  Ring moved;
  std::size_t hits = 0;
  for (std::size_t i = 0; i < asked.queries; ++i) {
    move(asked.moving, asked.poses[i], moved);
    hits += PlainLoop::collide(asked.fixed, moved) ? 1 : 0;
  }
  return hits;
}

using BoostPoint = boost::geometry::model::d2::point_xy<double>;
using BoostRing = boost::geometry::model::polygon<BoostPoint, false>;  // counter-clockwise

void toBoost(const Ring& ring, BoostRing& to) {
  to.outer().clear();
  for (const Vec2& v : ring) to.outer().emplace_back(v.x(), v.y());
  to.outer().push_back(to.outer().front());
}

std::size_t askBoost(const FirstAsked& asked) {
  BoostRing fixed, at;
  toBoost(asked.fixed, fixed);
  Ring moved;
  std::size_t hits = 0;
  for (std::size_t i = 0; i < asked.queries; ++i) {
    move(asked.moving, asked.poses[i], moved);
    toBoost(moved, at);
    hits += boost::geometry::intersects(fixed, at) ? 1 : 0;
  }
  return hits;
}

std::unique_ptr<geos::geom::Polygon> toGeos(const Ring& ring) {
  std::vector<geos::geom::Coordinate> coordinates;
  for (const Vec2& v : ring) coordinates.emplace_back(v.x(), v.y());
  coordinates.push_back(coordinates.front());
  const auto& factory = *geos::geom::GeometryFactory::getDefaultInstance();
  return factory.createPolygon(
      factory.createLinearRing(std::make_unique<geos::geom::CoordinateArraySequence>(std::move(coordinates))));
}

/// Writes a ring's vertices, moved, over a geometry's.
class GeosMover : public geos::geom::CoordinateSequenceFilter {
 public:
  explicit GeosMover(const Ring& ring) : ring_(ring) {}
  void start(const Pose& pose) {
    move(ring_, pose, moved_);
    moved_.push_back(moved_.front());
  }
  void filter_rw(geos::geom::CoordinateSequence& sequence, std::size_t i) override {
    if (i != 0) return;
    for (std::size_t k = 0; k < moved_.size(); ++k)
      sequence.setAt(geos::geom::Coordinate(moved_[k].x(), moved_[k].y()), k);
  }
  bool isDone() const override { return false; }
  bool isGeometryChanged() const override { return true; }

 private:
  const Ring& ring_;
  Ring moved_;
};

template <bool Prepared>
std::size_t askGeos(const FirstAsked& asked) {
  const auto fixed = toGeos(asked.fixed), moved = toGeos(asked.moving);
  std::unique_ptr<geos::geom::prep::PreparedGeometry> prepared;
  if (Prepared) prepared = geos::geom::prep::PreparedGeometryFactory::prepare(fixed.get());
  GeosMover mover(asked.moving);
  std::size_t hits = 0;
  for (std::size_t i = 0; i < asked.queries; ++i) {
    mover.start(asked.poses[i]);
    moved->apply_rw(mover);
    hits += (Prepared ? prepared->intersects(moved.get()) : fixed->intersects(moved.get())) ? 1 : 0;
  }
  return hits;
}

b2PolygonShape toBox2d(const Ring& ring) {
  b2Vec2 vertices[b2_maxPolygonVertices];
  for (std::size_t i = 0; i < ring.size(); ++i)
    vertices[i].Set(static_cast<float>(ring[i].x()), static_cast<float>(ring[i].y()));
  b2PolygonShape shape;
  shape.Set(vertices, static_cast<int>(ring.size()));
  return shape;
}

std::size_t askBox2d(const FirstAsked& asked) {
  const b2PolygonShape fixed = toBox2d(asked.fixed), moving = toBox2d(asked.moving);
  b2Transform still;
  still.SetIdentity();
  std::size_t hits = 0;
  for (std::size_t i = 0; i < asked.queries; ++i) {
    const Pose& pose = asked.poses[i];
    b2Transform at;
    at.p.Set(static_cast<float>(pose.translation().x()), static_cast<float>(pose.translation().y()));
    at.q.c = static_cast<float>(pose.linear()(0, 0));
    at.q.s = static_cast<float>(pose.linear()(1, 0));
    hits += b2TestOverlap(&fixed, 0, &moving, 0, still, at) ? 1 : 0;
  }
  return hits;
}

}  // namespace

const char* const kFirstReport = "first";

const std::vector<FirstMethod>& firstMethods() {
  static const std::vector<FirstMethod> methods = {
      {"tricover", FirstMethod::Ours, askTricover},      {"Boost", FirstMethod::Library, askBoost},
      {"GEOS", FirstMethod::Library, askGeos<false>},    {"GEOS prepared", FirstMethod::Library, askGeos<true>},
      {"a plain loop", FirstMethod::Loop, askPlainLoop}, {"Box2D", FirstMethod::Box2d, askBox2d},
  };
  return methods;
}

}  // namespace tricover::bench
