"""Tests of lists of voxels, of arrays of others, and of what notebooks show: python3 -m unittest voxc_arrays_test"""
import ctypes
import gc
import inspect
import pathlib
import re
import tempfile
import unittest

import numpy as np

import voxc
from voxc_test import ball


class Shared:
    """An array that another library would share by DLPack alone."""

    def __init__(self, array, device=1):
        self.array, self.device = array, device

    def __dlpack__(self, **options):
        return self.array.__dlpack__(**options)

    def __dlpack_device__(self):
        return self.device, 0


class Bar:
    """A bar as tqdm has them."""

    def __init__(self):
        self.n, self.told, self.stages = 0, [], []

    def reset(self, total):
        self.n, self.total = 0, total

    def update(self, more):
        self.n += more
        self.told.append(self.n)

    def set_description(self, text):
        self.stages.append(text)


def spread(numbers):
    """Each bit of numbers below 2^21 at three times its place."""
    numbers, spread = numbers.astype(np.uint64), np.zeros(numbers.shape, np.uint64)
    for bit in range(21):
        spread |= (numbers >> np.uint64(bit) & np.uint64(1)) << np.uint64(3 * bit)
    return spread


class Points(unittest.TestCase):
    # R(3, 3, 3) M(3, 3, 3) numbers its voxels otherwise than in Morton order.
    FORMATS = ("G(5)", "R(2, 2, 2) G(3)", "R(2^3) M(3, 3, 3)", "R(1^3) M(1^3) M(1^3) M(2^3)", "S(5)")

    def check(self, words):
        z, y, x = np.nonzero(words)
        codes = spread(x) | spread(y) << np.uint64(1) | spread(z) << np.uint64(2)
        order = np.argsort(codes)
        for format in self.FORMATS:
            places, colours = voxc.build(format, voxels=words).points()
            self.assertEqual((places.dtype, colours.dtype, colours.shape), (np.int32, np.uint8, (len(x), 4)))
            np.testing.assert_array_equal(places, np.stack([x, y, z], -1)[order])
            np.testing.assert_array_equal(colours.view("<u4")[:, 0], words[z, y, x][order])

    def test_points_are_all_voxels_in_morton_order(self):
        self.check(ball())

    def test_points_of_cubes_of_one_colour_are_all_their_voxels(self):
        self.check(np.where(ball() != 0, np.uint32(0xFF0080FF), np.uint32(0)))

    def test_build_takes_them(self):
        volume = voxc.build("R(2, 2, 2) G(3)", "builtin:terrain:32", passes="whole-level-dedup")
        points = volume.points()
        again = voxc.build(volume.ir, places=points.places, colours=points.colours, extent=volume.extent)
        np.testing.assert_array_equal(again.words, volume.words)

    def test_labels_are_words(self):
        labels = np.zeros((4, 4, 4), np.uint16)
        labels[1, 2, 3], labels[3, 2, 1] = 7, 65535
        volume = voxc.build("G(2)", labels=labels)
        places, words = volume.points()
        self.assertEqual((places.tolist(), words.tolist()), ([[3, 2, 1], [1, 2, 3]], [7, 65535]))
        empty = voxc.build("G(2)", labels=np.zeros((4, 4, 4), np.uint16)).points()
        self.assertEqual((empty.places.shape, empty.colours.shape), ((0, 3), (0, 4)))

    def test_chunks_are_boxes_that_have_voxels(self):
        words = ball()[:30, :, :20]
        volume = voxc.build("R(2, 2, 2) G(3)", voxels=words)
        again = np.zeros_like(words)
        for (x, y, z), chunk in volume.chunks(8):
            self.assertTrue(chunk.any())
            again[z:z + 8, y:y + 8, x:x + 8] = chunk
        np.testing.assert_array_equal(again, words)

    def test_npz_keeps_a_volume(self):
        volume = voxc.build("R(2, 2, 2) G(3)", voxels=ball()[:30], passes="whole-level-dedup")
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "ball.npz"
            volume.save_npz(path)
            np.testing.assert_array_equal(voxc.load_npz(path).words, volume.words)
            self.assertEqual(voxc.load_npz(path).extent, (32, 32, 30))
            other = voxc.load_npz(path, "S(5)", threads=1)
            self.assertEqual((other.format, other.voxels), ("S(5)", volume.voxels))
            np.savez(path, places=np.zeros((1, 3)))
            with self.assertRaisesRegex(voxc.InputError, "was not written by save_npz, for it has no extent and no format and no words"):
                voxc.load_npz(path)


