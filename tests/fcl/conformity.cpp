// SPDX-License-Identifier: BSD-3-Clause
// What FCL's requests and results mean for polygons, beside what FCL itself does for boxes of the same size: field by
// field, as a table that is printed. (The boxes' heights differ, because MPR errs where they don't.)
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/math/motion/translation_motion.h>

#include <cmath>
#include <cstdio>
#include <functional>

#include "ask.h"

namespace tricover_fcl::test {
namespace {

/// Two cuboids with sides 2 along x and y, from -2 to 2 and from -4 to 4 along z: boxes or prisms. Grown by margins of
/// prisms; boxes, which have none, have sides as much longer.
struct Pair {
  std::shared_ptr<Body> a, b;
};

Pair boxes(double by) {
  return {std::make_shared<fcl::Boxd>(2 + 2 * by, 2 + 2 * by, 4),
          std::make_shared<fcl::Boxd>(2 + 2 * by, 2 + 2 * by, 8)};
}

Pair prisms(double by) { return {rectangular(-1, -1, 1, 1, {by, -2, 2}), rectangular(-1, -1, 1, 1, {by, -4, 4})}; }

Transform at(double x, double z = 0) { return lifted(0, x, 0, z); }

/// Six digits, as far as FCL's own answers go.
std::string text(double value) {
  char digits[32];
  std::snprintf(digits, sizeof digits, "%.6g", value == 0 ? 0 : value);
  return digits;
}
std::string text(const Vec3& v) { return "(" + text(v.x()) + ", " + text(v.y()) + ", " + text(v.z()) + ")"; }
std::string yes(bool is_so) { return is_so ? "yes" : "no"; }

/// What is asked of a pair.
using Query = std::function<std::string(const Pair&)>;

Query joined(const Query& first, const Query& second, const char* by = ", ") {
  return [=](const Pair& pair) {
    const std::string left = first(pair);
    return left + by + second(pair);
  };
}

class Conformity : public ::testing::Test {
 protected:
  static void SetUpTestSuite() { std::printf("| field | FCL, boxes | polygons | |\n|---|---|---|---|\n"); }

  /// FCL and we say the same.
  void same(const std::string& field, const std::string& expected, const Query& query, double grown = 0) {
    row(field, expected, expected, "", query, grown);
  }

  /// They don't, for a reason.
  void differs(const std::string& field, const std::string& of_boxes, const std::string& ours, const std::string& why,
               const Query& query) {
    EXPECT_NE(of_boxes, ours) << field;
    row(field, of_boxes, ours, why, query, 0);
  }

