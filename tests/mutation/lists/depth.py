# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/depth/border.cpp", "return side != 0; })) return &polygon;", "return true; })) return &polygon;", "depth: slits and edges used twice are borders"),
    ("src/depth/depth.cpp", "result.is_point_of_a = of_a.distance > of_b.distance;", "result.is_point_of_a = of_a.distance < of_b.distance;", "depth: the point that isn't as deep"),
    ("src/depth/depth.cpp", "if (found.upper_bound > 64 * precision) return found;", "return found;", "depth: rounding hides whether interiors meet"),
    ("src/depth/depth.cpp", "depth.is_point_of_a = !depth.is_point_of_a;", "", "depth: whose point it is, of swapped operands"),
    ("src/depth/depth.cpp", "if (found.depth > enough) return found;", "return found;", "negative margins: a depth near the margin isn't looked at closely"),
    ("src/depth/deepest_point.cpp", "if (!is_outside && near.distance > reach) return;", "if (near.distance > reach) return;", "depth: cells deep inside are left out"),
    ("src/depth/deepest_point.cpp", "const bool is_deepest = is_outside && is_in_part && offer", "const bool is_deepest = is_outside && offer", "depth: points that aren't the part's"),
    ("src/depth/deepest_point.cpp", "if (!piece.is_known) return Look::InArea;", "", "depth: arcs that run along a border aren't located"),
    ("src/depth/deepest_point.cpp", "if (part_.polygon.isDegenerate()) return;", "return;", "depth: the interior isn't searched"),
    ("src/depth/peak.h", "value = std::min(value, highest);", "value = std::min(value, 0.5 * highest);", "depth: upper bounds of cells too low"),
    ("src/depth/inner_arcs.cpp", "{found.location != Location::Boundary, found.winding}", "{true, found.winding}", "depth: an arc's winding number taken from a boundary"),
    ("src/depth/collide.cpp", "depth > allowed : depth >= allowed", "depth >= allowed : depth >= allowed", "negative margins: touching allowed"),
    ("src/depth/signed_distance.cpp", "return {-d.upper_bound - options.margin,", "return {-d.upper_bound,", "signed distance: depths without the margin"),
    ("src/depth/signed_distance.cpp", "result.normal = -result.normal;", "", "signed distance: the normal of swapped operands"),
    ("src/depth/signed_distance.cpp", ".distance - options.margin, 0.0);", ".distance - options.margin, 1.0);", "signed distance: rounding tells on which side of the margin"),
    ("src/depth/deep_impact.cpp", "    if (of_.depth(0).upper_bound >= of_.allowed) return impactAt(0);\n", "", "deep impact: pieces decide at the start"),
    ("src/depth/deep_impact.cpp", "if (time > 0 && deep.most >=", "if (deep.most >=", "deep impact: what is nearly deep enough at the start is"),
    ("src/depth/deep_contact.cpp", "  if (touch.edge_a == -1) return {touch.normal};\n", "", "deep impact: an edge of a piece that touches none"),
]
