#!/usr/bin/env python3
"""Pages that read their volume by HTTP ranges, in a real browser: streamed-in-browser.py VOXC [V.hvx ...]

Every hit is compared with `voxc trace`'s, which the exact oracle has looked at, with little room for pages too; pictures with those of
`voxc render`; and what is wrong with a server or a file has to be said. Of compressed volumes that are named, pictures of 1280 and 390
pixels are left beside them, and their figures are printed, over a line of 100 Mbit/s.
"""
import contextlib
import json
import shutil
import sys
import tempfile
import time
import unittest
from pathlib import Path

import range_server
import volume_page
from volume_page import STATE, Browser, Page, differences, exact_hits, figures, hard_rays, render, voxc

PAGE_BYTES = 4096
LINE = 100e6
RAYS = 5000
# A tree, trees in a grid, references in granules, a search, values apart.
FORMATS = """
G(5) --restart-sv
R(2^3) G(3) --whole-level-dedup
R(2^3) G(0) G(3) --granules --granules
H(3^3) M(2^3) --share-grids --short-pointers
D(3^3,15) M(2^3) --octant-distances --df-packing --share-grids --values-apart
M(1^3) M(2^3) M(2^3) --payload auto --share-grids --values-apart
""".strip().splitlines()


class StreamedPage(Page):
    """A page on a server, which may not come to show anything."""

    def __enter__(self):
        Browser.__enter__(self)
        self.call("Page.navigate", url=self.path)
        return self

    def told(self, name):
        """What the page says of its pages, once that picture is there."""
        return json.loads(self.wait(f"({STATE}.pages && JSON.parse({STATE}.pages).moments.{name} && {STATE}.pages)"))

    def problem(self):
        """What the page says that is wrong."""
        end = time.monotonic() + 60
        while not (problem := self.evaluate(f"{STATE}.problem")):
            if time.monotonic() > end:
                raise TimeoutError("nothing is wrong")
            time.sleep(0.1)
        assert self.evaluate("document.getElementById('status').textContent") == "This page cannot be shown here: " + problem
        return problem


def stored(volume):
    """The volume in pages, beside it."""
    path = Path(volume).with_suffix(".pages.hvx")
    voxc("export", volume, "--compress", "--page-bytes", PAGE_BYTES, "-o", path)
    return path


def streamed(path, *options):
    """The page of such a volume, beside it, and the figures of its making."""
    page = path.with_name(path.stem + "".join(options) + ".html")
    return page, figures(path.with_suffix(".json"), "export", path, "-o", page, "--url", path.name, *options)


