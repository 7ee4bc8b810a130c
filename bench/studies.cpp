// SPDX-License-Identifier: BSD-3-Clause
#include "studies.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <stdexcept>
#include <string>
#include <tuple>
#include <utility>

#include "inputs.h"
#include "matrix.h"
#include "plain_core.h"
#include "rivals/boost.h"
#include "rivals/box2d.h"
#include "rivals/fcl_call.h"
#include "rivals/fcl_meshes.h"
#include "rivals/fcl_prisms.h"
#include "rivals/geos.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/paper.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"
#include "tricover_fcl/tricover_fcl.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr bool kCoherent = true, kAnywhere = false;  ///< whether a method's samples are long runs

/// tricover's core as its users call it, the fixed polygon at the identity; `cache`: nothing, or one.
template <class... Cache>
class Core {
 public:
  Core(Polygon fixed, Polygon moving) : fixed_(std::move(fixed)), moving_(std::move(moving)) {}
  void prepare(const std::vector<Pose>& poses) { poses_ = poses.data(); }
  bool collide(std::size_t i) {
    return asked(i, [](auto&... query) { return tricover::collide(query...); });
  }
  double value(std::size_t i) {
    return asked(i, [](auto&... query) { return distance(query...).distance; });
  }

 protected:
  template <class Ask>
  auto asked(std::size_t i, Ask ask) {
    return std::apply([&](auto&... cache) { return ask(fixed_, identity_, moving_, poses_[i], cache...); }, cache_);
  }

 private:
  Polygon fixed_, moving_;
  Pose identity_ = Pose::Identity();
  const Pose* poses_ = nullptr;
  std::tuple<Cache...> cache_;
};
using CachedCore = Core<PairCache>;

/// The paper's Algorithm 3.
class PaperCore : public Core<paper::MaskCache> {
 public:
  using Core::Core;
  bool collide(std::size_t i) {
    return asked(i, [](auto&... query) { return paper::collide(query...); });
  }
};

/// Whether there is any contact.
template <class... Cache>
class ContactCore : public Core<Cache...> {
 public:
  using Core<Cache...>::Core;
  bool collide(std::size_t i) {
    return this->asked(i, [](auto&... query) { return !contacts(query...).empty(); });
  }
};

class ImpactCore {
 public:
  ImpactCore(Polygon fixed, Polygon moving) : fixed_(std::move(fixed)), moving_(std::move(moving)) {}
  void prepare(const std::vector<Motion>& motions) { motions_ = motions.data(); }
  double value(std::size_t i) {
    const auto impact = timeOfImpact(fixed_, still_, moving_, motions_[i], {0, kTimeError});
    return impact ? impact->time : kInfinity;
  }

 private:
  Polygon fixed_, moving_;
  Motion still_;
  const Motion* motions_ = nullptr;
};

/// A geometry of no known type. Its collision function, once registered, answers "free" and does nothing else: what
/// fcl::collide costs whoever registers a function.
class EmptyGeometry : public fcl::CollisionGeometryd {
 public:
  fcl::OBJECT_TYPE getObjectType() const override { return fcl::OT_GEOM; }
  void computeLocalAABB() override {
    aabb_local = fcl::AABBd(fcl::Vector3d::Zero());
    aabb_center.setZero();
    aabb_radius = 0;
  }
};

Geometry emptyGeometry() {
  using Solver = fcl::detail::GJKSolver_libccdd;
  // A slot that neither FCL nor tricover uses.
  fcl::getCollisionFunctionLookTable<Solver>().collision_matrix[fcl::BV_UNKNOWN][fcl::BV_UNKNOWN] =
      [](const fcl::CollisionGeometryd*, const fcl::Transform3d&, const fcl::CollisionGeometryd*,
         const fcl::Transform3d&, const Solver*, const fcl::CollisionRequestd&,
         fcl::CollisionResultd&) { return std::size_t{0}; };
  return std::make_shared<EmptyGeometry>();
}

Geometry shapeOf(const Polygon& polygon) { return std::make_shared<tricover_fcl::PolygonShaped>(polygon); }

template <class Answers>
MethodTable<Answers> ourMethods(const Polygon& fixed, const Polygon& moving) {
  MethodTable<Answers> table;
  table.template add<Core<>>("cold", Role::Ours, kAnywhere, kAny, fixed, moving);
  table.template add<CachedCore>("cached", Role::Ours, kCoherent, kSmallSteps, fixed, moving);
  table.template add<FclCall>("via FCL", Role::Ours, kCoherent, kAny, shapeOf(fixed), shapeOf(moving));
  return table;
}

