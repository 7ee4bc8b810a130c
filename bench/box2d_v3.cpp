// SPDX-License-Identifier: BSD-3-Clause
// Small convex pairs, and the nearest of many bodies, beside Box2D v3, which Debian doesn't have: built where CMake is
// told where its sources are (TRICOVER_BENCH_BOX2D_V3). Needs no FCL.
#include <box2d/collision.h>
#include <box2d/math_functions.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "inputs.h"
#include "measure.h"
#include "random.h"
#include "report.h"
#include "shapes.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/polygon.h"
#include "tricover/scene.h"
#include "tricover/time_of_impact.h"

namespace tricover::bench {
namespace {

constexpr int kRounds = 15;
const Pose kStill = Pose::Identity();

b2Vec2 vectorOf(const Vec2& v) { return {static_cast<float>(v.x()), static_cast<float>(v.y())}; }
float angleOf(const Pose& pose) { return static_cast<float>(std::atan2(pose.linear()(1, 0), pose.linear()(0, 0))); }
b2Transform transformOf(const Pose& pose) { return {vectorOf(pose.translation()), b2MakeRot(angleOf(pose))}; }

b2Polygon shapeOf(const Polygon& polygon) {
  std::vector<b2Vec2> vertices;
  for (const Vec2& vertex : polygon.rings()[0]) vertices.push_back(vectorOf(vertex));
  const b2Hull hull = b2ComputeHull(vertices.data(), static_cast<int>(vertices.size()));
  return b2MakePolygon(&hull, 0);
}
b2ShapeProxy proxyOf(const b2Polygon& shape) { return b2MakeProxy(shape.vertices, shape.count, 0); }

float distanceOf(const b2ShapeProxy& a, const b2Transform& pose_a, const b2ShapeProxy& b, const b2Transform& pose_b,
                 b2SimplexCache& cache) {
  b2DistanceInput input{};
  input.proxyA = a;
  input.proxyB = b;
  input.transform = b2InvMulTransforms(pose_a, pose_b);
  return b2ShapeDistance(&input, &cache, nullptr, 0).distance;
}

Polygon regular(int n, double radius) { return Polygon({support::regular(n, radius)}); }

/// Each way's time for one of `count` answers; `misses` counts those that differ by more than 0.01.
Result timed(const std::string& bodies, const std::string& query, std::size_t count,
             const std::function<double(std::size_t i)>& ours, const std::function<double(std::size_t i)>& theirs) {
  std::vector<double> of_ours(count), of_theirs(count);
  Result result = measureInTurn(
      {"Box2D v3", bodies, query, 0, 0, count},
      {taskOf("tricover", Role::Ours, of_ours, ours), taskOf("Box2D v3", Role::Rival, of_theirs, theirs)}, kRounds);
  result.timings[1].checked = count;
  for (std::size_t i = 0; i < count; ++i) result.timings[1].misses += std::abs(of_ours[i] - of_theirs[i]) > 0.01;
  return result;
}

/// A pair of about ten metres, of which Box2D's 0.005, where its times end before contact, are about the error that our
/// times are asked for.
struct Pair {
  std::string name;
  Polygon fixed, moving;
  b2Polygon fixed_shape = shapeOf(fixed), moving_shape = shapeOf(moving);
  b2ShapeProxy fixed_proxy = proxyOf(fixed_shape), moving_proxy = proxyOf(moving_shape);
};

std::vector<Pair> pairs() {
  const Polygon triangle({{{-4, -3}, {6, -2}, {-1, 5}}}), box({{{-5, -2}, {5, -2}, {5, 2}, {-5, 2}}}),
      slim({{{-6, -0.5}, {6, -0.5}, {6, 0.5}, {-6, 0.5}}});
  return {{"triangles", triangle, triangle},
          {"boxes", box, box},
          {"slim boxes", slim, slim},
          {"5-gons", regular(5, 5), regular(5, 4)},
          {"8-gons", regular(8, 5), regular(8, 4)},
          {"box, 8-gon", box, regular(8, 4)}};
}

void addDistances(const Pair& pair, std::vector<Result>& rows) {
  const auto add = [&](const std::string& query, const std::vector<Pose>& poses, bool cached) {
    std::vector<b2Transform> transforms;
    for (const Pose& pose : poses) transforms.push_back(transformOf(pose));
    PairCache kept;
    b2SimplexCache simplex{};
    rows.push_back(timed(
        pair.name, query, poses.size(),
        [&](std::size_t i) {
          return (cached ? distance(pair.fixed, kStill, pair.moving, poses[i], kept)
                         : distance(pair.fixed, kStill, pair.moving, poses[i]))
              .distance;
        },
        [&](std::size_t i) {
          if (!cached) simplex = {};
          return static_cast<double>(
              distanceOf(pair.fixed_proxy, b2Transform_identity, pair.moving_proxy, transforms[i], simplex));
        }));
  };
  add("distance near", separatedPoses(pair.fixed, pair.moving, 1.03, 1.5), false);
  add("distance at 1 %", separatedPoses(pair.fixed, pair.moving, 1.0, 1.01), false);
  add("distance overlapping", separatedPoses(pair.fixed, pair.moving, 0.6, 0.9), false);
  add("distance on a walk", posesOf("gap 0.1", pair.fixed, pair.moving), false);
  add("distance on a walk, both with caches", posesOf("gap 0.1", pair.fixed, pair.moving), true);
}

/// One contact with up to two points and a normal, of both. Depths are compared: Box2D prefers its first polygon's
/// faces, up to a tenth of its slop.
void addContacts(const Pair& pair, std::vector<Result>& rows) {
  const auto add = [&](const std::string& query, const std::vector<Pose>& all) {
    std::vector<Pose> poses;
    for (const Pose& pose : all)
      if (!contacts(pair.fixed, kStill, pair.moving, pose).empty()) poses.push_back(pose);
    std::vector<b2Transform> transforms;
    for (const Pose& pose : poses) transforms.push_back(transformOf(pose));
    rows.push_back(timed(
        pair.name, query, poses.size(),
        [&](std::size_t i) { return contacts(pair.fixed, kStill, pair.moving, poses[i])[0].depth; },
        [&](std::size_t i) {
          const b2LocalManifold found = b2CollidePolygons(&pair.fixed_shape, &pair.moving_shape, transforms[i]);
          float depth = 0;
          for (int k = 0; k < found.pointCount; ++k) depth = std::max(depth, -found.points[k].separation);
          return static_cast<double>(depth);
        }));
  };
  add("contacts, just overlapping", separatedPoses(pair.fixed, pair.moving, 0.95, 1));
  add("contacts, overlapping", separatedPoses(pair.fixed, pair.moving, 0.6, 0.9));
  add("contacts, deep in each other", separatedPoses(pair.fixed, pair.moving, 0, 0.5));
}

void addImpacts(const Pair& pair, bool turning, std::vector<Result>& rows) {
  // Box2D goes along the chord of larger angles.
  const std::vector<Motion> all =
      randomMotions(pair.fixed, pair.moving, (pair.fixed.radius() + pair.moving.radius()) / 2, turning ? 0.5 : 0, 3);
  std::vector<b2TOIInput> sweeps;
  for (const Motion& motion : all) {
    const Vec2 from = motion.start * motion.pivot;
    b2TOIInput input{};
    input.proxyA = pair.fixed_proxy;
    input.proxyB = pair.moving_proxy;
    input.sweepA.q1 = input.sweepA.q2 = b2Rot_identity;
    input.sweepB.localCenter = vectorOf(motion.pivot);
    input.sweepB.c1 = vectorOf(from);
    input.sweepB.c2 = vectorOf(from + motion.shift);
    input.sweepB.q1 = b2MakeRot(angleOf(motion.start));
    input.sweepB.q2 = b2MakeRot(angleOf(motion.start) + static_cast<float>(motion.angle));
    input.maxFraction = 1;
    sweeps.push_back(input);
  }
  const auto ours = [&](std::size_t i) {
    const auto impact = timeOfImpact(pair.fixed, {}, pair.moving, all[i], {0, 1e-3});
    return impact ? impact->time : 1;  // 1 where the two don't meet
  };
  rows.push_back(timed(pair.name, turning ? "rotates, b2TimeOfImpact" : "slides, b2TimeOfImpact", all.size(), ours,
                       [&](std::size_t i) { return static_cast<double>(b2TimeOfImpact(&sweeps[i]).fraction); }));
  if (turning) return;
  std::vector<b2ShapeCastPairInput> casts;
  for (const Motion& motion : all) {
    b2ShapeCastPairInput input{};
    input.proxyA = pair.fixed_proxy;
    input.proxyB = pair.moving_proxy;
    input.transform = transformOf(motion.start);
    input.translationB = vectorOf(motion.shift);
    input.maxFraction = 1;
    casts.push_back(input);
  }
  rows.push_back(timed(pair.name, "slides, b2ShapeCast", all.size(), ours, [&](std::size_t i) {
    const b2CastOutput output = b2ShapeCast(&casts[i]);
    return output.hit ? static_cast<double>(output.fraction) : 1.0;
  }));
}

/// Box2D's tree with the descent to the nearest body that it doesn't have: the nearer child first.
class NearestTree {
 public:
  NearestTree(const Polygon& body, const std::vector<Pose>& poses) : shape_(shapeOf(body)) {
    tree_ = b2DynamicTree_Create(static_cast<int>(poses.size()));
    for (const Pose& pose : poses) {
      const b2Transform transform = transformOf(pose);
      b2DynamicTree_CreateProxy(&tree_, b2ComputePolygonAABB(&shape_, transform), 1, transforms_.size());
      transforms_.push_back(transform);
    }
    b2DynamicTree_Rebuild(&tree_, true);
    proxy_ = proxyOf(shape_);
  }
  NearestTree(const NearestTree&) = delete;
  NearestTree& operator=(const NearestTree&) = delete;
  ~NearestTree() { b2DynamicTree_Destroy(&tree_); }