class StreamedPages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.kept.name)
        voxc("build", "R(3^3) G(5)", "builtin:terrain:256", "--whole-level-dedup", "-o", cls.folder / "terrain.hvx")
        cls.volume = stored(cls.folder / "terrain.hvx")
        cls.page, cls.made = streamed(cls.volume)

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    @contextlib.contextmanager
    def opened(self, page, size=(320, 240), **server):
        """An open page on a server; whatever it logs, and all that it asks for but its volume, is an error."""
        with range_server.serving(self.folder, **server) as line, StreamedPage(line.url + page.name, *size) as open_page:
            open_page.line = line
            yield open_page
            here = "it asks for " + line.url
            self.assertEqual([error for error in open_page.errors if not error.startswith((here, "it asks for blob:"))], [])
            self.assertEqual([path for path, _, _ in line.requests if path != "/" + page.name and not path.endswith(".hvx")], [])

    def test_every_hit_is_exact(self):
        for number, line in enumerate(FORMATS):
            text, *passes = line.replace(" --", "\n--").split("\n")
            with self.subTest(line):
                volume = self.folder / f"{number}.hvx"
                voxc("build", text, "builtin:terrain:32", *" ".join(passes).split(), "-o", volume)
                with self.opened(streamed(stored(volume))[0]) as page:
                    page.told("coarse")
                    rays = page.check_rays(RAYS) + hard_rays([32, 32, 32])
                    for precision in ("exact", "fast"):
                        hits, exact = page.trace(rays, precision), exact_hits(volume, rays, self.folder)
                        self.assertLessEqual(differences(hits, exact), 0 if precision == "exact" else len(exact) / 24)

    def test_hits_are_exact_with_little_room(self):
        page, _ = streamed(self.volume, "--device-memory", "400KiB")
        with self.opened(page) as page:
            told = page.told("coarse")
            self.assertLessEqual(told["slotBytes"] + 4 * told["pages"], 400 << 10)
            self.assertLess(told["slots"], told["pages"])
            rays = page.check_rays(1000)
            self.assertEqual(differences(page.trace(rays, "exact"), exact_hits(self.folder / "terrain.hvx", rays, self.folder)), 0)
            self.assertGreater(page.evaluate("voxc.pages.gone"), 0)

    def test_the_picture_is_that_of_render(self):
        samples = 2
        for size, options in (((320, 180), ()), ((390, 600), ()), ((320, 180), ("--device-memory", "400KiB"))):
            page, made = streamed(self.volume, *options)
            exposure = render(self.folder / "terrain.hvx", self.folder / "terrain.png", size, samples, made["camera"])
            with self.subTest(size=size, options=options), self.opened(page) as page:
                page.told("coarse")
                if size[0] < size[1]:
                    page.evaluate("voxc.camera.wide = 0") # voxc render takes no narrow picture by a wider angle.
                mean, far = page.difference(self.folder / "terrain.png", size, samples, exposure)
                self.assertLess(mean, 0.1)
                self.assertLess(far, 0.001)

    def test_cuts_and_parallel_rays_are_those_of_render(self):
        size, samples, cut = (320, 180), 2, "--clip-plane=-1,0,-0.7,-200"
        page, made = streamed(self.volume, cut, "--orthographic")
        exposure = render(self.folder / "terrain.hvx", self.folder / "cut.png", size, samples, f"{made['camera']} {cut}")
        with self.opened(page) as page:
            page.told("coarse")
            mean, far = page.difference(self.folder / "cut.png", size, samples, exposure)
            self.assertLess(mean, 0.5)
            self.assertLess(far, 0.02)
            page.wait(f"{STATE}.checked && JSON.parse({STATE}.checked).precision === 'exact'")
            self.assertEqual(json.loads(page.evaluate(f"{STATE}.checked")), {"precision": "exact", "others": 0, "worst": 0})

    def test_is_small_and_says_what_it_reads(self):
        self.assertLess(self.page.stat().st_size, 60000)
        with self.opened(self.page) as page:
            page.wait(f"{STATE}.checked && JSON.parse({STATE}.checked).precision === 'exact'")
            self.assertEqual(json.loads(page.evaluate(f"{STATE}.checked")), {"precision": "exact", "others": 0, "worst": 0})
            text = page.evaluate("document.getElementById('about').textContent")
            told = page.told("lit")
            self.assertIn(f"{told['read']:,} of {told['pages']:,} read", text)
            self.assertEqual(told["gone"], 0)
            asked = [end - begin for path, begin, end in page.line.requests if path.endswith(".hvx")]
            self.assertLess(max(asked), self.volume.stat().st_size) # Never the whole file, nor any part twice.
            self.assertLessEqual(sum(asked), self.volume.stat().st_size)

    def test_first_picture_needs_few_requests(self):
        with self.opened(self.page, (1280, 800)) as page:
            told = page.told("coarse")
            self.assertLessEqual(told["rounds"], 3) # The page knows which pages that picture looks at.

    def wrong(self, change, **server):
        """What the page says of a file that was changed."""
        good = self.volume.read_bytes()
        try:
            self.volume.write_bytes(change(bytearray(good)))
            with range_server.serving(self.folder, **server) as line, StreamedPage(line.url + self.page.name) as page:
                return page.problem()
        finally:
            self.volume.write_bytes(good)

    def test_says_what_is_wrong_with_a_file(self):
        def flipped(at):
            def flip(file):
                file[at] ^= 1
                return file
            return flip

        name, size = self.volume.name, self.volume.stat().st_size
        self.assertRegex(self.wrong(flipped(-1)), f"^page \\d+ of {name} is not what was stored: it is damaged, or has changed while it was read$")
        self.assertEqual(self.wrong(flipped(400)), f"{name} is damaged: its checksum does not match its head")
        self.assertEqual(self.wrong(flipped(16)), f"{name} is not the volume that this page was made of, or has changed since: export the page again")
        self.assertEqual(self.wrong(lambda file: file[:-1]), f"{name} has {size - 1} bytes, and the volume of this page has {size}: it was cut short, or is another")

    def test_says_what_is_wrong_with_a_server(self):
        name = self.volume.name
        self.assertEqual(self.wrong(bytes, knows_ranges=False),
                         f"the server sends the whole of {name} where a part of it was asked for: put it on a server that answers HTTP range requests")
        page, _ = streamed(shutil.copy(self.volume, self.folder / "gone.hvx") and self.folder / "gone.hvx")
        (self.folder / "gone.hvx").unlink()
        with range_server.serving(self.folder) as line, StreamedPage(line.url + page.name) as open_page:
            self.assertEqual(open_page.problem(), "gone.hvx cannot be read: the server answers 404 Not Found")
        with StreamedPage("file://" + str(self.page)) as open_page:
            self.assertRegex(open_page.problem(), "^browsers let no page read files beside it: .* http://localhost:8000/terrain.pages.html$")

    def test_says_that_a_file_changes_or_a_server_ends(self):
        good = self.volume.read_bytes()

        def replace(contents): # At once, so that no answer is made of a file that is half written.
            other = self.folder / "other.hvx"
            other.write_bytes(contents)
            other.replace(self.volume)

        # Cut in the middle of the pages, so that what has not been read is not there any more or lies behind the end.
        for change, words in ((lambda: replace(good[:-4096] + bytes(4096)), "has changed while it was read"),
                              (lambda: replace(good[:len(good) // 2]), "was cut short"),
                              (lambda: replace(good[:1]), "was cut short"),
                              (lambda: self.line.close(), "cannot be read at")):
            page, _ = streamed(self.volume, "--device-memory", "400KiB") # So that it asks again.
            try:
                with range_server.serving(self.folder) as self.line, StreamedPage(self.line.url + page.name) as open_page:
                    open_page.told("coarse")
                    change()
                    self.assertIn(words, open_page.problem())
            finally:
                self.volume.write_bytes(good)


def look_at(volume):
    """Pictures of a page over a line of 100 Mbit/s, and its figures."""
    volume = Path(volume)
    page, _ = streamed(volume)
    print(f"{volume.name}: page {page.stat().st_size} bytes, volume {volume.stat().st_size}")
    for width, height in ((1280, 800), (390, 844)):
        with range_server.serving(volume.parent, LINE) as line, StreamedPage(line.url + page.name, width, height) as opened:
            told = opened.told("coarse")
            opened.picture(volume.with_name(f"{volume.stem}-{width}-coarse.png"), height=height)
            print(f"  {width}x{height}: first pixels after {told['moments']['first']} ms, a coarse picture after {told['moments']['coarse']} ms")
            told = opened.told("lit")
            asked = sum(end - begin for path, begin, end in line.requests if path.endswith(".hvx"))
            print(f"  every pixel after {told['moments']['fine']} ms, in its light after {told['moments']['lit']} ms")
            print(f"  {told['read']} of {told['pages']} pages, {asked} bytes in {len(line.requests) - 1} requests, {told['gone']} went, {told['slotBytes'] + told['tableBytes']} bytes of room")
            opened.wait(f"{STATE}.checked")
            print("  check of 1,024 rays:", opened.evaluate(f"{STATE}.checked"))
            opened.picture(volume.with_name(f"{volume.stem}-{width}.png"), height=height)


if __name__ == "__main__":
    volume_page.VOXC = sys.argv.pop(1)
    if len(sys.argv) > 1 and sys.argv[1].endswith(".hvx"):
        for path in sys.argv[1:]:
            look_at(path)
    else:
        unittest.main()
