# SPDX-License-Identifier: BSD-3-Clause
"""beside_shapely.py <rewrite> <countries_110m.txt> <folder>: Shapely, and ogr2ogr where it is installed, write GeoJSON
and WKT, rewrite reads and writes them, and Shapely says whether that is the same. Ends with 77 without Shapely."""
import csv
import json
import math
import pathlib
import random
import shutil
import subprocess
import sys

try:
    from shapely import wkt
    from shapely.geometry import MultiPolygon, Polygon, box, mapping, shape
    from shapely.ops import unary_union
except ImportError:
    print("skipped: this Python has no Shapely (Debian and Ubuntu: python3-shapely)")
    sys.exit(77)

REWRITE, COUNTRIES, FOLDER = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])


def of_rings(rings):
    """A ring inside of an odd number of others is a hole of the smallest of these."""
    regions = sorted((Polygon(ring) for ring in rings), key=lambda region: -region.area)
    parts = []  # shell, holes
    for number, region in enumerate(regions):
        around = [other for other in regions[:number] if region.within(other)]
        if len(around) % 2 == 0:
            parts.append((region, []))
        else:
            next(part for part in reversed(parts) if part[0] is around[-1])[1].append(region.exterior.coords)
    polygons = [Polygon(shell.exterior.coords, holes) for shell, holes in parts]
    return polygons[0] if len(polygons) == 1 else MultiPolygon(polygons)


def countries():
    lines = iter(COUNTRIES.read_text().splitlines())
    for line in lines:
        _, name, count = line.split()
        rings = []
        for _ in range(int(count)):
            vertices = int(next(lines).split()[1])
            rings.append([tuple(map(float, next(lines).split())) for _ in range(vertices)])
        yield name, of_rings(rings)


def odd_ones():
    yield "clockwise, hole counter-clockwise", Polygon([(0, 0), (0, 9), (9, 9), (9, 0)], [[(1, 1), (2, 1), (2, 2)]])
    yield "hole touches the shell", Polygon([(0, 0), (9, 0), (9, 9), (0, 9)], [[(0, 5), (2, 4), (2, 6)]])
    yield "holes touch", Polygon([(0, 0), (9, 0), (9, 9), (0, 9)], [[(1, 1), (4, 1), (4, 4)], [(4, 4), (6, 4), (6, 6)]])
    yield "parts touch", MultiPolygon([box(0, 0, 1, 1), box(1, 1, 2, 2), Polygon([(2, 1.5), (3, 1), (3, 2)])])
    ring_road = Polygon(box(0, 0, 9, 9).exterior.coords, [box(1, 1, 8, 8).exterior.coords])
    yield "island in a hole", MultiPolygon([ring_road, box(2, 2, 7, 7)])
    yield "repeated vertices", Polygon([(0, 0), (0, 0), (4, 0), (4, 4), (4, 4), (4, 4)])
    yield "height", Polygon([(0, 0, 7), (4, 0, 8), (4, 4, 9.5)])
    yield "tiny", Polygon([(0, 0), (1e-150, 0), (1e-150, 1e-150)])
    yield "huge", Polygon([(-1e150, 0), (1e150, 0.1), (1e150, 1e150)])
    yield "sliver", Polygon([(0.1, 0.1), (1e6 / 3, 0.2), (1e6, 0.4)])
    chance = random.Random(1)
    for number in range(100):
        low = lambda: chance.randrange(20) / 7
        corners = [(low(), low()) for _ in range(12)]
        union = unary_union([box(x, y, x + chance.randrange(1, 9) / 7, y + chance.randrange(1, 9) / 7) for x, y in corners])
        yield f"union {number}", union
        angles = sorted(chance.uniform(0, 2 * math.pi) for _ in range(20))
        star = [(5e5 + chance.uniform(1, 2) * math.cos(angle), chance.uniform(1, 2) * math.sin(angle)) for angle in angles]
        yield f"star {number}", Polygon(star)


def rewrite(name, text):
    """The text's file rewritten."""
    source, target = FOLDER / name, FOLDER / ("our_" + name)
    source.write_text(text)
    subprocess.run([REWRITE, source, target], check=True)
    return target


def flat(geometry):
    """Without z, and with rings and parts in an order of their own."""
    return shape(json.loads(json.dumps(mapping(geometry)), object_hook=drop_z)).normalize()


def drop_z(value):
    def cut(item):
        return item[:2] if isinstance(item[0], (int, float)) else [cut(each) for each in item]

    if "coordinates" in value:
        value["coordinates"] = cut(value["coordinates"])
    return value


def require(is_right, name, what):
    if not is_right:
        sys.exit(f"{name}: {what}")


def require_same(name, ours, theirs):
    """The same vertices. A polygon is written as one, whether it came as a MultiPolygon or not."""
    require(ours.is_valid, name, "what we write is invalid")
    vertices = [[part.wkb_hex for part in getattr(flat(each), "geoms", [flat(each)])] for each in (ours, theirs)]
    require(vertices[0] == vertices[1], name, "we write other vertices")
    require(math.isclose(ours.area, theirs.area, rel_tol=1e-12), name, "another area")


