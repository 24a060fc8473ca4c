"""Tests of volumes that change, and of what follows them: python3 -m unittest voxc_edits_test"""
import ctypes
import tempfile
import threading
import unittest

import numpy as np

import voxc

library = voxc._library


def full(text="G(3)", side=8):
    return voxc.build(text, voxels=np.ones((side, side, side), bool))


def is_waiting(function):
    """Starts a function in a thread, and tells the thread and whether it is still at it after a while."""
    thread = threading.Thread(target=function)
    thread.start()
    thread.join(0.2)
    return thread, thread.is_alive()


class Editing(unittest.TestCase):
    def test_a_function_of_an_edit_edits_nothing_itself(self):
        editable = voxc.Editable(full())
        state = editable.snapshot()
        for inner in (lambda: editable.set_box((0, 0, 0), (1, 1, 1), 0), lambda: editable.restore(state),
                      lambda: editable.apply((0, 0, 0), (1, 1, 1), lambda *_: 0)):
            with self.assertRaisesRegex(RuntimeError, "an edit of this volume is running"):
                editable.apply((0, 0, 0), (2, 2, 2), lambda *_: inner() or 0)
        self.assertEqual(editable.voxels, 512)
        editable.apply((0, 0, 0), (2, 2, 2), lambda *_: editable.view().voxels and 0)
        self.assertEqual(editable.voxels, 504)

    def test_a_function_in_c_edits_nothing_either(self):
        editable = voxc.Editable(full())
        tracer, first = editable.view().tracer("cpu"), editable.snapshot()
        editable.clear((0, 0, 0), (1, 1, 1))
        handle, low, size, made = editable._handle, library.int3((1, 1, 1), "low"), library.int3((1, 1, 1), "size"), ctypes.c_void_p()
        empty = library.EDITED_VOXEL(lambda *_: 0)
        calls = ((library.lib.voxc_editable_set_box, handle, low, size, 0), (library.lib.voxc_editable_apply, handle, low, size, empty, None),
                 (library.lib.voxc_editable_compact, handle, None, ctypes.byref(made)),
                 (library.lib.voxc_tracer_follow, tracer._handle, handle, None))
        told = set()

        def inner(*_):
            for function, *arguments in calls:
                try:
                    told.add(library.check(function(*arguments)))
                except voxc.UsageError as error:
                    told.add(str(error))
            library.lib.voxc_editable_restore(handle, first._state)
            return 0

        library.check(library.lib.voxc_editable_apply(handle, low, size, library.EDITED_VOXEL(inner), None))
        self.assertEqual(told, {"an edit of this volume is running, whose function must not edit, compact, follow or frame it"})
        self.assertEqual(editable.voxels, 510)
        editable.restore(first)
        self.assertEqual(editable.voxels, 512)

    def test_a_snapshot_within_a_function_is_of_the_state_before(self):
        editable, states = voxc.Editable(full("R(3, 3, 3)")), []
        function = library.EDITED_VOXEL(lambda *_: states.append(library.lib.voxc_editable_snapshot(editable._handle)) or 0)
        low, size = library.int3((0, 0, 0), "low"), library.int3((8, 8, 4), "size")
        library.check(library.lib.voxc_editable_apply(editable._handle, low, size, function, None))
        self.assertEqual(editable.voxels, 256)
        for state in (states[0], states[-1]):
            library.lib.voxc_editable_restore(editable._handle, state)
            self.assertEqual((editable.voxels, np.count_nonzero(editable.view().read())), (512, 512))

    def test_many_frames_that_repeat_are_read_again(self):
        editable = voxc.Editable(full("R(1, 1, 1)", 2))
        states = [editable.snapshot()]
        editable.clear((0, 0, 0), (1, 1, 1))
        states.append(editable.snapshot())
        with tempfile.TemporaryDirectory() as folder:
            path = folder + "/loop.hvx"
            editable.framed(states * 35000).save(path, compress=True)
            self.assertEqual(voxc.Volume.load(path, frame=70000).voxels, 7)

    def test_the_progress_of_a_compaction_edits_nothing(self):
        editable, made = voxc.Editable(full()), ctypes.c_void_p()
        reporter = library.Reporter(lambda *_: editable.clear((0, 0, 0), (4, 4, 4)))
        options = library.options(library.BuildOptions, progress=reporter.pointer)
        with self.assertRaisesRegex(voxc.UsageError, "a compaction of this volume is running, whose function must not edit"):
            reporter.call(library.lib.voxc_editable_compact, editable._handle, ctypes.byref(options), ctypes.byref(made))
        self.assertEqual(editable.compact().voxels, 512)

    def test_threads_wait_for_each_other(self):
        editable, threads = voxc.Editable(full()), []
        others = (lambda: editable.set_box((4, 0, 0), (1, 8, 8), 0), editable.view)

        def voxel(x, y, z, word):
            while len(threads) < len(others):
                threads.append(is_waiting(others[len(threads)]))
            return 0

        editable.apply((0, 0, 0), (1, 8, 8), voxel)
        for thread, was_waiting in threads:
            thread.join()
            self.assertTrue(was_waiting)
        self.assertEqual(editable.voxels, 512 - 2 * 64)


