// SPDX-License-Identifier: BSD-3-Clause
// What FCL's requests and results mean for polygons, beside what FCL itself does for boxes of the same size: field by
// field, as a table that is printed. (The boxes' heights differ, because MPR errs where they don't.)
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/math/motion/translation_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <cmath>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "scene.h"

namespace tricover_fcl::test {
namespace {

/// Two cuboids with sides 2 along x and y, from -2 to 2 and from -4 to 4 along z: boxes or prisms.
struct Pair {
  std::shared_ptr<fcl::CollisionGeometryd> a, b;
};

Pair boxes() { return {std::make_shared<fcl::Boxd>(2, 2, 4), std::make_shared<fcl::Boxd>(2, 2, 8)}; }

Pair prisms() {
  const tricover::Polygon square({rectangle(-1, -1, 1, 1)});
  return {std::make_shared<PolygonShaped>(square, PolygonOptions{0, -2, 2}),
          std::make_shared<PolygonShaped>(square, PolygonOptions{0, -4, 4})};
}

/// Margins for prisms, and for boxes, which have none, sides as much longer.
Pair grown(const Pair& pair, double by) {
  if (std::dynamic_pointer_cast<fcl::Boxd>(pair.a) != nullptr) {
    return {std::make_shared<fcl::Boxd>(2 + 2 * by, 2 + 2 * by, 4),
            std::make_shared<fcl::Boxd>(2 + 2 * by, 2 + 2 * by, 8)};
  }
  const auto wide = [by](const fcl::CollisionGeometryd& geometry) {
    const auto& shape = static_cast<const PolygonShaped&>(geometry);
    return std::make_shared<PolygonShaped>(shape.polygon(),
                                           PolygonOptions{by, shape.options().z_low, shape.options().z_high});
  };
  return {wide(*pair.a), wide(*pair.b)};
}

fcl::Transform3d at(double x, double z = 0) { return lifted(0, x, 0, z); }

/// Six digits, as far as FCL's own answers go.
std::string text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value == 0 ? 0 : value);
  return digits;
}
std::string text(const fcl::Vector3d& v) { return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")"; }

class Conformity : public ::testing::Test {
 protected:
  using Query = std::function<std::string(const Pair&)>;

  static void SetUpTestSuite() { std::printf("| field | FCL, boxes | polygons | |\n|---|---|---|---|\n"); }

  /// FCL and we say the same.
  void same(const std::string& field, const std::string& expected, const Query& query) {
    row(field, expected, expected, "", query);
  }

  /// They don't, for a reason.
  void differs(const std::string& field, const std::string& of_boxes, const std::string& ours, const std::string& why,
               const Query& query) {
    EXPECT_NE(of_boxes, ours) << field;
    row(field, of_boxes, ours, why, query);
  }

 private:
  void row(const std::string& field, const std::string& of_boxes, const std::string& ours, const std::string& why,
           const Query& query) {
    EXPECT_EQ(query(boxes()), of_boxes) << field << " of boxes";
    EXPECT_EQ(query(prisms()), ours) << field << " of polygons";
    std::printf("| %s | %s | %s | %s |\n", field.c_str(), of_boxes.c_str(), ours.c_str(), why.c_str());
  }
};

fcl::CollisionResultd collide(const Pair& pair, double x, const fcl::CollisionRequestd& request) {
  fcl::CollisionResultd result;
  const std::size_t returned = fcl::collide(pair.a.get(), at(0), pair.b.get(), at(x), request, result);
  EXPECT_EQ(returned, result.numContacts());
  return result;
}

double cost(fcl::CollisionResultd& result) {
  std::vector<fcl::CostSourced> sources;
  result.getCostSources(sources);
  return sources.empty() ? 0 : sources.front().total_cost;
}

std::string contacts(const fcl::CollisionResultd& result) { return std::to_string(result.numContacts()); }

