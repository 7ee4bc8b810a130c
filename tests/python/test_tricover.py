"""What the module answers, how it takes arrays, and what it refuses."""
import copy
import math
import sys
import tempfile
import threading
import time
import unittest

import numpy as np
import tricover as tc

SQUARE = tc.Polygon([(0, 0), (1, 0), (1, 1), (0, 1)])
FRAME = tc.Polygon([np.array([(0, 0), (9, 0), (9, 9), (0, 9)]), [(1, 1), (8, 1), (8, 8), (1, 8)]])
ORIGIN = (0, 0, 0)


def matrix(x, y, heading):
    c, s = np.cos(heading), np.sin(heading)
    return np.array([(c, -s, x), (s, c, y), (0, 0, 1)])


def matrices(of):
    return tc.Poses.from_matrices(of)


class Polygons(unittest.TestCase):
    def test_rings_come_back(self):
        self.assertEqual(len(FRAME.rings), 2)
        np.testing.assert_array_equal(FRAME.rings[1], [(1, 1), (8, 1), (8, 8), (1, 8)])
        self.assertEqual(FRAME.vertex_count, 8)
        self.assertEqual(FRAME.fill_rule, tc.FillRule.EVEN_ODD)
        np.testing.assert_array_equal(FRAME.edge(3), [(0, 9), (0, 0)])
        self.assertGreaterEqual(FRAME.radius, np.hypot(4.5, 4.5))
        self.assertEqual(FRAME.covering_origin.shape, (2,))

    def test_the_fill_rule_counts(self):
        twice = [[(0, 0), (4, 0), (4, 4), (0, 4)], [(1, 1), (3, 1), (3, 3), (1, 3)]]
        self.assertEqual(tc.locate(tc.Polygon(twice), (2, 2)), tc.Location.OUTSIDE)
        self.assertEqual(tc.locate(tc.Polygon(twice, tc.FillRule.NON_ZERO), (2, 2)), tc.Location.INSIDE)
        locations = tc.locate(tc.Polygon(twice), [(2, 2), (0, 1), (0.5, 0.5)])
        np.testing.assert_array_equal(locations, [0, 1, 2])
        for i, location in enumerate((tc.Location.OUTSIDE, tc.Location.BOUNDARY, tc.Location.INSIDE)):
            np.testing.assert_array_equal(locations == location, np.arange(3) == i)
            np.testing.assert_array_equal(locations != location, np.arange(3) != i)
            self.assertEqual((location == i, i == location, location == i + 1), (True, True, False))
        self.assertTrue((locations >= tc.Location.BOUNDARY).tolist() == [False, True, True])

    def test_measures(self):
        shape = tc.Polygon([(0, 0), (4, 0), (4, 1), (1, 1), (1, 3), (0, 3)])
        self.assertEqual(shape.area, 6)
        np.testing.assert_allclose(shape.centroid, (1.5, 1))
        np.testing.assert_array_equal(shape.bounds, [(0, 0), (4, 3)])
        self.assertEqual((shape.is_convex, SQUARE.is_convex), (False, True))
        np.testing.assert_array_equal(shape.translated((1, 2)).bounds, [(1, 2), (5, 5)])
        self.assertEqual(shape.scaled(2).area, 24)
        many = tc.Polygon([(x, 1e-3 * (x % 2)) for x in range(20)] + [(20, 5), (0, 5)])
        self.assertLess(many.simplified(0.01).vertex_count, 6)
        covered = many.simplified(0.01, tc.Simplify.OUTWARDS)
        self.assertTrue(all(tc.locate(covered, ring).all() for ring in many.rings))

    def test_boxes_and_poses(self):
        crate = tc.Polygon.box(4, 2)
        np.testing.assert_array_equal(crate.bounds, [(-2, -1), (2, 1)])
        np.testing.assert_allclose(crate.bounds_at(tc.pose_at(5, 0, np.pi / 2)), [(4, -2), (6, 2)], atol=1e-15)
        np.testing.assert_allclose(crate.transformed((5, 0, np.pi / 2)).bounds, [(4, -2), (6, 2)], atol=1e-15)
        np.testing.assert_array_equal(tc.pose_at(1, 2), matrix(1, 2, 0))
        np.testing.assert_allclose(tc.pose_at(1, 2, 0.5), matrix(1, 2, 0.5))
        with self.assertRaisesRegex(ValueError, "width"):
            tc.Polygon.box(-1, 2)
        with self.assertRaisesRegex(ValueError, "pose"):
            tc.pose_at(0, np.nan)

    def test_maps(self):
        cells = np.zeros((3, 4), np.int8)
        cells[0, 1:3] = 100
        region = tc.outline(cells, 0.5, (1, 2))
        self.assertEqual(region.vertex_count, 4)
        self.assertEqual(tc.locate(region, (1.75, 2.25)), tc.Location.INSIDE)
        self.assertIsNone(tc.outline(np.zeros((2, 2))))
        for occupied in (0.9, 256, -256, 1e-300, 1e300, np.nan, np.inf, -1, 1j, True, np.uint64(2**63)):
            for cells in ([[occupied, 0]], np.array([[occupied, 0]])):
                self.assertEqual(tc.outline(cells).area, 1, occupied)
        with self.assertRaisesRegex(ValueError, "cells"):
            tc.outline([1, 0])
        with tempfile.TemporaryDirectory() as folder:
            with open(folder + "/m.pgm", "w") as file:
                file.write("P2 2 1 255 0 254")
            with open(folder + "/m.yaml", "w") as file:
                file.write("image: m.pgm\nresolution: 0.5\norigin: [1, 2, 0]\nnegate: 0\noccupied_thresh: 0.6\nfree_thresh: 0.2")
            read = tc.read_occupancy_map(folder + "/m.yaml")
            np.testing.assert_array_equal(read.cells, [[100, 0]])
            self.assertEqual(read.resolution, 0.5)
            np.testing.assert_array_equal(read.pose, matrix(1, 2, 0))
            self.assertIs(tc.collide(read.outline(), ORIGIN, tc.Polygon.point((1.2, 2.2)), ORIGIN), True)
            apart = tc.outline(read.cells, read.resolution)
            self.assertIs(tc.collide(apart, read.pose, tc.Polygon.point((1.2, 2.2)), ORIGIN), True)
            with self.assertRaisesRegex(RuntimeError, "none.yaml"):
                tc.read_occupancy_map(folder + "/none.yaml")


