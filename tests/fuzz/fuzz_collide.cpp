// SPDX-License-Identifier: BSD-3-Clause
// All laws of all queries, and conflicts on a motion, against the exact reference; the cache has seen b elsewhere.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "byte_reader.h"
#include "exact_reference.h"
#include "laws.h"
#include "reproduction.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tricover;
  using namespace tricover::support;
  fuzz::ByteReader bytes(data, size);
  const Polygon a = bytes.polygon();
  const Pose pose_a = bytes.pose();
  const Polygon b = bytes.polygon();
  const Pose pose_b = bytes.pose(), before = bytes.pose();
  const bool with_margin = bytes.byte() % 4 == 0;
  const double margin = with_margin ? std::min(std::abs(bytes.coordinate()), 1e150) : 0;
  const Case c{a, pose_a, b, pose_b};
  Random random(size);
  PairCache old;
  collide(a, pose_a, b, before, old, {margin});
  for (const Touching touching : {Touching::Collides, Touching::Allowed}) {
    const std::string wrong = brokenLaw(c, margin, touching, areWithin(c, margin, touching), random, old);
    if (!wrong.empty()) fuzz::fail(wrong.c_str(), reproduction(c));
  }
  if (margin != 0) return 0;
  if ((before.linear().determinant() < 0) != (pose_b.linear().determinant() < 0)) return 0;  // no motion mirrors
  const Motion motion = Motion::between(before, pose_b, b.coveringOrigin());
  if (!motion.shift.allFinite()) return 0;
  const std::vector<Conflict> spans = conflicts(a, Motion::still(pose_a), b, motion, {0, 0x1p-5});
  for (int i = 0; i <= 8; ++i) {
    const double time = i / 8.0;
    const bool told = std::any_of(spans.begin(), spans.end(),
                                  [&](const Conflict& span) { return span.impact.time <= time && time <= span.end; });
    if (!told && exact::collide(a, pose_a, b, motion.at(time)))
      fuzz::fail("conflicts", "missed at " + hex(time) + "\n" + reproduction({a, pose_a, b, pose_b}) +
                                  reproduction("motion", motion));
  }
  return 0;
}