  double nearest(const b2ShapeProxy& query, const b2Transform& pose, const b2AABB& box) const {
    struct Entry {
      int node;
      float gap;
    } stack[256];
    int top = 0;
    stack[top++] = {tree_.root, 0};
    float best = std::numeric_limits<float>::max(), square = best;
    while (top > 0) {
      const Entry entry = stack[--top];
      if (entry.gap >= square) continue;
      const b2TreeNode& node = tree_.nodes[entry.node];
      if (node.flags & b2_leafNode) {
        b2SimplexCache cache{};
        best = std::min(best, distanceOf(proxy_, transforms_[node.userData], query, pose, cache));
        square = best * best;
        if (best == 0) break;
        continue;
      }
      Entry near{node.children.child1, gapOf(tree_.nodes[node.children.child1].aabb, box)};
      Entry far{node.children.child2, gapOf(tree_.nodes[node.children.child2].aabb, box)};
      if (near.gap > far.gap) std::swap(near, far);
      if (far.gap < square) stack[top++] = far;
      if (near.gap < square) stack[top++] = near;
    }
    return static_cast<double>(best);
  }

 private:
  static float gapOf(const b2AABB& a, const b2AABB& b) {
    const float dx = std::max({0.f, a.lowerBound.x - b.upperBound.x, b.lowerBound.x - a.upperBound.x});
    const float dy = std::max({0.f, a.lowerBound.y - b.upperBound.y, b.lowerBound.y - a.upperBound.y});
    return dx * dx + dy * dy;
  }