TEST_F(Conformity, collision) {
  same("collide: apart / overlapping (CollisionResult::isCollision)", "0 / 1", [](const Pair& pair) {
    return std::to_string(collide(pair, 2.5, {}).isCollision()) + " / " +
           std::to_string(collide(pair, 1.5, {}).isCollision());
  });
  same("collide: touching", "1", [](const Pair& pair) { return contacts(collide(pair, 2, {})); });
  same("num_max_contacts = 0", "0", [](const Pair& pair) { return contacts(collide(pair, 1.5, {0})); });
  same("num_max_contacts = 1, enable_contact", "1", [](const Pair& pair) {
    return contacts(collide(pair, 1.5, {1, true}));
  });
  differs("num_max_contacts = 100, enable_contact", "4", "2",
          "the ends of each part of the overlap where edges face each other", [](const Pair& pair) {
            return contacts(collide(pair, 1.5, {100, true}));
          });
  same("num_max_contacts = 2, three calls with one result", "2", [](const Pair& pair) {
    fcl::CollisionResultd result;
    for (int i = 0; i < 3; ++i) {
      fcl::collide(pair.a.get(), at(0), pair.b.get(), at(1.5), fcl::CollisionRequestd(2), result);
    }
    return contacts(result);
  });
  same("isSatisfied: poses of no use once it is", "1", [](const Pair& pair) {
    fcl::CollisionResultd result = collide(pair, 1.5, {});
    fcl::collide(pair.a.get(), at(0), pair.b.get(), at(std::nan("")), fcl::CollisionRequestd(), result);
    return contacts(result);
  });
  same("enable_contact = false: contacts, o1, o2, b1, b2", "1, a, b, -1, -1", [](const Pair& pair) {
    const fcl::CollisionResultd result = collide(pair, 1.5, {});
    const fcl::Contactd& contact = result.getContact(0);
    return contacts(result) + (contact.o1 == pair.a.get() ? ", a" : ", ?") +
           (contact.o2 == pair.b.get() ? ", b, " : ", ?, ") + std::to_string(contact.b1) + ", " +
           std::to_string(contact.b2);
  });
  same("Contact::normal", "(1, 0, 0)", [](const Pair& pair) {
    return text(collide(pair, 1.5, {1, true}).getContact(0).normal);
  });
  same("Contact::penetration_depth", "0.5", [](const Pair& pair) {
    return text(collide(pair, 1.5, {1, true}).getContact(0).penetration_depth);
  });
  same("Contact::pos.x()", "0.75", [](const Pair& pair) {
    return text(collide(pair, 1.5, {1, true}).getContact(0).pos.x());
  });
  differs("Contact::b1, b2", "none", "edges", "that part last", [](const Pair& pair) {
    const fcl::Contactd contact = collide(pair, 1.5, {1, true}).getContact(0);
    return contact.b1 >= 0 && contact.b2 >= 0 ? "edges" : contact.b1 == -1 && contact.b2 == -1 ? "none" : "?";
  });
  same("enable_cost: sources, total_cost", "1, 4", [](const Pair& pair) {
    fcl::CollisionResultd result = collide(pair, 1.5, {1, false, 1, true});
    return std::to_string(result.numCostSources()) + ", " + text(cost(result));
  });
  same("enable_cost, apart", "0", [](const Pair& pair) {
    return std::to_string(collide(pair, 2.5, {1, false, 1, true}).numCostSources());
  });
  same("num_max_cost_sources = 0", "0", [](const Pair& pair) {
    return std::to_string(collide(pair, 1.5, {1, false, 0, true}).numCostSources());
  });
  same("use_approximate_cost = false: total_cost", "4", [](const Pair& pair) {
    fcl::CollisionResultd result = collide(pair, 1.5, {1, false, 1, true, false});
    return text(cost(result));
  });
  same("one uncertain, enable_cost: contacts, total_cost", "0, 2", [](const Pair& pair) {
    pair.a->cost_density = 0.5;
    fcl::CollisionResultd result = collide(pair, 1.5, {1, false, 1, true});
    return contacts(result) + ", " + text(cost(result));
  });
  same("one free, enable_cost: contacts, sources", "0, 0", [](const Pair& pair) {
    pair.a->cost_density = 0;
    const fcl::CollisionResultd result = collide(pair, 1.5, {1, false, 1, true});
    return contacts(result) + ", " + std::to_string(result.numCostSources());
  });
  same("the other one free, enable_cost: contacts, sources", "0, 0", [](const Pair& pair) {
    pair.b->cost_density = 0;
    const fcl::CollisionResultd result = collide(pair, 1.5, {1, false, 1, true});
    return contacts(result) + ", " + std::to_string(result.numCostSources());
  });
  same("gjk_solver_type = GST_INDEP: depth", "0.5", [](const Pair& pair) {
    return text(collide(pair, 1.5, {1, true, 1, false, true, fcl::GST_INDEP}).getContact(0).penetration_depth);
  });
  same("gjk_tolerance = 1e-15 / 0.1, gap 0.01", "0 / 0", [](const Pair& pair) {
    return contacts(collide(pair, 2.01, {1, false, 1, false, true, fcl::GST_INDEP, 1e-15})) + " / " +
           contacts(collide(pair, 2.01, {1, false, 1, false, true, fcl::GST_INDEP, 0.1}));
  });
  same("enable_cached_gjk_guess, any guess: gap 0.01 / overlap 0.01", "0 / 1", [](const Pair& pair) {
    fcl::CollisionRequestd request;
    request.enable_cached_gjk_guess = true;
    request.cached_gjk_guess = fcl::Vector3d(-3, 1, 7);
    return contacts(collide(pair, 2.01, request)) + " / " + contacts(collide(pair, 1.99, request));
  });
}

