// SPDX-License-Identifier: BSD-3-Clause
#include "contact_costs.h"

#include <functional>

#include "measure.h"
#include "rivals/geos_moved.h"
#include "rivals/geos_region.h"
#include "tricover/collide.h"
#include "tricover/contacts.h"
#include "tricover/penetration.h"
#include "workloads.h"

namespace tricover::bench {
namespace {

using workloads::Kind;

constexpr int kRounds = 5;
constexpr std::size_t kPoses = 20;

/// Overlapping poses, of which `wanted` says by the number of crossings whether they are asked.
std::vector<Pose> overlaps(const Polygon& fixed, const Polygon& moving, bool deep, bool (*wanted)(std::size_t count)) {
  std::vector<Pose> poses;
  for (const Pose& pose :
       deep ? workloads::overlapPoses(fixed, moving, 3) : workloads::contactPoses(fixed, moving, 3)) {
    if (poses.size() == kPoses) break;
    if (!collide(fixed, Pose::Identity(), moving, pose)) continue;
    if (wanted(crossings(fixed, Pose::Identity(), moving, pose).size())) poses.push_back(pose);
  }
  return poses;
}

ContactCost measured(const std::string& polygons, const std::string& name, const Polygon& fixed, const Polygon& moving,
                     const std::vector<Pose>& poses) {
  const auto region = geosRegion(fixed);
  GeosMoved moved(moving);
  const Pose still = Pose::Identity();
  std::size_t found = 0;  // so that nothing is left out
  const auto each = [&](auto ask) {
    return [&, ask] {
      for (const Pose& pose : poses) found += ask(pose);
    };
  };
  const auto askContacts = [&](const Pose& pose, ContactDetail detail) {
    ContactOptions options;
    options.detail = detail;
    return contacts(fixed, still, moving, pose, options).size();
  };
  const std::vector<std::function<void()>> tasks = {
      each([&](const Pose& pose) { return crossings(fixed, still, moving, pose).size(); }),
      each([&](const Pose& pose) { return askContacts(pose, ContactDetail::Points); }),
      each([&](const Pose& pose) { return askContacts(pose, ContactDetail::LocalDepth); }),
      each([&](const Pose& pose) { return askContacts(pose, ContactDetail::WayOut); }),
      each([&](const Pose& pose) { return std::size_t{penetration(fixed, still, moving, pose).has_value()}; }),
      each([&](const Pose& pose) { return region->intersection(moved.at(pose))->getNumPoints(); })};
  ContactCost cost{polygons, name, {}};
  for (const double seconds : secondsInTurn(tasks, kRounds, threadSeconds))
    cost.ns.push_back(1e9 * seconds / static_cast<double>(poses.size()));
  return cost;
}

const char *const kTwice = "crossing twice", *const kOften = "crossing more often";

}  // namespace

const std::vector<std::string>& contactQuestions() {
  static const std::vector<std::string> questions = {"crossings", "points",      "local depths",
                                                     "contacts",  "penetration", "GEOS overlay"};
  return questions;
}

std::vector<ContactCost> measureContactCosts() {
  std::vector<ContactCost> costs;
  const auto measureAt = [&](Kind kind, std::size_t n, const char* poses, bool deep, bool (*wanted)(std::size_t)) {
    const Polygon fixed = workloads::makePolygon(kind, n, 1), moving = workloads::makePolygon(kind, n, 2);
    costs.push_back(measured(workloads::name(kind) + " " + std::to_string(n), poses, fixed, moving,
                             overlaps(fixed, moving, deep, wanted)));
  };
  for (const Kind kind : {Kind::Convex, Kind::Slim}) {
    measureAt(kind, 8, kTwice, true, [](std::size_t count) { return count == 2; });
    measureAt(kind, 8, kOften, true, [](std::size_t count) { return count > 2; });
  }
  for (const std::size_t n : {8u, 24u, 64u}) {
    measureAt(Kind::Contour, n, "shallow", false, [](std::size_t) { return true; });
    measureAt(Kind::Contour, n, "deep", true, [](std::size_t) { return true; });
  }
  return costs;
}

std::vector<Target> judgeContactCosts(const std::vector<ContactCost>& costs) {
  constexpr std::size_t kCrossings = 0, kPoints = 1, kLocal = 2, kContacts = 3;
  std::vector<Figure> often_times, points, local;
  for (const ContactCost& cost : costs) {
    points.push_back({cost.ns[kPoints] / cost.ns[kCrossings], cost.polygons + ", " + cost.poses});
    local.push_back({cost.ns[kLocal] / cost.ns[kCrossings], cost.polygons + ", " + cost.poses});
    for (const ContactCost& often : costs)
      if (cost.polygons == often.polygons && cost.poses == kTwice && often.poses == kOften)
        often_times.push_back({often.ns[kContacts] / cost.ns[kContacts], often.polygons});
  }
  return {judged("contacts of convex pairs", "crossing more often / crossing twice", often_times, {false, 1.5}),
          judged("contacts, points alone", "/ crossings", points, {false, 2}),
          judged("contacts, local depths", "/ crossings", local, {false, 4})};
}

}  // namespace tricover::bench
