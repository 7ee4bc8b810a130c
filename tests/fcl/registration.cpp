// SPDX-License-Identifier: BSD-3-Clause
#include "tricover_fcl/registration.h"

#include <fcl/narrowphase/collision.h>

#include <atomic>
#include <stdexcept>
#include <thread>
#include <vector>

#include "scene.h"

namespace tricover_fcl::test {
namespace {

/// The first registration of the process, for all tests: by many threads at once.
class Registration : public ::testing::Environment {
  void SetUp() override {
    std::vector<std::thread> threads;
    for (int i = 0; i < 8; ++i) {
      threads.emplace_back([this] {
        registerNarrowphase();
        ++returned_;
      });
    }
    for (std::thread& thread : threads) thread.join();
    ASSERT_EQ(returned_, 8);
  }

  std::atomic<int> returned_{0};
};

const ::testing::Environment* const registration = ::testing::AddGlobalTestEnvironment(new Registration);

TEST(Registration, refusesAnotherFcl) {
  EXPECT_NO_THROW(checkFclLayout());
  FclLayout patched;
  patched.sphere += 8;
  EXPECT_THROW(checkFclLayout(patched), std::logic_error);
  FclLayout avx;
  avx.alignment *= 2;
  EXPECT_THROW(checkFclLayout(avx), std::logic_error);
}

TEST(Registration, canBeRepeated) { EXPECT_NO_THROW(registerNarrowphase()); }

TEST(Registration, threadsShareShapes) {
  Random random(3);
  const Shape<double> a = shapeOf(randomPolygon(random, 1)), b = shapeOf(randomPolygon(random, 1));
  constexpr int kSteps = 300;
  const auto hits = [&a, &b](int thread) {
    int count = 0;
    for (int i = 0; i < kSteps; ++i) {
      // The constructor recomputes the shared shape's box.
      const fcl::CollisionObjectd moving(a, lifted(turnedAndMoved(0.01 * i, 0.01 * (i - 100 - thread), 0)));
      const fcl::CollisionObjectd standing(b);
      fcl::CollisionResultd result;
      count += static_cast<int>(fcl::collide(&moving, &standing, fcl::CollisionRequestd(), result));
    }
    return count;
  };
  std::vector<int> counts(4);
  std::vector<std::thread> threads;
  for (int t = 0; t < 4; ++t) threads.emplace_back([&, t] { counts[static_cast<std::size_t>(t)] = hits(t); });
  for (std::thread& thread : threads) thread.join();
  for (int t = 0; t < 4; ++t) EXPECT_EQ(counts[static_cast<std::size_t>(t)], hits(t));
  EXPECT_GT(counts[0], kSteps / 4);
  EXPECT_LT(counts[0], kSteps * 9 / 10);
}

}  // namespace
}  // namespace tricover_fcl::test
