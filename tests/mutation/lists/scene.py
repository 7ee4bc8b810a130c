# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/scene/bounds.cpp", "(kTiny + reach)", "(kTiny)", "scene: boxes without the margin"),
    ("src/scene/bounds.h", "if (finite == 3)", "if (true)", "scene: boxes that overflow"),
    ("src/scene/bounds.h", "roundedUp<4>(radius + reach)", "radius", "scene: a query's disc without the margin"),
    ("src/scene/nearest.cpp", "boundsOf(polygon.data(), pose, options.margin)", "boundsOf(polygon.data(), pose, 0)", "scene: the nearest is sought without the margin"),
    ("src/scene/asked.h", "discs_.radius + discs.radius + margin", "discs_.radius + discs.radius", "scene: discs apart without the margin"),
    ("src/scene/cached.cpp", "(cache.except == kNoBody || cache.except == filter.except)", "true", "scene cache: forgets whom it didn't ask"),
    ("src/scene/clear_box.cpp", "boundsOfEdge(polygon, edge, pose, margin)", "boundsOfEdge(polygon, edge, pose, 0)", "scene: where a body is clear, without its margin"),
    ("src/scene/scene_state.cpp", "  state.discs.forget();\n  state.clear.forget();\n", "  state.discs.forget();\n", "scene: where a body was clear before it moved"),
    ("src/scene/scene_state.cpp", "  state.options = options;\n  state.clear.forget();\n", "  state.options = options;\n", "scene: where a body was clear with other options"),
    ("src/scene/scene_state.cpp", "state.generation = old.generation + 1;", "state.generation = old.generation;", "scene: a stale handle names another body"),
    ("src/scene/cached.cpp", "gapBetween(bounds, box); gap > 0)", "gapBetween(bounds, box); gap >= 0)", "scene cache: boxes that meet pass for a gap"),
    ("src/scene/cached.cpp", "cache.version == state.version", "true", "scene cache: of another state"),
    ("src/scene/scene_state.cpp", "    for (Link& link : state.links) link.due = -1;\n", "", "scene: a jump leaves facts"),
    ("src/scene/scene_state.cpp", "roundedDown<3>(room * (1 - part))", "roundedDown<3>(room)", "scene: shares are more than the room"),
    ("src/scene/scene_state.cpp", "moveBody(body, pose, stepTo(body, pose), nullptr);", "moveBody(body, pose, steps[i], nullptr);", "scene: a body's second move is measured from where it was before the first"),
    ("src/scene/scene_state.cpp", "!(p.listed && q.listed)}", "false}", "scene: a body that isn't listed is due too late"),
    ("src/scene/scene_state.cpp", "fact.collides ? fact.clearance : roundedDown<1>(fact.clearance - options.margin)", "fact.clearance", "scene: facts forget margins"),
    ("src/scene/scene_state.cpp", "bodies[other].fresh && other <= body", "bodies[other].fresh", "scene: pairs of two bodies that are new found by neither"),
    ("src/scene/scene_state.cpp", "if (body < link.other || !finds(", "if (body < link.other && !finds(", "scene: pairs that are due for both bodies left out"),
    ("src/scene/impacts.cpp", "leg != legs_.end() && leg->begin() <= end", "leg != legs_.end() && leg->begin() < begin", "scene: of a trajectory's legs in a window the first alone"),
]
