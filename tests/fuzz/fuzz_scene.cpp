// SPDX-License-Identifier: BSD-3-Clause
// A stream of commands to a Scene, whose answers must be those of the exact
// reference for all pairs.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "byte_reader.h"
#include "exact_reference.h"
#include "reproduction.h"
#include "tricover/polygon.h"
#include "tricover/ray.h"
#include "tricover/scene.h"

namespace {

using namespace tricover;

class Player {
 public:
  Player(const std::uint8_t* data, std::size_t size)
      : bytes_(data, size),
        polygons_{bytes_.polygon(), bytes_.polygon(), Polygon::segment(bytes_.point(), bytes_.point())} {}

  void play() {
    for (int command = 0; command < 24; ++command) {
      switch (bytes_.integer(0, 6)) {
        case 0:
          if (bodies_.size() < 5) add();
          break;
        case 1:
          if (bodies_.size() > 2) remove();
          break;
        case 2:
        case 3:
        case 4:
          if (!bodies_.empty()) move(bodies_[static_cast<std::size_t>(bytes_.byte()) % bodies_.size()]);
          break;
        case 5:
          collisions();
          break;
        default:
          ask();
      }
    }
    collisions();
  }

 private:
  const Polygon& anyPolygon() { return polygons_[static_cast<std::size_t>(bytes_.integer(0, 2))]; }

  void add() {
    BodyOptions options;
    if (bytes_.byte() % 4 == 0) options.margin = std::min(std::abs(bytes_.coordinate()), 1e300);
    if (bytes_.byte() % 8 == 0) options.mask = 2;
    if (bytes_.byte() % 4 == 0) options.category = 3;
    const Polygon& polygon = anyPolygon();
    bodies_.push_back(scene_.add(polygon, bytes_.pose(), options));
  }

  void remove() {
    const auto at = bodies_.begin() + bytes_.byte() % static_cast<std::ptrdiff_t>(bodies_.size());
    scene_.remove(*at);
    bodies_.erase(at);
  }

  void move(Scene::Body body) {
    Pose pose = scene_.pose(body);
    const Vec2 by = 0x1p-6 * Vec2(bytes_.integer(-8, 8), bytes_.integer(-8, 8));
    if (bytes_.byte() % 4 == 0)
      pose = bytes_.pose();
    else
      pose.translation() += by;
    scene_.move(body, pose);
  }

  static bool meet(const Polygon& p, const Pose& pose_p, const Polygon& q, const Pose& pose_q, double margin) {
    return margin == 0 ? exact::collide(p, pose_p, q, pose_q)
                       : exact::within(exact::distanceSquared(p, pose_p, q, pose_q), mpq_class(margin));
  }

  void collisions() {
    const std::vector<BodyPair> found = scene_.collisions();
    std::vector<BodyPair> now;
    for (const Scene::Body p : bodies_)
      for (const Scene::Body q : bodies_) {
        const BodyOptions &of_p = scene_.options(p), &of_q = scene_.options(q);
        if (p >= q || (of_p.category & of_q.mask) == 0 || (of_q.category & of_p.mask) == 0) continue;
        const bool truth =
            meet(scene_.polygon(p), scene_.pose(p), scene_.polygon(q), scene_.pose(q), of_p.margin + of_q.margin);
        if (truth) now.push_back({p, q});
        if (std::binary_search(found.begin(), found.end(), BodyPair{p, q}) != truth)
          fuzz::fail("collisions",
                     "margins " + support::hex(of_p.margin) + " and " + support::hex(of_q.margin) + "\n" +
                         support::reproduction({scene_.polygon(p), scene_.pose(p), scene_.polygon(q), scene_.pose(q)}));
      }
    std::sort(now.begin(), now.end());
    if (now != found) fuzz::fail("collisions: pairs of bodies that there aren't, or in disorder", "");
    std::vector<BodyPair> news, gone;
    std::set_difference(now.begin(), now.end(), before_.begin(), before_.end(), std::back_inserter(news));
    std::set_difference(before_.begin(), before_.end(), now.begin(), now.end(), std::back_inserter(gone));
    if (scene_.began() != news || scene_.ended() != gone) fuzz::fail("began or ended", "");
    before_ = now;
  }

  void ask() {
    const Polygon& polygon = anyPolygon();
    const Pose pose = bytes_.pose();
    CollideOptions options;
    if (bytes_.byte() % 4 == 0) options.margin = std::min(std::abs(bytes_.coordinate()), 1e300);
    std::vector<Scene::Body> expected;
    for (const Scene::Body body : bodies_)
      if (meet(polygon, pose, scene_.polygon(body), scene_.pose(body), options.margin + scene_.options(body).margin))
        expected.push_back(body);
    std::sort(expected.begin(), expected.end());
    const auto expect = [&](bool right, const char* what) {
      if (!right) fail(what, polygon, pose, options.margin);
    };
    expect(scene_.colliding(polygon, pose, options) == expected, "colliding");
    expect(scene_.collides(polygon, pose, options) == !expected.empty(), "collides");
    const auto nearest = scene_.nearestWithin(polygon, pose, 1e300, {options.margin});
    const bool meets = nearest && nearest->result.distance == 0;
    const auto few = scene_.nearestK(polygon, pose, 5, 1e300, {options.margin});
    const auto apart = [](const BodyDistance& body) { return body.result.distance > 0; };
    expect(static_cast<std::size_t>(std::find_if(few.begin(), few.end(), apart) - few.begin()) == expected.size(),
           "nearestK");
    expect(meets != expected.empty() && (!meets || nearest->body == expected[0]), "nearest");
    castRay(bytes_.point(), bytes_.point());
  }

  [[noreturn]] void fail(const char* what, const Polygon& polygon, const Pose& pose, double margin) const {
    std::string text = "margin " + support::hex(margin) + "\n";
    for (const Scene::Body body : bodies_)
      text += "body " + std::to_string(body) + ", margin " + support::hex(scene_.options(body).margin) + "\n" +
              support::reproduction({polygon, pose, scene_.polygon(body), scene_.pose(body)});
    fuzz::fail(what, text);
  }

  void castRay(const Vec2& from, const Vec2& to) {
    mpq_class least = 2;
    for (const Scene::Body body : bodies_) {
      if (scene_.options(body).margin != 0) return;  // not met exactly
      const auto hit = exact::castRay(scene_.polygon(body), scene_.pose(body), from, to);
      if (hit && hit->fraction < least) least = hit->fraction;
    }
    const auto hit = scene_.castRay(from, to);
    if (hit.has_value() != (least <= 1) || (hit && abs(mpq_class(hit->hit.fraction) - least) > 1e-14))
      fuzz::fail("castRay", support::hex(from.x()) + ", " + support::hex(from.y()) + " to " + support::hex(to.x()) +
                                ", " + support::hex(to.y()));
  }

  fuzz::ByteReader bytes_;
  const Polygon polygons_[3];
  Scene scene_;
  std::vector<Scene::Body> bodies_;
  std::vector<BodyPair> before_;
};

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  Player(data, size).play();
  return 0;
}
