// SPDX-License-Identifier: BSD-3-Clause
// Asks FCL about its own geometries only and prints every field of every answer, doubles to the last bit. Linked twice:
// with FCL alone (fcl_alone.cpp), and with tricover registered (fcl_with_tricover.cpp). Both must print the same.
#include "fcl_untouched.h"

#include <fcl/broadphase/broadphase_dynamic_AABB_tree.h>
#include <fcl/broadphase/default_broadphase_callbacks.h>
#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/geometry/geometric_shape_to_BVH_model.h>
#include <fcl/geometry/octree/octree.h>
#include <fcl/geometry/shape/box.h>
#include <fcl/geometry/shape/capsule.h>
#include <fcl/geometry/shape/cone.h>
#include <fcl/geometry/shape/convex.h>
#include <fcl/geometry/shape/cylinder.h>
#include <fcl/geometry/shape/ellipsoid.h>
#include <fcl/geometry/shape/halfspace.h>
#include <fcl/geometry/shape/plane.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/geometry/shape/triangle_p.h>
#include <fcl/math/motion/interp_motion.h>
#include <fcl/narrowphase/collision.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include <algorithm>
#include <cstdio>
#include <exception>
#include <memory>
#include <vector>

#include "random.h"

namespace {

using Geometry = std::shared_ptr<fcl::CollisionGeometryd>;
using Random = tricover::support::Random;

/// How much FCL serves of a geometry; what is beyond that crashes in FCL, or only warns.
enum Serves { kCollide, kDistance, kAdvancement };

struct Named {
  const char* name;
  Geometry geometry;
  Serves serves = kAdvancement;
};

template <typename Volume>
Geometry boxMesh() {
  auto mesh = std::make_shared<fcl::BVHModel<Volume>>();
  fcl::generateBVHModel(*mesh, fcl::Boxd(0.9, 0.7, 0.8), fcl::Transform3d::Identity());
  mesh->computeLocalAABB();
  return mesh;
}

Geometry octahedron() {
  const auto vertices = std::make_shared<const std::vector<fcl::Vector3d>>(
      std::vector<fcl::Vector3d>{{0.5, 0, 0}, {-0.5, 0, 0}, {0, 0.4, 0}, {0, -0.4, 0}, {0, 0, 0.6}, {0, 0, -0.6}});
  const auto faces = std::make_shared<const std::vector<int>>(
      std::vector<int>{3, 0, 2, 4, 3, 2, 1, 4, 3, 1, 3, 4, 3, 3, 0, 4, 3, 2, 0, 5, 3, 1, 2, 5, 3, 3, 1, 5, 3, 0, 3, 5});
  return std::make_shared<fcl::Convexd>(vertices, 8, faces);
}

Geometry octree() {
  const auto tree = std::make_shared<octomap::OcTree>(0.2);
  for (int x = -2; x <= 2; ++x) {
    for (int y = -1; y <= 1; ++y)
      tree->updateNode(0.2F * static_cast<float>(x), 0.2F * static_cast<float>(y), 0.1F, true);
  }
  return std::make_shared<fcl::OcTreed>(tree);
}

std::vector<Named> geometries() {
  return {{"box", std::make_shared<fcl::Boxd>(0.9, 0.6, 0.7)},
          {"sphere", std::make_shared<fcl::Sphered>(0.4)},
          {"ellipsoid", std::make_shared<fcl::Ellipsoidd>(0.3, 0.4, 0.5)},
          {"capsule", std::make_shared<fcl::Capsuled>(0.3, 0.7)},
          {"cone", std::make_shared<fcl::Coned>(0.4, 0.8)},
          {"cylinder", std::make_shared<fcl::Cylinderd>(0.3, 0.8)},
          {"convex", octahedron()},
          {"plane", std::make_shared<fcl::Planed>(0.6, 0, 0.8, 0.1), kCollide},
          {"halfspace", std::make_shared<fcl::Halfspaced>(0, 0.6, 0.8, -0.2), kCollide},
          {"AABB mesh", boxMesh<fcl::AABBd>(), kCollide},
          {"OBB mesh", boxMesh<fcl::OBBd>(), kCollide},
          {"RSS mesh", boxMesh<fcl::RSSd>()},
          {"kIOS mesh", boxMesh<fcl::kIOSd>(), kDistance},
          {"OBBRSS mesh", boxMesh<fcl::OBBRSSd>()},
          {"KDOP16 mesh", boxMesh<fcl::KDOPd<16>>(), kCollide},
          {"KDOP18 mesh", boxMesh<fcl::KDOPd<18>>(), kCollide},
          {"KDOP24 mesh", boxMesh<fcl::KDOPd<24>>(), kCollide},
          {"octree", octree(), kDistance},
          // FCL knows no pair of it, and says so on cerr.
          {"triangle", std::make_shared<fcl::TrianglePd>(fcl::Vector3d(0.5, 0, 0), fcl::Vector3d(-0.3, 0.4, 0),
                                                         fcl::Vector3d(0, -0.4, 0.6))}};
}

bool isMesh(const Named& named) { return named.geometry->getObjectType() == fcl::OT_BVH; }

auto isOfType(fcl::NODE_TYPE type) {
  return [type](const Named& named) { return named.geometry->getNodeType() == type; };
}

/// Whether one of the two is `first` and the other `second`.
template <typename First, typename Second>
bool are(const Named& a, const Named& b, const First& first, const Second& second) {
  return (first(a) && second(b)) || (first(b) && second(a));
}

/// FCL's collide of the two calls a null pointer.
bool crashes(const Named& a, const Named& b) {
  return are(a, b, isOfType(fcl::GEOM_PLANE), isOfType(fcl::GEOM_CONVEX)) ||
         are(a, b, isOfType(fcl::GEOM_PLANE), isMesh) || are(a, b, isOfType(fcl::GEOM_HALFSPACE), isMesh);
}

Serves both(const Named& a, const Named& b) {
  // The distance of a sphere in a mesh is what was in the memory.
  if (are(a, b, isOfType(fcl::GEOM_SPHERE), isMesh)) return kCollide;
  const Serves least = std::min(a.serves, b.serves);
  return least == kAdvancement && isMesh(a) != isMesh(b) ? kDistance : least;
}

fcl::Transform3d randomPose(Random& random) {
  const auto entry = [&] { return random.real(-1, 1); };
  fcl::Transform3d pose = fcl::Transform3d::Identity();
  pose.linear() = fcl::Quaterniond(entry(), entry(), entry(), entry()).normalized().toRotationMatrix();
  pose.translation() = 0.7 * fcl::Vector3d(entry(), entry(), entry());
  return pose;
}

void printVector(const fcl::Vector3d& v) { std::printf(" (%a %a %a)", v.x(), v.y(), v.z()); }

/// Calls `query`, which prints; an exception is an answer, too, but for its text, which tells the line in a source
/// file.
template <typename Query>
void ask(const char* what, const Query& query) {
  std::printf("%s:", what);
  try {
    query();
  } catch (const std::exception&) {
    std::printf(" throws");
  }
  std::printf("\n");
}

class Questions {
 public:
  Questions(const Named& a, const fcl::Transform3d& pose_a, const Named& b, const fcl::Transform3d& pose_b,
            fcl::GJKSolverType solver, int* hits)
      : a_(a), b_(b), pose_a_(pose_a), pose_b_(pose_b), solver_(solver), hits_(hits) {}

