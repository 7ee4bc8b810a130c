// SPDX-License-Identifier: BSD-3-Clause
// Arbitrary doubles, ring sizes and poses: either std::invalid_argument, exactly where the contract says so, or a
// polygon and answers; never anything else.
#include <stdexcept>

#include "byte_reader.h"
#include "reproduction.h"
#include "tricover/collide.h"

namespace {

using namespace tricover;

bool valid(const std::vector<Ring>& rings) {
  bool result = !rings.empty();
  for (const Ring& ring : rings) {
    result = result && ring.size() >= 3;
    for (const Vec2& vertex : ring) result = result && vertex.allFinite();
  }
  return result;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  fuzz::ByteReader bytes(data, size);
  std::vector<Ring> rings(static_cast<std::size_t>(bytes.integer(0, 3)));
  for (Ring& ring : rings) {
    for (int i = bytes.integer(1, 5); i > 0; --i) {
      const double x = bytes.byte() < 192 ? bytes.coordinate() : bytes.anyDouble();
      ring.emplace_back(x, bytes.byte() < 192 ? bytes.coordinate() : bytes.anyDouble());
    }
  }
  Pose pose = bytes.pose();
  if (bytes.byte() % 2 == 0) pose.matrix()(bytes.integer(0, 1), bytes.integer(0, 2)) = bytes.anyDouble();
  CollideOptions options;
  if (bytes.byte() % 2 == 0) options.margin = bytes.anyDouble();

  const double defect = (pose.linear().transpose() * pose.linear() - Eigen::Matrix2d::Identity()).cwiseAbs().maxCoeff();
  const bool legal_length = std::isfinite(options.margin);
  const bool finite = pose.matrix().allFinite() && legal_length;
  const bool may_pass = finite && defect < 2 * kRigidTolerance, must_pass = finite && defect < 0.5 * kRigidTolerance;
  try {
    const Polygon polygon(rings);
    if (!valid(rings)) fuzz::fail("a bad polygon was taken", support::reproduction(polygon, {0, 0}));
    try {
      const bool forwards = collide(polygon, pose, polygon, Pose::Identity(), options);
      if (!may_pass) fuzz::fail("bad input was taken", support::reproduction({polygon, pose, polygon, pose}));
      if (forwards != collide(polygon, Pose::Identity(), polygon, pose, options))
        fuzz::fail("the order matters", support::reproduction({polygon, pose, polygon, Pose::Identity()}));
    } catch (const std::invalid_argument& error) {
      if (must_pass) fuzz::fail(error.what(), support::reproduction({polygon, pose, polygon, pose}));
    }
  } catch (const std::invalid_argument& error) {
    if (valid(rings)) fuzz::fail("a good polygon was refused", std::string(error.what()) + "\n");
  }
  return 0;
}