class Following(unittest.TestCase):
    RAY = (-1, 16.5, 16.5), (1, 0, 0)
    VIEW = {"eye": (60, 50, 70), "look": (16, 16, 16)}

    def setUp(self):
        # A grid of several blocks, which an edit changes without a word more in the first of them.
        volume = full("R(5, 5, 5)", 32)
        self.editable, self.tracer = voxc.Editable(volume), volume.tracer()

    def needs_a_device(self):
        if self.tracer.device == "cpu":
            self.skipTest("no device has a memory of its own")

    def test_rays_with_bounds_see_the_state_that_is_followed(self):
        editable = voxc.Editable(full())
        tracer = editable.view().tracer("cpu")
        tracer.follow(editable)
        editable.clear((0, 0, 0), (8, 8, 8))
        for bounds in ({"tmin": 0}, {}):
            hit = tracer.trace([[-1, 4.5, 4.5]], [[1, 0, 0]], **bounds)
            self.assertEqual(hit["voxel"].tolist(), [[0, 4, 4]])
        tracer.follow(editable)
        self.assertEqual(tracer.trace([[-1, 4.5, 4.5]], [[1, 0, 0]])["voxel"].tolist(), [[-1, -1, -1]])
        self.assertIn("<table>", editable.view()._repr_html_())

    def test_another_volume_takes_the_place_of_one_that_is_followed(self):
        self.needs_a_device()
        self.tracer.follow(self.editable)
        self.editable.clear((0, 0, 0), (12, 32, 32))
        self.tracer.update(self.editable.view())
        self.assertEqual(self.tracer.trace(*self.RAY)["voxel"].tolist(), [12, 16, 16])
        self.editable.clear((0, 0, 0), (20, 32, 32))
        copied = self.tracer.update(self.editable.view())
        self.assertEqual(self.tracer.trace(*self.RAY)["voxel"].tolist(), [20, 16, 16])
        self.assertEqual(self.tracer.update(self.editable.view()), 0)
        self.assertGreater(copied, 0)

    def test_what_followed_before_an_update_follows_again(self):
        self.needs_a_device()
        other = self.editable.view()
        self.editable.clear((0, 0, 0), (12, 32, 32))
        self.tracer.follow(self.editable)
        self.tracer.update(other)
        self.tracer.follow(self.editable)
        self.assertEqual(self.tracer.trace(*self.RAY)["voxel"].tolist(), [12, 16, 16])

    def test_changes_stay_where_following_fails(self):
        self.needs_a_device()
        other = full("G(5)", 32).tracer("cpu")
        self.editable.clear((0, 0, 0), (12, 32, 32))
        with self.assertRaisesRegex(voxc.UsageError, r"another format, R\(5, 5, 5\) \(digest 0x\w+\), than that of the tracer, G\(5\)"):
            other.follow(self.editable)
        self.assertGreater(self.tracer.follow(self.editable), 0)
        self.assertEqual(self.tracer.trace(*self.RAY)["voxel"].tolist(), [12, 16, 16])

    def test_threads_wait_for_each_other(self):
        tracer, threads = full("G(5)", 32).tracer("cpu"), []

        def report(*_):
            if not threads:
                threads.append(is_waiting(lambda: tracer.trace(*self.RAY)))

        tracer.render(64, 64, **self.VIEW, progress=report)
        [(thread, was_waiting)] = threads
        thread.join()
        self.assertTrue(was_waiting)

    def test_the_progress_of_a_picture_does_not_use_its_tracer(self):
        tracer, other = self.editable.view().tracer("cpu"), self.editable.view()
        for inner in (lambda: tracer.update(other), lambda: tracer.follow(self.editable), lambda: tracer.trace(*self.RAY), lambda: tracer.render(8, 8)):
            with self.assertRaisesRegex(RuntimeError, "a picture of this tracer is being made"):
                tracer.render(64, 64, **self.VIEW, clip_box=((0, 0, 0), (9, 9, 9)), progress=lambda *_: inner())
        self.assertEqual(tracer.render(8, 8).shape, (8, 8, 4))

    def test_a_picture_whose_progress_edits_waits_for_nobody(self):
        tracer, threads = self.editable.view().tracer("cpu"), []

        def report(*_):
            if not threads:
                threads.append(is_waiting(lambda: tracer.follow(self.editable)))
            self.editable.set_box((0, 0, 0), (1, 1, 1), 0)

        tracer.render(64, 64, **self.VIEW, progress=report)
        [(thread, was_waiting)] = threads
        thread.join()
        self.assertTrue(was_waiting)


if __name__ == "__main__":
    unittest.main()