class Arrays(unittest.TestCase):
    @unittest.skipUnless(hasattr(np, "from_dlpack"), "this NumPy has no DLPack")
    def test_arrays_of_others_are_taken(self):
        volume = voxc.build("R(2, 2, 2) G(3)", voxels=Shared(ball()))
        np.testing.assert_array_equal(volume.read(), ball())
        tracer = volume.tracer("cpu")
        rays = np.full((4, 3), 16, np.float32) * (0, 1, 1), np.array([1, 0, 0], np.float32)
        hits = tracer.trace(*map(Shared, map(np.ascontiguousarray, rays)))
        np.testing.assert_array_equal(hits, tracer.trace(*rays))
        # And hits are theirs.
        self.assertEqual(np.from_dlpack(hits["t"]).tolist(), hits["t"].tolist())

    def test_the_order_of_an_array_means_nothing(self):
        numbers = np.random.default_rng(17).integers(0, 255, (5, 6, 7))
        kinds = {"voxels": [numbers > 99, numbers.astype(np.uint32) | 0xFF000000, np.stack([numbers] * 3, -1).astype(np.uint8)],
                 "labels": [numbers.astype(np.uint16)], "greys": [numbers.astype(np.uint8)],
                 "densities": [numbers.astype(np.float32), numbers.astype(np.int16)]}
        for name, arrays in kinds.items():
            options = {"threshold": 99.5} if name == "densities" else {}
            for array in arrays:
                expected = voxc.build("S(3)", **{name: np.ascontiguousarray(array)}, **options).read()
                axes = (2, 0, 1, 3)[:array.ndim]
                for given in (np.asfortranarray(array), np.ascontiguousarray(array.transpose(axes)).transpose(np.argsort(axes)),
                              np.ascontiguousarray(array[::-1])[::-1]):
                    np.testing.assert_array_equal(voxc.build("S(3)", **{name: given}, **options).read(), expected, (name, array.dtype))

    def test_densities_are_compared_as_a_file_has_them(self):
        densities = np.full((4, 4, 4), 0.2, np.float32)
        densities[0, 0, 0], densities[1, 1, 1] = 0.7, 0.9  # The float32 of 0.7 is less than that.
        self.assertEqual(voxc.build("G(2)", densities=densities, threshold=0.7).voxels, 1)
        large = np.full((2, 2, 2), 2**53, np.int64)
        large[0, 0, 0] += 1
        self.assertEqual(voxc.build("G(1)", densities=large, threshold=2**53 + 1).voxels, 1)
        for window in ((), (1, 2, 3), (2, 1), (0, float("inf"))):
            with self.assertRaisesRegex(ValueError, "a window is two numbers"):
                voxc.build("G(2)", densities=densities, threshold=0.5, window=window)
        self.assertEqual(voxc.build("G(2)", densities=densities, threshold=0.5, window=np.array([0, 1])).voxels, 2)

    def test_what_does_not_fit_is_told(self):
        volume = voxc.build("G(3)", voxels=np.ones((8, 8, 8), bool))
        for call in (lambda: volume.read((0, 0), (2, 2)), lambda: volume.read((0, 0, 0), (3, 3)), lambda: volume.read((2**32, 0, 0), (2, 2, 2)),
                     lambda: voxc.build("G(3)", places=[[1, 1, 1]], extent=(2**32 + 8, 8, 8)),
                     lambda: voxc.build("G(5)", "builtin:menger", resolution=2**32 + 27),
                     lambda: voxc.build("G(5)", "builtin:menger", resolution=np.int64(2**32 + 27)), lambda: list(volume.chunks(0))):
            self.assertRaises(ValueError, call)
        editable = voxc.Editable(volume)
        for call in (lambda: editable.set_box((1, 2), (4, 5), 0), lambda: editable.set_box((0, 0, 0), (1, 1, 1), 2**32),
                     lambda: editable.set_box((0, 0, 0), (1, 1, 1), -1), lambda: editable.apply((0, 0, 0), (1, 1, 1), lambda *_: 1.7),
                     lambda: editable.set_sphere((4, 4, 4), -2, 0), lambda: editable.set_sphere((4, 4, 4), 2.5, 0),
                     lambda: editable.set_sphere((4, 4, 4), 2**20 + 1, 0), lambda: editable.set_sphere((4, 4, 4), float("inf"), 0)):
            self.assertRaises(ValueError, call)
        self.assertEqual(editable.voxels, 512)
        self.assertRaisesRegex(voxc.UsageError, "changes what a volume stores", volume.tracer, "cpu", passes="palette=4")
        self.assertRaisesRegex(voxc.UsageError, "leaves no choice", volume.tracer, "cpu", query="any", outputs="voxel")
        self.assertRaisesRegex(ValueError, "has no formats", voxc.suggest, "builtin:full:8", formats=[])

    def test_what_is_of_another_kind_is_told(self):
        volume = voxc.build("G(3)", voxels=np.ones((8, 8, 8), bool))
        editable, other = voxc.Editable(volume), voxc.Editable(voxc.build("G(4)", "builtin:full:16"))
        tracer = volume.tracer("cpu")
        for call in (lambda: voxc.Format(None), lambda: voxc.build(None, voxels=np.ones((8, 8, 8), bool)), lambda: voxc.suggest(None),
                     lambda: voxc.Volume.load(None), lambda: volume.attribute(None), lambda: voxc.Editable(editable),
                     lambda: editable.paste(other), lambda: tracer.follow(volume), lambda: tracer.update(editable)):
            self.assertRaises(TypeError, call)
        self.assertRaisesRegex(ValueError, "null byte", voxc.Format, "G(3)\0junk")
        self.assertRaisesRegex(ValueError, "null byte", volume.save, "/tmp/none\0.hvx")
        self.assertRaisesRegex(ValueError, "of another volume", editable.view, other.snapshot())
        self.assertRaisesRegex(ValueError, "colours are one word", voxc.build, "G(3)", places=[[0, 0, 0], [1, 1, 1]],
                               colours=np.ones((2, 2, 1), np.uint32))

    def test_what_numpy_makes_of_words_keeps_the_volume(self):
        words = np.asarray(voxc.build("R(6, 6, 6)", voxels=np.ones((64, 64, 64), bool)).words)
        again = np.frombuffer(voxc.build("R(6, 6, 6)", voxels=np.ones((64, 64, 64), bool)).words, np.uint8)
        gc.collect()
        self.assertEqual(int((words == words[-1]).sum()), 64**3)
        self.assertEqual(4 * len(words), len(again))
        self.assertEqual(again.tobytes(), words.tobytes())

    def test_options_without_a_size_are_told(self):
        library, volume = voxc._library, voxc.build("G(3)", "builtin:full:8")
        options, tracer = library.TracerOptions(device=b"no such device"), ctypes.c_void_p()
        with self.assertRaisesRegex(voxc.UsageError, "struct_size of options is 0; begin them with their macro"):
            library.check(library.lib.voxc_tracer_create(volume._handle, ctypes.byref(options), ctypes.byref(tracer)))

    def test_functions_of_bool_are_white(self):
        volume = voxc.build("G(3)", voxel=lambda x, y, z: x < 2, extent=(4, 1, 1))
        self.assertEqual(volume.points().colours.tolist(), [[255] * 4] * 2)

    def test_arrays_of_devices_are_told(self):
        with self.assertRaisesRegex(ValueError, r"voxels lie in the memory of another device; \.cpu\(\) of torch"):
            voxc.build("G(5)", voxels=Shared(ball(), device=2))

    def test_a_volume_is_an_array(self):
        words = ball()
        volume = voxc.build("G(5)", voxels=words)
        np.testing.assert_array_equal(np.asarray(volume), words)
        np.testing.assert_array_equal(np.asarray(volume, bool), words != 0)