  /// Whether there are contacts and all have depth.
  bool collide() const {
    bool deep = false;
    ask("collide", [&] {
      fcl::CollisionRequestd request(4, true, 2, true);
      request.gjk_solver_type = solver_;
      fcl::CollisionResultd result;
      const std::size_t n = fcl::collide(a_.geometry.get(), pose_a_, b_.geometry.get(), pose_b_, request, result);
      *hits_ += n > 0;
      std::printf(" %zu", n);
      for (std::size_t i = 0; i < result.numContacts(); ++i) {
        const fcl::Contactd& contact = result.getContact(i);
        deep = (i == 0 || deep) && contact.penetration_depth > 0;
        printVector(contact.pos);
        printVector(contact.normal);
        std::printf(" %a %ld %ld %d", contact.penetration_depth, static_cast<long>(contact.b1),
                    static_cast<long>(contact.b2), contact.o1 == a_.geometry.get());
      }
      std::vector<fcl::CostSourced> costs;
      result.getCostSources(costs);
      for (const fcl::CostSourced& cost : costs) {
        printVector(cost.aabb_min);
        printVector(cost.aabb_max);
        std::printf(" %a", cost.total_cost);
      }
    });
    return deep;
  }

  double distance(bool is_signed) const {
    double d = 0;
    ask(is_signed ? "signed distance" : "distance", [&] {
      fcl::DistanceRequestd request(true, is_signed);
      request.gjk_solver_type = solver_;
      fcl::DistanceResultd result;
      d = fcl::distance(a_.geometry.get(), pose_a_, b_.geometry.get(), pose_b_, request, result);
      std::printf(" %a %a", d, result.min_distance);
      // FCL leaves the points of an overlap, and of a pair that it doesn't serve, uninitialised.
      if (result.o1 == nullptr || (d <= 0 && !is_signed)) return;
      printVector(result.nearest_points[0]);
      printVector(result.nearest_points[1]);
      std::printf(" %ld %ld", static_cast<long>(result.b1), static_cast<long>(result.b2));
    });
    return d;
  }