struct Measured {
  double returned;
  fcl::DistanceResultd result;
};

Measured distance(const Pair& pair, double x, const fcl::DistanceRequestd& request, double z = 0,
                  fcl::DistanceResultd result = {}) {
  const double returned = fcl::distance(pair.a.get(), at(0), pair.b.get(), at(x, z), request, result);
  return {returned, result};
}

const fcl::DistanceRequestd kDefault;

fcl::DistanceRequestd asking(bool is_signed, fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  return fcl::DistanceRequestd(true, is_signed, 0, 0, 1e-6, solver);
}

TEST_F(Conformity, distance) {
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    const std::string name = solver == fcl::GST_LIBCCD ? " (LIBCCD)" : " (INDEP)";
    same("distance: returned, min_distance" + name, "1, 1", [&](const Pair& pair) {
      const Measured m = distance(pair, 3, asking(false, solver));
      return text(m.returned) + ", " + text(m.result.min_distance);
    });
    same("nearest_points: x" + name, "1, 2", [&](const Pair& pair) {
      const fcl::DistanceResultd result = distance(pair, 3, asking(false, solver)).result;
      return text(result.nearest_points[0].x()) + ", " + text(result.nearest_points[1].x());
    });
    same("overlapping, unsigned" + name, "-1",
         [&](const Pair& pair) { return text(distance(pair, 1.5, asking(false, solver)).returned); });
    same("enable_signed_distance: min_distance" + name, "-0.5",
         [&](const Pair& pair) { return text(distance(pair, 1.5, asking(true, solver)).result.min_distance); });
  }
  differs("distance along z (LIBCCD)", "4.47214", "4", "libccd's GJK is wrong here",
          [](const Pair& pair) { return text(distance(pair, 0, asking(false), 10).returned); });
  same("distance along z (INDEP)", "4",
       [](const Pair& pair) { return text(distance(pair, 0, asking(false, fcl::GST_INDEP), 10).returned); });
  same("enable_signed_distance: returned (LIBCCD)", "-0.5",
       [](const Pair& pair) { return text(distance(pair, 1.5, asking(true)).returned); });
  differs("enable_signed_distance: returned (INDEP)", "-1", "-0.5", "what min_distance says",
          [](const Pair& pair) { return text(distance(pair, 1.5, asking(true, fcl::GST_INDEP)).returned); });
  same("enable_signed_distance: nearest_points, x (LIBCCD)", "1, 0.5", [](const Pair& pair) {
    const fcl::DistanceResultd result = distance(pair, 1.5, asking(true)).result;
    return text(result.nearest_points[0].x()) + ", " + text(result.nearest_points[1].x());
  });
  differs("touching", "-1", "0", "exact", [](const Pair& pair) { return text(distance(pair, 2, kDefault).returned); });
  same("enable_nearest_points = false: nearest_points, x", "1, 2", [](const Pair& pair) {
    const fcl::DistanceResultd result = distance(pair, 3, kDefault).result;
    return text(result.nearest_points[0].x()) + ", " + text(result.nearest_points[1].x());
  });
  same("DistanceResult::o1, o2", "a, b", [](const Pair& pair) {
    const fcl::DistanceResultd result = distance(pair, 3, kDefault).result;
    return std::string(result.o1 == pair.a.get() ? "a" : "?") + (result.o2 == pair.b.get() ? ", b" : ", ?");
  });
  differs("DistanceResult::b1, b2", "none", "edges", "on which the points lie", [](const Pair& pair) {
    const fcl::DistanceResultd result = distance(pair, 3, kDefault).result;
    return result.b1 >= 0 && result.b2 >= 0 ? "edges" : result.b1 == -1 && result.b2 == -1 ? "none" : "?";
  });
  same("PolygonOptions::margin = 0.25 (boxes: as much wider): min_distance, nearest_points: x", "0.5, 1.25, 1.75",
       [](const Pair& pair) {
         const fcl::DistanceResultd result = distance(grown(pair, 0.25), 3, kDefault).result;
         return text(result.min_distance) + ", " + text(result.nearest_points[0].x()) + ", " +
                text(result.nearest_points[1].x());
       });
  same("the same, where only the margins meet: min_distance, signed", "-1, -0.25", [](const Pair& pair) {
    const Pair wider = grown(pair, 0.25);
    return text(distance(wider, 2.25, kDefault).result.min_distance) + ", " +
           text(distance(wider, 2.25, asking(true)).result.min_distance);
  });
  same("... signed: nearest_points, x", "1.25, 1", [](const Pair& pair) {
    const fcl::DistanceResultd result = distance(grown(pair, 0.25), 2.25, asking(true)).result;
    return text(result.nearest_points[0].x()) + ", " + text(result.nearest_points[1].x());
  });
  same("... collide: normal, penetration_depth, pos.x()", "(1, 0, 0), 0.25, 1.125", [](const Pair& pair) {
    const fcl::Contactd contact = collide(grown(pair, 0.25), 2.25, {1, true}).getContact(0);
    return text(contact.normal) + ", " + text(contact.penetration_depth) + ", " + text(contact.pos.x());
  });
  same("a result that is nearer already: returned, o1 kept", "0.5, yes", [](const Pair& pair) {
    const Measured m = distance(pair, 3, kDefault, 0, fcl::DistanceResultd(0.5));
    return text(m.returned) + (m.result.o1 == nullptr ? ", yes" : ", no");
  });
  same("isSatisfied: a result at 0 is kept", "0",
       [](const Pair& pair) { return text(distance(pair, 1.5, kDefault, 0, fcl::DistanceResultd(0)).returned); });
  same("rel_err = 0.5, abs_err = 0.1: within 1.6", "yes", [](const Pair& pair) {
    const double answer = distance(pair, 3, fcl::DistanceRequestd(true, false, 0.5, 0.1)).returned;
    return answer >= 1 - 1e-6 && answer <= 1.6 ? "yes" : "no";
  });
  same("distance_tolerance = 1e-3: to that", "yes", [](const Pair& pair) {
    const double answer = distance(pair, 3, fcl::DistanceRequestd(true, false, 0, 0, 1e-3)).returned;
    return std::abs(answer - 1) <= 1e-3 ? "yes" : "no";
  });
}

