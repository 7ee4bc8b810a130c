# SPDX-License-Identifier: BSD-3-Clause
# (file, text as it stands there once, replacement, what it breaks): see ../run.py.
MUTATIONS = [
    ("src/io/map_fields.cpp", "p >= fields.occupied_thresh", "p > fields.occupied_thresh", "maps: what is at occupied_thresh"),
    ("src/io/map_fields.cpp", "p <= fields.free_thresh", "p < fields.free_thresh", "maps: what is at free_thresh"),
    ("src/io/pgm.cpp", "if (too_long == 1) in_.get();", "", "maps: LF of a header that ends in CR LF"),
    ("src/io/pgm.cpp", "      grid.cells[row * pgm.width + column]", "      grid.cells[(pgm.height - 1 - row) * pgm.width + column]", "maps: the first row is the lowest"),
    ("src/io/map_fields.cpp", "if (yaml.size > kMostBytes)", "if (false)", "maps: long YAML files"),
    ("src/io/map_files.cpp", "if (width * height > kMostCells)", "if (false)", "maps: a PNG file of 2^32 cells"),
    ("src/io/png.cpp", "const bool is_known = is_opaque || fields.mode == MapMode::Raw;", "const bool is_known = true;", "maps: transparent pixels are known"),
    ("src/io/png.cpp", "is_interlaced_ ? PNG_ROW_FROM_PASS_ROW(row, pass) : row", "row", "maps: rows of interlaced pictures"),
    ("src/io/map_image.h", "(255 * (100 - value) + 50) / 100", "255 * (100 - value) / 100", "maps: greys that are written are rounded down"),
    ("src/io/parts.cpp", "requireSimple(all, regions, pairs[0]);", "", "parts: one that crosses itself among ones that overlap"),
    ("src/io/parts.cpp", "orient(ring, &ring == part.data() ? 1 : -1);", "orient(ring, 1);", "parts: holes of parts that overlap are filled"),
    ("src/io/parts.cpp", "if (crossings.size() > most) break;", "", "parts: crossings that rounding doubles each round"),
    ("src/io/parts.cpp", "if (std::abs(sum) > error && std::isfinite(error))", "if (sum != 0)", "parts: directions of flat rings by rounded areas"),
    ("src/io/parts.cpp", "if (!isIn(holes.back(), shell))", "if (false)", "parts: holes outside of their shells"),
    ("src/io/parts.cpp", "around[outer].size() > around[shell].size()", "around[outer].size() < around[shell].size()", "parts: an island's hole is given to the shell around both"),
    ("src/io/parts.cpp", "return winding == 0 ? Is::Shell : winding + directions[ring] == 0 ? Is::Hole : Is::Neither;", "return winding == 0 ? Is::Shell : Is::Hole;", "parts: rings within a non-zero region are holes"),
    ("src/io/rasterize.cpp", "return covers(polygon_, pose_, region, pose_grid_, {-kMore * options_.margin});", "return covers(polygon_, pose_, region, pose_grid_);", "rasterize: negative margins where a block is inside"),
    ("src/io/rasterize.cpp", "margin > 0 && collide(polygon_, pose_, region, pose_grid_, {margin})", "collide(polygon_, pose_, region, pose_grid_, {options_.margin})", "rasterize: a block of which one cell is near"),
    ("src/io/geojson.cpp", "if (++depth_ > kMostDepth)", "if (++depth_ > 1000000)", "GeoJSON: arrays that nest deep"),
]
