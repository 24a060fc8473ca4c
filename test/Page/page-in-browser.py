#!/usr/bin/env python3
"""Pages of volumes in a real browser: page-in-browser.py VOXC [V.hvx ...]

Every hit that a page finds is compared with `voxc trace`'s, which the exact oracle has looked at, and pictures with those of
`voxc render`. Of volumes that are named, pictures of 1280 and 390 pixels are left beside them, and their figures are printed.
"""
import contextlib
import json
import math
import subprocess
import sys
import tempfile
import time
import unittest
from pathlib import Path

import volume_page
from volume_page import STATE, Browser, Page, differences, exact_hits, figures, hard_rays, other_voxels, page_of, render, voxc

RAYS = 20000
# One of each kind of level, traversal and payload.
FORMATS = """
R(2^3) G(3) --whole-level-dedup
G(5) --restart-sv --inline-leaves
G(6, 2) --unroll-sv
S(5)
S(2) S(3) --flat-traversal
D(3^3,6) R(2^3) --direct-traversal
D(2^3,15) G(3) --df-packing
D(3^3,15) M(2^3) --octant-distances --df-packing --share-grids --values-apart
H(3^3) M(2^3) --share-grids --short-pointers
M(1^3) M(2^3) M(2^3) --payload auto --share-grids --values-apart
R(1^3) G(4) --values-apart --payload auto
R(2^3) G(0) G(3) --granules --granules
G(5) --rgb565
""".strip().splitlines()


def ball_mesh():
    """A sphere of triangles, as .obj."""
    turns, rings = 48, 24
    lines = []
    for ring in range(rings + 1):
        for turn in range(turns):
            tilt, angle = math.pi * ring / rings, 2 * math.pi * turn / turns
            lines.append(f"v {math.sin(tilt) * math.cos(angle)} {math.cos(tilt)} {math.sin(tilt) * math.sin(angle)}")
    for ring in range(rings):
        for turn in range(turns):
            a, b = ring * turns + turn + 1, ring * turns + (turn + 1) % turns + 1
            lines.append(f"f {a} {b} {b + turns} {a + turns}")
    return "\n".join(lines) + "\n"


