// SPDX-License-Identifier: BSD-3-Clause
// locate() and castRay() against the exact reference.
#include "byte_reader.h"
#include "exact_reference.h"
#include "ray_laws.h"
#include "reproduction.h"
#include "tricover/locate.h"
#include "tricover/polygon.h"
#include "tricover/ray.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace tricover;
  fuzz::ByteReader bytes(data, size);
  const Polygon polygon = bytes.polygon();
  for (int i = 0; i < 6; ++i) {
    const Vec2 point = i == 3 ? polygon.coveringOrigin() : bytes.point();
    if (locate(polygon, point) != exact::locate(polygon, point))
      fuzz::fail("location", support::reproduction(polygon, point));
  }
  const Pose pose = bytes.pose();
  for (int i = 0; i < 3; ++i) {
    const Vec2 from = bytes.point(), to = bytes.point();
    const auto truth = exact::castRay(polygon, pose, from, to);
    const auto hit = castRay(polygon, pose, from, to);
    const bool right = hit.has_value() == truth.has_value() &&
                       (!hit || (hit->edge == support::namedEdge(polygon, static_cast<EdgeIndex>(truth->edge)) &&
                                 abs(truth->fraction - hit->fraction) <= 1e-14));
    if (!right) fuzz::fail("ray", support::reproduction({polygon, pose, Polygon::segment(from, to), Pose::Identity()}));
  }
  return 0;
}
