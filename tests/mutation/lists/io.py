# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/io/map_fields.cpp", "p >= fields.occupied_thresh", "p > fields.occupied_thresh", "maps: what is at occupied_thresh"),
    ("src/io/map_fields.cpp", "p <= fields.free_thresh", "p < fields.free_thresh", "maps: what is at free_thresh"),
    ("src/io/pgm.cpp", "if (too_long == 1) in_.get();", "", "maps: LF of a header that ends in CR LF"),
    ("src/io/pgm.cpp", "      grid.cells[row * pgm.width + column]", "      grid.cells[(pgm.height - 1 - row) * pgm.width + column]", "maps: the first row is the lowest"),
    ("src/io/map_fields.cpp", "if (yaml.size > kMostBytes)", "if (false)", "maps: long YAML files"),
]