/// `a` goes along x from -10 by `way`, past b at the origin.
fcl::ContinuousCollisionResultd pass(const Pair& pair, const fcl::ContinuousCollisionRequestd& request,
                                     double way = 20) {
  fcl::ContinuousCollisionResultd result;
  fcl::continuousCollide(pair.a.get(), at(-10), at(-10 + way), pair.b.get(), at(0), at(0), request, result);
  return result;
}

std::string outcome(const fcl::ContinuousCollisionResultd& result) {
  return std::to_string(result.is_collide) + ", " + text(result.time_of_contact);
}

fcl::ContinuousCollisionRequestd advancing(double error = 1e-4, fcl::CCDMotionType type = fcl::CCDM_TRANS,
                                           fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  return fcl::ContinuousCollisionRequestd(10, error, type, solver, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
}

/// What is said of a time that should be 0.4.
std::string near(const fcl::ContinuousCollisionResultd& result, double error) {
  const double early = 0.4 - result.time_of_contact;
  return result.is_collide && early >= -1e-12 && early <= error ? "yes" : "no";
}

TEST_F(Conformity, continuous) {
  differs("NAIVE (the default), at most 1e-4 early", "no", "yes", "FCL samples",
          [](const Pair& pair) { return near(pass(pair, {}), 1e-4); });
  differs("NAIVE, num_max_iterations = 3", "no", "yes", "FCL samples",
          [](const Pair& pair) { return near(pass(pair, {3}), 1e-4); });
  differs("NAIVE, toc_err = 0.5", "no", "yes", "FCL samples, and says \"free\"", [](const Pair& pair) {
    return near(pass(pair, {10, 0.5}), 0.5);
  });
  same("NAIVE: contact_tf1, contact_tf2 are the motions' poses", "yes", [](const Pair& pair) {
    const auto result = pass(pair, {});
    const double x = -10 + 20 * result.time_of_contact;
    return std::abs(result.contact_tf1.translation().x() - x) < 1e-9 && result.contact_tf2.isApprox(at(0)) ? "yes"
                                                                                                           : "no";
  });
  for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
    const std::string name = solver == fcl::GST_LIBCCD ? " (LIBCCD)" : " (INDEP)";
    same("CONSERVATIVE_ADVANCEMENT, at most 1e-4 early" + name, "yes",
         [&](const Pair& pair) { return near(pass(pair, advancing(1e-4, fcl::CCDM_TRANS, solver)), 1e-4); });
  }
  same("toc_err = 1e-9", "yes", [](const Pair& pair) { return near(pass(pair, advancing(1e-9)), 1e-9); });
  same("num_max_iterations = 1: no effect", "yes", [](const Pair& pair) {
    fcl::ContinuousCollisionRequestd request = advancing();
    request.num_max_iterations = 1;
    return near(pass(pair, request), 1e-4);
  });
  same("free: is_collide, time_of_contact", "0, 1",
       [](const Pair& pair) { return outcome(pass(pair, advancing(), 7.5)); });
  same("contact at the begin", "1, 0", [](const Pair& pair) {
    fcl::ContinuousCollisionResultd result;
    fcl::continuousCollide(pair.a.get(), at(1), at(9), pair.b.get(), at(0), at(0), advancing(), result);
    return outcome(result);
  });
  differs("contact at the end (touching)", "0, 1", "1, 1", "counts",
          [](const Pair& pair) { return outcome(pass(pair, advancing(1e-9), 8)); });
  same("contact_tf1.x() where they meet, to 0.01", "yes", [](const Pair& pair) {
    return std::abs(pass(pair, advancing()).contact_tf1.translation().x() + 2) < 0.01 ? "yes" : "no";
  });
  same("CCDM_LINEAR", "yes",
       [](const Pair& pair) { return near(pass(pair, advancing(1e-4, fcl::CCDM_LINEAR)), 1e-4); });
  differs("CCDM_SCREW without a turn", "no", "yes", "boxes: FCL's ScrewMotion goes 20 times as far",
          [](const Pair& pair) { return near(pass(pair, advancing(1e-4, fcl::CCDM_SCREW)), 1e-4); });
  for (const fcl::CCDSolverType solver : {fcl::CCDC_RAY_SHOOTING, fcl::CCDC_POLYNOMIAL_SOLVER}) {
    const bool shoots = solver == fcl::CCDC_RAY_SHOOTING;
    differs(shoots ? "CCDC_RAY_SHOOTING, at most 1e-4 early" : "CCDC_POLYNOMIAL_SOLVER, at most 1e-4 early", "no",
            "yes", "FCL's answer reads as \"free\"", [&](const Pair& pair) -> std::string {
              fcl::ContinuousCollisionRequestd request;
              request.ccd_solver_type = solver;
              return near(pass(pair, request), 1e-4);
            });
  }
}

