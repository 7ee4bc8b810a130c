// SPDX-License-Identifier: BSD-3-Clause
#include "hierarchy/wide.h"

#include <atomic>

namespace tricover::detail {
namespace {

namespace portable {
#define TRICOVER_TARGET
#define TRICOVER_VECTOR 16
#include "hierarchy/wide_body.h"
#undef TRICOVER_TARGET
#undef TRICOVER_VECTOR
}  // namespace portable

#if defined(__x86_64__)
#define TRICOVER_HAS_AVX2 1
namespace avx2 {
#define TRICOVER_TARGET __attribute__((target("avx2")))
#define TRICOVER_VECTOR 32
#include "hierarchy/wide_body.h"
#undef TRICOVER_TARGET
#undef TRICOVER_VECTOR
}  // namespace avx2
#endif

struct Descents {
  decltype(&portable::descend) descend;
  decltype(&portable::visitPairs) visit_pairs;
  decltype(&portable::visitEdgesOnRay) visit_edges_on_ray;
  decltype(&portable::convexMeet) convex_meet;
  decltype(&portable::innerDepth) inner_depth;
};

constexpr Descents kPortable = {portable::descend, portable::visitPairs, portable::visitEdgesOnRay,
                                portable::convexMeet, portable::innerDepth};

const Descents* fastest() {
#ifdef TRICOVER_HAS_AVX2
  static const Descents wide = {avx2::descend, avx2::visitPairs, avx2::visitEdgesOnRay, avx2::convexMeet,
                                avx2::innerDepth};
  if (__builtin_cpu_supports("avx2")) return &wide;
#endif
  return &kPortable;
}

// Constant until this file's initialisers run, for static objects that ask questions in theirs.
std::atomic<const Descents*> chosen{&kPortable};
[[maybe_unused]] const bool initialised = (chosen.store(fastest(), std::memory_order_relaxed), true);

const Descents& descents() { return *chosen.load(std::memory_order_relaxed); }

}  // namespace

DescentResult descend(const Descent& descent) { return descents().descend(descent); }

void visitPairs(const Descent& descent, const PairVisitor& visitor) { descents().visit_pairs(descent, visitor); }

void visitEdgesOnRay(const Hierarchy& hierarchy, const Ray& ray, bool (*visit)(void*, std::uint32_t), void* context) {
  descents().visit_edges_on_ray(hierarchy, ray, visit, context);
}

Meeting convexMeet(const SmallConvex& a, const SmallConvex& b, const UnitMap& map, double rounding) {
  return descents().convex_meet(a, b, map, rounding);
}

double innerDepth(const InnerDiscs& a, const InnerDiscs& b, const UnitMap& map, double rounding) {
  return descents().inner_depth(a, b, map, rounding);
}

void usePortableLanes(bool portable) { chosen.store(portable ? &kPortable : fastest(), std::memory_order_relaxed); }

}  // namespace tricover::detail
