"""Tests of tracers and pictures: python3 -m unittest voxc_trace_test"""
import tempfile
import unittest

import numpy as np

import voxc
from voxc_test import ball


class Tracing(unittest.TestCase):
    def test_hits(self):
        words = ball()
        volume = voxc.build("R(2, 2, 2) G(3)", voxels=words)
        tracer = volume.tracer("cpu", outputs="voxel,t,face,colour")
        self.assertEqual(tracer.device, "cpu")
        y, z = np.mgrid[0:32, 0:32] + 0.5
        origins = np.stack([np.full_like(y, -10), y, z], -1)
        hits = tracer.trace(origins, (1, 0, 0))
        self.assertEqual(hits.shape, (32, 32))
        first = np.argmax(words != 0, axis=2).T  # Along x, indexed [y, z].
        found = (words != 0).any(axis=2).T
        np.testing.assert_array_equal(hits["voxel"][..., 0], np.where(found, first, -1))
        np.testing.assert_array_equal(hits["t"], np.where(found, first + 10, 0))
        np.testing.assert_array_equal(hits["face"][found], 0)

    def test_rays_of_files(self):
        volume = voxc.build("G(5)", voxels=ball())
        rays = np.zeros(3, voxc.RAY)
        rays["origin"], rays["direction"] = (16, 16, -4), (0, 0, 2)
        hits = volume.trace(rays, None, "cpu")
        np.testing.assert_array_equal(hits["voxel"], [(16, 16, 4)] * 3)
        np.testing.assert_array_equal(hits["t"], [4] * 3)

    def test_bounds(self):
        volume = voxc.build("G(5)", voxels=ball())
        tracer = volume.tracer("cpu", outputs="voxel,t,face,colour")
        origins = np.full((3, 3), (16, 16, -4), np.float32)
        hits = tracer.trace(origins, (0, 0, 2), tmin=[0, 4, 4.25], tmax=4.5)
        np.testing.assert_array_equal(hits["voxel"][:, 2], [4, 4, 5])
        np.testing.assert_array_equal(hits["t"], [4, 4, 4.5])
        np.testing.assert_array_equal(voxc.normals(hits), [(0, 0, -1)] * 3)
        missed = tracer.trace(origins, (0, 0, 2), tmax=3.5)
        np.testing.assert_array_equal(missed["voxel"], [(-1, -1, -1)] * 3)
        np.testing.assert_array_equal(voxc.normals(missed), np.zeros((3, 3)))
        np.testing.assert_array_equal(tracer.trace(origins, (0, 0, 2))["t"], [4] * 3)
        rays = np.zeros(2, voxc.BOUNDED_RAY)
        rays["origin"], rays["direction"], rays["tmin"], rays["tmax"] = (16, 16, -4), (0, 0, 2), 4.5, np.inf
        np.testing.assert_array_equal(volume.trace(rays, None, "cpu")["voxel"], [(16, 16, 5)] * 2)
        only = volume.trace((16, 16, -4), (0, 0, 2), "cpu", tmin=4.5, query="any")
        self.assertEqual(only["voxel"].tolist(), [0, 0, 0])
        with self.assertRaisesRegex(ValueError, "take no others"):
            tracer.trace(rays, tmin=1)
        with self.assertRaisesRegex(voxc.Error, "gives bounds to points"):
            volume.tracer("cpu", query="occupancy", bounds=True)

    def test_queries(self):
        volume = voxc.build("G(5)", voxels=ball())
        self.assertEqual(volume.trace((-1, 16, 16), (1, 0, 0), "cpu", query="any")["voxel"].tolist(), [0, 0, 0])
        with self.assertRaisesRegex(voxc.Error, "query cannot be 'all'"):
            volume.tracer("cpu", query="all")
        with self.assertRaisesRegex(voxc.Error, "'steps' is no output"):
            volume.tracer("cpu", outputs="voxel,steps")

    def test_the_volume_may_go_first(self):
        tracer = voxc.build("G(5)", voxels=ball()).tracer("cpu")
        self.assertEqual(tracer.trace((16, 16, -1), (0, 0, 1))["voxel"].tolist(), [16, 16, 4])
        words = voxc.build("G(5)", voxels=ball()).words[5:]
        self.assertGreater(words.sum(), 0)

    def test_attributes(self):
        words = ball()
        words[words != 0] += np.arange((words != 0).sum(), dtype=np.uint32)
        volume = voxc.build("R(3, 3, 3) M(2, 2, 2)", voxels=words, passes=["values-apart"])
        with self.assertRaises(KeyError):
            volume.attribute("colour")
        numbers = np.arange(volume.voxels, dtype="<u4")
        more = volume.with_attribute("number", numbers).with_attribute("place", np.zeros((volume.voxels, 3), "<f4"))
        del volume
        np.testing.assert_array_equal(more.attribute("number").view("<u4")[:, 0], numbers)
        self.assertEqual(more.attribute("place").shape, (more.voxels, 12))
        hit = more.trace((16.5, 16.5, -1), (0, 0, 1), "cpu", outputs="voxel,index")
        x, y, z = hit["voxel"].tolist()
        codes = [sum((c >> b & 1) << (3 * b + axis) for axis, c in enumerate(cell) for b in range(5))
                 for cell in zip(*np.nonzero(words)[::-1])]
        place = sum((c >> b & 1) << (3 * b + axis) for axis, c in enumerate((x, y, z)) for b in range(5))
        self.assertEqual(int(hit["rgba"]), sum(code < place for code in codes))
        with self.assertRaisesRegex(ValueError, "3 elements, but"):
            more.with_attribute("short", np.zeros(3))
        with self.assertRaisesRegex(voxc.Error, "cannot be called 'words'"):
            more.with_attribute("words", numbers)

    def test_update(self):
        words = ball()
        tracer = voxc.build("G(5)", voxels=words).tracer("cpu")
        words[:, :, :16] = 0
        tracer.update(voxc.build("G(5)", voxels=words))
        self.assertEqual(tracer.trace((8.5, 16.5, -1), (0, 0, 1))["voxel"].tolist(), [-1, -1, -1])
        self.assertEqual(tracer.trace((20.5, 16.5, -1), (0, 0, 1))["voxel"].tolist()[:2], [20, 16])
        with self.assertRaisesRegex(voxc.Error, r"another format, R\(5, 5, 5\) \(digest 0x\w+\), than that of the tracer, G\(5\) "
                                                r"\(digest 0x\w+\); it takes a tracer of its own$"):
            tracer.update(voxc.build("R(5, 5, 5)", voxels=words))

    def test_update_reaches_rays_with_bounds(self):
        words = ball()
        tracer = voxc.build("G(5)", voxels=words).tracer("cpu")
        self.assertEqual(tracer.trace((8.5, 16.5, -1), (0, 0, 1), tmax=99)["voxel"].tolist()[:2], [8, 16])
        words[:, :, :16] = 0
        tracer.update(voxc.build("G(5)", voxels=words))
        self.assertEqual(tracer.trace((8.5, 16.5, -1), (0, 0, 1), tmax=99)["voxel"].tolist(), [-1, -1, -1])

    def test_rays_are_kept_or_refused(self):
        tracer = voxc.build("G(5)", voxels=ball()).tracer("cpu")
        for rays, sentence in (((np.zeros((5, 3)), np.zeros((4, 3))), r"origins of the shape \(5, 3\) and directions of the shape \(4, 3\) do not fit"),
                               ((np.zeros((5, 2)), (1, 0, 0)), r"origins have three numbers each, \(\.\.\., 3\), and not the shape \(5, 2\)"),
                               ((np.zeros((5, 3)),), "there are no directions"), ((np.zeros((5, 3), complex), (1, 0, 0)), "origins are numbers, not complex"),
                               (("abc", (1, 0, 0)), "origins are numbers"),
                               ((np.ma.masked_equal(np.zeros((5, 3)), 0), (1, 0, 0)), "origins are a masked array")):
            with self.assertRaisesRegex(ValueError, sentence):
                tracer.trace(*rays)
        with self.assertRaisesRegex(ValueError, r"tmin is a number for all rays or one for each; it has the shape \(2,\), and the rays \(5,\)"):
            tracer.trace(np.zeros((5, 3)), (1, 0, 0), tmin=[1, 2])