MethodTable<Hits> collisionMethods(const Polygon& fixed, const Polygon& moving) {
  MethodTable<Hits> table = ourMethods<Hits>(fixed, moving);
  table.add<PaperCore>("paper", Role::Ours, kCoherent, kPaper, fixed, moving);
  table.add<FclCall>("empty", Role::Floor, kAnywhere, kAny, emptyGeometry(), emptyGeometry());
  table.addMade(kPlain,
                [walk = tricover_plain_double::plainWalk(fixed.rings(), moving.rings())](
                    const std::vector<Pose>& poses) -> Contender {
                  return {"plain signs", Role::Inexact, kAnywhere,
                          [&poses, walk](const Sampling& sampling, Hits& hits) {
                            walk(poses.data(), poses.size(), sampling.period, sampling.run, sampling.first, hits);
                          }};
                });
  const auto mpr = table.add<FclMpr>("FCL MPR", Role::Rival, kAnywhere, kAny, fixed, moving);
  table.decided_at_once = [mpr] { return mpr->decidedAtOnce(); };
  table.add<FclGjk>("FCL GJK", Role::Rival, kAnywhere, kAny, fixed, moving, false);
  table.add<FclGjk>("FCL GJK guess", Role::Rival, kCoherent, kSmallSteps, fixed, moving, true);
  table.add<FclBvh>("FCL BVH", Role::Rival, kAnywhere, kAny, fixed, moving);
  table.add<Geos>("GEOS", Role::Rival, kAnywhere, kAny, fixed, moving);
  table.add<BoostGeometry>("Boost", Role::Rival, kAnywhere, kAny, fixed, moving);
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    table.add<Box2dOverlap>("Box2D overlap", Role::Box2d, kAnywhere, kAny, fixed, moving);
    table.add<Box2dManifold>("Box2D manifold", Role::Box2d, kAnywhere, kAny, fixed, moving);
  }
  return table;
}

MethodTable<Values> distanceMethods(const Polygon& fixed, const Polygon& moving) {
  // Methods that compare all edges with all are timed up to this number of pairs. Beyond it they are the slowest.
  const bool few = fixed.vertexCount() * moving.vertexCount() <= 64 * 64;
  MethodTable<Values> table = ourMethods<Values>(fixed, moving);
  table.add<FclRssDistance>("FCL RSS", Role::Rival, kAnywhere, kAny, fixed, moving);
  if (fixed.isConvex() && moving.isConvex()) {
    table.add<LibccdDistance>("FCL GJK (libccd)", Role::Rival, kAnywhere, kAny, fixed, moving, false);
    table.add<IndepDistance>("FCL GJK (indep)", Role::Rival, kAnywhere, kAny, fixed, moving, false);
    table.add<IndepDistance>("FCL GJK (indep) guess", Role::Rival, kCoherent, kSmallSteps, fixed, moving, true);
  }
  table.add<Geos>("GEOS prepared", Role::Rival, kAnywhere, kAny, fixed, moving);
  if (few) table.add<Geos>("GEOS", Role::Rival, kAnywhere, kAny, fixed, moving, false);
  if (few) table.add<BoostGeometry>("Boost", Role::Rival, kAnywhere, kAny, fixed, moving);
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    table.add<Box2dDistance>("Box2D", Role::Box2d, kAnywhere, kAny, fixed, moving, false);
    table.add<Box2dDistance>("Box2D warm", Role::Box2d, kCoherent, kSmallSteps, fixed, moving, true);
  }
  return table;
}

MethodTable<Values, Motion> impactMethods(const Polygon& fixed, const Polygon& moving) {
  const std::vector<Triangle> a = triangulate(fixed), b = triangulate(moving);
  MethodTable<Values, Motion> table;
  table.add<ImpactCore>("cold", Role::Ours, kAnywhere, kAny, fixed, moving);
  table.add<FclAdvancement>("via FCL", Role::Ours, kAnywhere, kAny, shapeOf(fixed), shapeOf(moving));
  table.add<FclAdvancement>("FCL RSS", Role::Rival, kAnywhere, kAny, makeFlatMesh<fcl::RSSd>(a),
                            makeFlatMesh<fcl::RSSd>(b));
  table.add<FclAdvancement>("FCL OBBRSS", Role::Rival, kAnywhere, kAny, makeFlatMesh(a), makeFlatMesh(b));
  if (box2dTakes(fixed) && box2dTakes(moving)) {
    table.add<Box2dImpact>("Box2D", Role::Box2d, kAnywhere, kAny, fixed, moving);
    table.add<Box2dCast>("Box2D cast", Role::Box2d, kAnywhere, kSliding, fixed, moving);
  }
  return table;
}