  void continuous(const fcl::Transform3d& end_a, const fcl::Transform3d& end_b, fcl::CCDMotionType type,
                  fcl::CCDSolverType method) const {
    ask("continuous", [&] {
      const fcl::ContinuousCollisionRequestd request(10, 0.0001, type, solver_, method);
      fcl::ContinuousCollisionResultd result;
      double time;
      if (type == fcl::CCDM_LINEAR) {
        // FCL leaves the pivot of this motion uninitialised where it makes it from two poses.
        const auto motion = [](const fcl::Transform3d& from, const fcl::Transform3d& to) {
          return fcl::InterpMotion<double>(from.linear(), from.translation(), to.linear(), to.translation(),
                                           fcl::Vector3d::Zero());
        };
        const auto motion_a = motion(pose_a_, end_a), motion_b = motion(pose_b_, end_b);
        time =
            fcl::continuousCollide<double>(a_.geometry.get(), &motion_a, b_.geometry.get(), &motion_b, request, result);
      } else {
        time = fcl::continuousCollide(a_.geometry.get(), pose_a_, end_a, b_.geometry.get(), pose_b_, end_b, request,
                                      result);
      }
      std::printf(" %a %d %a", time, result.is_collide, result.time_of_contact);
      if (!result.is_collide) return;  // the poses are uninitialised
      printVector(result.contact_tf1.translation());
      printVector(result.contact_tf2.translation());
    });
  }

 private:
  const Named &a_, &b_;
  const fcl::Transform3d &pose_a_, &pose_b_;
  fcl::GJKSolverType solver_;
  int* hits_;
};

/// FCL's default callbacks, called by a manager of all geometries that it can serve.
void askManager(const std::vector<Named>& all, Random& random) {
  std::vector<std::unique_ptr<fcl::CollisionObjectd>> objects;
  fcl::DynamicAABBTreeCollisionManagerd manager;
  for (const Named& named : all) {
    if (named.serves == kCollide) continue;
    objects.push_back(std::make_unique<fcl::CollisionObjectd>(named.geometry, randomPose(random)));
    objects.back()->computeAABB();
    manager.registerObject(objects.back().get());
  }
  manager.setup();
  fcl::DefaultCollisionData<double> collision;
  collision.request = fcl::CollisionRequestd(1000, true);
  manager.collide(&collision, fcl::DefaultCollisionFunction);
  std::printf("manager: %zu", collision.result.numContacts());
  fcl::DefaultDistanceData<double> distance;
  manager.distance(&distance, fcl::DefaultDistanceFunction);
  std::printf(" %a\n", distance.result.min_distance);
}

}  // namespace

int main() {
  constexpr int kPoses = 4;
  beforeQueries();
  const std::vector<Named> all = geometries();
  Random random(4);
  int asked = 0, hits = 0;
  for (const Named& a : all) {
    for (const Named& b : all) {
      if (crashes(a, b)) continue;
      for (int i = 0; i < kPoses; ++i) {
        const fcl::Transform3d pose_a = randomPose(random), pose_b = randomPose(random);
        const fcl::Transform3d end_a = randomPose(random), end_b = randomPose(random);
        for (const fcl::GJKSolverType solver : {fcl::GST_LIBCCD, fcl::GST_INDEP}) {
          std::printf("%s, %s, %d, solver %d\n", a.name, b.name, i, solver);
          const Questions questions(a, pose_a, b, pose_b, solver, &hits);
          ++asked;
          const Serves serves = both(a, b);
          const bool deep = questions.collide();
          // libfcl's own assert ends the program where an overlap has no depth.
          if (serves >= kDistance && (questions.distance(false) > 0 || deep)) questions.distance(true);
          for (const fcl::CCDMotionType motion : {fcl::CCDM_TRANS, fcl::CCDM_LINEAR, fcl::CCDM_SCREW}) {
            questions.continuous(end_a, end_b, motion, fcl::CCDC_NAIVE);
            if (serves == kAdvancement) questions.continuous(end_a, end_b, motion, fcl::CCDC_CONSERVATIVE_ADVANCEMENT);
          }
        }
      }
    }
  }
  for (int i = 0; i < 5; ++i) askManager(all, random);
  std::printf("%d of %d collide\n", hits, asked);
  return hits > asked / 5 && hits < asked / 5 * 4 ? 0 : 1;  // otherwise the poses are no test
}
