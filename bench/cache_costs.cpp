// SPDX-License-Identifier: BSD-3-Clause
#include <cmath>
#include <string>
#include <utility>

#include "asked.h"
#include "random.h"
#include "scenes/placed.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

/// For polygons of 100 units.
constexpr double kSize = 100, kDepth = 0.1, kBeside = 1;
constexpr std::size_t kPoses = 200;
constexpr int kRounds = 7;

/// A cache knows no more than so many poses of this walk: pairs meet and part.
const char* const kPairsAnew = "steps of 5 %, pairs anew";
constexpr std::size_t kPosesOfPair = 50;

struct Pair {
  std::string name;
  Polygon fixed, moving;
};

std::vector<Pair> pairs() {
  const Polygon triangle({{{-40, -30}, {60, -20}, {-10, 50}}}), box({{{-50, -20}, {50, -20}, {50, 20}, {-50, 20}}});
  std::vector<Pair> pairs = {{"triangles", triangle, triangle}, {"boxes", box, box}};
  for (const auto& [kind, vertices] : {std::pair(Kind::Convex, 8u),
                                       {Kind::Convex, 64u},
                                       {Kind::Contour, 12u},
                                       {Kind::Contour, 64u},
                                       {Kind::Contour, 512u}})
    pairs.push_back({workloads::name(kind) + " " + std::to_string(vertices), workloads::makePolygon(kind, vertices, 1),
                     workloads::makePolygon(kind, vertices, 2)});
  return pairs;
}

Pose at(double x, double y) { return poseAt({x, y}, 0.3); }

/// Where they touch, coming from the right.
double contactOf(const Pair& pair) {
  double meets = 0, apart = 4 * kSize;
  for (int i = 0; i < 50; ++i) {
    const double middle = 0.5 * (meets + apart);
    (collide(pair.fixed, Pose::Identity(), pair.moving, at(middle, 0)) ? meets : apart) = middle;
  }
  return apart;
}

/// To and fro across, by steps of so much.
std::vector<Pose> toAndFro(double x, double step) {
  std::vector<Pose> poses;
  for (std::size_t i = 0; i < kPoses; ++i) {
    const std::size_t phase = i % 40;
    poses.push_back(at(x, step * static_cast<double>(phase < 20 ? phase : 40 - phase)));
  }
  return poses;
}

/// Beside each other, by steps of 5 % anywhere.
std::vector<Pose> wander(const Pair& pair, double contact) {
  support::Random random(1);
  std::vector<Pose> poses;
  for (Pose pose = at(contact + kBeside, 0); poses.size() < kPoses;) {
    const double direction = random.real(0, 2 * static_cast<double>(EIGEN_PI)), step = 0.05 * kSize;
    Pose next = pose * poseAt({0, 0}, random.real(-0.05, 0.05));
    next.translation() += step * Vec2(std::cos(direction), std::sin(direction));
    if (collide(pair.fixed, Pose::Identity(), pair.moving, next) ||
        !collide(pair.fixed, Pose::Identity(), pair.moving, next, {0.1 * kSize}))
      continue;
    poses.push_back(pose = next);
  }
  return poses;
}

std::vector<std::pair<std::string, std::vector<Pose>>> walksOf(const Pair& pair) {
  const double contact = contactOf(pair);
  return {{"resting", toAndFro(contact - kDepth, 1e-6 * kSize)},
          {"beside", toAndFro(contact + kBeside, 1e-6 * kSize)},
          {"steps of 0.1 %", toAndFro(contact + kBeside, 1e-3 * kSize)},
          {"steps of 1 %", toAndFro(contact + kBeside, 1e-2 * kSize)},
          {"steps of 5 %", toAndFro(contact + kBeside, 5e-2 * kSize)},
          {"jumps", workloads::nearPoses(pair.fixed, pair.moving, 1, kPoses)}};
}

/// Through each other, where separating translations have to be searched for.
std::vector<std::pair<std::string, std::vector<Pose>>> deepWalksOf(const Pair& pair) {
  const double x = 0.4 * contactOf(pair);
  return {{"deep, steps of 0.1 %", toAndFro(x, 1e-3 * kSize)},
          {"deep, steps of 1 %", toAndFro(x, 1e-2 * kSize)},
          {"deep, steps of 5 %", toAndFro(x, 5e-2 * kSize)}};
}

/// ask(pose) without a cache and ask(pose, cache).
template <class Ask>
Result measured(const Pair& pair, const std::string& query, const std::string& walk, const std::vector<Pose>& poses,
                Ask ask) {
  std::vector<double> answers(poses.size());
  PairCache cache;
  const bool are_anew = walk == kPairsAnew;
  return measureInTurn({"cache", pair.name, query + ", " + walk, 0, 0, poses.size()},
                       {taskOf("none", Role::Ours, answers, [&](std::size_t i) { return ask(poses[i]); }),
                        taskOf("cached", Role::Ours, answers,
                               [&, are_anew](std::size_t i) {
                                 if (are_anew && i % kPosesOfPair == 0) cache = PairCache();
                                 return ask(poses[i], cache);
                               })},
                       kRounds);
}

}  // namespace

std::vector<Result> measureCaches() {
  std::vector<Result> results;
  const Pose still = Pose::Identity();
  for (const Pair& pair : pairs()) {
    const Polygon &a = pair.fixed, &b = pair.moving;
    const auto depth = [&](const Pose& pose, auto&... cache) {
      const auto found = penetration(a, still, b, pose, cache...);
      return found ? found->depth : 0.0;
    };
    if (b.edgeCount() <= 64)  // larger ones take milliseconds
      for (const auto& [walk, poses] : deepWalksOf(pair))
        results.push_back(measured(pair, "penetration", walk, poses, depth));
    const auto points = [&](const Pose& pose, auto&... cache) {
      return static_cast<double>(contacts(a, still, b, pose, cache...).size());
    };
    results.push_back(measured(pair, "contacts", kPairsAnew, wander(pair, contactOf(pair)), points));
    for (const auto& [walk, poses] : walksOf(pair)) {
      results.push_back(measured(pair, "collide", walk, poses, [&](const Pose& pose, auto&... cache) {
        return collide(a, still, b, pose, cache...) ? 1.0 : 0.0;
      }));
      results.push_back(measured(pair, "distance", walk, poses, [&](const Pose& pose, auto&... cache) {
        return distance(a, still, b, pose, cache...).distance;
      }));
      results.push_back(measured(pair, "contacts", walk, poses, points));
      results.push_back(measured(pair, "penetration", walk, poses, depth));
    }
  }
  return results;
}

}  // namespace tricover::bench