class Poses(unittest.TestCase):
    def test_a_matrix_is_a_pose(self):
        for heading in (0, 0.5, 3):
            pose = (0.3, 0.2, heading)
            self.assertEqual(tc.distance(SQUARE, ORIGIN, SQUARE, (5, 0.2, heading)).distance,
                             tc.distance(SQUARE, ORIGIN, SQUARE, matrices(matrix(5, 0.2, heading))).distance)
            self.assertIs(tc.collide(SQUARE, ORIGIN, SQUARE, matrices(matrix(*pose))), True)
        mirror = np.diag([-1.0, 1, 1])
        self.assertEqual(tc.distance(SQUARE, matrices(mirror), SQUARE, (3, 0, 0)).distance, 3)
        many = matrices([mirror, np.eye(3)])
        np.testing.assert_array_equal(tc.distance(SQUARE, many, SQUARE, (3, 0, 0)).distance, [3, 2])
        np.testing.assert_array_equal(np.asarray(many), [mirror, np.eye(3)])
        self.assertEqual(np.asarray(tc.Poses((1, 2, 3)), np.float32).dtype, np.float32)
        still = tc.Motion.still(matrices(mirror)).at(0.5)
        np.testing.assert_array_equal(still, mirror)
        self.assertEqual(tc.distance(SQUARE, still, SQUARE, (3, 0, 0)).distance, 3)

    def test_three_rows_are_three_poses_and_never_a_matrix(self):
        three = np.array([(0.5, 0, 0), (5, 0, 0), (1, 1, 0)])
        np.testing.assert_array_equal(tc.collide(SQUARE, ORIGIN, SQUARE, three), [True, False, True])
        # Either, as far as anybody can tell.
        either = [[1, 0, 5], [0, 1, 5], [0, 0, 1]]
        for function in (tc.collide, tc.distance, tc.penetration, tc.contacts):
            for array in (either, np.diag([2.0, 2, 1]), np.eye(3)):
                for arguments in ((array, SQUARE, ORIGIN), (ORIGIN, SQUARE, array)):
                    with self.assertRaisesRegex(ValueError, r"pose_[ab]: it may be a matrix or three poses; give Poses"):
                        function(SQUARE, *arguments)
        with self.assertRaisesRegex(ValueError, "pose: it may be a matrix"):
            tc.Scene().collides(SQUARE, np.eye(3))
        with self.assertRaisesRegex(ValueError, "start: it may be a matrix"):
            tc.Motion.translation(np.eye(3), (1, 0))
        self.assertEqual(tc.collide(SQUARE, ORIGIN, SQUARE, tc.Poses(either)).shape, (3,))
        self.assertIs(tc.collide(SQUARE, ORIGIN, SQUARE, matrices(either)), False)
        with self.assertRaisesRegex(ValueError, "^tricover: matrices: linear"):
            matrices(np.diag([2.0, 2, 1]))

    def test_many_are_one_by_one(self):
        rng = np.random.default_rng(1)
        poses = np.column_stack([rng.uniform(-2, 10, (3000, 2)), rng.uniform(0, 7, 3000)])
        hits = tc.collide(FRAME, ORIGIN, SQUARE, poses)
        self.assertEqual(hits.dtype, bool)
        self.assertTrue(0.1 < hits.mean() < 0.9)
        one_by_one = [tc.collide(FRAME, ORIGIN, SQUARE, pose) for pose in poses]
        np.testing.assert_array_equal(hits, one_by_one)
        for threads in (1, 2, 5):
            np.testing.assert_array_equal(tc.collide(SQUARE, poses, FRAME, ORIGIN, threads=threads), one_by_one)
        np.testing.assert_array_equal(tc.collide(FRAME, ORIGIN, SQUARE, matrices([matrix(*pose) for pose in poses])), one_by_one)
        both = tc.distance(SQUARE, poses[:50], SQUARE, poses[50:100])
        self.assertEqual(both.point_a.shape, (50, 2))
        for i in range(50):
            one = tc.distance(SQUARE, poses[i], SQUARE, poses[50 + i])
            self.assertEqual(one.distance, both.distance[i])
            np.testing.assert_array_equal(one.point_b, both.point_b[i])

    def test_what_is_refused_is_named(self):
        def refused(message, *arguments, error=ValueError, function=tc.collide):
            with self.assertRaisesRegex(error, message):
                function(*arguments)

        bad = np.zeros((5, 3))
        bad[3, 1] = np.nan
        refused(r"pose_b\[3\]", SQUARE, ORIGIN, SQUARE, bad)
        refused("pose_b", SQUARE, ORIGIN, SQUARE, (0, np.inf, 0))
        refused(r"pose_a: it must have the shape .* not \(1, 3, 3\); give matrices as Poses", SQUARE, [np.eye(3)], SQUARE, ORIGIN)
        refused("pose_a: it is no array", SQUARE, "here", SQUARE, ORIGIN, error=TypeError)
        refused(r"matrices\[1\]: linear", [np.eye(3), np.diag([2.0, 2, 1])], function=matrices)
        refused(r"matrices: they must have the shape .* not \(3,\)", ORIGIN, function=matrices)
        refused(r"poses\[1\]: ", [ORIGIN, (0, np.nan, 0)], function=tc.Poses)
        refused("pose: one pose is wanted", [ORIGIN, ORIGIN], function=SQUARE.transformed)
        refused(r"pose_a: it must have the shape .* not \(2,\)", SQUARE, (0, 0), SQUARE, ORIGIN)
        refused("pose_b: there are 4, but of pose_a 5", SQUARE, np.zeros((5, 3)), SQUARE, np.zeros((4, 3)))
        refused(r"matrices\[0\]: its last row", np.ones((1, 3, 3)), function=matrices)
        refused("margin", SQUARE, ORIGIN, SQUARE, ORIGIN, np.nan)
        refused(r"rings\[0\]", [[(0, 0, 0)]], function=tc.Polygon)
        refused("ring 0", [[(0, 0), (1, 1)]], function=tc.Polygon)
        refused("not finite", [[(0, 0), (1, 1), (np.nan, 0)]], function=tc.Polygon)
        refused("edge", 4, error=IndexError, function=SQUARE.edge)