def require_close(name, ours, theirs):
    """The same region, but for the 15 digits that OGR writes."""
    require(ours.is_valid, name, "what we write is invalid")
    rounding = 1e-14 * max(map(abs, theirs.bounds))
    require(ours.symmetric_difference(theirs).area <= rounding * theirs.length, name, "another region than OGR's")


def feature(name, geometry):
    return {"type": "Feature", "id": name, "properties": {"name": name, "parts": [1, None]}, "geometry": mapping(geometry)}


def collection(named):
    return json.dumps({"type": "FeatureCollection", "features": [feature(*each) for each in named]})


def features_of(path):
    return json.loads(path.read_text())["features"]


def check_geojson(named):
    written = rewrite("shapely.geojson", collection(named))
    features = features_of(written)
    require(len(features) == len(named), "GeoJSON", "another number of features")
    for (name, theirs), ours in zip(named, features):
        require((ours["id"], ours["properties"]) == (name, {"name": name, "parts": [1, None]}), name, "other members")
        require_same(name, shape(ours["geometry"]), theirs)


def check_wkt(named):
    # GEOS 3.11 overruns a buffer when it writes a number as long as the huge ones, and writes tiny ones as 0.
    named = [each for each in named if max(map(abs, each[1].bounds)) < 1e100]
    named = [each for each in named if wkt.loads(each[1].wkt).is_valid]
    require(len(named) > 300, "WKT", f"Shapely writes only {len(named)} polygons")
    texts = [geometry.wkt for _, geometry in named]
    lines = rewrite("shapely.wkt", "".join(text + "\n" for text in texts)).read_text().splitlines()
    require(len(lines) == len(texts), "WKT", "another number of lines")
    for (name, _), theirs, ours in zip(named, texts, lines):
        require(not ours.startswith("refused"), name, ours)
        require_same(name, wkt.loads(ours), wkt.loads(theirs))


def check_invalid(geometries):
    """What Shapely calls invalid is refused, and nothing else."""
    chance = random.Random(2)
    texts = ["POLYGON ((0 0, 2 2, 2 0, 0 2, 0 0))", *(geometry.wkt for geometry in geometries)]
    for _ in range(50):
        corners = [(chance.uniform(0, 9), chance.uniform(0, 9)) for _ in range(3)]
        texts.append(MultiPolygon([box(x, y, x + 3, y + 2) for x, y in corners]).wkt)
    lines = rewrite("invalid.wkt", "".join(text + "\n" for text in texts)).read_text().splitlines()
    require(len(lines) == len(texts), "invalid ones", "another number of lines")
    for text, ours in zip(texts, lines):
        require(ours.startswith("refused") != wkt.loads(text).is_valid, text, ours)


def check_ogr(named):
    def ogr(source, target, *options):
        target.unlink(missing_ok=True)
        subprocess.run(["ogr2ogr", "-f", "CSV" if target.suffix == ".csv" else "GeoJSON", target, source, *options], check=True)

    # OGR writes some 15 digits, which is too few for what is tiny or huge.
    named = [each for each in named if each[1].area > 1e-9 and max(map(abs, each[1].bounds)) < 1e9]
    require(len(named) > 300, "OGR", f"only {len(named)} polygons")
    written = rewrite("for_ogr.geojson", collection(named))
    by_name = dict(named)
    ogr(written, FOLDER / "ogr.geojson", "-lco", "COORDINATE_PRECISION=17")
    features = features_of(rewrite("ogr_again.geojson", (FOLDER / "ogr.geojson").read_text()))
    require(len(features) == len(named), "OGR's GeoJSON", "another number of features")
    for ours in features:
        name = ours["properties"]["name"]
        require_close(name, shape(ours["geometry"]), by_name[name])
    ogr(written, FOLDER / "ogr.csv", "-lco", "GEOMETRY=AS_WKT")
    with open(FOLDER / "ogr.csv", newline="") as file:
        rows = list(csv.DictReader(file))
    require(len(rows) == len(named), "CSV", "another number of rows")
    # Edges an ulp apart may meet by 15 digits.
    rows = [row for row in rows if wkt.loads(row["WKT"]).is_valid]
    require(len(rows) > 300, "CSV", f"only {len(rows)} valid rows")
    lines = rewrite("ogr.wkt", "".join(row["WKT"] + "\n" for row in rows)).read_text().splitlines()
    for row, ours in zip(rows, lines):
        require(not ours.startswith("refused"), row["name"], ours)
        require_close(row["name"], wkt.loads(ours), by_name[row["name"]])


def main():
    FOLDER.mkdir(exist_ok=True)
    everything = [*countries(), *odd_ones()]
    named = [(name, geometry) for name, geometry in everything if geometry.is_valid]
    require(len(named) > 300, "cases", f"only {len(named)} of {len(everything)} are valid")
    check_geojson(named)
    check_wkt(named)
    check_invalid([geometry for _, geometry in everything if not geometry.is_valid])
    if shutil.which("ogr2ogr"):
        check_ogr(named)
    else:
        print("ogr2ogr isn't installed (Debian and Ubuntu: gdal-bin), so its files were not read")
    print(f"{len(named)} polygons are the same, {len(everything) - len(named)} are invalid and refused")


main()
