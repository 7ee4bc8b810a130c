// SPDX-License-Identifier: BSD-3-Clause
// Boxes along the axes, in doubles. Lanes::Doubles are as many of them as fit, Lanes::bitsOf() a comparison's bits.
#pragma once

#include "hierarchy/axis_boxes.h"

namespace tricover::detail::simd {

/// As many doubles as a vector V holds.
template <class V>
struct DoublesOf {
  static constexpr int kCount = sizeof(V) / sizeof(double);
  V v;

  [[gnu::always_inline]] static DoublesOf load(const double* p) {
    DoublesOf loaded;
    __builtin_memcpy(&loaded.v, p, sizeof(V));
    return loaded;
  }
  [[gnu::always_inline]] static DoublesOf all(double value) { return {value - V{}}; }
  [[gnu::always_inline]] void store(double* p) const { __builtin_memcpy(p, &v, sizeof(V)); }

  using D = DoublesOf;
  [[gnu::always_inline]] friend D operator+(D p, D q) { return {p.v + q.v}; }
  [[gnu::always_inline]] friend D operator-(D p, D q) { return {p.v - q.v}; }
  [[gnu::always_inline]] friend D operator*(D p, D q) { return {p.v * q.v}; }
  [[gnu::always_inline]] friend D larger(D p, D q) { return {p.v > q.v ? p.v : q.v}; }
  [[gnu::always_inline]] friend D smaller(D p, D q) { return {p.v < q.v ? p.v : q.v}; }
  [[gnu::always_inline]] friend auto noLarger(D p, D q) { return p.v <= q.v; }
};

template <class Lanes>
unsigned boxesMeeting(const EightBoxes& boxes, const Bounds& bounds) {
  using Doubles = typename Lanes::Doubles;
  const Doubles min_x = Doubles::all(bounds.min_x), min_y = Doubles::all(bounds.min_y);
  const Doubles max_x = Doubles::all(bounds.max_x), max_y = Doubles::all(bounds.max_y);
  unsigned bits = 0;
  for (int i = 0; i < kLanes; i += Doubles::kCount)
    bits |= Lanes::bitsOf(
                noLarger(Doubles::load(boxes.min_x + i), max_x) & noLarger(min_x, Doubles::load(boxes.max_x + i)) &
                noLarger(Doubles::load(boxes.min_y + i), max_y) & noLarger(min_y, Doubles::load(boxes.max_y + i)))
            << i;
  return bits;
}

template <class Lanes>
unsigned boxesOnRay(const EightBoxes& boxes, const BoxRay& ray, double most, double* at) {
  using Doubles = typename Lanes::Doubles;
  const bool right = ray.inverse[0] > 0, up = ray.inverse[1] > 0;
  const double *near_x = right ? boxes.min_x : boxes.max_x, *far_x = right ? boxes.max_x : boxes.min_x;
  const double *near_y = up ? boxes.min_y : boxes.max_y, *far_y = up ? boxes.max_y : boxes.min_y;
  const Doubles inverse_x = Doubles::all(ray.inverse[0]), inverse_y = Doubles::all(ray.inverse[1]);
  const Doubles enter_x = Doubles::all(ray.enter[0]), enter_y = Doubles::all(ray.enter[1]);
  const Doubles leave_x = Doubles::all(ray.leave[0]), leave_y = Doubles::all(ray.leave[1]);
  unsigned bits = 0;
  for (int i = 0; i < kLanes; i += Doubles::kCount) {
    const Doubles begin_x = Doubles::load(near_x + i) * inverse_x - enter_x;
    const Doubles begin_y = Doubles::load(near_y + i) * inverse_y - enter_y;
    const Doubles end_x = Doubles::load(far_x + i) * inverse_x - leave_x;
    const Doubles end_y = Doubles::load(far_y + i) * inverse_y - leave_y;
    const Doubles begin = larger(larger(begin_x, begin_y), Doubles::all(-BoxRay::kEarlier));
    const Doubles end = smaller(smaller(end_x, end_y), Doubles::all(most));
    const auto is_box = noLarger(Doubles::load(boxes.min_x + i), Doubles::load(boxes.max_x + i));
    larger(begin, Doubles::all(0)).store(at + i);
    bits |= Lanes::bitsOf(noLarger(begin, end) & is_box) << i;
  }
  return bits;
}

template <class Lanes>
unsigned boxesNear(const EightBoxes& boxes, const Bounds& bounds, double most, double* at) {
  using Doubles = typename Lanes::Doubles;
  const Doubles min_x = Doubles::all(bounds.min_x), min_y = Doubles::all(bounds.min_y);
  const Doubles max_x = Doubles::all(bounds.max_x), max_y = Doubles::all(bounds.max_y);
  const Doubles limit = Doubles::all(most), none = Doubles::all(0);
  unsigned bits = 0;
  for (int i = 0; i < kLanes; i += Doubles::kCount) {
    const Doubles right = Doubles::load(boxes.min_x + i) - max_x, left = min_x - Doubles::load(boxes.max_x + i);
    const Doubles above = Doubles::load(boxes.min_y + i) - max_y, below = min_y - Doubles::load(boxes.max_y + i);
    const Doubles x = larger(none, larger(right, left)), y = larger(none, larger(above, below));  // NaN remains
    const Doubles square = x * x + y * y;
    square.store(at + i);
    bits |= Lanes::bitsOf(noLarger(square, limit)) << i;
  }
  return bits;
}

}  // namespace tricover::detail::simd