class Pictures(unittest.TestCase):
    def test_picture(self):
        picture = voxc.build("G(5)", voxels=ball()).render(40, 30, device="cpu")
        self.assertEqual((picture.shape, picture.dtype), ((30, 40, 4), np.uint8))
        self.assertNotEqual(picture[15, 20].tolist(), picture[0, 0].tolist())
        self.assertEqual(picture[15, 20, 3], 255)
        with tempfile.NamedTemporaryFile(suffix=".png") as file:
            voxc.save_picture(file.name, picture)
            self.assertEqual(file.read(8), b"\x89PNG\r\n\x1a\n")

    def test_choices(self):
        tracer = voxc.build("G(5)", voxels=ball()).tracer("cpu")
        depth = tracer.render(20, 20, style="depth", eye=(16, 16, -30), look=(16, 16, 16), fov=40)
        self.assertEqual(depth.shape, (20, 20, 4))
        with self.assertRaisesRegex(voxc.Error, "'oil' is no style; there are lit, flat"):
            tracer.render(20, 20, style="oil")
        with self.assertRaisesRegex(voxc.Error, "an eye is given without the point that it looks at; give both, or neither"):
            tracer.render(20, 20, eye=(0, 0, 0))
        with self.assertRaisesRegex(voxc.Error, "a point to look at is given without an eye"):
            tracer.render(20, 20, look=(0, 0, 0))
        with self.assertRaisesRegex(ValueError, r"eye is a point x, y, z, and not \(1, 2\)"):
            tracer.render(20, 20, eye=(1, 2), look=(0, 0, 0))

    def test_cuts_and_parallel_rays(self):
        words = np.full((32, 32, 32), 0xFF0000FF, np.uint32)  # Red, and green from z = 16 on down.
        words[:16] = 0xFF00FF00
        tracer = voxc.build("G(5)", voxels=words).tracer("cpu")
        options = dict(style="flat", eye=(16, 16, 90), look=(16, 16, 16))
        centre = lambda **more: tracer.render(21, 21, **options, **more)[10, 10, :3].argmax()
        self.assertEqual(centre(), 0)
        self.assertEqual(centre(clip_box=((0, 0, 0), (32, 32, 16))), 1)
        self.assertEqual(centre(clip_planes=(0, 0, -1, -10)), 1)
        self.assertEqual(centre(clip_planes=np.array([[0, 0, -1, -20], [1, 0, 0, 2]])), 0)
        self.assertEqual(centre(clip_planes=[]), 0)
        # By parallel rays the block is as large wherever the eye is: half of what is shown.
        reds = [np.count_nonzero((tracer.render(64, 64, style="flat", eye=(16, 16, z), look=(16, 16, 16), view_height=64)[..., :3] == (255, 0, 0)).all(-1))
                for z in (50, 90)]
        self.assertEqual(reds[0], reds[1])
        plain = tracer.render(40, 30, view="iso")
        self.assertFalse((tracer.render(40, 30, view="iso", orthographic=True) == plain).all())
        np.testing.assert_array_equal(tracer.render(40, 30, view="iso", orthographic=False), plain)
        for error, wrong, sentence in (
                (ValueError, dict(clip_box=(1, 2, 3)), r"clip_box is two corners, .*, and not \(1, 2, 3\)"),
                (ValueError, dict(clip_box=((1, 2), (3,))), "clip_box is two corners"),
                (ValueError, dict(clip_planes=5), "clip_planes are planes .*, and not 5"),
                (ValueError, dict(clip_planes=[(1, 2, 3)]), "clip_planes are planes"),
                (ValueError, dict(clip_planes=[(1, 2, 3, 4), (1,)]), "clip_planes are planes"),
                (voxc.Error, dict(clip_box=((1, 2, 3), (1, 9, 9))), "a box of a picture holds nothing"),
                (voxc.Error, dict(clip_planes=(0, 0, 0, 1)), "a plane of a picture should be a direction"),
                (voxc.Error, dict(clip_planes=(0, np.nan, 1, 1)), "a plane of a picture should be a direction"),
                (voxc.Error, dict(view_height=-1), "lies between 0.001 and 1e9 voxels"),
                (voxc.Error, dict(view_height=9, fov=40), "give one of the two"),
                (voxc.Error, dict(view="inside", orthographic=True), "an orthographic camera sees nothing from inside")):
            with self.assertRaisesRegex(error, sentence):
                tracer.render(8, 8, **wrong)


if __name__ == "__main__":
    unittest.main()
