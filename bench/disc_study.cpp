// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <limits>
#include <vector>

#include "random.h"
#include "studies.h"
#include "tricover/tricover.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

constexpr std::size_t kPositions = 1000;
constexpr double kRadius = 20, kTimeError = 1e-5;

/// The other polygon, and the margin with which it is asked for: a point with its radius, or an 8-gon without.
struct Other {
  const char* name;
  Role role;  ///< the 8-gon's answers are another region's, and are not compared
  Polygon polygon;
  double margin;
};

std::vector<Other> others() {
  Ring octagon;
  for (int i = 0; i < 8; ++i) {
    const double angle = i * static_cast<double>(EIGEN_PI) / 4;
    octagon.push_back(kRadius * Vec2(std::cos(angle), std::sin(angle)));
  }
  return {{"disc", Role::Ours, point({0, 0}), kRadius}, {"8-gon", Role::Floor, Polygon({octagon}), 0}};
}

std::vector<Motion> randomMotions(double reach, double low, double high, bool turning) {
  support::Random random(13);
  std::vector<Motion> motions;
  for (std::size_t i = 0; i < kPositions; ++i) {
    const double direction = random.real(-3.15, 3.15), away = reach * random.real(low, high);
    const Vec2 outwards(std::cos(direction), std::sin(direction));
    Motion motion;
    motion.start.linear() = Eigen::Rotation2Dd(random.real(-3.15, 3.15)).toRotationMatrix();
    motion.start.translation() = away * outwards;
    motion.shift = -reach * random.real(0.5, 2) * (Eigen::Rotation2Dd(random.real(-1.2, 1.2)) * outwards);
    if (turning) motion.angle = random.real(-2.6, 2.6);
    motions.push_back(motion);
  }
  return motions;
}

Workload workload(const char* query, std::size_t vertices) {
  return {"disc", "core, disc and 8-gon", query, vertices, 1, kPositions, 1};
}

Result measureCollide(const Polygon& fixed, const Settings& settings) {
  const auto motions = randomMotions(fixed.radius() + kRadius, 0.4, 1.2, false);
  std::vector<Contender> contenders;
  for (const Other& other : others()) {
    contenders.push_back({other.name, other.role, false, [=](const Sampling& sampling, Hits& hits) {
                            forEachSample(sampling, kPositions, [&](std::size_t i) {
                              const bool hit = collide(fixed, Pose::Identity(), other.polygon, motions[i].start,
                                                       CollideOptions{other.margin});
                              if (hit) hits.push_back(static_cast<std::uint32_t>(i));
                            });
                          }});
  }
  return measure(workload("collide", fixed.vertexCount()), contenders, settings);
}

/// `ask(other, motion)` answers a query.
template <class Ask>
Result measureValues(const char* query, const Polygon& fixed, const std::vector<Motion>& motions, double hit,
                     const Settings& settings, Ask ask) {
  std::vector<ValueContender> contenders;
  for (const Other& other : others()) {
    contenders.push_back({other.name, other.role, false, [=, &motions](const Sampling& sampling, Values& values) {
                            forEachSample(sampling, kPositions,
                                          [&](std::size_t i) { values.push_back(ask(other, motions[i])); });
                          }});
  }
  return measure(workload(query, fixed.vertexCount()), contenders, {hit, {0, 0}, {0, 0}}, settings);
}

}  // namespace

std::vector<Result> measureDiscs(const Settings& settings) {
  std::vector<Result> results;
  for (const std::size_t vertices : {8, 64}) {
    const Polygon fixed = workloads::makePolygon(workloads::Kind::Convex, vertices, 1);
    const double reach = fixed.radius() + kRadius;
    results.push_back(measureCollide(fixed, settings));
    const auto apart = randomMotions(reach, 1.03, 2, false);
    results.push_back(
        measureValues("distance", fixed, apart, 0, settings, [fixed = fixed](const Other& other, const Motion& motion) {
          DistanceOptions options;
          options.margin = other.margin;
          return distance(fixed, Pose::Identity(), other.polygon, motion.start, options).distance;
        }));
    for (const bool turning : {false, true}) {
      const auto motions = randomMotions(reach, 1.03, 1.5, turning);
      results.push_back(measureValues(
          turning ? "turning" : "sliding", fixed, motions, 1, settings,
          [fixed = fixed](const Other& other, const Motion& motion) {
            const auto impact = timeOfImpact(fixed, {}, other.polygon, motion, {other.margin, kTimeError});
            return impact ? impact->time : std::numeric_limits<double>::infinity();
          }));
    }
  }
  return results;
}

}  // namespace tricover::bench