class Pairs(unittest.TestCase):
    def test_a_touch_is_a_touch(self):
        self.assertTrue(tc.collide(SQUARE, ORIGIN, SQUARE, (1, 0, 0)))
        self.assertFalse(tc.collide(SQUARE, ORIGIN, SQUARE, (np.nextafter(1, 2), 0, 0)))
        self.assertTrue(tc.collide(SQUARE, ORIGIN, SQUARE, (1.5, 0, 0), margin=0.5))

    def test_a_touch_may_be_allowed(self):
        allowed = tc.Touching.ALLOWED
        poses = [(1, 0, 0), (np.nextafter(1, 0), 0, 0)]
        np.testing.assert_array_equal(tc.collide(SQUARE, ORIGIN, SQUARE, poses, touching=allowed), [False, True])
        self.assertIsNone(tc.penetration(SQUARE, ORIGIN, SQUARE, (1, 0, 0), touching=allowed))
        self.assertEqual(tc.penetration(SQUARE, ORIGIN, SQUARE, (1, 0, 0)).depth, 0)
        self.assertEqual(len(tc.contacts(SQUARE, ORIGIN, SQUARE, (1, 0, 0))), 1)
        self.assertEqual(tc.contacts(SQUARE, ORIGIN, SQUARE, (1, 0, 0), touching=allowed), [])

    def test_an_overlap_may_be_allowed(self):
        poses = [(0.95, 0, 0), (0.85, 0, 0)]
        np.testing.assert_array_equal(tc.collide(SQUARE, ORIGIN, SQUARE, poses, margin=-0.1), [False, True])
        floor, slides = tc.Motion.still((0, -1, 0)), tc.Motion.translation((0, 0, 0), (0.5, 0))
        self.assertEqual(tc.time_of_impact(SQUARE, floor, SQUARE, slides).time, 0)
        self.assertIsNone(tc.time_of_impact(SQUARE, floor, SQUARE, slides, margin=-1e-6))
        self.assertEqual(tc.conflicts(SQUARE, floor, SQUARE, slides, margin=-1e-6), [])

    def test_covers(self):
        sheet, crate = tc.Polygon.box(4, 4), tc.Polygon.box(1, 1)
        poses = [(0, 0, 0), (1.5, 0, 0), (1.6, 0, 0)]
        np.testing.assert_array_equal(tc.covers(sheet, ORIGIN, crate, poses), [True, True, False])
        np.testing.assert_array_equal(tc.covers(sheet, ORIGIN, crate, poses, margin=0.25), [True, False, False])
        self.assertIs(tc.covers(crate, ORIGIN, sheet, ORIGIN), False)
        lanes = tc.Scene()
        left, _ = lanes.add(sheet, (-2, 0, 0)), lanes.add(sheet, (2, 0, 0))
        self.assertIs(lanes.covers(crate, ORIGIN), True)
        self.assertIs(lanes.covers(crate, ORIGIN, ignored=left), False)
        np.testing.assert_array_equal(tc.covers(sheet, ORIGIN, crate, poses, margin=-0.125), [True, True, True])
        np.testing.assert_array_equal(tc.covers(sheet, ORIGIN, crate, poses, margin=-0.0625), [True, True, False])
        with self.assertRaisesRegex(ValueError, "margin"):
            tc.covers(sheet, ORIGIN, crate, ORIGIN, margin=math.nan)
        with self.assertRaisesRegex(ValueError, "pose_part: there are 3, but of pose_area 2"):
            tc.covers(sheet, poses[:2], crate, poses)

    def test_rays_ignore_an_overlap_that_is_allowed(self):
        scene = tc.Scene()
        scene.add(SQUARE, ORIGIN, margin=-0.1)
        self.assertEqual([part.end.fraction for _, part in scene.cast_ray_all((-1, 0.5), (3, 0.5))], [0.5])

    def test_complements(self):
        outside = SQUARE.complement()
        self.assertEqual((SQUARE.is_complement, outside.is_complement), (False, True))
        np.testing.assert_array_equal(tc.locate(outside, [(0.5, 0.5), (0, 0.5), (9, 9)]), [0, 1, 2])
        crate = tc.Polygon.box(0.5, 0.5)
        self.assertEqual(tc.distance(outside, ORIGIN, crate, (0.5, 0.5, 0)).distance, 0.25)
        np.testing.assert_array_equal(tc.collide(outside, ORIGIN, crate, [(0.5, 0.5, 0), (5, 5, 0)]), [False, True])
        with self.assertRaises(ValueError):
            tc.penetration(outside, ORIGIN, crate, (5, 5, 0))

    def test_measures(self):
        gap = tc.distance(SQUARE, ORIGIN, SQUARE, (4, 0, 0), margin=1)
        self.assertEqual((gap.distance, gap.edge_a), (2, 1))
        self.assertEqual((gap.point_a[0], gap.point_b[0]), (1, 4))
        way = tc.penetration(SQUARE, ORIGIN, SQUARE, (0.75, 0.1, 0))
        self.assertEqual(way.depth, 0.25)
        np.testing.assert_array_equal(way.normal, (1, 0))
        self.assertTrue(way.optimal)
        self.assertIsNone(tc.penetration(SQUARE, ORIGIN, SQUARE, (5, 0, 0)))
        ways = tc.penetration(SQUARE, ORIGIN, SQUARE, [(0.75, 0.1, 0), (5, 0, 0)])
        np.testing.assert_array_equal(ways.found, [True, False])
        np.testing.assert_array_equal(ways.depth, [0.25, np.nan])
        np.testing.assert_array_equal(ways.edge_a[1], -1)

    def test_signed_distances(self):
        apart = tc.signed_distance(SQUARE, ORIGIN, SQUARE, (4, 0, 0), margin=1)
        self.assertEqual((apart.distance, apart.edge_a), (2, 1))
        np.testing.assert_array_equal(apart.normal, (1, 0))
        both = tc.signed_distance(SQUARE, ORIGIN, SQUARE, [(4, 0, 0), (0.75, 0.1, 0)])
        np.testing.assert_array_equal(both.distance, [3, -0.25])

    def test_least_distances(self):
        still, passes = tc.Motion.still(ORIGIN), tc.Motion.translation((-5, 3, 0), (10, 0))
        least = tc.least_distance(SQUARE, still, SQUARE, passes, margin=0.5, absolute_error=1e-9)
        self.assertAlmostEqual(least.distance, 1.5, 8)
        self.assertLessEqual(least.lower_bound, least.distance)
        self.assertTrue(0.39 < least.time < 0.61)
        rest = tc.Trajectory([(0, 5, still)])
        way = tc.Trajectory([(4, 14, passes)])  # together until x is -4
        self.assertAlmostEqual(tc.least_distance(SQUARE, rest, SQUARE, way).distance, 2, 5)
        self.assertAlmostEqual(tc.least_distance(SQUARE, rest.vanishing(), SQUARE, way.appearing()).distance,
                               np.hypot(3, 2), 5)
        self.assertAlmostEqual(tc.least_distance(SQUARE, tc.Trajectory(tc.pose_at(0, 0)), SQUARE, way).distance, 2, 5)

    def test_who_is_absent_meets_nobody(self):
        before = tc.Trajectory([(0, 10, tc.Motion.still(ORIGIN))])
        after = tc.Trajectory([(11, 20, tc.Motion.still(ORIGIN))])
        self.assertEqual(len(tc.conflicts(SQUARE, before, SQUARE, after)), 1)
        self.assertEqual(tc.conflicts(SQUARE, before.vanishing(), SQUARE, after.appearing()), [])
        self.assertEqual(tc.conflicts(SQUARE, before, SQUARE, after.appearing())[0].impact.time, 11)
        self.assertFalse(after.appearing().is_there(10.5))
        scene = tc.Scene()
        bodies = [scene.add(SQUARE, ORIGIN) for _ in range(2)]
        ways = list(zip(bodies, [before, after]))
        self.assertEqual(len(scene.conflicts(ways)), 1)
        ways = list(zip(bodies, [before.vanishing(), after.appearing()]))
        self.assertEqual(scene.conflicts(ways), [])
        self.assertEqual(scene.impacts(ways), [])

    def test_contacts(self):
        beam = tc.Polygon([(-1, 4), (10, 4), (10, 5), (-1, 5)])
        self.assertEqual(len(tc.contacts(FRAME, ORIGIN, beam, ORIGIN)), 2)
        one = tc.contacts(FRAME, ORIGIN, beam, ORIGIN, most=1, detail=tc.ContactDetail.LOCAL_DEPTH)
        self.assertEqual(len(one), 1)
        self.assertGreater(one[0].depth, 0)
        crate = tc.Polygon([(-0.5, 0), (0.5, 0), (0.5, 1), (-0.5, 1)])
        floor = tc.Polygon([(-10, -1), (10, -1), (10, 0), (-10, 0)])
        flat = tc.contacts(floor, ORIGIN, crate, (2, -0.25, 0))[0]
        np.testing.assert_allclose(sorted(flat.points.tolist()), [(1.5, -0.125), (2.5, -0.125)], atol=1e-15)
        np.testing.assert_allclose(flat.depths, [0.25, 0.25], atol=1e-15)
        counts = [len(found) for found in tc.contacts(FRAME, ORIGIN, beam, [(0, 0, 0), (0, 99, 0)])]
        self.assertEqual(counts, [2, 0])

    def test_times_of_impact(self):
        hit = tc.time_of_impact(SQUARE, tc.Motion.still(ORIGIN), SQUARE, tc.Motion.translation((3, 0, 0), (-4, 0)))
        self.assertIs(hit.budget_ended, False)
        self.assertAlmostEqual(hit.time, 0.5, 5)
        self.assertEqual(hit.edge_a, 1)
        turn = tc.Motion.between((3, 3, 0), (3, 3, 1.0))
        self.assertIsNone(tc.time_of_impact(SQUARE, tc.Motion.still(ORIGIN), SQUARE, turn))
        np.testing.assert_allclose(turn.at(0.5), matrix(3, 3, 0.5), atol=1e-15)
        way = tc.Motion.spline((0, 0, 0), (3, 0, 0), (1, 1, 1), (0, 3, 0))
        np.testing.assert_allclose(way.at(1), matrix(1, 1, 1), atol=1e-15)

    def test_conflicts(self):
        still, there_and_back = tc.Motion.still(ORIGIN), tc.Motion.spline((-3, 0, 0), (12, 0, 0), (-3, 0, 0), (-12, 0, 0))
        one, = tc.conflicts(SQUARE, still, SQUARE, there_and_back)
        self.assertIs(one.budget_ended, False)
        self.assertAlmostEqual(one.impact.time, 1 - one.end, 5)
        leaves = tc.Motion.translation((0.5, 0, 0), (9, 0))
        self.assertEqual(tc.time_of_impact(SQUARE, still, SQUARE, leaves).time, 0)
        self.assertIsNone(tc.time_of_impact(SQUARE, still, SQUARE, leaves, ignore_initial=True))
        self.assertEqual(tc.conflicts(SQUARE, still, SQUARE, leaves, ignore_initial=True), [])

    def test_trajectories(self):
        way = tc.Trajectory.through([10, 20, 30, 40], [(-10, 0, 0), (0, 0, 0), (0, 0, 0), (10, 0, 0)])
        self.assertEqual((way.begin, way.end, len(way.legs)), (10, 40, 3))
        np.testing.assert_allclose(way.at(15), matrix(-5, 0, 0))
        np.testing.assert_allclose(way.part(10, 15).at(1), matrix(-5, 0, 0))
        rest = tc.Trajectory([(0, 1, tc.Motion.still(ORIGIN))])
        hit = tc.time_of_impact(SQUARE, rest, SQUARE, way)
        self.assertAlmostEqual(hit.time, 19, 5)
        span, = tc.conflicts(SQUARE, rest, SQUARE, way)
        self.assertAlmostEqual(span.end, 31, 5)
        spline = tc.Trajectory.spline([0, 2, 5], [(0, 0, 0), (2, 0, 0), (5, 0, 0)], [(1, 0, 0)] * 3)
        np.testing.assert_allclose(spline.at(4), matrix(4, 0, 0), atol=1e-14)
        with self.assertRaisesRegex(ValueError, r"waypoints: its shape must be \(n, 3\)"):
            tc.Trajectory.through([1, 2], [ORIGIN])
        with self.assertRaisesRegex(ValueError, r"waypoints\[1\].time"):
            tc.Trajectory.through([1, 1], [ORIGIN, ORIGIN])
        with self.assertRaises(TypeError):
            tc.time_of_impact(SQUARE, rest, SQUARE, tc.Motion.still(ORIGIN))

    def test_rays(self):
        hit = tc.cast_ray(SQUARE, (2, 0, 0), (0, 0.5), (4, 0.5))
        self.assertEqual((hit.fraction, hit.edge), (0.5, 3))
        np.testing.assert_array_equal(hit.normal, (-1, 0))
        self.assertIsNone(tc.cast_ray(SQUARE, (2, 0, 0), (0, 5), (4, 5)))
        parts = tc.cast_ray_all(FRAME, ORIGIN, (-1, 4), (9, 4))
        self.assertEqual([(part.begin.edge, part.end.edge) for part in parts], [(3, 7), (5, -1)])
        np.testing.assert_array_equal([part.end.point for part in parts], [(1, 4), (9, 4)])
        self.assertEqual(len(tc.cast_ray_all(FRAME, ORIGIN, (-1, 4), (9, 4), margin=4)), 1)

    def test_other_threads_run_meanwhile(self):
        rng = np.random.default_rng(2)
        angles = np.linspace(0, 2 * np.pi, 400, endpoint=False)
        star = tc.Polygon(np.column_stack([np.cos(angles), np.sin(angles)]) * rng.uniform(0.4, 1, (400, 1)))
        poses = np.column_stack([rng.uniform(-1, 1, (2000, 2)), rng.uniform(0, 7, 2000)])
        ticks, done = [0], threading.Event()

        def tick():
            while not done.is_set():
                ticks[0] += 1

        other = threading.Thread(target=tick)
        other.start()
        seconds = 0
        while seconds < 0.5:  # of one call, during which nothing else of this thread runs
            poses = np.concatenate([poses, poses])
            before, begin = ticks[0], time.monotonic()
            tc.distance(star, ORIGIN, star, poses, threads=1)
            during, seconds = ticks[0] - before, time.monotonic() - begin
        done.set()
        other.join()
        self.assertGreater(during, 0)