class Told(unittest.TestCase):
    def test_errors_have_kinds(self):
        for error, kind, call in (
            (voxc.InputError, "input", lambda: voxc.Format("Q(3)")),
            (voxc.UsageError, "usage", lambda: voxc.Format("G(3)", "nothing")),
            (voxc.UsageError, "usage", lambda: voxc.Format("G(3)").header(language="cobol")),
            (voxc.MachineError, "environment", lambda: voxc.build("G(3)", "builtin:full:8").tracer("no such device")),
            (voxc.MachineError, "environment", lambda: voxc.search("builtin:full:8", device="no such device")),
            (voxc.UsageError, "usage", lambda: voxc.suggest("builtin:full:8", objective="nicest")),
            (voxc.InputError, "input", lambda: voxc.suggest("builtin:full:8", formats=["Q(3)"])),
        ):
            with self.assertRaises(error) as caught:
                call()
            self.assertEqual(caught.exception.kind, kind)
            self.assertIsInstance(caught.exception, voxc.Error)

    def test_bars_are_progress(self):
        bar = Bar()
        voxc.build("R(3, 3, 3) G(5)", "builtin:terrain", resolution=128, progress=bar)
        self.assertTrue(bar.stages)
        self.assertEqual(len(set(bar.stages)), len(bar.stages))
        self.assertTrue(all(0 <= fraction <= 1.001 for fraction in bar.told))

    def test_everything_is_annotated_and_told_of(self):
        for name in voxc.__all__:
            thing = getattr(voxc, name)
            methods = [method for _, method in inspect.getmembers(thing, inspect.isfunction)] if inspect.isclass(thing) else []
            for function in [thing, *methods]:
                if not inspect.isfunction(function) or not function.__module__.startswith("voxc"):
                    continue
                hints = set(function.__annotations__)
                wanted = {argument for argument in inspect.signature(function).parameters if argument not in ("self", "cls")} | {"return"}
                self.assertEqual(wanted - hints, set(), function.__qualname__)
                if not function.__name__.startswith("_"):
                    self.assertTrue(function.__doc__ or function.__module__ == "voxc.points", function.__qualname__)
        self.assertTrue((pathlib.Path(voxc.__file__).parent / "py.typed").exists())


