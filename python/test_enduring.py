"""The module `enduring` as a reader of NumPy arrays meets it. Run by ./course python; the module's folder is on PYTHONPATH."""
import gc
import unittest

import numpy as np

import enduring

BALL = {"name": "ball", "dt": 0.005, "duration": 1, "planes": [{"name": "ground"}],
        "bodies": [{"name": "ball", "type": "rigid", "shape": {"sphere": {"radius": 0.25}}, "density": 1000, "position": [0, 1, 0]}]}


def ball(**more):
    return enduring.read(BALL, **more)


class Scenes(unittest.TestCase):
    def test_a_ball_falls_by_the_law_of_free_fall_and_comes_to_rest_with_its_weight_on_the_pairs(self):
        scene = ball()
        body = scene.bodies["ball"]
        scene.step(50)
        fallen = 9.81 * 0.005**2 * 50 * 51 / 2
        self.assertAlmostEqual(body.pose[0][1], 1 - fallen, 12)
        np.testing.assert_allclose(body.velocity, [0, -9.81 * 0.25, 0], atol=1e-12)
        scene.step(950)
        weight = 9.81 * body.mass
        np.testing.assert_allclose(scene.forces[0], [0, weight, 0], atol=1e-3 * weight)
        np.testing.assert_allclose(scene.pairs.force.sum(axis=0), [0, weight, 0], atol=1e-3 * weight)
        np.testing.assert_allclose(scene.vertex_forces[0].sum(axis=0), scene.forces[0], atol=1e-9)

    def test_every_chapter_s_solver_can_be_chosen_before_the_first_step_and_no_other(self):
        for chapter in range(1, enduring.chapters + 1):
            with self.subTest(chapter):
                scene = ball(chapter=chapter)
                scene.step()
                self.assertEqual(scene.chapter, chapter)
                self.assertEqual(scene.time, 0.005)
        with self.assertRaisesRegex(enduring.SceneError, "before the first step"):
            scene.chapter = 3
        with self.assertRaisesRegex(enduring.SceneError, "chapter 13 has no solver"):
            ball(chapter=13)

    def test_joints_tell_what_they_carry_and_need_a_solver_that_has_them(self):
        box = {"name": "box", "type": "rigid", "shape": {"box": {"size": [0.1, 0.1, 0.1]}}, "mass": 2, "position": [0, -0.5, 0]}
        machine = {"name": "machine", "dt": 0.01, "duration": 1, "bodies": [box],
                   "joints": [{"name": "rod", "type": "rod", "a": "box", "at": [0, -0.5, 0], "to": [0, 0, 0]}]}
        with self.assertRaisesRegex(enduring.SceneError, "/joints: chapter 10 has no joints"):
            enduring.read(machine, chapter=10)
        scene = enduring.read(machine, chapter=12)
        scene.step(10)
        rod = scene.joints["rod"]
        np.testing.assert_allclose(rod["force"], [0, 2 * 9.81, 0], atol=1e-6)
        self.assertAlmostEqual(rod["way"], 0.5, 12)
        self.assertFalse(rod["broken"])

    def test_a_scene_that_asks_for_exact_contact_refuses_a_solver_whose_springs_give(self):
        patch = {"contact": {"exact": True}}
        with self.assertRaisesRegex(enduring.SceneError, "/contact/exact: the springs of chapter 10 give"):
            ball(patch=patch, chapter=10)
        scene = ball(patch=patch)
        with self.assertRaises(enduring.SceneError):
            scene.chapter = 6
        self.assertEqual(scene.chapter, enduring.chapters)
        scene.step(200)
        self.assertGreater(scene.pairs.depth.min(), -1e-8)

    def test_a_step_tells_what_it_cost_in_counts(self):
        scene = ball()
        self.assertEqual(scene.work["attempts"], 0)
        worked = []
        for _ in range(200):
            scene.step()
            worked.append(scene.work)
        self.assertEqual({work["parts"] for work in worked[:20]}, {1})
        self.assertEqual(sum(work["newton_steps"] for work in worked[:20]), 0)  # it falls
        self.assertGreater(max(work["newton_steps"] for work in worked), 0)
        self.assertEqual(worked[-1]["islands"], 1)
        self.assertLess(worked[-1]["residual"], 1e-6)
        self.assertTrue(all(work["attempts"] >= work["parts"] for work in worked))

    def test_a_patch_changes_a_file_of_the_course(self):
        scene = enduring.load(enduring.scene_file("falling_sphere"), patch={"dt": 0.002})
        self.assertEqual((scene.name, scene.dt), ("falling_sphere", 0.002))

    def test_a_scene_may_hold_arrays_and_numbers_of_numpy(self):
        scene = ball(patch={"dt": np.float32(0.5), "/bodies/0/position": np.array([0, 2, 0])})
        self.assertEqual(scene.dt, 0.5)
        np.testing.assert_array_equal(scene.bodies["ball"].pose[0].round(12), [0, 2, 0])

    def test_a_mistake_in_a_scene_is_an_exception_that_tells_its_place(self):
        for patch, place in (({"dt": -1}, "scene: /dt: expected"), ({"/bodies/0/density": -3}, "/bodies/0/density"),
                             ({"bodyes": []}, "unknown key")):
            with self.assertRaisesRegex(enduring.SceneError, place):
                ball(patch=patch)
        with self.assertRaisesRegex(ValueError, "line 1"):
            enduring.read("{")
        with self.assertRaises(enduring.SceneError):
            enduring.load("no/such/file.json")


