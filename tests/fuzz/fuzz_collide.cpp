// SPDX-License-Identifier: BSD-3-Clause
// collide() in every way of asking, and what must agree with it, against the exact reference; the caches have seen b
// elsewhere.
#include <algorithm>
#include <cmath>
#include <vector>

#include "byte_reader.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "strategies.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/contacts.h"
#include "tricover/distance.h"
#include "tricover/penetration.h"
#include "tricover/time_of_impact.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tricover;
  fuzz::ByteReader bytes(data, size);
  const Polygon a = bytes.polygon();
  const Pose pose_a = bytes.pose();
  const Polygon b = bytes.polygon();
  const Pose pose_b = bytes.pose(), before = bytes.pose();
  const bool with_margin = bytes.byte() % 4 == 0;
  const double margin = with_margin ? std::abs(bytes.coordinate()) : 0;
  const bool truth = margin == 0 ? exact::collide(a, pose_a, b, pose_b)
                                 : exact::within(exact::distanceSquared(a, pose_a, b, pose_b), mpq_class(margin));
  const auto expect = [&](bool answer, const char* what) {
    if (answer == truth) return;
    fuzz::fail(what, "margin " + support::hex(margin) + ", truth " + (truth ? "1\n" : "0\n") +
                         support::reproduction({a, pose_a, b, pose_b}));
  };
  using support::Strategy;
  for (const Strategy strategy : {Strategy::Hierarchy, Strategy::Paper}) {
    const CollideOptions options{margin};
    const bool paper = strategy == Strategy::Paper;
    expect(collide(strategy, a, pose_a, b, pose_b, options), paper ? "Paper, cold" : "Hierarchy, cold");
    expect(collide(strategy, b, pose_b, a, pose_a, options), paper ? "Paper, swapped" : "Hierarchy, swapped");
    support::StrategyCaches cache;
    collide(strategy, a, pose_a, b, before, cache, options);
    expect(collide(strategy, a, pose_a, b, pose_b, cache, options), paper ? "Paper, cached" : "Hierarchy, cached");
    expect(collide(strategy, b, pose_b, a, pose_a, cache, options), paper ? "Paper, again" : "Hierarchy, again");
  }
  if (margin != 0) return 0;
  const bool overlap = exact::interiorsMeet(a, pose_a, b, pose_b);
  for (const bool swapped : {false, true})
    if (collide(swapped ? b : a, swapped ? pose_b : pose_a, swapped ? a : b, swapped ? pose_a : pose_b,
                {0, 0, Touching::Allowed}) != overlap)
      fuzz::fail("touching allowed",
                 "truth " + std::string(overlap ? "1\n" : "0\n") + support::reproduction({a, pose_a, b, pose_b}));
  const std::vector<Contact> parts = contacts(a, pose_a, b, pose_b);
  expect(!parts.empty(), "contacts");
  for (const Contact& part : parts)
    expect(part.depth >= 0 && std::abs(part.normal.norm() - 1) < 1e-9, "contacts: depth or normal");
  expect(penetration(a, pose_a, b, pose_b).has_value(), "penetration");
  expect(distance(a, pose_a, b, pose_b).distance == 0, "distance");
  PairCache cache;
  distance(a, pose_a, b, before, cache);
  expect(distance(a, pose_a, b, pose_b, cache).distance == 0, "distance, cached");
  const auto impact = timeOfImpact(a, Motion::still(pose_a), b, Motion::still(pose_b));
  expect(impact && impact->time == 0, "time of impact");
  if ((before.linear().determinant() < 0) != (pose_b.linear().determinant() < 0)) return 0;  // no motion mirrors
  const Motion motion = Motion::between(before, pose_b, b.origin());
  if (!motion.shift.allFinite()) return 0;
  const std::vector<Conflict> spans = conflicts(a, Motion::still(pose_a), b, motion, {0, 0x1p-5});
  for (int i = 0; i <= 8; ++i) {
    const double time = i / 8.0;
    const bool told = std::any_of(spans.begin(), spans.end(),
                                  [&](const Conflict& span) { return span.impact.time <= time && time <= span.end; });
    if (!told && exact::collide(a, pose_a, b, motion.at(time)))
      fuzz::fail("conflicts", "missed at " + support::hex(time) + "\n" + support::reproduction({a, pose_a, b, pose_b}) +
                                  support::reproduction("motion", motion));
  }
  return 0;
}
