"""__geo_interface__ in and out, GeoJSON and WKT; with Shapely where it is installed."""
import json
import pathlib
import sys
import tempfile
import unittest

import numpy as np
import tricover as tc

try:
    import shapely.affinity
    import shapely.geometry
except ImportError:
    shapely = None

COUNTRIES = pathlib.Path(__file__).parents[2] / "bench" / "data" / "countries_110m.txt"


def countries_at_110m():
    lines = iter(COUNTRIES.read_text().splitlines())
    for line in lines:
        rings = int(line.split()[2])
        yield tc.Polygon([[tuple(map(float, next(lines).split())) for _ in range(int(next(lines).split()[1]))]
                          for _ in range(rings)])


SHELL, HOLE = [(0, 0), (9, 0), (9, 9), (0, 9)], [(1, 1), (1, 8), (8, 8), (8, 1)]
FRAME = tc.Polygon([SHELL, HOLE])


def closed(ring):
    return [*ring, ring[0]]


class Geometry:
    def __init__(self, kind, **fields):
        self.__geo_interface__ = {"type": kind, **fields}


class Interface(unittest.TestCase):
    def test_in(self):
        rings = [closed(SHELL), closed(HOLE)]
        far = [closed([(20, 0), (22, 0), (22, 2)])]
        one, two = {"type": "Polygon", "coordinates": rings}, {"type": "Polygon", "coordinates": far}
        for given, area in ((Geometry("Polygon", coordinates=rings), 32),
                            (Geometry("Polygon", coordinates=np.array([closed(SHELL)])), 81),
                            (Geometry("Polygon", coordinates=[[(*p, 7.0) for p in closed(SHELL)]]), 81),
                            (Geometry("MultiPolygon", coordinates=[rings, far]), 34),
                            (Geometry("Feature", properties={"of": object()}, geometry=one), 32),
                            (Geometry("GeometryCollection", geometries=[one, two]), 34),
                            (Geometry("FeatureCollection", features=[{"type": "Feature", "geometry": each} for each in (one, two)]), 34)):
            self.assertEqual(tc.Polygon(given).area, area)
            self.assertEqual(tc.Polygon.from_geo(given.__geo_interface__).area, area)
        self.assertEqual(tc.Polygon(Geometry("Polygon", coordinates=rings)), FRAME)

    def test_parts_that_overlap_are_one_region(self):
        part = [closed(SHELL)]
        twice = tc.Polygon(Geometry("MultiPolygon", coordinates=[part, [[(x + 3, y) for x, y in closed(SHELL)]]]))
        self.assertEqual(twice.area, 12 * 9)

    def test_out(self):
        out = FRAME.__geo_interface__
        self.assertEqual(out["type"], "Polygon")
        self.assertEqual([len(ring) for ring in out["coordinates"]], [5, 5])
        for ring in out["coordinates"]:
            self.assertEqual(ring[0], ring[-1])
            self.assertEqual({type(number) for point in ring for number in point}, {float})
        self.assertIsInstance(hash(out["coordinates"]), int)
        two = tc.Polygon([SHELL, [(20, 0), (22, 0), (22, 2)]])
        self.assertEqual(two.__geo_interface__["type"], "MultiPolygon")
        for polygon in (FRAME, two, tc.Polygon([(0.1, 0.2), (1e300, 1), (1 / 3, 5e-324)])):
            self.assertEqual(tc.Polygon(polygon.__geo_interface__ and Geometry(**{
                "kind": polygon.__geo_interface__["type"], "coordinates": polygon.__geo_interface__["coordinates"]})).area,
                             polygon.area)

    def test_refused(self):
        for message, error, given in (("Point", ValueError, Geometry("Point", coordinates=(0, 0))),
                                      ("geometry", ValueError, Geometry("Polygon", coordinates=[[(0, 0), (1, 0), (np.nan, 1), (0, 0)]])),
                                      ("geometry", ValueError, Geometry("Polygon")),
                                      ("geometry", ValueError, Geometry("Feature", geometry=None)),
                                      ("geometry", ValueError, Geometry("Nothing"))):
            with self.subTest(message), self.assertRaisesRegex(error, message):
                tc.Polygon(given)
        for kind in ("Polygon", "MultiPolygon"):  # Shapely's empty ones
            with self.assertRaisesRegex(ValueError, f"^geometry: its geometry is a {kind} without coordinates, which has no area$"):
                tc.Polygon(Geometry(kind, coordinates=()))
        with self.assertRaisesRegex(TypeError, "__geo_interface__"):
            tc.Polygon.from_geo(17)
        with self.assertRaisesRegex(ValueError, "complement"):
            FRAME.complement().__geo_interface__
        with self.assertRaises(ValueError):
            tc.Polygon([(0, 0), (2, 2), (2, 0), (0, 2)]).__geo_interface__

    def test_a_geometry_in_the_wrong_place_says_so(self):
        given = Geometry("Polygon", coordinates=[closed(SHELL)])
        with self.assertRaisesRegex(TypeError, r"Polygon\("):
            tc.collide(given, (0, 0, 0), FRAME, (0, 0, 0))
        with self.assertRaisesRegex(TypeError, "pose_a, b, pose_b"):
            tc.collide(FRAME, given, FRAME, (0, 0, 0))


