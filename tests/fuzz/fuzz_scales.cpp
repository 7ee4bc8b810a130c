// SPDX-License-Identifier: BSD-3-Clause
// Queries of lengths at mixed scales, from 1e-300 to 1e300 within one input: none may hang, whatever it answers.
//
// In CTest this runs for crashes and broken promises alone. Set TRICOVER_FUZZ_MS to the milliseconds of processor time
// that a query may take, and the target fails above them:
//   TRICOVER_FUZZ_MS=50 build/tests/fuzz/fuzz_scales --seconds=300 --seed=7
//   TRICOVER_FUZZ_MS=50 build/tests/fuzz/fuzz_scales_libfuzzer -max_total_time=300 -max_len=256
// Use a build with optimization and without sanitizers. A slow query runs three times, and the fastest run counts.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <ctime>
#include <stdexcept>
#include <string>
#include <vector>

#include "byte_reader.h"
#include "reproduction.h"
#include "tricover/collide.h"
#include "tricover/conflicts.h"
#include "tricover/distance.h"
#include "tricover/least_distance.h"
#include "tricover/polygon.h"
#include "tricover/ray.h"

namespace {

using namespace tricover;

/// Makes a case of bytes.
class Scales {
 public:
  Scales(const std::uint8_t* data, std::size_t size) : bytes_(data, size), usual_(scale()) {}

  double scale() {
    constexpr double kScales[] = {1,      1,     1e-3,  1e3,    1e-9,   1e9,   1e-16,   1e16,
                                  1e-30,  1e30,  1e-70, 1e70,   1e-100, 1e100, 1e150,   1e-150,
                                  1e-200, 1e200, 1e300, 1e-300, 1e-310, 1e307, 0x1p-60, 0};
    return kScales[static_cast<std::size_t>(bytes_.byte()) % std::size(kScales)];
  }
  double length() {
    const int kind = bytes_.byte();
    const double cell = bytes_.integer(-4, 4);
    const double nudged = kind & 32 ? support::nudged(cell, bytes_.integer(-2, 2)) : kind & 64 ? cell / 3 : cell;
    const double at = nudged * (kind % 8 == 0 ? scale() : usual_);
    return std::isfinite(at) ? at : cell;
  }
  Vec2 point() {
    const double x = length();
    return {x, length()};
  }
  Polygon polygon() {
    const int kind = bytes_.byte();
    if (kind % 16 == 0) return tricover::Polygon::point(point());
    if (kind % 16 == 1) return Polygon::segment(point(), point());
    std::vector<Ring> rings(static_cast<std::size_t>(1 + (kind & 32 ? kind % 3 : 0)));
    for (Ring& ring : rings)
      for (int count = bytes_.integer(3, kind & 64 ? 20 : 6); count > 0; --count)
        ring.push_back(ring.size() > 1 && bytes_.byte() % 8 == 0 ? ring.back() : point());
    Polygon made(std::move(rings), kind & 128 ? FillRule::NonZero : FillRule::EvenOdd);
    return kind % 16 == 2 ? complementOf(made) : made;
  }
  Pose pose() {
    Pose pose = bytes_.pose();
    pose.translation() = point();
    return pose;
  }
  Motion motion() {
    const int kind = bytes_.byte();
    Motion motion = Motion::translation(pose(), point());
    if (kind % 4 == 0) motion.shift.setZero();
    if (kind & 4) motion.angle = kind & 8 ? length() : bytes_.integer(-8, 8) * 0.5;
    if (kind & 16) motion.pivot = point();
    if (kind % 8 == 0) motion.shift_2 = point(), motion.angle_2 = bytes_.integer(-4, 4) * 0.25;
    if (kind % 16 == 0) motion.shift_3 = point();
    return motion;
  }
  /// Not negative.
  double margin() { return bytes_.byte() % 2 == 0 ? 0 : std::abs(length()); }
  double error() {
    constexpr double kErrors[] = {1e-6, 1e-3, 1e-9, 1e-12};
    return kErrors[bytes_.integer(0, 3)];
  }
  bool coin() { return bytes_.byte() % 2 == 0; }

