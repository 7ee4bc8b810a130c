// SPDX-License-Identifier: BSD-3-Clause
// First answers: polygons made of raw vertices and asked k times, all in, beside what others take for the same.
// Needs no FCL.
#include <box2d/b2_collision.h>
#include <box2d/b2_polygon_shape.h>
#include <geos/geom/CoordinateArraySequence.h>
#include <geos/geom/CoordinateSequenceFilter.h>
#include <geos/geom/GeometryFactory.h>
#include <geos/geom/LinearRing.h>
#include <geos/geom/Polygon.h>
#include <geos/geom/prep/PreparedGeometryFactory.h>

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "inputs.h"
#include "measure.h"
#include "random.h"
#include "report.h"
#include "tricover/collide.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

/// Two rings of raw vertices, counter-clockwise, and where the second one is at each query. The first stays.
struct FirstAsked {
  const Ring& fixed;
  const Ring& moving;
  const Pose* poses;
  std::size_t queries;
};

/// Makes what it needs of the raw vertices, asks every pose whether the two collide, and forgets it all.
struct FirstMethod {
  const char* name;
  Role role;          ///< Box2d: up to 8 vertices
  bool convex_alone;  ///< takes no others
  std::size_t (*hits)(const FirstAsked& asked);

  bool takes(bool convex, std::size_t vertices) const {
    return (convex || !convex_alone) && (role != Role::Box2d || vertices <= 8);
  }
};

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

const FirstMethod kMethods[] = {{"tricover", Role::Ours, false, askTricover},
                                {"Boost", Role::Rival, false, askBoost},
                                {"GEOS", Role::Rival, false, askGeos<false>},
                                {"GEOS prepared", Role::Rival, false, askGeos<true>},
                                {"Box2D", Role::Box2d, true, askBox2d}};

constexpr std::size_t kQueries[] = {1, 2, 3, 5, 10, 20, 30, 50, 100};
constexpr std::size_t kVertices[] = {4, 8, 24, 64, 1024};
constexpr std::size_t kMostQueries = 100;
constexpr std::size_t kPairs = 16;
constexpr int kRounds = 7;

/// Pairs of rings, and for each pair the poses that it may be asked at.
struct FirstCell {
  std::string poses;
  std::size_t vertices;
  bool convex;
  std::vector<Polygon> fixed, moving;
  std::vector<std::vector<Pose>> at;

  /// How often a pair is made and asked, so that a round takes some milliseconds at most.
  std::size_t visits() const { return std::min<std::size_t>(64, 8192 / vertices); }
  FirstAsked visit(std::size_t i, std::size_t queries) const {
    const std::size_t pair = i % kPairs;
    return {fixed[pair].rings()[0], moving[pair].rings()[0], at[pair].data() + i, queries};
  }
};

/// An arrowhead or, convex, a kite, of 100 units.
Polygon quadrilateral(bool convex, std::uint64_t seed) {
  support::Random random(seed);
  const double half = random.real(10, 40), tail = convex ? random.real(55, 90) : random.real(10, 40);
  const double tip = convex ? 0 : 100;
  return Polygon({{{tip, -half}, {tail, 0}, {tip, half}, {convex ? -10 : 0, 0}}});
}

Polygon ringOf(std::size_t vertices, bool convex, std::uint64_t seed) {
  if (vertices == 4) return quadrilateral(convex, seed);
  return workloads::makePolygon(convex ? workloads::Kind::Slim : workloads::Kind::Contour, vertices, seed);
}

FirstCell makeCell(std::size_t vertices, bool convex, const std::string& poses) {
  FirstCell cell{poses, vertices, convex, {}, {}, {}};
  for (std::size_t pair = 0; pair < kPairs; ++pair) {
    cell.fixed.push_back(ringOf(vertices, convex, 2 * pair + 1));
    cell.moving.push_back(ringOf(vertices, convex, 2 * pair + 2));
    const Polygon &a = cell.fixed.back(), &b = cell.moving.back();
    const std::size_t positions = cell.visits() + kMostQueries;
    cell.at.push_back(poses == "near" ? workloads::nearPoses(a, b, pair, positions)
                                      : workloads::overlapPoses(a, b, pair, positions));
  }
  return cell;
}

/// The answers of polygons that have been asked often.
std::size_t hitsKnown(const FirstCell& cell, std::size_t queries) {
  std::size_t hits = 0;
  for (std::size_t i = 0; i < cell.visits(); ++i)
    for (std::size_t k = 0; k < queries; ++k)
      hits += collide(cell.fixed[i % kPairs], Pose::Identity(), cell.moving[i % kPairs], cell.at[i % kPairs][i + k])
                  ? 1
                  : 0;
  return hits;
}

Result measureRow(const FirstCell& cell, std::size_t queries) {
  std::vector<Task> tasks;
  std::size_t hits = 0, of_ours = 0;
  for (const FirstMethod& method : kMethods) {
    if (!method.takes(cell.convex, cell.vertices)) continue;
    tasks.push_back({method.name, method.role, [&] {
                       hits = 0;
                       for (std::size_t i = 0; i < cell.visits(); ++i) hits += method.hits(cell.visit(i, queries));
                       if (method.role == Role::Ours) of_ours = hits;
                     }});
  }
  const std::string name = cell.poses + " k=" + std::to_string(queries);
  Result result = measureInTurn(
      {"first", cell.convex ? "convex" : "outline", name, cell.vertices, cell.vertices, cell.visits() * queries}, tasks,
      kRounds);
  if (of_ours != hitsKnown(cell, queries)) throw std::logic_error("first answers differ from later ones: " + name);
  result.workload.positions = queries;
  return result;
}

const char* const kHow =
    R"(- Nanoseconds a query, all in: both polygons made of raw vertices, tested at k poses, and forgotten. CPU time of one
  thread, methods in turn, medians of 7. Others move the vertices and build what they need.
)";

}  // namespace

bool run(const std::string& directory, bool) {
  std::vector<Result> results;
  for (const bool convex : {false, true}) {
    for (const std::size_t vertices : kVertices) {
      if (convex && vertices > 8) continue;
      for (const char* poses : {"near", "deep"}) {
        const FirstCell cell = makeCell(vertices, convex, poses);
        for (const std::size_t queries : kQueries) results.push_back(measureRow(cell, queries));
      }
    }
  }
  return writeStudies(directory, "first", {{"First answers", results}}, kHow);
}

}  // namespace tricover::bench
