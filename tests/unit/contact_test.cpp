// SPDX-License-Identifier: BSD-3-Clause
// A contact names edges, whatever shorter way there is to the answer alone: half planes, inner discs.
#include <gtest/gtest.h>

#include "shapes.h"
#include "tricover/contacts.h"

namespace tricover::support {
namespace {

TEST(Contact, NamesEdgesOfSmallConvexAndOfDeepPairs) {
  for (const int n : {4, 8, 16, 200}) {
    const Polygon a({regular(n, 1)}), b({regular(n, 0.9)});
    for (const double x : {0.3, 0.6, 1.2}) {
      const auto found = contact(a, Pose::Identity(), b, pose(0.1, x, 0));
      ASSERT_TRUE(found.has_value());
      EXPECT_GE(found->edge_a, 0) << n << " " << x;
      EXPECT_GE(found->edge_b, 0) << n << " " << x;
      EXPECT_NEAR(found->point.norm(), 1, 0.3);
    }
    const auto contained = contact(a, Pose::Identity(), Polygon({regular(n, 0.1)}), Pose::Identity());
    ASSERT_TRUE(contained.has_value());
    EXPECT_EQ(contained->edge_a, -1);
    EXPECT_EQ(contained->edge_b, 0);
    EXPECT_NEAR(contained->point.norm(), 0.1, 1e-12);
  }
}

}  // namespace
}  // namespace tricover::support
