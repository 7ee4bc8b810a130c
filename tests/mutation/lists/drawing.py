# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/drawing/recording.cpp", "record.rows.resize(record.last_frame - record.first_frame + 1, last);", "", "recordings: bodies that rested before they moved"),
    ("src/drawing/recording.cpp", "record.looks.back().margin == options.margin &&", "", "recordings: margins that change"),
    ("src/drawing/recording.cpp", "now.push_back({pair, met ? before->begin : frame, frame});", "now.push_back({pair, frame, frame});", "recordings: when a meeting began"),
    ("src/drawing/recording.cpp", "if (found != state.bodies.end() && state.shapes", "if (false && state.shapes", "recordings: bodies of another scene"),
    ("src/drawing/recording_columns.cpp", "c == '<')", "false)", "recordings: </script> in a name"),
    ("src/drawing/recording_page_picture.cpp", "view.x + (p.x - view.width / 2) / view.scale", "view.x + (p.x - view.width / 3) / view.scale", "recordings: the point below the pointer"),
    ("src/drawing/recording_page_picture.cpp", "view.y += before.y - after.y;", "", "recordings: zooming keeps its point"),
    ("src/drawing/recording_page_data.cpp", "moment.begin <= time && time <= moment.end", "moment.begin <= time || time <= moment.end", "recordings: drawings outside of their interval"),
    ("src/drawing/recording_page_controls.cpp", '"next, previous mark on the time line", () => goToMark(1)', '"next, previous mark on the time line", () => goToMark(-1)', "recordings: the next mark"),
    ("src/drawing/recording_page_controls.cpp", "view.y += (at.y - before.y) / view.scale;", "view.y -= (at.y - before.y) / view.scale;", "recordings: dragging goes the other way"),
]