/// Two objects with motions: a passes b as in pass().
struct MovingPair {
  fcl::ContinuousCollisionObjectd a, b;

  explicit MovingPair(const Pair& pair)
      : a(pair.a, std::make_shared<fcl::TranslationMotiond>(at(-10), at(10))),
        b(pair.b, std::make_shared<fcl::TranslationMotiond>(at(0), at(0))) {}
};

TEST_F(Conformity, movingObjects) {
  same("collide(ContinuousCollisionObject, ...)", "yes", [](const Pair& pair) {
    const MovingPair moving(pair);
    fcl::ContinuousCollisionResultd result;
    const double returned = fcl::collide(&moving.a, &moving.b, advancing(), result);
    return returned == result.time_of_contact ? near(result, 1e-4) : "no";
  });
  // FCL 0.7.0 has the callback and an abstract manager to call it, but none that does.
  same("DefaultContinuousCollisionFunction: returned, is_collide, done", "0, 1, 0", [](const Pair& pair) {
    MovingPair moving(pair);
    fcl::DefaultContinuousCollisionData<double> data;
    data.request = advancing();
    const bool returned = fcl::DefaultContinuousCollisionFunction<double>(&moving.a, &moving.b, &data);
    return std::to_string(returned) + ", " + std::to_string(data.result.is_collide) + ", " + std::to_string(data.done);
  });
  same("DefaultContinuousCollisionFunction once done: returned, is_collide", "1, 0", [](const Pair& pair) {
    MovingPair moving(pair);
    fcl::DefaultContinuousCollisionData<double> data;
    data.request = advancing();
    data.done = true;
    const bool returned = fcl::DefaultContinuousCollisionFunction<double>(&moving.a, &moving.b, &data);
    return std::to_string(returned) + ", " + std::to_string(data.result.is_collide);
  });
  // (ContinuousCollisionObject::computeAABB() crashes on motions of FCL's own: their Taylor models have no time
  // interval.)
}

}  // namespace
}  // namespace tricover_fcl::test
