# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/contact/contacts.cpp", "false, fact.clearance);", "false, 2 * fact.clearance);", "contact cache: apart for too long"),
    ("src/contact/convex_contact.cpp", "mirrors_a != mirrors_b ? -turn_b : turn_b", "turn_b", "convex contact: b mirrored"),
    ("src/contact/convex_contact.cpp", "const double next = std::min(depthOf(faces[static_cast<std::size_t>(count)]), std::sqrt(most_));", "const double next = depthOf(faces[static_cast<std::size_t>(count)]);", "contact cache: faces that weren't looked behind are deep for ever"),
    ("src/contact/convex_contact.cpp", "return cache.deeper - motion > least_ + 64 * frame_.error() ?", "return true ?", "contact cache: faces that aren't kept may be the best by now"),
    ("src/contact/convex_penetration.cpp", "pose.linear().determinant() < 0", "false", "convex penetration: mirrored poses"),
    ("src/contact/convex_penetration.cpp", "dot(normal, of.at(k) - other.at(farthest[k])).high / length", "depths[k]", "convex penetration: plain doubles"),
    ("src/contact/convex_penetration.cpp", "depths[k] + errors[k]);", "depths[k] - 4 * errors[k]);", "convex penetration: the least depth is left out"),
    ("src/contact/convex_penetration.cpp", "polygon_.extent * scale_ +", "1e-3 * polygon_.extent * scale_ +", "convex penetration: the bound of plain doubles"),
    ("src/contact/disc_cover.cpp", "room = radius_[k] - radius;", "room = radius_[k];", "penetration: discs overlap all around"),
    ("src/contact/disc_cover.cpp", "room * std::abs(room)", "room * room", "penetration: discs that are smaller hold"),
    ("src/contact/overlap_components.cpp", "{known, -c.direction}", "{known, c.direction}", "components: winding's change along a"),
    ("src/contact/overlap_components.cpp", "found.winding * pair.handed", "found.winding", "components: winding under a mirror"),
    ("src/contact/overlap_components.cpp", "winding.known = winding.known && stop.change.known;", "", "components: winding trusted past a touch"),
    ("src/contact/penetration.cpp", "!collideByHierarchy(PosedPair(a, pose_a, b, moved_b), {}, 0, Wanted::Answer).collides &&", "", "penetration: the translation of b isn't proven"),
    ("src/contact/penetration.cpp", "std::min(shortest.lower_bound * unit, result.depth)", "result.depth", "penetration: the lower bound is the depth"),
    ("src/contact/translation_search.cpp", "if (cell.half > coarse_) return false;", "if (cell.half > coarse_) return true;", "penetration: large cells are done with"),
    ("src/contact/translation_search.cpp", "if (depthOf(pair, outcome) >= radius) return true;", "return true;", "penetration: a cell whose centre overlaps is done with"),
    ("src/contact/translation_search.cpp", "if (clearance >= radius) return true;", "return true;", "penetration: a cell whose centre is free is done with"),
    ("src/contact/translation_search.cpp", "if (!outcome.collides) return Cover::Little;", "if (!outcome.collides) return Cover::Whole;", "penetration: cells covered where they are free"),
    ("src/contact/translation_space.cpp", "disc.radius * scale * (1 - kLargestDefect)", "disc.radius * (1 - kLargestDefect)", "penetration: discs in their polygon's units"),
]
