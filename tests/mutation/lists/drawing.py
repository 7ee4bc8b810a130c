# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/drawing/svg.cpp", "number(p.x()) + \",\" + number(-p.y())", "number(p.x()) + \",\" + number(p.y())", "svg: y upwards"),
    ("src/drawing/svg.cpp", "high_ = high_.cwiseMax(point);", "", "svg: what is drawn isn't framed"),
    ("src/drawing/svg.cpp", "result += \"&lt;\";", "result += '<';", "svg: text isn't escaped"),
    ("src/drawing/svg.cpp", "polygon.fillRule() == FillRule::EvenOdd ? \"evenodd\" : \"nonzero\"", "\"evenodd\"", "svg: fill rule"),
    ("src/drawing/svg.cpp", "hit_a[i] = hit_b[j] = true;", "hit_a[i] = true;", "svg: b's hit edges"),
]
