"""Tests of building: python3 -m unittest voxc_test voxc_trace_test voxc_edits_test voxc_arrays_test runs all of the module"""
import os
import pathlib
import re
import signal
import subprocess
import sys
import tempfile
import unittest

import numpy as np

import voxc


def ball(side=32):
    """A ball in RGBA words [z, y, x], coloured by place."""
    z, y, x = np.indices((side, side, side))
    inside = (x - side / 2) ** 2 + (y - side / 2) ** 2 + (z - side / 2) ** 2 <= (0.4 * side) ** 2
    words = (4 * x | 4 * y << 8 | 4 * z << 16 | 0xFF000000).astype(np.uint32)
    return np.where(inside, words, np.uint32(0))


class Building(unittest.TestCase):
    def test_grid_is_read_back(self):
        words = ball()
        volume = voxc.build("R(2, 2, 2) G(3)", voxels=words, passes=["whole-level-dedup"])
        self.assertEqual(volume.extent, (32, 32, 32))
        self.assertEqual(volume.voxels, np.count_nonzero(words))
        np.testing.assert_array_equal(volume.read(), words)
        np.testing.assert_array_equal(volume.read((3, 4, 5), (6, 7, 8)), words[5:13, 4:11, 3:9])
        self.assertEqual(volume.read((-2, 0, 0), (2, 1, 1)).tolist(), [[[0, 0]]])

    def test_axes_are_z_y_x(self):
        words = np.zeros((2, 3, 4), np.uint32)
        words[1, 2, 3] = 7
        volume = voxc.build("R(2, 2, 2)", voxels=words)
        self.assertEqual(volume.extent, (4, 3, 2))
        self.assertEqual(volume.read((3, 2, 1), (1, 1, 1)).item(), 7)

    def test_kinds_of_arrays(self):
        solid = ball() != 0
        colours = np.zeros((*solid.shape, 4), np.uint8)
        colours[solid] = 9, 8, 7, 255
        grey = np.full((*solid.shape, 3), 0, np.uint8)
        grey[solid] = 9, 8, 7
        for voxels, word in ((solid, 0xFFFFFFFF), (colours, 0xFF070809), (grey, 0xFF070809)):
            read = voxc.build("G(5)", voxels=voxels).read()
            np.testing.assert_array_equal(read, np.where(solid, np.uint32(word), np.uint32(0)))
        with self.assertRaisesRegex(ValueError, r"indexed \[z, y, x\]"):
            voxc.build("G(5)", voxels=np.zeros(5))

    def test_nothing_is_cast_or_dropped_in_silence(self):
        floats = np.random.default_rng(1).random((8, 8, 8))
        whole = np.full((4, 4, 4), 2**32)
        refused = {
            "densities= takes such numbers": [floats.astype("f4"), floats * 255, floats.astype("f2")],
            "are from 0 to 4294967295": [whole, -whole, whole.astype("u8")],
            "labels= takes labels": [np.arange(64).reshape(4, 4, 4), np.full((4, 4, 4), 7, np.uint8),
                                     np.full((4, 4, 4), 300, np.int16), np.full((4, 4, 4), 2**24 - 1)],
            "words are uint32, not": [np.full((4, 4, 4), "x"), np.full((4, 4, 4), None)],
            "uint8 with 3 or 4 channels": [np.zeros((4, 4, 4, 2), np.uint8), np.zeros((4, 4, 4, 3))],
            r"indexed \[z, y, x\]": [np.zeros((4, 4)), 5],
        }
        for sentence, arrays in refused.items():
            for voxels in arrays:
                with self.subTest(sentence=sentence, dtype=np.asarray(voxels).dtype):
                    with self.assertRaisesRegex(ValueError, sentence):
                        voxc.build("G(5)", voxels=voxels)
        words = np.full((4, 4, 4), 0xFF0000FF)  # Words with an alpha are what they seem to be, whatever holds them.
        np.testing.assert_array_equal(voxc.build("G(2)", voxels=words).read(), words.astype(np.uint32))

    def test_arrays_of_every_kind_are_kept_or_refused(self):
        words = np.arange(1, 25, dtype=np.uint32).reshape(2, 3, 4) | np.uint32(0xFF000000)
        mask = (words & 1).astype(bool)
        labels = np.arange(24, dtype=np.uint16).reshape(2, 3, 4) * 2849  # Up to 65527.
        spread = np.zeros((4, 6, 8), np.uint32)
        spread[::2, ::2, ::2] = words
        read_only = words.copy()
        read_only.flags.writeable = False
        kept = [  # Kinds of arrays that hold what they seem to hold, and what is to be read back.
            ("bool", dict(voxels=mask), np.where(mask, 0xFFFFFFFF, 0)),
            ("Fortran order", dict(voxels=np.asfortranarray(words)), words),
            ("not contiguous", dict(voxels=spread[::2, ::2, ::2]), words),
            ("turned around", dict(voxels=words[::-1, :, ::-1]), words[::-1, :, ::-1]),
            ("transposed", dict(voxels=words.T), words.T),
            ("read only", dict(voxels=read_only), words),
            ("big-endian words", dict(voxels=words.astype(">u4")), words),
            ("small big-endian words", dict(voxels=np.full((2, 2, 2), 7, ">u4")), np.full((2, 2, 2), 7)),
            ("int64 with an alpha", dict(voxels=words.astype(np.int64)), words),
            ("nested lists", dict(voxels=words.tolist()), words),
            ("a view of bytes", dict(voxels=words.view(np.uint8).reshape(2, 3, 4, 4)), words),
            ("uint16 labels", dict(labels=labels), labels),
            ("big-endian labels", dict(labels=labels.astype(">u2")), labels),
            ("int8 labels", dict(labels=np.arange(8, dtype=np.int8).reshape(2, 2, 2)), np.arange(8).reshape(2, 2, 2)),
            ("bool labels", dict(labels=mask), mask),
            ("int64 labels", dict(labels=labels.astype(np.int64)), labels),
            ("float16 densities", dict(densities=(labels / 65536).astype("f2"), threshold=0.5), None),
            ("int8 densities", dict(densities=np.arange(-4, 4, dtype=np.int8).reshape(2, 2, 2), threshold=-1.5), None),
            ("big-endian densities", dict(densities=labels.astype(">f8"), threshold=30000), None),
        ]
        for kind, given, expected in kept:
            with self.subTest(kind):
                read = voxc.build("R(2, 2, 2)" if kind != "transposed" else "G(3)", **given).read()
                if expected is None:
                    np.testing.assert_array_equal(read != 0, given["densities"].astype(float) >= given["threshold"])
                else:
                    np.testing.assert_array_equal(read, np.asarray(expected).astype(np.uint32))
        refused = [
            ("complex", dict(voxels=words * 1j), "words are uint32, not complex"),
            ("complex densities", dict(densities=words * 1j, threshold=1), "densities are numbers"),
            ("objects", dict(voxels=words.astype(object)), "words are uint32, not object"),
            ("texts", dict(labels=labels.astype(str)), "labels are whole numbers, not <U"),
            ("bytes", dict(greys=labels.astype("S")), "greys are uint8"),
            ("dates", dict(labels=labels.astype("M8[s]")), "labels are whole numbers"),
            ("structures", dict(voxels=np.zeros((2, 2, 2), "u1,u1")), "words are uint32"),
            ("masked words", dict(voxels=np.ma.masked_equal(words, words[0, 0, 0])), "voxels are a masked array"),
            ("masked labels", dict(labels=np.ma.masked_equal(labels, 0)), "labels are a masked array"),
            ("masked densities", dict(densities=np.ma.masked_equal(labels, 0), threshold=1), "densities are a masked array"),
            ("int8 below 0", dict(labels=np.full((2, 2, 2), -1, np.int8)), "labels are from 0"),
            ("uint32 labels above 65535", dict(labels=np.full((2, 2, 2), 65536, np.uint32)), "from 0 to 65535, and these from 65536"),
            ("whole float labels", dict(labels=labels.astype(float)), "labels are whole numbers, not float64"),
            ("NaN", dict(densities=np.full((2, 2, 2), np.nan, "f4"), threshold=0), "no number"),
            ("infinity", dict(densities=np.full((2, 2, 2), np.inf), threshold=0), "infinite"),
            ("no voxel", dict(voxels=np.zeros((0, 3, 4), np.uint32)), "at least one voxel an axis"),
            ("no colour", dict(voxels=np.zeros((2, 0, 4, 4), np.uint8)), "at least one voxel an axis"),
            ("no axis", dict(voxels=np.uint32(7)), r"indexed \[z, y, x\]"),
            ("two channels", dict(voxels=np.zeros((2, 3, 4, 2), np.uint8)), "3 or 4 channels"),
            ("colours of 16 bits", dict(voxels=np.zeros((2, 3, 4, 4), np.uint16)), "3 or 4 channels"),
            ("five axes", dict(voxels=np.zeros((2, 3, 4, 4, 4), np.uint8)), r"indexed \[z, y, x\]"),
            ("masked places", dict(places=np.ma.masked_equal(np.ones((2, 3), int), 0)), "places are a masked array"),
            ("infinite places", dict(places=[[np.inf, 0, 0]]), "places are"),
            ("complex places", dict(places=[[1j, 0, 0]]), "places are whole numbers"),
            ("object places", dict(places=np.ones((2, 3), object)), "places are whole numbers"),
            ("flat places", dict(places=[1, 2, 3]), r"\(n, 3\)"),
        ]
        for kind, given, sentence in refused:
            with self.subTest(kind), self.assertRaisesRegex(ValueError, sentence):
                voxc.build("R(3, 3, 3)", **given)

    def test_elements_are_kept_or_refused(self):
        volume = voxc.build("M(1, 1, 1)", voxels=np.full((1, 1, 2), 0xFF000007, np.uint32), passes="values-apart")
        self.assertEqual(volume.with_attribute("n", np.array([1, 258], ">u2")).attribute("n").view("<u2")[:, 0].tolist(), [1, 258])
        for elements in (np.ones(2, object), np.array(["a", "b"]), np.ma.masked_equal([1, 2], 1), np.ones(3), np.float32(1)):
            with self.assertRaises(ValueError):
                volume.with_attribute("n", elements)

    def test_places_are_kept_or_refused(self):
        for places in ([[1.9, 2.9, 3.9]], [[2**32 + 1, 2, 3]], [["1", "2", "3"]], [[np.nan, 0, 0]], [[True, False, True]]):
            with self.assertRaisesRegex(ValueError, "places are"):
                voxc.build("G(5)", places=places)
        for colours in ([1.5], [2**33], [7], np.zeros((1, 4))):
            with self.assertRaises(ValueError):
                voxc.build("G(5)", places=[[1, 2, 3]], colours=np.asarray(colours))
        self.assertEqual(voxc.build("G(5)", places=[[1.0, 2.0, 3.0]]).extent, (2, 3, 4))

    def test_labels_greys_and_densities(self):
        labels = np.arange(64, dtype=np.uint8).reshape(4, 4, 4)
        np.testing.assert_array_equal(voxc.build("G(2)", labels=labels).read(), labels)
        np.testing.assert_array_equal(voxc.build("G(2)", greys=labels).read(),
                                      np.where(labels, labels * np.uint32(0x010101) | np.uint32(0xFF000000), 0))
        densities = np.linspace(-1, 1, 64).reshape(4, 4, 4)
        read = voxc.build("G(2)", densities=densities, threshold=0.5).read()
        np.testing.assert_array_equal(read != 0, densities >= 0.5)
        self.assertEqual(read[3, 3, 3], 0xFFFFFFFF)
        self.assertLess(read[densities >= 0.5].min(), 0xFF101010)
        for given, sentence in (({"labels": labels - 1.0}, "labels are whole numbers"), ({"labels": labels.astype(int) - 1}, "labels are from 0"),
                                ({"greys": labels.astype(int)}, "greys are uint8"), ({"densities": densities}, "need a threshold"),
                                ({"densities": densities, "threshold": 2}, "no density reaches the threshold 2"),
                                ({"densities": np.full((4, 4, 4), np.nan), "threshold": 0}, "no number"),
                                ({"densities": densities, "threshold": np.nan}, "need a threshold")):
            with self.assertRaisesRegex(ValueError, sentence):
                voxc.build("G(2)", **given)

    def test_options_are_named(self):
        solid = np.ones((2, 2, 2), bool)
        volume = voxc.build("G(1)", voxels=solid)
        for call, sentence in (
                (lambda: voxc.build("G(5)", "builtin:terrain:32", resoluton=32), "build has no option resoluton; did you mean resolution[?]"),
                (lambda: voxc.build("G(5)", voxels=solid, thread=2), "build has no option thread; did you mean threads[?]"),
                (lambda: voxc.build("G(5)", voxels=solid, zzz=2), "build has no option zzz; there are input, voxels, labels"),
                (lambda: volume.tracer("cpu", outputz="t"), "tracer has no option outputz; did you mean outputs[?]"),
                (lambda: volume.trace((0, 0, 0), (1, 0, 0), "cpu", quarry="any"), "trace has no option quarry; did you mean query[?]"),
                (lambda: volume.render(8, 8, "cpu", stile="flat"), "render has no option stile; did you mean style[?]")):
            with self.assertRaisesRegex(TypeError, sentence):
                call()

    def test_what_means_nothing_is_refused(self):
        solid = np.ones((2, 2, 2), bool)
        for given, sentence in ((dict(voxels=solid, colours=[1]), "colours is for places"), (dict(voxels=solid, extent=(2, 2, 2)), "extent is for"),
                                (dict(voxels=solid, is_empty=bool), "is_empty is for functions"), (dict(voxels=solid, window=(0, 1)), "window is for"),
                                (dict(voxels=solid, z_up=True), "z_up is for files"), (dict(voxels=solid, threshold=1), "threshold is for"),
                                (dict(voxels=solid, compress=True), "compress is for a path")):
            with self.assertRaisesRegex(TypeError, sentence):
                voxc.build("G(1)", **given)
        with self.assertRaisesRegex(TypeError, "passes is for formats that are texts"):
            voxc.build(voxc.Format("G(1)"), voxels=solid, passes="values-apart")
        with self.assertRaisesRegex(ValueError, "extent is three whole numbers of 32 bits, along x, y and z, and not"):
            voxc.build("G(1)", voxel=lambda x, y, z: 1, extent=(2, 2))

    def test_what_a_function_raises_is_raised(self):
        for voxel, sentence in ((lambda x, y, z: 1 // 0, "division"), (lambda x, y, z: 1.5, "not 1.5"), (lambda x, y, z: -1, "not -1")):
            with self.assertRaisesRegex((ZeroDivisionError, ValueError), sentence):
                voxc.build("G(2)", voxel=voxel, extent=(4, 4, 4))

    def test_places_and_functions(self):
        words = ball()
        z, y, x = np.nonzero(words)
        places = np.stack([x, y, z], 1)
        listed = voxc.build("G(5)", places=places, colours=words[z, y, x], extent=(32, 32, 32))
        called = voxc.build("G(5)", voxel=lambda x, y, z: words[z, y, x], extent=(32, 32, 32))
        gridded = voxc.build("G(5)", voxels=words)
        self.assertEqual(listed.words.tolist(), gridded.words.tolist())
        self.assertEqual(called.words.tolist(), gridded.words.tolist())
        twice = voxc.build("G(5)", places=[[1, 2, 3], [1, 2, 3]], colours=np.array([5, 6], np.uint32))
        self.assertEqual((twice.extent, twice.read((1, 2, 3), (1, 1, 1)).item()), ((2, 3, 4), 6))
        with self.assertRaisesRegex(voxc.Error, "voxel 0 lies at -1, 0, 0, outside"):
            voxc.build("G(5)", places=[[-1, 0, 0]])
        with self.assertRaisesRegex(voxc.Error, "a grid of 2147483647x1x1 cells is not possible: each axis takes 1 to 2097152"):
            voxc.build("G(5)", places=[[2**31 - 1, 0, 0]])

    def test_files(self):
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "terrain.hvx"
            built = voxc.build("R(2, 2, 2) G(4)", "builtin:terrain", path=path)
            built.save(pathlib.Path(folder) / "copy.hvx", compress=True)
            for name in ("terrain.hvx", "copy.hvx"):
                loaded = voxc.Volume.load(pathlib.Path(folder) / name)
                self.assertEqual(loaded.words.tolist(), built.words.tolist())
                self.assertEqual(loaded.format, built.format)
            with self.assertRaisesRegex(voxc.Error, "No such file"):
                voxc.Volume.load(pathlib.Path(folder) / "none.hvx")

    def test_a_header_fits_volumes_of_its_format_alone(self):
        volume = voxc.build("R(4, 4, 4) G(5)", "builtin:terrain:32")
        for format, fits in (("G(9)", False), ("R(4, 4, 4) G(5)", True)):
            [digest] = re.findall(r"#define VOXC_SCENE_STORAGE_DIGEST 0x(\w+)ull", voxc.Format(format).header("scene"))
            self.assertEqual(int(digest, 16) == volume.digest, fits)

    def test_errors_are_the_sentences_of_the_tools(self):
        with self.assertRaisesRegex(voxc.Error, "error: .*Q"):
            voxc.Format("Q(3)")
        with self.assertRaisesRegex(voxc.Error, "'nothing' is no pass; the passes are whole-level-dedup") as caught:
            voxc.Format("G(3)", "nothing")
        self.assertEqual(caught.exception.kind, "usage")
        with self.assertRaises(voxc.Error):
            voxc.build("G(2)", voxels=ball())

    def test_progress_can_stop(self):
        def stop(stage, fraction, done):
            raise LookupError(stage)

        with self.assertRaises(LookupError):
            voxc.build("R(3, 3, 3) G(5)", "builtin:terrain", progress=stop)


    def test_control_c_says_nothing_of_its_own(self):
        # Another thread presses it while this one is in the library, whose next callback would be the first to see it.
        program = ("import os, signal, threading, time, voxc\n"
                   "signal.signal(signal.SIGINT, signal.default_int_handler)  # Whoever starts this may ignore it.\n"
                   "began = threading.Event()\n"
                   "def press(): began.wait(); time.sleep(0.05); os.kill(os.getpid(), signal.SIGINT)\n"
                   "threading.Thread(target=press).start()\n"
                   "try: voxc.build('R(3, 3, 3) G(7)', 'builtin:terrain', progress=lambda *_: began.set()); time.sleep(60)\n"
                   "except KeyboardInterrupt: print('interrupted')\n"
                   "print(signal.getsignal(signal.SIGINT) is signal.default_int_handler, voxc.build('G(3)', 'builtin:full:8').voxels)\n")
        done = subprocess.run([sys.executable, "-c", program], capture_output=True, text=True)
        self.assertEqual((done.stdout, done.stderr), ("interrupted\nTrue 512\n", ""))

    def test_handlers_of_the_program_stay(self):
        came = []
        former = signal.signal(signal.SIGINT, lambda *_: came.append(True))
        try:
            voxc.build("G(5)", "builtin:terrain:32", progress=lambda *_: came or signal.raise_signal(signal.SIGINT))
        finally:
            signal.signal(signal.SIGINT, former)
        self.assertTrue(came)

    def test_auto_is_a_format(self):
        words = ball()
        volume = voxc.build("auto", voxels=words)
        np.testing.assert_array_equal(volume.read(), words)
        with tempfile.TemporaryDirectory() as folder:
            path = pathlib.Path(folder) / "menger.hvx"
            built = voxc.build("auto", "builtin:menger", resolution=27, path=path, threads=1)
            np.testing.assert_array_equal(built.read(), voxc.build("G(5)", "builtin:menger:27").read())
            self.assertEqual(voxc.Volume.load(path).digest, built.digest)
        with self.assertRaisesRegex(voxc.Error, "No such file"):
            voxc.build("auto", "no/such.obj")
        with self.assertRaisesRegex(TypeError, "passes and progress are for a format that is named"):
            voxc.build("auto", voxels=words, passes="values-apart")
        program, os.environ["VOXC"] = os.environ.get("VOXC"), "/no/such/voxc"
        try:
            with self.assertRaisesRegex(voxc.Error, "runs the program voxc, and '/no/such/voxc' cannot be run"):
                voxc.build("auto", voxels=words)
        finally:
            del os.environ["VOXC"]
            if program is not None:
                os.environ["VOXC"] = program

    def test_formats_are_told_in_short_and_in_full(self):
        format = voxc.Format("R(2^3) G(3)", "values-apart")
        self.assertEqual((format.text, str(format)), ("R(2, 2, 2) G(3)",) * 2)
        volume = voxc.build(format, voxels=ball())
        self.assertEqual(volume.format, "R(2, 2, 2) G(3)")
        self.assertEqual(voxc.build(volume.ir, voxels=ball()).digest, volume.digest)



if __name__ == "__main__":
    unittest.main()
