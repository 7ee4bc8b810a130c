"""What Python's users expect of values: pickle, copy, ==, hash, repr, and errors that say what to do."""
import copy
import pickle
import sys
import unittest

import numpy as np
import tricover as tc

SQUARE = tc.Polygon.box(2, 2)
ORIGIN = (0, 0, 0)


def values():
    """Pairs that are equal and aren't the same object, of each class that is a value."""
    spline = ([0, 1, 3], [(0, 0, 0), (1, 0.1, 0.2), (3, 0, 0)], [(1, 0, 0)] * 3)
    yield tc.Polygon([(0, 0), (1, 0), (0, 1)]), tc.Polygon([(0, 0), (1, 0), (0, 1)])
    yield SQUARE.complement(), tc.Polygon.box(2, 2).complement()
    yield tc.pose_at(0.1, 0.2, 0.3), tc.Poses((0.1, 0.2, 0.3))
    yield tc.Poses([(0.1, 0.2, 0.3)] * 2), tc.Poses([tc.pose_at(0.1, 0.2, 0.3)] * 2)
    yield tc.Motion.between(ORIGIN, (1, 2, 3)), tc.Motion.between(ORIGIN, (1, 2, 3))
    yield tc.Trajectory.through([0, 1, 2], [ORIGIN, (0.1, 0.2, 0.3), (1, 2, 3)]), tc.Trajectory.through(
        [0, 1, 2], [ORIGIN, (0.1, 0.2, 0.3), (1, 2, 3)])
    yield tc.Trajectory.spline(*spline).appearing(), tc.Trajectory.spline(*spline).appearing()
    yield tc.Trajectory(tc.pose_at(1, 2, 0.3)), tc.Trajectory(tc.pose_at(1, 2, 0.3))
    for pose in ((5, 0, 0), (1, 0, 0)):
        yield tuple(tc.signed_distance(SQUARE, ORIGIN, SQUARE, pose) for _ in range(2))
    yield tuple(tc.distance(SQUARE, ORIGIN, SQUARE, [(5, 0, 0), (1, 0, 0)]) for _ in range(2))


class Values(unittest.TestCase):
    def test_equal_ones_have_one_hash(self):
        for one, other in values():
            with self.subTest(one):
                self.assertEqual(one, other)
                self.assertFalse(one != other)
                self.assertEqual(hash(one), hash(other))
                self.assertNotEqual(one, "another type")

    def test_different_ones_differ(self):
        ones = [one for one, _ in values()]
        for i, one in enumerate(ones):
            self.assertEqual([one == other for other in ones], [i == j for j in range(len(ones))], one)

    def test_pickles_and_copies_are_equal(self):
        for one, _ in values():
            for protocol in range(2, pickle.HIGHEST_PROTOCOL + 1):
                with self.subTest(one, protocol=protocol):
                    self.assertEqual(pickle.loads(pickle.dumps(one, protocol)), one)
            self.assertEqual(copy.copy(one), one)
            self.assertEqual(copy.deepcopy(one), one)

    def test_a_trajectory_comes_back_to_the_last_bit(self):
        way = tc.Trajectory.through([0, 0.3, 0.7], [ORIGIN, (0.1, 0.2, 0.3), (1, 2, 3)])
        back = pickle.loads(pickle.dumps(way.vanishing()))
        self.assertEqual((back.begin, back.end, back.vanishes, back.appears), (0, 0.7, True, False))
        for time in np.linspace(0, 0.7, 50):
            np.testing.assert_array_equal(back.at(time), way.at(time))

    def test_bodies_and_enumerations(self):
        scene = tc.Scene()
        body = scene.add(SQUARE, ORIGIN)
        for one in (body, tc.Location.INSIDE, tc.FillRule.NON_ZERO):
            back = pickle.loads(pickle.dumps(one))
            self.assertEqual((back, type(back)), (one, type(one)))
        self.assertEqual(repr(body), "Body(0)")

    def test_texts_make_the_value_again(self):
        names = {name: getattr(tc, name) for name in tc.__all__}
        for one in (tc.Polygon([(0, 0), (1.5, 0), (0, 1e-300)]), tc.pose_at(0.1, 0.2, 0.3), tc.Location.INSIDE,
                    tc.Poses.from_matrices(np.diag([-1.0, 1, 1]))):
            text = repr(one)
            if text.startswith("<"):  # an enumeration's
                self.assertIn("INSIDE", text)
            else:
                self.assertEqual(eval(text, names), one)


class Errors(unittest.TestCase):
    def test_what_was_meant_is_said(self):
        class Geometry:
            __geo_interface__ = {"type": "Point", "coordinates": (0, 0)}

        for message, error, call in (
                ("order of arguments is a, pose_a", TypeError, lambda: tc.collide(SQUARE, SQUARE, ORIGIN, ORIGIN)),
                ("Polygon", TypeError, lambda: tc.collide(Geometry(), ORIGIN, SQUARE, ORIGIN)),
                ("Polygon", TypeError, lambda: tc.collide([(0, 0), (1, 0), (0, 1)], ORIGIN, SQUARE, ORIGIN)),
                ("Touching", TypeError, lambda: tc.collide(SQUARE, ORIGIN, SQUARE, ORIGIN, touching=1)),
                ("some of its items are Poses", TypeError,
                 lambda: tc.collide(SQUARE, [tc.pose_at(0, 0), ORIGIN], SQUARE, ORIGIN)),
                ("pose", TypeError, lambda: tc.Scene().impacts([(0, ORIGIN)]))):
            with self.subTest(message), self.assertRaisesRegex(error, message):
                call()

    def test_a_list_of_poses_is_many(self):
        hits = tc.collide(SQUARE, ORIGIN, SQUARE, [tc.pose_at(0, 0), tc.pose_at(9, 0)])
        np.testing.assert_array_equal(hits, [True, False])


if __name__ == "__main__":
    unittest.main(argv=sys.argv)