class PagesOfAnyDevice:
    """Tests of pages that draw by `device`, which they call `name`."""

    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.kept.name)
        voxc("build", "R(2^3) G(4)", "builtin:terrain:64", "--whole-level-dedup", "-o", cls.folder / "terrain.hvx")
        cls.page, cls.made = page_of(cls.folder / "terrain.hvx", cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    @contextlib.contextmanager
    def opened(self, path, *size):
        """An open page; whatever it logs or asks the network for is an error."""
        with Page(path, *size, device=self.device) as page:
            self.assertEqual(page.evaluate(f"{STATE}.device"), self.name)
            yield page
            self.assertEqual(page.errors, [])

    def test_every_hit_is_exact(self):
        for number, line in enumerate(FORMATS):
            text, *passes = line.replace(" --", "\n--").split("\n")
            with self.subTest(line):
                volume = self.folder / f"{number}.hvx"
                voxc("build", text, "builtin:terrain:32", *" ".join(passes).split(), "-o", volume)
                with self.opened(page_of(volume, self.folder)[0]) as page:
                    rays = page.check_rays(RAYS) + hard_rays([32, 32, 32])
                    self.assertEqual(differences(page.trace(rays, "exact"), exact_hits(volume, rays, self.folder)), 0)

    def test_frames_are_chosen_and_played(self):
        animation, volume = self.folder / "roll.vox", self.folder / "roll.hvx"
        subprocess.run([sys.executable, volume_page.HERE.parent / "Edit" / "Inputs" / "animation.py", "write", animation], check=True)
        voxc("build", "R(2^3) G(3)", animation, "--whole-level-dedup", "--frames", "-o", volume)
        with self.opened(page_of(volume, self.folder)[0]) as page:
            rays = page.check_rays(RAYS)
            self.assertEqual(differences(page.trace(rays, "exact"), exact_hits(volume, rays, self.folder)), 0)
            for frame in (4, 2, 5, 1):
                page.evaluate(f"(f => {{ f.value = {frame}; f.dispatchEvent(new Event('input')); }})(document.getElementById('frame'))")
                page.wait(f"{STATE}.frame === '{frame}'")
                with self.subTest(frame=frame):
                    self.assertEqual(differences(page.trace(rays, "exact"), exact_hits(f"{volume}#{frame}", rays, self.folder)), 0)
            page.evaluate("document.getElementById('play').click()")
            for frame in (2, 3):
                page.wait(f"+{STATE}.frame >= {frame}")
            page.evaluate("document.getElementById('play').click()")
            self.assertEqual(page.evaluate("document.getElementById('play').textContent"), "Play")
        with self.opened(self.page) as page:
            self.assertFalse(page.evaluate("!!document.getElementById('frames')"))

    def test_fast_hits_are_seldom_others(self):
        with self.opened(self.page) as page:
            rays = page.check_rays(RAYS)
            exact = exact_hits(self.folder / "terrain.hvx", rays, self.folder)
            self.assertLess(other_voxels(page.trace(rays, "fast"), exact), RAYS / 1000)

    def test_the_picture_is_that_of_render(self):
        size, samples = (320, 180), 4
        for view in ("iso", "top"):
            page, made = page_of(self.folder / "terrain.hvx", self.folder, "--view", view)
            exposure = render(self.folder / "terrain.hvx", self.folder / "terrain.png", size, samples, made["camera"])
            with self.subTest(view), self.opened(page) as page:
                mean, far = page.difference(self.folder / "terrain.png", size, samples, exposure)
                self.assertLess(mean, 0.1)
                self.assertLess(far, 0.001)

    def test_smooth_surfaces_are_nearly_those_of_render(self):
        size, samples, ball = (320, 180), 4, self.folder / "ball.obj"
        ball.write_text(ball_mesh())
        voxc("build", "G(7)", ball, "-o", self.folder / "ball.hvx")
        page, made = page_of(self.folder / "ball.hvx", self.folder)
        exposure = render(self.folder / "ball.hvx", self.folder / "ball.png", size, samples, made["camera"])
        with self.opened(page) as page:
            mean, far = page.difference(self.folder / "ball.png", size, samples, exposure)
            self.assertLess(mean, 2)
            self.assertLess(far, 0.05)
            page.evaluate("voxc.scene.smooth = false")
            self.assertGreater(page.difference(self.folder / "ball.png", size, samples, exposure)[1], 2 * far)

    def test_scans_have_their_spacing(self):
        size, samples, scan = (320, 180), 4, self.folder / "scan.nii"
        subprocess.run([sys.executable, volume_page.HERE.parent / "Driver" / "Inputs" / "ball.py", scan], check=True)
        voxc("build", "R(3^3) G(4)", scan, "-o", self.folder / "scan.hvx")
        page, made = page_of(self.folder / "scan.hvx", self.folder)
        exposure = render(self.folder / "scan.hvx", self.folder / "scan.png", size, samples, made["camera"])
        with self.opened(page) as page:
            self.assertEqual(page.evaluate("voxc.scene.spacing"), [1, 3, 1])
            mean, far = page.difference(self.folder / "scan.png", size, samples, exposure)
            self.assertLess(mean, 2)
            self.assertLess(far, 0.05)
        # Voxels as cubes are another picture.
        with self.opened(page_of(self.folder / "scan.hvx", self.folder, "--cubic-voxels")[0]) as page:
            self.assertGreater(page.difference(self.folder / "scan.png", size, samples, exposure)[1], 0.2)

    def test_cuts_and_parallel_rays_are_those_of_render(self):
        size, samples, scan = (320, 180), 4, self.folder / "cut.nii"
        subprocess.run([sys.executable, volume_page.HERE.parent / "Driver" / "Inputs" / "ball.py", scan], check=True)
        voxc("build", "R(3^3) G(4)", scan, "-o", self.folder / "cut.hvx")
        parallel = ["--orthographic"]
        for volume, cuts, camera in (("terrain", [], parallel), ("terrain", ["--clip-box=0,0,0,40,64,40"], []), ("terrain", ["--clip-plane=-1,0,-0.7,-50"], []),
                                     ("cut", ["--clip-plane=-1,-0.4,0.2,-30.3"], parallel)):
            volume = self.folder / f"{volume}.hvx"
            made = figures(self.folder / "figures.json", "export", volume, "-o", self.folder / "cut.html", *cuts, *camera)
            picture = self.folder / "cut.png"
            exposure = render(volume, picture, size, samples, " ".join([made["camera"], *cuts]))
            with self.subTest(cuts=cuts, camera=camera), self.opened(self.folder / "cut.html", *size) as page:
                mean, far = page.difference(picture, size, samples, exposure)
                self.assertLess(mean, 0.5)
                self.assertLess(far, 0.01)
                page.wait(f"{STATE}.checked && JSON.parse({STATE}.checked).precision === 'exact'")
                self.assertEqual(json.loads(page.evaluate(f"{STATE}.checked")), {"precision": "exact", "others": 0, "worst": 0})
                # Rays that are asked for are those of all of the volume.
                rays = page.check_rays(RAYS)
                self.assertEqual(differences(page.trace(rays, "exact"), exact_hits(volume, rays, self.folder)), 0)
                # The picture of all of it is another one.
                render(volume, picture, size, samples, made["camera"])
                if cuts:
                    self.assertGreater(page.difference(picture, size, samples, exposure)[1], 0.05)

    def test_changes_to_parallel_rays_and_back(self):
        with self.opened(self.page) as page:
            page.evaluate("document.querySelector('canvas').focus()")
            key = lambda name: page.call("Input.dispatchKeyEvent", type="keyDown", key=name, code="Key" + name.upper(), text=name)
            lens = lambda: page.evaluate("[voxc.camera.isParallel, voxc.camera.half, voxc.camera.distance]")
            tangent, first = page.evaluate("voxc.camera.tangent"), lens()
            key("x")
            self.assertEqual(lens(), [True, tangent * first[2], first[2]])
            page.evaluate("voxc.camera.approach(2)")
            self.assertEqual(lens(), [True, tangent * first[2] / 2, first[2]])
            key("x")
            self.assertEqual(lens(), [False, 0, first[2] / 2])

    def test_says_what_it_is(self):
        with self.opened(self.page) as page:
            text = page.evaluate("document.getElementById('about').textContent")
            for word in ("terrain", "R(2, 2, 2) G(4)", "64 × 64 × 64", "bytes a voxel", "Drawn by" + self.name, "exact"):
                self.assertIn(word, text)
            page.wait(f"{STATE}.checked && JSON.parse({STATE}.checked).precision === 'exact'") # A slow compiler has it begin with fast.
            self.assertEqual(json.loads(page.evaluate(f"{STATE}.checked")), {"precision": "exact", "others": 0, "worst": 0})
            self.assertIn("here, all 1,024 rays of a check have the exact hit", page.evaluate("document.getElementById('arithmetic').textContent"))
            page.evaluate("document.getElementById('switch').click()")
            page.wait(f"JSON.parse({STATE}.checked).precision === 'fast'")
            self.assertRegex(page.evaluate("document.getElementById('arithmetic').textContent"),
                             r"^fast: plain float32; of 20,000 rays on the maker's cpu \d+ hit another voxel; here: of 1,024 rays \d+ hit another voxel, and t is off by [0-9.e-]+ voxels at most$")

    def test_fits_its_window(self):
        for width, height in ((1280, 800), (390, 844)):
            with self.opened(self.page, width, height) as page:
                self.assertEqual(page.evaluate("[document.documentElement.scrollWidth, document.documentElement.scrollHeight]"), [width, height])
                box = page.evaluate("(b => [b.left, b.top, b.right, b.bottom])(document.getElementById('about').getBoundingClientRect())")
                self.assertTrue(0 <= box[0] < box[2] <= width and 0 <= box[1] < box[3] <= height, box)
                self.assertEqual(page.evaluate("document.getElementById('about').open"), width == 1280)

    def shown(self, page, name):
        """A screenshot of a page without what it says."""
        page.evaluate("document.getElementById('about').hidden = true")
        path = self.folder / f"{name}.png"
        page.picture(path, height=page.size[1])
        return path

    def test_shows_a_poster_where_its_picture_will_be(self):
        for width, height in ((1280, 800), (390, 844)):
            with self.subTest(width):
                lacking = self.enterContext(Browser(width, height, draws=True))
                lacking.call("Page.addScriptToEvaluateOnNewDocument", source="HTMLCanvasElement.prototype.getContext = () => null")
                lacking.open(self.page)
                poster = self.shown(lacking, "poster")
                self.assertEqual(lacking.evaluate("document.querySelector('#poster img').naturalWidth >= 240"), True)
                with self.opened(self.page, width, height) as page:
                    page.wait("!document.getElementById('poster')")
                    page.wait("document.getElementById('status').textContent.endsWith(' samples a pixel')")
                    mean, far = volume_page.far_apart(page, poster, self.shown(page, "picture"))
                    self.assertLess(mean, 12)
                    self.assertLess(far, 0.1)

    def test_says_when_the_picture_is_finished(self):
        with self.opened(self.page, 64, 48) as page:
            page.wait("document.getElementById('status').textContent !== voxc.scene.wait")
            page.wait("document.getElementById('status').textContent === '256 of 256 samples a pixel: the picture is finished'")
            self.assertEqual(page.evaluate("document.getElementById('poster')"), None)
            page.evaluate("voxc.camera.turn(0.5, 0)")
            page.evaluate("voxc.changed()")
            page.wait("!document.getElementById('status').textContent.includes('finished')")

    def test_has_no_poster_once_somebody_has_moved(self):
        with self.opened(self.page, 1280, 800) as page:
            page.evaluate("voxc.camera.turn(0.5, 0)")
            page.evaluate("voxc.changed()")
            page.wait("!document.getElementById('poster')")

    def test_is_light_and_dark(self):
        with self.opened(self.page) as page:
            colours = set()
            for scheme in ("light", "dark"):
                page.prefer(scheme)
                colours.add(page.evaluate("getComputedStyle(document.getElementById('about')).backgroundColor"))
            self.assertEqual(len(colours), 2)

    def test_turns_and_comes_closer(self):
        with self.opened(self.page) as page:
            mouse = lambda kind, x, y, **more: page.call("Input.dispatchMouseEvent", type=kind, x=x, y=y, **more)
            camera = lambda: page.evaluate("[voxc.camera.yaw, voxc.camera.distance, ...voxc.camera.look]")
            first = camera()
            mouse("mousePressed", 200, 60, button="left", clickCount=1)
            mouse("mouseMoved", 240, 60, button="left", buttons=1)
            mouse("mouseReleased", 240, 60, button="left", clickCount=1)
            turned = camera()
            self.assertNotEqual(turned[0], first[0])
            self.assertEqual(turned[1:], first[1:])
            mouse("mouseWheel", 200, 60, deltaX=0, deltaY=-100)
            page.wait(f"voxc.camera.distance < {turned[1]}")
            nearer = camera()
            finger = lambda *places: [{"x": x, "y": y, "id": i} for i, (x, y) in enumerate(places)]
            page.call("Emulation.setTouchEmulationEnabled", enabled=True, maxTouchPoints=2)
            page.call("Input.dispatchTouchEvent", type="touchStart", touchPoints=finger((150, 60), (190, 60)))
            page.call("Input.dispatchTouchEvent", type="touchMove", touchPoints=finger((130, 60), (230, 60)))
            page.call("Input.dispatchTouchEvent", type="touchEnd", touchPoints=[])
            page.wait(f"voxc.camera.distance < {nearer[1]}")
            self.assertNotEqual(camera()[2:], nearer[2:])
            page.evaluate("document.querySelector('canvas').focus()")
            page.call("Input.dispatchKeyEvent", type="keyDown", key="0", code="Digit0", text="0", windowsVirtualKeyCode=48)
            page.wait(f"voxc.camera.yaw === {first[0]}")
            self.assertEqual(camera(), first)

    def test_says_what_a_browser_lacks(self):
        page = self.enterContext(Browser(320, 240, draws=True))
        page.call("Page.addScriptToEvaluateOnNewDocument", source="HTMLCanvasElement.prototype.getContext = () => null")
        page.open(f"{self.page}#{self.device}")
        page.wait_until_still()
        while page.evaluate(f"!{STATE}.problem"):
            time.sleep(0.1)
        self.assertEqual(page.evaluate("document.getElementById('status').textContent"), "This page cannot be shown here: this browser has no " + self.name)


class PagesByWebGpu(PagesOfAnyDevice, unittest.TestCase):
    device, name = "webgpu", "WebGPU"


class PagesByWebGl(PagesOfAnyDevice, unittest.TestCase):
    device, name = "webgl", "WebGL 2"


class Choice(unittest.TestCase):
    """By what a page draws that is not told."""

    @classmethod
    def setUpClass(cls):
        cls.kept = tempfile.TemporaryDirectory()
        cls.folder = Path(cls.kept.name)
        voxc("build", "G(4)", "builtin:terrain:16", "-o", cls.folder / "terrain.hvx")
        cls.page, _ = page_of(cls.folder / "terrain.hvx", cls.folder)

    @classmethod
    def tearDownClass(cls):
        cls.kept.cleanup()

    def chosen(self, before=""):
        """By what, and with which precision, where this script has been run before that of the page."""
        with Page(self.page, before=before) as page:
            page.wait(f"{STATE}.checked")
            return page.evaluate(f"[{STATE}.device, JSON.parse({STATE}.checked).precision]")

    def test_is_webgpu_where_the_browser_has_it(self):
        self.assertEqual(self.chosen(), ["WebGPU", "exact"])

    def test_is_webgl_where_webgpu_is_lacking_or_wrong(self):
        for before in ("delete Navigator.prototype.gpu",
                       "GPU.prototype.requestAdapter = async () => null",
                       "GPUDevice.prototype.createRenderPipelineAsync = async () => { throw new Error('no') }",
                       "GPUQueue.prototype.writeTexture = () => {}", # Its arithmetic is of other numbers then.
                       "GPUCanvasContext.prototype.getCurrentTexture = () => { throw new Error('no') }"):
            with self.subTest(before):
                self.assertEqual(self.chosen(before), ["WebGL 2", "exact"])


def look_at(volume):
    """Pictures of a page and its figures."""
    volume = Path(volume)
    with tempfile.TemporaryDirectory() as kept:
        folder = Path(kept)
        page, made = page_of(volume, folder)
        voxc("export", volume, "--compress", "-o", folder / "small.hvx")
        small = (folder / "small.hvx").stat().st_size
        print(f"{volume.name}: page {page.stat().st_size} bytes, {page.stat().st_size / small:.3f} times the compressed volume")
        size, samples = (1280, 720), 1
        exposure = render(volume, folder / "render.png", size, samples, made["camera"])
        for device in ("webgpu", "webgl"):
            with Page(page, device=device) as opened:
                print(f"  {opened.evaluate(STATE + '.device')}:")
                rays = opened.check_rays(RAYS)
                exact = exact_hits(volume, rays, folder)
                for precision in ("exact", "fast"):
                    hits = opened.trace(rays, precision)
                    print(f"    {precision}: of {RAYS} rays {differences(hits, exact)} differ from the exact hit, {other_voxels(hits, exact)} in the voxel")
                mean, far = opened.difference(folder / "render.png", size, samples, exposure)
                print(f"    picture: {mean:.3f} of 255 from that of voxc render, {100 * far:.3f} % of the pixels off by more than 8")
        for width, height in ((1280, 800), (390, 844)):
            with Page(page, width, height) as opened:
                opened.wait(f"{STATE}.checked")
                opened.picture(volume.with_name(f"{volume.stem}-{width}.png"), height=height)


if __name__ == "__main__":
    volume_page.VOXC = sys.argv.pop(1)
    if len(sys.argv) > 1 and sys.argv[1].endswith(".hvx"):
        for path in sys.argv[1:]:
            look_at(path)
    else:
        unittest.main()