 private:
  static Polygon complementOf(const Polygon& polygon) {
    try {
      return polygon.complement();
    } catch (const std::invalid_argument&) {
      return polygon;
    }
  }

  fuzz::ByteReader bytes_;
  const double usual_;
};

double mostMilliseconds() {
  const char* const given = std::getenv("TRICOVER_FUZZ_MS");
  return given != nullptr ? std::atof(given) : 0;
}

class Case {
 public:
  explicit Case(Scales& from)
      : a_(from.polygon()),
        b_(from.polygon()),
        motion_a_(from.motion()),
        motion_b_(from.motion()),
        from_(from.point()),
        to_(from.point()),
        options_{from.margin(), from.error(), from.coin()} {}

  void run() {
    const double margin = options_.margin;
    const Pose &pose_a = motion_a_.start, &pose_b = motion_b_.start;
    time("collide", [&] { collide(a_, pose_a, b_, pose_b, {margin}); });
    time("distance", [&] { expect(distance(a_, pose_a, b_, pose_b).distance >= 0, "distance"); });
    time("castRayAll", [&] { castRayAll(a_, pose_a, from_, to_, {margin}); });
    time("timeOfImpact", [&] {
      const auto impact = timeOfImpact(a_, motion_a_, b_, motion_b_, options_);
      expect(!impact || (impact->time >= 0 && impact->time <= 1), "a time of impact");
    });
    time("conflicts", [&] {
      double last = 0;
      for (const Conflict& conflict : conflicts(a_, motion_a_, b_, motion_b_, options_)) {
        expect(conflict.impact.time >= last && conflict.end >= conflict.impact.time && conflict.end <= 1, "conflicts");
        last = conflict.end;
      }
    });
    time("leastDistance", [&] {
      LeastDistanceOptions least;
      least.margin = margin;
      least.absolute_error = options_.time_error * std::max(std::min(a_.radius(), b_.radius()), 1e-300);
      if (!std::isfinite(least.absolute_error)) least.absolute_error = 1e-6;
      const LeastDistance found = leastDistance(a_, motion_a_, b_, motion_b_, least);
      expect(found.lower_bound <= found.distance, "a least distance");
    });
  }

 private:
  template <typename Query>
  void time(const char* name, Query query) {
    static const double most = mostMilliseconds();
    double fastest = 0;
    for (int i = 0; i < 3; ++i) {
      const std::clock_t begin = std::clock();
      try {
        query();
      } catch (const std::invalid_argument&) {
      } catch (const std::length_error&) {
      }
      const double taken = 1e3 * static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
      fastest = i == 0 ? taken : std::min(fastest, taken);
      if (most == 0 || fastest <= most) return;
    }
    fail(name + (" takes " + std::to_string(fastest)) + " ms");
  }
  void expect(bool right, const char* what) const {
    if (!right) fail(what);
  }
  [[noreturn]] void fail(const std::string& what) const {
    fuzz::fail((what + ": margin " + support::hex(options_.margin) + ", time_error " +
                support::hex(options_.time_error) + (options_.ignore_initial ? ", ignore_initial" : "") +
                (a_.isComplement() ? ", a a complement" : "") + (b_.isComplement() ? ", b a complement" : ""))
                   .c_str(),
               "ray from " + support::hex(from_.x()) + ", " + support::hex(from_.y()) + " to " + support::hex(to_.x()) +
                   ", " + support::hex(to_.y()) + "\n" +
                   support::reproduction({a_, motion_a_.start, b_, motion_b_.start}) +
                   support::reproduction("motion_a", motion_a_) + support::reproduction("motion_b", motion_b_));
  }

  const Polygon a_, b_;
  const Motion motion_a_, motion_b_;
  const Vec2 from_, to_;
  const ImpactOptions options_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Scales from(data, size);
  Case(from).run();
  return 0;
}
