"""Recordings, drawings and what a Scene answers of contacts, least distances and pairs that may touch."""
import pathlib
import pickle
import sys
import tempfile
import unittest

import numpy as np
import tricover as tc

SQUARE = tc.Polygon.box(2, 2)


class Recordings(unittest.TestCase):
    def setUp(self):
        self.scene = tc.Scene()
        self.one, self.other = self.scene.add(SQUARE, [(0, 0, 0), (9, 0, 0)])
        self.ways = {self.one: tc.Trajectory.through([0, 18], [(0, 0, 0), (18, 0, 0)])}

    def test_all_of_it(self):
        recording = tc.SceneRecording("Fleet & dock")
        recording.trajectories(self.scene, self.ways)
        recording.name(self.one, "fleet")
        recording.conflicts(self.scene.conflicts(self.ways))
        recording.impacts(self.scene.impacts(self.ways))
        recording.nearest(tc.distance(SQUARE, (0, 0, 0), SQUARE, (9, 0, 0)), when=(0, 1))
        recording.nearest(self.scene.least_distance(SQUARE, tc.Trajectory.through([0, 1], [(0, 5, 0), (9, 5, 0)]),
                                                    ignored=self.one).least)
        recording.contacts(tc.contacts(SQUARE, (0, 0, 0), SQUARE, (1.5, 0, 0)), when=(2, 3))
        recording.ray((-9, 0), (9, 0), self.scene.cast_ray((-9, 0), (9, 0)), when=(0, 18))
        recording.text((0, 3), "here it is", when=(0, 18))
        page = str(recording)
        for text in ("Fleet & dock", "here it is", "fleet"):
            self.assertIn(text, page)
        self.assertTrue(recording._repr_html_().startswith("<iframe"))
        self.assertNotIn("<script", recording._repr_html_())
        with tempfile.TemporaryDirectory() as folder:
            recording.save(folder + "/fleet.html")
            self.assertEqual(pathlib.Path(folder, "fleet.html").read_text(encoding="utf-8"), page)

    def test_frames(self):
        recording = tc.SceneRecording()
        for time in range(3):
            self.scene.move(self.one, (4 * time, 0, 0))
            recording.frame(time, self.scene, self.scene.collisions())
        with self.assertRaisesRegex(ValueError, "time"):
            recording.frame(1, self.scene)
        with self.assertRaises(TypeError):
            recording.frame(3, self.scene, [(self.one,)])
        with self.assertRaises(TypeError):
            recording.trajectories(self.scene, {self.one: tc.Motion.still((0, 0, 0))})


class Scenes(unittest.TestCase):
    def test_pairs_that_may_touch(self):
        scene = tc.Scene()
        one, other = scene.add(SQUARE, [(0, 0, 0), (1.5, 0, 0)])
        self.assertEqual([found.pair for found in scene.contacts()], [(one, other)])
        scene.set_ignored(one, other)
        self.assertIs(scene.is_ignored(other, one), True)
        self.assertEqual((scene.contacts(), scene.collisions()), ([], []))
        scene.set_ignored(one, other, False)
        self.assertEqual(scene.contacts(threads=2)[0].contact.depth, 0.5)

    def test_conflicts_of_motions(self):
        scene = tc.Scene()
        one, other = scene.add(SQUARE, [(0, 0, 0), (9, 0, 0)])
        found, = scene.conflicts({one: tc.Motion.translation((0, 0, 0), (18, 0))})
        self.assertAlmostEqual(found.conflict.impact.time, 7 / 18, 5)
        self.assertAlmostEqual(found.conflict.end, 11 / 18, 5)

    def test_least_distances(self):
        scene = tc.Scene()
        bodies = scene.add(SQUARE, [(0, 0, 0), (0, 9, 0)])
        ways = [tc.Motion.translation((-5, y, 0), (10, 0)) for y in (3, 6)]
        least = scene.least_distance(SQUARE, ways)
        np.testing.assert_array_equal(least.body, bodies)
        np.testing.assert_allclose(least.least.distance, [1, 1], atol=1e-5)
        self.assertIsNone(tc.Scene().least_distance(SQUARE, ways[0]))


class Maps(unittest.TestCase):
    def test_they_come_back(self):
        cells = np.array([[0, 100, -1], [100, 0, 0]], np.int8)
        given = tc.OccupancyMap(cells, 0.05, (1.5, -2.25, 0.3))
        with tempfile.TemporaryDirectory() as folder:
            tc.write_occupancy_map(given, folder + "/map.yaml")
            back = tc.read_occupancy_map(folder + "/map.yaml")
        np.testing.assert_array_equal(back.cells, cells)
        self.assertEqual((back.resolution, back.pose), (0.05, given.pose))
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(given)).cells, cells)

    def test_cells_of_a_polygon(self):
        hall = tc.OccupancyMap(np.zeros((10, 20), np.int8), 0.5, (3, 4, 0.7))
        rng = np.random.default_rng(5)
        cell = tc.Polygon([(0, 0), (0.5, 0), (0.5, 0.5), (0, 0.5)])
        corners = np.array([(0.5 * column, 0.5 * row, 1) for row in range(10) for column in range(20)])
        places = (hall.pose.matrices @ corners.T).T
        poses = np.column_stack([places[:, :2], np.full(200, 0.7)])
        for _ in range(20):
            pose = (*(np.array([3, 4]) + rng.uniform(-2, 6, 2)), rng.uniform(0, 7))
            np.testing.assert_array_equal(tc.rasterize(SQUARE, pose, hall), np.flatnonzero(tc.collide(cell, poses, SQUARE, pose)))


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