class Scenes(unittest.TestCase):
    def setUp(self):
        self.scene = tc.Scene()
        self.near = self.scene.add(SQUARE, (0, 0, 0))
        self.far = self.scene.add(SQUARE, (5, 0, 0), margin=0.5, category=2)

    def test_bodies(self):
        self.assertEqual(len(self.scene), 2)
        self.assertEqual(self.scene.bodies, [self.near, self.far])
        self.assertIn(self.near, self.scene)
        np.testing.assert_array_equal(self.scene.pose(self.far), matrix(5, 0, 0))
        self.assertEqual(self.scene.polygon(self.far).vertex_count, 4)
        branch = copy.copy(self.scene)
        self.scene.remove(self.near)
        self.assertNotIn(self.near, self.scene)
        self.assertIn(self.near, branch)
        self.assertEqual(len(copy.deepcopy(branch)), 2)
        with self.assertRaises(IndexError):
            self.scene.move(self.near, (0, 0, 0))

    def test_options(self):
        self.assertEqual(self.scene.options(self.far)[:3], (0.5, 2, 0xFFFFFFFF))
        self.scene.move(self.near, (3.5, 0, 0))
        self.assertEqual(len(self.scene.collisions()), 1)
        self.scene.set_options(self.far, margin=0.5, touching=tc.Touching.ALLOWED)
        self.assertEqual(self.scene.options(self.far).touching, tc.Touching.ALLOWED)
        self.assertEqual(self.scene.collisions(), [])
        self.assertIs(self.scene.collides(SQUARE, (2.5, 0, 0)), True)
        self.assertIs(self.scene.collides(SQUARE, (2.5, 0, 0), touching=tc.Touching.ALLOWED), False)
        self.assertEqual(self.scene.colliding(SQUARE, (2.5, 0, 0), touching=tc.Touching.ALLOWED), [])

    def test_a_body_is_no_mask(self):
        scene, way = self.scene, tc.Motion.still(ORIGIN)
        for body in (self.near, self.far):  # the first one is 0, which as a mask selects nothing
            self.assertEqual((body, type(body)), (int(body), tc.Body))
            for query in (lambda: scene.collides(SQUARE, ORIGIN, mask=body), lambda: scene.colliding(SQUARE, ORIGIN, mask=body),
                          lambda: scene.nearest(SQUARE, ORIGIN, mask=body), lambda: scene.cast_ray((0, 0), (1, 1), mask=body),
                          lambda: scene.first_impact(SQUARE, way, mask=body), lambda: scene.covers(SQUARE, ORIGIN, mask=body),
                          lambda: scene.add(SQUARE, ORIGIN, mask=body), lambda: scene.add(SQUARE, ORIGIN, category=body),
                          lambda: scene.set_options(self.near, mask=body),
                          lambda: scene.cast_ray_all((0, 0), (1, 1), mask=body)):
                with self.assertRaisesRegex(TypeError, "ignored="):
                    query()
        self.assertEqual(len(scene), 2)
        self.assertIs(scene.collides(SQUARE, ORIGIN, mask=1), True)
        self.assertIs(scene.collides(SQUARE, ORIGIN, ignored=int(self.near)), False)
        scene.move(self.near, (4.5, 0, 0))
        for bodies in (scene.bodies, scene.collisions()[0], scene.colliding(SQUARE, (4, 0, 0)), scene.began[0],
                       scene.impacts([(self.near, way)], margin=9)[0].pair, scene.nearest(SQUARE, ORIGIN)[:1]):
            self.assertEqual({type(body) for body in bodies}, {tc.Body})

    def test_trajectories(self):
        way = tc.Trajectory.through([0, 10, 20], [(0, 0, 0), (10, 0, 0), (0, 0, 0)])
        body, hit = self.scene.first_impact(SQUARE, way, ignored=self.near)
        self.assertEqual(body, self.far)
        self.assertAlmostEqual(hit.time, 3.5, 5)
        self.assertIsNone(self.scene.first_impact(SQUARE, tc.Motion.still(ORIGIN), ignore_initial=True))
        ((first, second), hit), = self.scene.impacts([(self.near, way)])
        self.assertEqual((first, second), (self.near, self.far))
        self.assertAlmostEqual(hit.time, 3.5, 5)
        spans = [span for _, span in self.scene.conflicts([(self.near, way)], threads=2)]
        np.testing.assert_allclose([(span.impact.time, span.end) for span in spans], [(3.5, 6.5), (13.5, 16.5)], atol=1e-5)

    def test_frames(self):
        self.assertEqual(self.scene.collisions(), [])
        self.scene.move(self.near, (3.6, 0, 0))
        self.assertEqual(self.scene.collisions(threads=2), [(self.near, self.far)])
        self.assertEqual(self.scene.began, [(self.near, self.far)])
        self.scene.move(self.near, (0, 0, 0))
        self.scene.collisions()
        self.assertEqual(self.scene.ended, [(self.near, self.far)])

    def test_queries(self):
        np.testing.assert_array_equal(
            self.scene.collides(SQUARE, [(0.5, 0, 0), (2, 0, 0), (3.5, 0, 0)]), [True, False, True])
        self.assertIs(self.scene.collides(SQUARE, (2, 0, 0), margin=1), True)
        self.assertIs(self.scene.collides(SQUARE, (0.5, 0, 0), mask=2), False)
        self.assertIs(self.scene.collides(SQUARE, (0.5, 0, 0), ignored=self.near), False)
        self.assertEqual(self.scene.colliding(SQUARE, (2.5, 0, 0), margin=1.5), [self.near, self.far])
        body, gap = self.scene.nearest(SQUARE, (3, 0, 0))
        self.assertEqual((body, gap.distance), (self.far, 0.5))
        self.assertIsNone(tc.Scene().nearest(SQUARE, (3, 0, 0)))
        body, hit = self.scene.first_impact(SQUARE, tc.Motion.translation((2, 0, 0), (-2, 0)))
        self.assertEqual(body, self.near)
        self.assertAlmostEqual(hit.time, 0.5, 5)
        ((first, second), hit), = self.scene.impacts([(self.near, tc.Motion.translation((0, 0, 0), (7, 0)))])
        self.assertEqual((first, second), (self.near, self.far))
        self.assertAlmostEqual(hit.time, 0.5, 5)
        body, hit = self.scene.cast_ray((2.5, 0.5), (6.5, 0.5))
        self.assertEqual(body, self.far)
        self.assertAlmostEqual(hit.fraction, 0.5)
        self.assertIsNone(self.scene.cast_ray((0, 5), (1, 5)))
        parts = self.scene.cast_ray_all((-1, 0.5), (9, 0.5))
        self.assertEqual([body for body, _ in parts], [self.near, self.far])
        np.testing.assert_allclose([part.end.fraction for _, part in parts], [0.2, 0.75])
        self.assertEqual([body for body, _ in self.scene.cast_ray_all((-1, 0.5), (9, 0.5), mask=2)], [self.far])

    def test_an_error_of_many_poses_says_which(self):
        poses = np.zeros((1000, 3))
        poses[700, 1] = np.inf
        with self.assertRaisesRegex(ValueError, r"pose\[700\]"):
            self.scene.collides(SQUARE, poses)

    def test_a_pose_comes_back(self):
        pose = self.scene.pose(self.far)
        self.assertIs(self.scene.collides(SQUARE, pose), True)
        self.scene.move(self.near, pose)
        np.testing.assert_array_equal(self.scene.pose(self.near), pose)


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
