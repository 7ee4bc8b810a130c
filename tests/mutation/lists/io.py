# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/io/occupancy_grid_io.cpp", "p >= occupied ? kOccupied", "p > occupied ? kOccupied", "maps: what is at occupied_thresh"),
    ("src/io/occupancy_grid_io.cpp", "p <= free ? kFree", "p < free ? kFree", "maps: what is at free_thresh"),
    ("src/io/occupancy_grid_io.cpp", "if (too_long == 1) file_.get();", "", "maps: LF of a header that ends in CR LF"),
    ("src/io/occupancy_grid_io.cpp", "map.grid.cells[row * pgm.width + column]", "map.grid.cells[(pgm.height - 1 - row) * pgm.width + column]", "maps: the first row is the lowest"),
    ("src/io/occupancy_grid_io.cpp", "if (size > kMostBytes)", "if (false)", "maps: long YAML files"),
]