class Notebooks(unittest.TestCase):
    PNG = b"\x89PNG\r\n\x1a\n"

    def test_volumes_and_pictures_are_shown(self):
        volume = voxc.build("R(2, 2, 2) G(3)", voxels=ball())
        self.assertTrue(volume._repr_png_().startswith(self.PNG))
        shown = volume._repr_html_()
        self.assertIn("R(2, 2, 2) G(3)", shown)
        self.assertIn("data:image/png;base64,", shown)
        picture = volume.render(16, 8, device="cpu")
        self.assertTrue(picture._repr_png_().startswith(self.PNG))
        self.assertEqual([part._repr_png_() for part in (picture[0], picture / 2, picture[:0])], [None] * 3)

    def test_a_page_is_shown_and_saved(self):
        page = voxc.build("R(2, 2, 2) G(3)", voxels=ball()).page("A ball")
        self.assertRegex(page._repr_html_(), '^<iframe srcdoc="&lt;!')
        with tempfile.TemporaryDirectory() as folder:
            page.save(pathlib.Path(folder) / "ball.html")
            self.assertIn("<title>A ball", (pathlib.Path(folder) / "ball.html").read_text())

    def test_headers_are_of_a_language(self):
        format = voxc.Format("R(2, 2, 2) G(3)")
        self.assertEqual(format.header("scene"), format.header("scene", "shared"))
        self.assertRegex(format.header("scene", "cuda"), r"__device__")
        self.assertRegex(format.header("scene", "wgsl"), r"fn voxc_scene_closest")
        cones = voxc.Format("format detail=cone { level 1: svdag(3) }")
        for function in (cones.header, lambda: cones._emit(voxc._library.lib.voxc_emit_header, None)):
            with self.assertRaisesRegex(voxc.InputError, "^the functions of a header stop at voxels alone: leave out detail=cone$"):
                function()

    def test_suggestions_are_rows(self):
        rows = voxc.suggest("builtin:terrain", resolution=32)
        self.assertEqual({tuple(row) for row in rows}, {tuple(rows[0])})
        [chosen] = [row for row in rows if row["chosen"]]
        self.assertTrue(chosen["frontier"] and chosen["camera_rays_per_second"] > 0)
        smallest = min(rows, key=lambda row: row["bytes"])
        volume = voxc.build(smallest["format"], "builtin:terrain", resolution=32, passes=smallest["passes"])
        self.assertEqual(4 * len(volume.words), smallest["bytes"])

    def test_suggestions_keep_to_what_is_asked(self):
        rows = voxc.suggest("builtin:terrain", resolution=32, formats=["G(5)", "R(2^3) G(3)"], objective="smallest", editable=True)
        self.assertEqual({row["format"] for row in rows}, {"G(5)", "R(2^3) G(3)"})
        self.assertEqual(min(rows, key=lambda row: row["bytes"])["chosen"], True)
        self.assertTrue(all("values-apart" not in row["passes"] for row in rows))
        rays = np.zeros(64, voxc.RAY)
        rays["origin"], rays["direction"] = (-1, 16, 16), (1, 0, 0)
        [row] = voxc.suggest("builtin:terrain", resolution=32, formats=["S(5)"], rays=rays, max_bytes=1 << 20)
        self.assertGreater(row["rays_rays_per_second"], 0)
        with self.assertRaisesRegex(voxc.InputError, "takes so few bytes"):
            voxc.suggest("builtin:terrain", resolution=32, max_bytes=8)

    def test_searches_measure_in_process(self):
        bar = Bar()
        rows = voxc.search("builtin:terrain", budget=60, resolution=32, device="cpu", formats=["G(5)", "R(5^3)"], threads=1, progress=bar)
        self.assertEqual({row["format"] for row in rows}, {"G(5)", "R(5^3)"})
        self.assertTrue(bar.stages)
        for row in rows:
            self.assertIsNone(row["failure"])
            self.assertEqual(row["wrong_rays"], 0)
            self.assertGreater(row["checked_rays"], 0)
            self.assertLessEqual(row["overview_slowest_rays_per_second"], row["overview_rays_per_second"])
            volume = voxc.build(row["format"], "builtin:terrain", resolution=32, passes=row["passes"])
            self.assertEqual(4 * len(volume.words), row["bytes"])
        self.assertEqual(sum(row["chosen"] for row in rows), 1)

    def test_searches_end(self):
        def stop(stage, fraction, done):
            raise ZeroDivisionError

        with self.assertRaises(ZeroDivisionError):
            voxc.search("builtin:terrain", resolution=64, device="cpu", progress=stop)
        with self.assertRaisesRegex(voxc.UsageError, "ended before one format was measured"):
            voxc.search("builtin:terrain", budget=1e-6, resolution=64, device="cpu")
        for seconds in (-1, float("inf"), float("nan")):
            with self.assertRaisesRegex(voxc.UsageError, "takes seconds, more than 0"):
                voxc.search("builtin:terrain", budget=seconds, resolution=64, device="cpu")
        with self.assertRaisesRegex(ValueError, "more than 0"):
            voxc.search("builtin:terrain", budget=0, resolution=64)
        with self.assertRaisesRegex(TypeError, "did you mean resolution"):
            voxc.search("builtin:terrain", resolutoin=64)


if __name__ == "__main__":
    unittest.main()