  b2Polygon shape_;
  b2ShapeProxy proxy_;
  std::vector<b2Transform> transforms_;
  b2DynamicTree tree_;
};

/// Anywhere in a square, or steps of 0.2 through it.
std::vector<Pose> askedPoses(double size, bool path) {
  support::Random random(2);
  std::vector<Pose> poses;
  double x = size / 2, y = size / 2, angle = 0, heading = 0;
  for (int i = 0; i < 4000; ++i) {
    if (path) {
      heading += random.real(-0.2, 0.2);
      x = std::clamp(x + 0.2 * std::cos(heading), 0.0, size);
      y = std::clamp(y + 0.2 * std::sin(heading), 0.0, size);
      angle += random.real(-0.05, 0.05);
    } else {
      x = random.real(0, size), y = random.real(0, size), angle = random.real(-3, 3);
    }
    poses.push_back(support::turnedAndMoved(angle, x, y));
  }
  return poses;
}

void addNearest(const std::string& name, const Polygon& body, double size, std::vector<Result>& rows) {
  support::Random random(1);
  std::vector<Pose> poses;
  for (int i = 0; i < 10000; ++i) {
    const double x = random.real(0, size), y = random.real(0, size);
    poses.push_back(support::turnedAndMoved(random.real(-3, 3), x, y));
  }
  std::vector<BodyPlacement> placements;
  for (const Pose& pose : poses) placements.push_back({body, pose, {}});
  Scene scene;
  scene.add(placements);
  const NearestTree tree(body, poses);
  const Polygon spot = Polygon::point({0, 0}), hexagon = regular(6, 1);
  const b2Polygon hexagon_shape = shapeOf(hexagon);
  const b2Vec2 origin = {0, 0};
  for (const bool is_spot : {true, false}) {
    const Polygon& query = is_spot ? spot : hexagon;
    const b2ShapeProxy proxy = is_spot ? b2MakeProxy(&origin, 1, 0) : proxyOf(hexagon_shape);
    for (const bool path : {false, true}) {
      const std::vector<Pose> asked = askedPoses(size, path);
      std::vector<b2Transform> transforms;
      for (const Pose& pose : asked) transforms.push_back(transformOf(pose));
      const auto theirs = [&](std::size_t i) {
        const b2Transform& at = transforms[i];
        return tree.nearest(proxy, at, is_spot ? b2AABB{at.p, at.p} : b2ComputePolygonAABB(&hexagon_shape, at));
      };
      const std::string asks =
          std::string("nearest to a ") + (is_spot ? "point" : "hexagon") + (path ? " on a path" : "");
      rows.push_back(timed(
          name, asks, asked.size(), [&](std::size_t i) { return scene.nearest(query, asked[i])->result.distance; },
          theirs));
    }
  }
}

}  // namespace

bool run(const std::string& directory, bool) {
  std::vector<Result> rows;
  for (const Pair& pair : pairs()) {
    addDistances(pair, rows);
    addContacts(pair, rows);
    for (const bool turning : {false, true}) addImpacts(pair, turning, rows);
  }
  addNearest("10,000 boxes", Polygon({{{-1, -0.6}, {1, -0.6}, {1, 0.6}, {-1, 0.6}}}), 309, rows);
  addNearest("10,000 slim boxes", Polygon({{{-2, -0.2}, {2, -0.2}, {2, 0.2}, {-2, 0.2}}}), 252, rows);
  addNearest("10,000 8-gons", regular(8, 1), 252, rows);

  return writeStudies(directory, "box2d_v3", {{"Beside Box2D v3", rows}},
                      "- CPU time of one thread, medians, in turn. Pairs of about ten metres; Box2D computes in "
                      "floats, and its times end 0.005 before contact.\n- Our times of impact are to 1e-3. Misses: "
                      "answers that differ by more than 0.01.\n");
}

}  // namespace tricover::bench