MethodTable<Hits> contactMethods(const Polygon& fixed, const Polygon& moving) {
  MethodTable<Hits> table;
  table.add<ContactCore<>>("cold", Role::Ours, kCoherent, kAny, fixed, moving);
  table.add<ContactCore<PairCache>>("cached", Role::Ours, kCoherent, kAny, fixed, moving);
  if (box2dTakes(fixed) && box2dTakes(moving))
    table.add<Box2dManifold>("Box2D manifold", Role::Box2d, kCoherent, kAny, fixed, moving);
  return table;
}

MethodTable<Hits> soupMethods(const Polygon& fixed, const Polygon& moving) {
  // Each ring's own triangles, as they overlap.
  const auto trianglesOf = [](const Polygon& polygon) {
    std::vector<Triangle> triangles;
    for (const Ring& ring : polygon.rings())
      for (const Triangle& triangle : triangulate(Polygon({ring}))) triangles.push_back(triangle);
    return triangles;
  };
  MethodTable<Hits> table = ourMethods<Hits>(fixed, moving);
  table.add<FclBvh>("FCL BVH", Role::Rival, kAnywhere, kAny, trianglesOf(fixed), trianglesOf(moving));
  return table;
}

/// From a pose where polygons of 100 units overlap by 0.2, to and fro by less than a thousandth of a step, or in steps
/// on along the surface.
std::vector<Pose> contactWalk(const std::string& name, const Polygon& fixed, const Polygon& moving) {
  constexpr std::size_t kSteps = 100;
  constexpr double kDepth = 0.2, kStep = 0.1;
  for (Pose pose : workloads::contactPoses(fixed, moving, 7)) {
    const auto deep = penetration(fixed, Pose::Identity(), moving, pose);
    if (!deep || !(deep->depth > 2 * kDepth)) continue;
    pose.translation() += (1 - kDepth / deep->depth) * deep->translation;
    const Vec2 along(-deep->normal.y(), deep->normal.x());
    std::vector<Pose> poses(kSteps, pose);
    bool overlaps = true;
    for (std::size_t i = 0; i < kSteps; ++i) {
      const auto step = static_cast<double>(i);
      poses[i].translation() += kStep * (name == "sliding contact" ? step : 1e-3 * std::sin(step)) * along;
      overlaps = overlaps && collide(fixed, Pose::Identity(), moving, poses[i]);
    }
    if (overlaps) return poses;
  }
  throw std::runtime_error("contact study: no pose found");
}

/// The study's poses, and poses apart. The circle is cut to its first tenth, which begins at the smallest gap, and
/// overlaps to 100: meshes and triangles take long there.
std::vector<Pose> distancePoses(const std::string& name, const Polygon& fixed, const Polygon& moving) {
  std::vector<Pose> poses = name == "near"  ? separatedPoses(fixed, moving, 1.03, 1.5)
                            : name == "far" ? separatedPoses(fixed, moving, 2, 4)
                                            : posesOf(name, fixed, moving);
  poses.resize(std::min<std::size_t>(poses.size(), name == "overlap" ? 100 : 9000));
  return poses;
}

std::vector<Motion> impactMotions(const std::string& name, const Polygon& fixed, const Polygon& moving) {
  return randomMotions(fixed, moving, (fixed.radius() + moving.radius()) / 2, name == "turning" ? 2.6 : 0, 3);
}

Shape shapeOf(Kind kind) {
  return {workloads::name(kind),
          [kind](std::size_t vertices, std::uint64_t seed) { return workloads::makePolygon(kind, vertices, seed); }};
}

using Sizes = std::vector<std::pair<std::size_t, std::size_t>>;

std::vector<Cell> cellsOf(const std::vector<Shape>& shapes, const Sizes& sizes, const std::vector<std::string>& names) {
  std::vector<Cell> cells;
  for (const Shape& shape : shapes)
    for (const auto& [fixed, moving] : sizes) cells.push_back({shape, fixed, moving, names});
  return cells;
}

