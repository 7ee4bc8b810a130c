# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/scene/bounds.cpp", "(kTiny + reach)", "(kTiny)", "scene: boxes without the margin"),
    ("src/scene/bounds.cpp", "if (finite == 3)", "if (true)", "scene: boxes that overflow"),
    ("src/scene/nearest.cpp", "boundsOf(polygon.data(), pose, options.margin)", "boundsOf(polygon.data(), pose, 0)", "scene: the nearest is sought without the margin"),
    ("src/scene/collides.cpp", "depthOfDiscs(pair, options.margin)", "depthOfDiscs(pair, 2 * options.margin)", "scene: discs that meet within twice the margin"),
    ("src/scene/collides.cpp", "options.margin) >= 0 && may_touch)", "options.margin) >= 0)", "scene: inner discs without an interior overlap"),
    ("src/scene/clear_box.cpp", "boundsOfEdge(polygon, edge, pose, margin)", "boundsOfEdge(polygon, edge, pose, 0)", "scene: where a body is clear, without its margin"),
    ("src/scene/box_tree.h", "last = keyOf(most, kLanes - 1);\n  }", "last = keyOf(0.5 * most, kLanes - 1);\n  }", "scene: bodies near the limit left out"),
    ("src/scene/moves.cpp", "  state.pose = pose;\n  state.clear.forget();\n", "  state.pose = pose;\n", "scene: where a body was clear before it moved"),
    ("src/scene/moves.cpp", "  state.options = options;\n  state.clear.forget();\n", "  state.options = options;\n", "scene: where a body was clear with other options"),
    ("src/scene/scene_state.h", "BodyHandle{tenancies[body].changes / 2} << 32", "BodyHandle{0} << 32", "scene: a stale handle names another body"),
    ("src/scene/moves.cpp", "    state.box_until = state.due = -1;\n    for (Link& link : state.links) link.due = -1;\n", "    state.box_until = state.due = -1;\n", "scene: a jump leaves facts"),
    ("src/scene/scene_state.cpp", "roundedDown<3>(room * (1 - part))", "roundedDown<3>(room)", "scene: shares are more than the room"),
    ("src/scene/moves.cpp", "if (moves[i].what == Moving::IsDue) due.push_back(moves[i].body);", "", "scene: bodies that move in their boxes aren't due"),
    ("src/scene/moves.cpp", "if (std::exchange(tenancies[move.body].batch, batch) == batch) move.what = Moving::Later;", "tenancies[move.body].batch = batch;", "scene: a body's second move may come before its first"),
    ("src/scene/moves.cpp", "    moveTheRest();\n    throw;\n", "    throw;\n", "scene: what was moved when the user's threads failed is forgotten"),
    ("src/scene/scene_state.cpp", "found.collides ? found.clearance : roundedDown<1>(found.clearance - options.margin)", "found.clearance", "scene: certificates forget margins"),
    ("src/scene/scene_state.cpp", "bodies[other].fresh && other <= body", "bodies[other].fresh", "scene: pairs of two bodies that are new found by neither"),
    ("src/scene/scene_state.cpp", "if (body < link.other || !finds(", "if (body < link.other && !finds(", "scene: pairs that are due for both bodies left out"),
    ("src/scene/impacts.cpp", "leg != legs_.end() && leg->begin() <= end", "leg != legs_.end() && leg->begin() < begin", "scene: of a trajectory's legs in an interval the first alone"),
    ("src/scene/collides.cpp", "options.touching == Touching::Collides && options.margin >= 0", "options.touching == Touching::Collides", "clear box: learnt where an overlap is allowed"),
]