class OwnBodies(unittest.TestCase):
    def test_bodies_from_arrays_move_as_the_same_bodies_from_a_file_to_the_last_bit(self):
        vertices, faces = enduring.sphere(0.25)
        own = enduring.Scene(dt=0.005)
        own.add_plane("ground")
        own.add_rigid("ball", vertices + [0, 1, 0], faces, density=1000)
        read = ball()
        for scene in (own, read):
            scene.step(200)
        np.testing.assert_array_equal(own.bodies["ball"].positions, read.bodies["ball"].positions)
        self.assertGreater(len(own.pairs), 0)

    def test_a_soft_tetrahedron_keeps_its_momentum_and_its_nodes_are_seen(self):
        scene = enduring.Scene(gravity=[0, 0, 0])
        nodes = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1]]
        soft = scene.add_deformable("soft", nodes, [[0, 1, 2, 3]], young=1e4, poisson=0.3, density=600, velocity=[1, 2, 3])
        scene.step(10)
        self.assertAlmostEqual(soft.mass, 100)
        np.testing.assert_allclose(soft.momentum, [100, 200, 300], rtol=1e-9)
        np.testing.assert_allclose(soft.nodes, np.array(nodes) + 0.1 * np.array([1, 2, 3]), atol=1e-9)

    def test_arrays_that_are_no_body_are_refused(self):
        scene = enduring.Scene()
        vertices, faces = enduring.box([1, 1, 1])
        with self.assertRaisesRegex(enduring.SceneError, "3 columns"):
            scene.add_rigid("box", vertices[:, :2], faces)
        with self.assertRaises(enduring.SceneError):
            scene.add_rigid("box", vertices, faces[1:])
        scene.add_rigid("box", vertices, faces)
        with self.assertRaisesRegex(enduring.SceneError, "already"):
            scene.add_rigid("box", vertices, faces)
        with self.assertRaisesRegex(enduring.SceneError, r"face 0 names a vertex outside \[0, 8\)"):
            scene.add_rigid("far", vertices, faces + 8)

    def test_a_scene_takes_bodies_and_planes_of_new_names_before_its_first_step_and_is_as_before_if_it_refuses(self):
        scene = enduring.Scene()
        vertices, faces = enduring.box([1, 1, 1])
        scene.add_plane("ground")
        scene.add_rigid("box", vertices, faces)
        adds = (lambda name: scene.add_rigid(name, vertices, faces), lambda name: scene.add_plane(name))
        for add in adds:
            for name, complaint in (("", "not empty"), ("box", "already"), ("ground", "already")):
                with self.assertRaisesRegex(enduring.SceneError, complaint):
                    add(name)
        scene.step()
        for add in adds:
            with self.assertRaisesRegex(enduring.SceneError, "before the first step"):
                add("late")
        self.assertEqual(list(scene.bodies), ["box"])

    def test_numbers_out_of_range_are_refused(self):
        for of in ({"dt": 0}, {"gravity": [0, np.nan, 0]}, {"mu_s": -1}, {"mu_s": 0.1, "mu_d": 0.2}):
            with self.subTest(of), self.assertRaisesRegex(enduring.SceneError, f"{list(of)[-1]}.*: expected"):
                enduring.Scene(**of)
        for of in ({"normal": [0, 0, 0]}, {"normal": [0, np.inf, 0]}, {"point": [0, np.nan, 0]}):
            with self.subTest(of), self.assertRaisesRegex(enduring.SceneError, f"{list(of)[-1]}.*: expected"):
                enduring.Scene().add_plane("plane", **of)
        with self.assertRaisesRegex(enduring.SceneError, "steps: expected"):
            ball().step(-1)


class Arrays(unittest.TestCase):
    def test_positions_are_the_solver_s_own_and_cannot_be_written(self):
        scene = ball()
        positions = scene.bodies["ball"].positions
        before = positions.copy()
        scene.step(10)
        self.assertTrue((positions[:, 1] < before[:, 1]).all())
        self.assertFalse(positions.flags.owndata)
        with self.assertRaises(ValueError):
            positions[0, 0] = 7

    def test_an_array_outlives_the_scene_that_it_came_from(self):
        positions = ball().bodies["ball"].positions
        gc.collect()
        self.assertAlmostEqual(positions[:, 1].mean(), 1, 6)

    def test_pairs_keep_their_moment_while_the_run_goes_on(self):
        scene = ball(patch={"/bodies/ball/position": [0, 0.2499, 0]})
        scene.step(40)
        pairs = scene.pairs
        impulse, kept = pairs.impulse, pairs.impulse.copy()
        bodies = pairs.bodies
        self.assertGreater(len(pairs), 0)
        self.assertFalse(impulse.flags.owndata)
        del pairs
        scene.step(200)
        gc.collect()
        np.testing.assert_array_equal(impulse, kept)
        np.testing.assert_array_equal(bodies, 0)

    def test_normals_points_and_depths_of_pairs_with_a_plane_are_the_plane_s(self):
        scene = ball()
        scene.step(200)
        pairs = scene.pairs
        np.testing.assert_array_equal(pairs.normal, np.tile([0.0, 1.0, 0.0], (len(pairs), 1)))
        np.testing.assert_allclose(pairs.p[:, 1], pairs.depth, atol=1e-15)
        np.testing.assert_array_equal(pairs.q[:, 1], 0)
        np.testing.assert_array_equal(pairs.p, scene.bodies["ball"].positions[pairs.vertices[:, 0]])

    def test_energies_of_a_free_fall_are_those_of_the_formula_and_their_sum_stays(self):
        scene = ball()
        mass = scene.bodies["ball"].mass
        scene.step(20)
        kinetic, gravitational, elastic = scene.energies[0]
        self.assertAlmostEqual(kinetic, mass * (9.81 * 0.1) ** 2 / 2, 9)
        self.assertAlmostEqual(gravitational, mass * 9.81 * scene.bodies["ball"].pose[0][1], 9)
        self.assertEqual(elastic, 0)


if __name__ == "__main__":
    unittest.main()