std::vector<Shape> allShapes() {
  std::vector<Shape> shapes;
  for (const Kind kind : workloads::allKinds()) shapes.push_back(shapeOf(kind));
  return shapes;
}

std::vector<Cell> studyCells(bool full) {
  std::vector<Cell> cells;
  for (const Kind kind : workloads::allKinds()) {
    for (std::size_t fixed = 8; fixed <= 1024; fixed *= 2) {
      for (std::size_t moving = 8; moving <= 1024; moving *= 2) {
        const bool diagonal = fixed == moving && (fixed == 8 || fixed == 64 || fixed == 1024);
        const bool corner = (fixed == 512 && moving == 16) || (fixed == 1024 && moving == 8);
        if (full || diagonal || corner) {
          cells.push_back({shapeOf(kind), fixed, moving, workloadNames()});
        } else if (kind == Kind::Contour) {
          cells.push_back({shapeOf(kind), fixed, moving, {"circular"}});
        }
      }
    }
  }
  return cells;
}

}  // namespace

unsigned traitsOf(const Workload& workload) {
  const std::string& name = workload.name;
  const bool follows_table_2 = name == "circular" || name == "linear";
  return (follows_table_2 || name == "gap 0.1" || name == "gap 0.01" ? kSmallSteps : kAny) |
         (follows_table_2 && workload.vertices_fixed == workload.vertices_moving ? kPaper : kAny) |
         (name == "contact" ? kPlain : kAny) | (name == "sliding" ? kSliding : kAny);
}

std::vector<Result> measureCollisions(bool full, const Settings& settings) {
  return measureAll("study", studyCells(full), collisionMethods, posesOf, settings);
}

std::vector<Result> measureDistances(bool full, Settings settings) {
  // The polygons are 100 units long: GJK's tolerance and floats pass.
  settings.agreement = {0, {0, 0}, {1e-4, 1e-4}};
  const Sizes some = {{8, 8}, {64, 64}, {1024, 1024}, {512, 16}};
  const Sizes all = {{8, 8},     {16, 16},  {32, 32},     {64, 64},  {128, 128}, {256, 256},
                     {512, 512}, {512, 16}, {1024, 1024}, {1024, 8}, {8, 1024}};
  return measureAll(
      "distance", cellsOf(allShapes(), full ? all : some, {"circular", "linear", "gap 0.01", "near", "far", "overlap"}),
      distanceMethods, distancePoses, settings);
}

std::vector<Result> measureImpacts(bool full, Settings settings) {
  // FCL's advancement stops short of contact where it comes slowly; that isn't counted as wrong below a thousandth.
  settings.agreement = {1, {kTimeError, kTimeError}, {1e-3, 2 * kTimeError}};
  const Sizes some = {{8, 8}, {64, 64}}, all = {{8, 8}, {16, 16}, {64, 64}, {256, 256}, {512, 16}, {1024, 1024}};
  std::vector<Cell> cells = cellsOf(allShapes(), full ? all : some, {"sliding", "turning"});
  if (!full) cells.push_back({shapeOf(Kind::Contour), 512, 16, {"sliding", "turning"}});
  return measureAll("impact", cells, impactMethods, impactMotions, settings);
}

std::vector<Result> measureContacts(const Settings& settings) {
  const std::vector<std::string> names = {"resting contact", "sliding contact"};
  return measureAll("contacts",
                    {{shapeOf(Kind::Convex), 8, 8, names},
                     {shapeOf(Kind::Convex), 64, 64, names},
                     {shapeOf(Kind::Contour), 64, 64, names}},
                    contactMethods, contactWalk, settings);
}

std::vector<Result> measureSoups(const Settings& settings) {
  const auto overlapping = [](const char* name, std::size_t corners, double squeeze) {
    return Shape{name, [=](std::size_t vertices, std::uint64_t seed) {
                   return workloads::makeOverlapping(vertices / corners, corners, squeeze, seed);
                 }};
  };
  return measureAll("soups",
                    cellsOf({overlapping("soup", 3, 1), overlapping("needles", 3, 0.1), overlapping("rings", 8, 1)},
                            {{64, 64}, {1024, 1024}, {512, 16}}, workloadNames()),
                    soupMethods, posesOf, settings);
}

}  // namespace tricover::bench
