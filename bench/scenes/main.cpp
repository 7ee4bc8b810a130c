// SPDX-License-Identifier: BSD-3-Clause
// Scenes beside what people use for them: many against many, one against many, rays, conflicts of a fleet.
#include <string>

#include "layout.h"
#include "report.h"
#include "scene_studies.h"
#include "tricover_fcl/tricover_fcl.h"

namespace tricover::bench {
namespace {

const char* const kHow =
    R"(- As in the other tables: all methods of a row are interleaved at random in one process, and every timed answer is
  compared with that of `cold`: the core, where one asks many behind a scan of all boxes, where many ask many behind
  FCL's manager.
- Frames: 2,000 outlines on circles of their own; every one is moved, then all pairs that collide are wanted. All methods
  walk 50 frames forth and back. via FCL: our shapes, fcl::collide deciding the pairs of DynamicAABBTreeCollisionManager;
  "array tree": of FCL's other fast manager; tight boxes: PolygonObjects under the first; SceneManager: ours. FCL BVH: flat OBBRSS meshes under the first. Box2D: b2BroadPhase, told of the motion so that it can look ahead; pairs
  are kept while their grown boxes meet, as in a b2World, and b2TestOverlap decides. It counts as touching what is closer
  than 0.02 of its units: "Box2D" has one of them for one of ours (outlines are 100 across), the others 0.1 and 0.01.
- Layouts: 80 parts of a dozen kinds, bottom-left fill. Eight of them in turn are taken out and placed anew: free (close
  to their own place, without a collision), local (around it by a fifth of the size), uniform (anywhere, turned anyhow).
- Maps: 10,000 obstacles and a fork lift of 12 vertices; a planner's path goes from free poses in small steps until it
  arrives or collides.
- GEOS STRtree: TemplateSTRtree over prepared geometries, the query's coordinates rewritten in place, left at the first
  hit. Boost rtree: packed, boost::geometry::intersects, left at the first hit.
- Rays: 360 from each of some free poses, 1,000 units long; a query is one ray. Box2D: b2DynamicTree, a b2PolygonShape a rack,
  the edges of a b2ChainShape a country. Boost: rtree of all edges. cold: castRay() of every body near the ray.
- Crowds: a frame moves all bodies, or one in a hundred; one thread, and two by wall time (oneTBB).
- Conflicts: robots on cubic splines with each other and with obstacles, each with its first time; the rival calls
  timeOfImpact() for every pair whose swept boxes meet. Nanoseconds are those of all conflicts.
)";

}  // namespace

bool run(const std::string& directory, bool full) {
  tricover_fcl::registerNarrowphase();
  const Countries countries = readCountries();
  const Settings settings = full ? Settings{5, 0.1} : Settings{3, 0.01};
  drawLayout(directory);
  return writeStudies(directory, "scenes",
                      {{"Frames", measureFrames(settings)},
                       {"Layouts", measureLayouts(settings)},
                       {"Maps", measureMaps(countries, settings)},
                       {"Rays", measureRays(countries, settings)},
                       {"Growing crowds, a body and frame", measureCrowds()},
                       {"Conflicts of a fleet on splines", measureFleet(directory, full)}},
                      "# How it was measured\n\n" + machine(settings) + kHow);
}

}  // namespace tricover::bench
