// SPDX-License-Identifier: BSD-3-Clause
#include "tricover/segment.h"

#include "numbers/errors.h"

namespace tricover {
namespace {

void requireFinite(const Vec2& p, const char* field) { detail::requireFinite(p, field); }

}  // namespace

Polygon point(const Vec2& p) {
  requireFinite(p, "p");
  const Vec2 ring[] = {p, p, p};
  return Polygon(ring, 3);
}

Polygon segment(const Vec2& p, const Vec2& q) {
  requireFinite(p, "p");
  requireFinite(q, "q");
  const Vec2 ring[] = {p, q, q};
  return Polygon(ring, 3);
}

}  // namespace tricover