class Files(unittest.TestCase):
    def test_features_come_back(self):
        features = [tc.GeoFeature(FRAME, 17, {"name": "Straße", "speed": 2.5}), tc.GeoFeature(tc.Polygon.box(1, 2), "dock", None),
                    tc.GeoFeature(tc.Polygon.box(3, 2))]
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "parts.json"
            tc.write_geo_json(path, features)
            self.assertEqual(len(json.loads(path.read_text())["features"]), 3)
            back = tc.read_geo_json(path)
        self.assertEqual([(one.id, one.properties, one.polygon.area) for one in back],
                         [(one.id, one.properties, one.polygon.area) for one in features])
        self.assertEqual(tc.parse_geo_json(tc.to_geo_json(features)), back)
        near, = tc.parse_geo_json(tc.to_geo_json(FRAME), origin=(1, 2))
        np.testing.assert_array_equal(near.polygon.bounds, [(-1, -2), (8, 7)])

    def test_others_are_skipped_on_request(self):
        text = '{"type": "FeatureCollection", "features": [{"type": "Feature", "properties": null, "geometry": ' \
               '{"type": "Point", "coordinates": [0, 0]}}]}'
        self.assertEqual(tc.parse_geo_json(text, skip_others=True), [])
        with self.assertRaisesRegex(RuntimeError, "Point"):
            tc.parse_geo_json(text)
        with self.assertRaisesRegex(TypeError, "GeoFeature"):
            tc.to_geo_json([FRAME])

    def test_wkt(self):
        self.assertEqual(tc.parse_wkt(tc.to_wkt(FRAME)).polygon.area, FRAME.area)


@unittest.skipUnless(shapely, "Shapely is not installed")
class BesideShapely(unittest.TestCase):
    def test_shapes_go_in_and_out(self):
        one = shapely.geometry.Polygon(SHELL, [HOLE])
        self.assertEqual(tc.Polygon(one), FRAME)
        self.assertTrue(shapely.geometry.shape(FRAME).equals(one))
        both = shapely.geometry.MultiPolygon([one, shapely.affinity.translate(one, 20, 0)])
        self.assertEqual(tc.Polygon(both).area, both.area)

    def test_stars_at_random(self):
        rng = np.random.default_rng(3)

        def star():
            angles = np.sort(rng.uniform(0, 2 * np.pi, 12))
            return np.column_stack([np.cos(angles), np.sin(angles)]) * rng.uniform(0.3, 2, (12, 1))

        hits = 0
        for _ in range(300):
            a, b, shift = star(), star(), rng.uniform(-3, 3, 2)
            p, q = shapely.geometry.Polygon(a), shapely.geometry.Polygon(b + shift)
            at = (*shift, 0)
            self.assertAlmostEqual(tc.Polygon(a).area, p.area, 12)
            gap = tc.distance(tc.Polygon(a), (0, 0, 0), tc.Polygon(b), at).distance
            self.assertAlmostEqual(gap, p.distance(q), 12)
            self.assertEqual(tc.collide(tc.Polygon(a), (0, 0, 0), tc.Polygon(b), at), p.intersects(q))
            small = tc.Polygon(b * 0.2)
            self.assertEqual(tc.covers(tc.Polygon(a), (0, 0, 0), small, at), p.covers(shapely.geometry.Polygon(b * 0.2 + shift)))
            hits += gap == 0
        self.assertTrue(20 < hits < 280)

    def test_countries(self):
        """Areas, containment, distances and who meets whom; neighbours have borders in common."""
        countries, refused = [], 0
        for polygon in countries_at_110m():
            try:
                countries.append((polygon, shapely.geometry.shape(polygon)))
            except ValueError:  # they cross themselves
                refused += 1
        self.assertEqual((len(countries), refused), (169, 4))
        still, rng = (0, 0, 0), np.random.default_rng(5)
        inside, meets, apart = 0, 0, 0
        for polygon, shape in countries:
            self.assertAlmostEqual(polygon.area / shape.area, 1, 12)
            low, high = polygon.bounds
            points = [shape.representative_point().coords[0], *rng.uniform(low, high, (20, 2))]
            for point in points:
                is_in = tc.locate(polygon, still, point) != tc.Location.OUTSIDE
                self.assertEqual(is_in, shape.intersects(shapely.geometry.Point(point)))
                inside += is_in
            part = tc.Polygon(np.asarray(points[0]) + [(-0.3, -0.3), (0.3, -0.3), (0, 0.3)])
            self.assertEqual(tc.covers(polygon, still, part, still), shape.covers(shapely.geometry.shape(part)))
        for i, (p, of_p) in enumerate(countries):
            for q, of_q in countries[:i]:
                gap = of_p.distance(of_q)
                self.assertAlmostEqual(tc.distance(p, still, q, still).distance, gap, 11)
                self.assertEqual(tc.collide(p, still, q, still), gap == 0)
                meets, apart = meets + (gap == 0), apart + (gap > 0)
        self.assertTrue(inside > 1500 and meets > 200 and apart > 10_000, (inside, meets, apart))



if __name__ == "__main__":
    unittest.main(argv=sys.argv)
