# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/drawing/recording.cpp", "record.rows.resize(record.last_frame - record.first_frame + 1, last);", "", "recordings: bodies that rested before they moved"),
    ("src/drawing/recording.cpp", "record.looks.back().margin == options.margin &&", "", "recordings: margins that change"),
    ("src/drawing/recording.cpp", "now.push_back({pair, met ? before->begin : frame, frame});", "now.push_back({pair, frame, frame});", "recordings: when a meeting began"),
    ("src/drawing/recording.cpp", "if (found != state.bodies.end() && state.shapes", "if (false && state.shapes", "recordings: bodies of another scene"),
    ("src/drawing/recording_columns.cpp", "c == '<')", "false)", "recordings: </script> in a name"),
]