 private:
  void row(const std::string& field, const std::string& of_boxes, const std::string& ours, const std::string& why,
           const Query& query, double grown) {
    EXPECT_EQ(query(boxes(grown)), of_boxes) << field << " of boxes";
    EXPECT_EQ(query(prisms(grown)), ours) << field << " of polygons";
    std::printf("| %s | %s | %s | %s |\n", field.c_str(), of_boxes.c_str(), ours.c_str(), why.c_str());
  }
};

fcl::CollisionResultd collide(const Pair& pair, double x, const fcl::CollisionRequestd& request) {
  fcl::CollisionResultd result;
  const std::size_t returned = fcl::collide(pair.a.get(), at(0), pair.b.get(), at(x), request, result);
  EXPECT_EQ(returned, result.numContacts());
  return result;
}

Query contacts(double x, const fcl::CollisionRequestd& request = {}) {
  return [=](const Pair& pair) { return std::to_string(collide(pair, x, request).numContacts()); };
}

/// Of the only contact.
Query contact(std::string (*of)(const fcl::Contactd&), double x = 1.5, fcl::GJKSolverType solver = fcl::GST_LIBCCD) {
  return [=](const Pair& pair) { return of(collide(pair, x, {1, true, 1, false, true, solver}).getContact(0)); };
}

std::string depth(const fcl::Contactd& contact) { return text(contact.penetration_depth); }
std::string normal(const fcl::Contactd& contact) { return text(contact.normal); }
std::string place(const fcl::Contactd& contact) { return text(contact.pos.x()); }

template <typename Result>
std::string indices(const Result& result) {
  return result.b1 >= 0 && result.b2 >= 0 ? "edges" : result.b1 == -1 && result.b2 == -1 ? "none" : "?";
}

Query sources(double x, const fcl::CollisionRequestd& request) {
  return [=](const Pair& pair) { return std::to_string(collide(pair, x, request).numCostSources()); };
}

Query cost(double x, const fcl::CollisionRequestd& request) {
  return [=](const Pair& pair) {
    std::vector<fcl::CostSourced> all;
    collide(pair, x, request).getCostSources(all);
    return text(all.empty() ? 0 : all.front().total_cost);
  };
}

/// With other densities: of `a` if the first is meant, else of `b`.
Query dense(bool first, double density, const Query& query) {
  return [=](const Pair& pair) {
    (first ? pair.a : pair.b)->cost_density = density;
    return query(pair);
  };
}

TEST_F(Conformity, collision) {
  const fcl::CollisionRequestd with_cost(1, false, 1, true);
  same("collide: apart / overlapping (CollisionResult::isCollision)", "0 / 1", [](const Pair& pair) {
    return std::to_string(collide(pair, 2.5, {}).isCollision()) + " / " +
           std::to_string(collide(pair, 1.5, {}).isCollision());
  });
  same("collide: touching", "1", contacts(2));
  same("num_max_contacts = 0", "0", contacts(1.5, {0}));
  same("num_max_contacts = 1, enable_contact", "1", contacts(1.5, {1, true}));
  differs("num_max_contacts = 100, enable_contact", "4", "2",
          "the ends of each part of the overlap where edges face each other", contacts(1.5, {100, true}));
  same("num_max_contacts = 2, three calls with one result", "2", [](const Pair& pair) {
    fcl::CollisionResultd result;
    for (int i = 0; i < 3; ++i)
      fcl::collide(pair.a.get(), at(0), pair.b.get(), at(1.5), fcl::CollisionRequestd(2), result);
    return std::to_string(result.numContacts());
  });
  same("isSatisfied: poses of no use once it is", "1", [](const Pair& pair) {
    fcl::CollisionResultd result = collide(pair, 1.5, {});
    fcl::collide(pair.a.get(), at(0), pair.b.get(), at(kNaN), fcl::CollisionRequestd(), result);
    return std::to_string(result.numContacts());
  });
  same("enable_contact = false: contacts, o1, o2, b1, b2", "1, a, b, none", [](const Pair& pair) {
    const fcl::CollisionResultd result = collide(pair, 1.5, {});
    const fcl::Contactd& contact = result.getContact(0);
    return std::to_string(result.numContacts()) + (contact.o1 == pair.a.get() ? ", a" : ", ?") +
           (contact.o2 == pair.b.get() ? ", b, " : ", ?, ") + indices(contact);
  });
  same("Contact::normal", "(1, 0, 0)", contact(normal));
  same("Contact::penetration_depth", "0.5", contact(depth));
  same("Contact::pos.x()", "0.75", contact(place));
  differs("Contact::b1, b2", "none", "edges", "that part last", contact(indices<fcl::Contactd>));
  same("enable_cost: sources, total_cost", "1, 4", joined(sources(1.5, with_cost), cost(1.5, with_cost)));
  same("enable_cost, apart", "0", sources(2.5, with_cost));
  same("num_max_cost_sources = 0", "0", sources(1.5, {1, false, 0, true}));
  same("use_approximate_cost = false: total_cost", "4", cost(1.5, {1, false, 1, true, false}));
  same("one uncertain, enable_cost: contacts, total_cost", "0, 2",
       dense(true, 0.5, joined(contacts(1.5, with_cost), cost(1.5, with_cost))));
  same("one free, enable_cost: contacts, sources", "0, 0",
       dense(true, 0, joined(contacts(1.5, with_cost), sources(1.5, with_cost))));
  same("the other one free, enable_cost: contacts, sources", "0, 0",
       dense(false, 0, joined(contacts(1.5, with_cost), sources(1.5, with_cost))));
  same("gjk_solver_type = GST_INDEP: depth", "0.5", contact(depth, 1.5, fcl::GST_INDEP));
  same("gjk_tolerance = 1e-15 / 0.1, gap 0.01", "0 / 0",
       joined(contacts(2.01, {1, false, 1, false, true, fcl::GST_INDEP, 1e-15}),
              contacts(2.01, {1, false, 1, false, true, fcl::GST_INDEP, 0.1}), " / "));
  fcl::CollisionRequestd guessed;
  guessed.enable_cached_gjk_guess = true;
  guessed.cached_gjk_guess = Vec3(-3, 1, 7);
  same("enable_cached_gjk_guess, any guess: gap 0.01 / overlap 0.01", "0 / 1",
       joined(contacts(2.01, guessed), contacts(1.99, guessed), " / "));
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

Query returned(double x, const fcl::DistanceRequestd& request = kDefault, double z = 0) {
  return [=](const Pair& pair) { return text(distance(pair, x, request, z).returned); };
}

Query least(double x, const fcl::DistanceRequestd& request = kDefault) {
  return [=](const Pair& pair) { return text(distance(pair, x, request).result.min_distance); };
}

/// The nearest points' x.
Query points(double x, const fcl::DistanceRequestd& request = kDefault) {
  return [=](const Pair& pair) {
    const fcl::DistanceResultd result = distance(pair, x, request).result;
    return text(result.nearest_points[0].x()) + ", " + text(result.nearest_points[1].x());
  };
}

TEST_F(Conformity, distance) {
  for (const fcl::GJKSolverType solver : kSolvers) {
    const std::string name = solver == fcl::GST_LIBCCD ? " (LIBCCD)" : " (INDEP)";
    const auto plain = asking(false, solver), with_sign = asking(true, solver);
    same("distance: returned, min_distance" + name, "1, 1", joined(returned(3, plain), least(3, plain)));
    same("nearest_points: x" + name, "1, 2", points(3, plain));
    same("overlapping, unsigned" + name, "-1", returned(1.5, plain));
    same("enable_signed_distance: min_distance" + name, "-0.5", least(1.5, with_sign));
  }
  differs("distance along z (LIBCCD)", "4.47214", "4", "libccd's GJK is wrong here", returned(0, asking(false), 10));
  same("distance along z (INDEP)", "4", returned(0, asking(false, fcl::GST_INDEP), 10));
  same("enable_signed_distance: returned (LIBCCD)", "-0.5", returned(1.5, asking(true)));
  differs("enable_signed_distance: returned (INDEP)", "-1", "-0.5", "what min_distance says",
          returned(1.5, asking(true, fcl::GST_INDEP)));
  same("enable_signed_distance: nearest_points, x (LIBCCD)", "1, 0.5", points(1.5, asking(true)));
  differs("touching", "-1", "0", "exact", returned(2));
  same("enable_nearest_points = false: nearest_points, x", "1, 2", points(3));
  same("DistanceResult::o1, o2", "yes", [](const Pair& pair) {
    const fcl::DistanceResultd result = distance(pair, 3, kDefault).result;
    return yes(result.o1 == pair.a.get() && result.o2 == pair.b.get());
  });
  differs("DistanceResult::b1, b2", "none", "edges", "on which the points lie",
          [](const Pair& pair) { return indices(distance(pair, 3, kDefault).result); });
  same("PolygonOptions::margin = 0.25 (boxes: as much wider): min_distance, nearest_points: x", "0.5, 1.25, 1.75",
       joined(least(3), points(3)), 0.25);
  same("the same, where only the margins meet: min_distance, signed", "-1, -0.25",
       joined(least(2.25), least(2.25, asking(true))), 0.25);
  same("... signed: nearest_points, x", "1.25, 1", points(2.25, asking(true)), 0.25);
  same("... collide: normal, penetration_depth, pos.x()", "(1, 0, 0), 0.25, 1.125",
       joined(contact(normal, 2.25), joined(contact(depth, 2.25), contact(place, 2.25))), 0.25);
  same("a result that is nearer already: returned, o1 kept", "0.5, yes", [](const Pair& pair) {
    const Measured m = distance(pair, 3, kDefault, 0, fcl::DistanceResultd(0.5));
    return text(m.returned) + ", " + yes(m.result.o1 == nullptr);
  });
  same("isSatisfied: a result at 0 is kept", "0",
       [](const Pair& pair) { return text(distance(pair, 1.5, kDefault, 0, fcl::DistanceResultd(0)).returned); });
  same("rel_err = 0.5, abs_err = 0.1: within 1.6", "yes", [](const Pair& pair) {
    const double answer = distance(pair, 3, fcl::DistanceRequestd(true, false, 0.5, 0.1)).returned;
    return yes(answer >= 1 - 1e-6 && answer <= 1.6);
  });
  same("distance_tolerance = 1e-3: to that", "yes", [](const Pair& pair) {
    return yes(std::abs(distance(pair, 3, fcl::DistanceRequestd(true, false, 0, 0, 1e-3)).returned - 1) <= 1e-3);
  });
}

/// `a` goes along x from `from` to `to`, past b at the origin.
Impact pass(const Pair& pair, const fcl::ContinuousCollisionRequestd& request, double from = -10, double to = 10) {
  Impact result;
  fcl::continuousCollide(pair.a.get(), at(from), at(to), pair.b.get(), at(0), at(0), request, result);
  return result;
}

/// What is said of a time that should be 0.4.
std::string near(const Impact& result, double error) {
  const double early = 0.4 - result.time_of_contact;
  return yes(result.is_collide && early >= -1e-12 && early <= error);
}

Query isNear(const fcl::ContinuousCollisionRequestd& request, double error) {
  return [=](const Pair& pair) { return near(pass(pair, request), error); };
}

Query outcome(const fcl::ContinuousCollisionRequestd& request, double from, double to) {
  return [=](const Pair& pair) {
    const Impact result = pass(pair, request, from, to);
    return std::to_string(result.is_collide) + ", " + text(result.time_of_contact);
  };
}

TEST_F(Conformity, continuous) {
  differs("NAIVE (the default), at most 1e-4 early", "no", "yes", "FCL samples", isNear({}, 1e-4));
  differs("NAIVE, num_max_iterations = 3", "no", "yes", "FCL samples", isNear({3}, 1e-4));
  differs("NAIVE, toc_err = 0.5", "no", "yes", "FCL samples, and says \"free\"", isNear({10, 0.5}, 0.5));
  same("NAIVE: contact_tf1, contact_tf2 are the motions' poses", "yes", [](const Pair& pair) {
    const Impact result = pass(pair, {});
    const double x = -10 + 20 * result.time_of_contact;
    return yes(std::abs(result.contact_tf1.translation().x() - x) < 1e-9 && result.contact_tf2.isApprox(at(0)));
  });
  same("CONSERVATIVE_ADVANCEMENT, at most 1e-4 early (LIBCCD)", "yes", isNear(advancing(1e-4), 1e-4));
  same("CONSERVATIVE_ADVANCEMENT, at most 1e-4 early (INDEP)", "yes",
       isNear(advancing(1e-4, fcl::CCDM_TRANS, fcl::GST_INDEP), 1e-4));
  same("toc_err = 1e-9", "yes", isNear(advancing(1e-9), 1e-9));
  fcl::ContinuousCollisionRequestd once = advancing(1e-4);
  once.num_max_iterations = 1;
  same("num_max_iterations = 1: no effect", "yes", isNear(once, 1e-4));
  same("free: is_collide, time_of_contact", "0, 1", outcome(advancing(1e-4), -10, -2.5));
  same("contact at the begin", "1, 0", outcome(advancing(1e-4), 1, 9));
  differs("contact at the end (touching)", "0, 1", "1, 1", "counts", outcome(advancing(1e-9), -10, -2));
  same("contact_tf1.x() where they meet, to 0.01", "yes", [](const Pair& pair) {
    return yes(std::abs(pass(pair, advancing(1e-4)).contact_tf1.translation().x() + 2) < 0.01);
  });
  same("CCDM_LINEAR", "yes", isNear(advancing(1e-4, fcl::CCDM_LINEAR), 1e-4));
  differs("CCDM_SCREW without a turn", "no", "yes", "boxes: FCL's ScrewMotion goes 20 times as far",
          isNear(advancing(1e-4, fcl::CCDM_SCREW), 1e-4));
  differs("CCDC_RAY_SHOOTING, at most 1e-4 early", "no", "yes", "FCL's answer reads as \"free\"",
          isNear({10, 1e-4, fcl::CCDM_TRANS, fcl::GST_LIBCCD, fcl::CCDC_RAY_SHOOTING}, 1e-4));
  differs("CCDC_POLYNOMIAL_SOLVER, at most 1e-4 early", "no", "yes", "FCL's answer reads as \"free\"",
          isNear({10, 1e-4, fcl::CCDM_TRANS, fcl::GST_LIBCCD, fcl::CCDC_POLYNOMIAL_SOLVER}, 1e-4));
}

/// Two objects with motions: a passes b as in pass().
struct MovingPair {
  fcl::ContinuousCollisionObjectd a, b;

  explicit MovingPair(const Pair& pair)
      : a(pair.a, std::make_shared<fcl::TranslationMotiond>(at(-10), at(10))),
        b(pair.b, std::make_shared<fcl::TranslationMotiond>(at(0), at(0))) {}
};

/// FCL 0.7.0 has the callback and an abstract manager to call it, but none that does.
/// (ContinuousCollisionObject::computeAABB() crashes on motions of FCL's own: their Taylor models have no interval.)
TEST_F(Conformity, movingObjects) {
  same("collide(ContinuousCollisionObject, ...)", "yes", [](const Pair& pair) {
    const MovingPair moving(pair);
    Impact result;
    const double returned = fcl::collide(&moving.a, &moving.b, advancing(1e-4), result);
    return returned == result.time_of_contact ? near(result, 1e-4) : "no";
  });
  const auto callback = [](bool done) {
    return [=](const Pair& pair) {
      MovingPair moving(pair);
      fcl::DefaultContinuousCollisionData<double> data;
      data.request = advancing(1e-4);
      data.done = done;
      const bool returned = fcl::DefaultContinuousCollisionFunction<double>(&moving.a, &moving.b, &data);
      return std::to_string(returned) + ", " + std::to_string(data.result.is_collide) + ", " +
             std::to_string(data.done);
    };
  };
  same("DefaultContinuousCollisionFunction: returned, is_collide, done", "0, 1, 0", callback(false));
  same("DefaultContinuousCollisionFunction once done: returned, is_collide, done", "1, 0, 1", callback(true));
}

}  // namespace
}  // namespace tricover_fcl::test
