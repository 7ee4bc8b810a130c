// SPDX-License-Identifier: BSD-3-Clause
// SIMD: eight floats (or boxes, or edges) side by side, by the instructions that the processor has.
//
// Such a function is declared where others find it (simd.h, axis_boxes.h), named in the list below, and defined once,
// as a template over its lanes. simd_portable.cpp and simd_avx2.cpp instantiate the list for what the target has anyway
// (SSE2, NEON) and for AVX2. No operation is reordered, and none is fused but what a product rounds off, which is exact
// either way: so both give the same bits.
#pragma once

#include <atomic>
#include <utility>

namespace tricover::detail {

constexpr int kLanes = 8;

/// Called like a function. It is constant initialised for the portable lanes, for static objects that ask questions
/// before it is known what the processor has.
template <class Signature>
class Simd;

template <class Result, class... Arguments>
class Simd<Result(Arguments...)> {
 public:
  using Function = Result (*)(Arguments...);

  constexpr Simd(Function function) : function_(function) {}
  void operator=(Function function) { function_.store(function, std::memory_order_relaxed); }
  Result operator()(Arguments... arguments) const {
    return function_.load(std::memory_order_relaxed)(std::forward<Arguments>(arguments)...);
  }

 private:
  std::atomic<Function> function_;
};

// clang-format off
#define TRICOVER_SIMD_FUNCTIONS(X) \
  X(findHit) X(showPairs) X(findEdgeNear) X(findNearestEdges) X(visitMarkedNear) \
  X(visitEdgesOnRay) X(findEdgesOnPaths) \
  X(cutIntervals) X(depthInDiscs) X(innerDepth) \
  X(convexGap) X(convexEntry) X(convexCrossing) X(fewEdgesMeet) \
  X(boxesMeeting) X(boxesOnRay) X(boxesNear) \
  X(measureDepths) X(twofoldWay) X(twofoldArea)
// clang-format on

#ifdef __x86_64__
void useAvx2();
#endif

#ifdef TRICOVER_TEST_SWITCHES
/// Chooses for the whole process: the fastest, as at its begin, or without AVX2.
void usePortableLanes(bool portable);
#endif

}  // namespace tricover::detail
