"""The page of a volume in a headless browser, and what it is compared with: the hits of `voxc trace` and the pictures of `voxc render`."""
import base64
import json
import subprocess
import sys
import time
from pathlib import Path

HERE = Path(__file__).parent
sys.path.insert(0, str(HERE.parent / "Bench"))
import browser
from browser import Browser

browser.TIMEOUT_SECONDS = 600  # A processor that stands for a graphics device takes its time, above all to compile.
STATE = "(document.documentElement?.dataset ?? {})" # Before the page has come there is no element.
VOXC = None # The program; whoever takes this sets it.


def voxc(*arguments):
    subprocess.run([VOXC, *map(str, arguments), "--quiet"], check=True)


def figures(path, *arguments):
    voxc(*arguments, "--stats", path)
    return json.loads(Path(path).read_text())


def page_of(volume, folder, *options):
    """The page of a volume, and the figures of its making."""
    page = folder / (Path(volume).stem + "".join(options) + ".html")
    return page, figures(folder / "figures.json", "export", volume, "-o", page, *options)


def hard_rays(extent):
    """Rays of all kinds, as those of the tests of headers are, for a volume of 32 voxels a side."""
    assert max(extent) <= 32
    script = HERE.parent / "Emit" / "Inputs" / "header" / "queries.py"
    return subprocess.run([sys.executable, script, "rays"], check=True, capture_output=True).stdout


class Page(Browser):
    """The page of a volume. `device`: "webgpu" or "webgl", by which it has to draw; else it chooses. `before` is run before its script."""

    def __init__(self, path, width=320, height=240, device="", before=""):
        super().__init__(width, height, draws=True)
        self.path, self.device, self.before = path, device, before

    def __enter__(self):
        super().__enter__()
        self.call("Page.addScriptToEvaluateOnNewDocument", source=self.before)
        self.open(f"{self.path}#{self.device}" if self.device else self.path)
        self.wait(f"{STATE}.ready")
        return self

    def wait(self, expression):
        end = time.monotonic() + browser.TIMEOUT_SECONDS
        while not (value := self.evaluate(f"{STATE}.problem ? 'problem' : {expression}")):
            if time.monotonic() > end:
                raise TimeoutError(f"{expression} does not come true")
            time.sleep(0.1)
        if value == "problem":
            raise RuntimeError(self.evaluate(f"{STATE}.problem"))
        return value

    def bytes_of(self, expression):
        """The bytes of a typed array that a promise brings."""
        return base64.b64decode(self.evaluate(f"""{expression}.then(array => {{
            const bytes = new Uint8Array(array.buffer);
            let text = "";
            for (let i = 0; i < bytes.length; i += 8192) text += String.fromCharCode(...bytes.subarray(i, i + 8192));
            return btoa(text);
        }})"""))

    def check_rays(self, count):
        return self.bytes_of(f"Promise.resolve(voxc.checkRays({count}))")

    def trace(self, rays, precision):
        return self.bytes_of(f"""voxc.trace(new Float32Array(
            Uint8Array.from(atob("{base64.b64encode(rays).decode()}"), c => c.charCodeAt(0)).buffer), "{precision}")""")

    def difference(self, picture, size, samples, exposure):
        """How far the page's picture is from a file's of that exposure: the mean over all channels, and the share of pixels that are off
        by more than 8."""
        width, height = size
        return self.evaluate(f"""(async () => {{
            voxc.scene.exposure = {exposure};
            const mine = await voxc.picture({width}, {height}, {samples}), image = new Image();
            image.src = "data:image/png;base64,{base64.b64encode(Path(picture).read_bytes()).decode()}";
            await image.decode();
            const context = Object.assign(document.createElement("canvas"), {{ width: {width}, height: {height} }}).getContext("2d");
            context.drawImage(image, 0, 0);
            const other = context.getImageData(0, 0, {width}, {height}).data;
            let sum = 0, far = 0;
            for (let i = 0; i < other.length; i += 4) {{
              const off = [0, 1, 2].map(k => Math.abs(other[i + k] - mine[i + k]));
              sum += off[0] + off[1] + off[2];
              far += Math.max(...off) > 8;
            }}
            return [sum / (3 * {width * height}), far / {width * height}];
        }})()""")


def far_apart(page, first, second):
    """How far two pictures of one size are apart: the mean over all channels, and the share of pixels that are off by more than 48. The
    browser compares them."""
    images = ", ".join(f'"{base64.b64encode(Path(path).read_bytes()).decode()}"' for path in (first, second))
    return page.evaluate(f"""(async () => {{
        const [one, other] = await Promise.all([{images}].map(async data => {{
          const image = new Image();
          image.src = "data:image/png;base64," + data;
          await image.decode();
          const context = Object.assign(document.createElement("canvas"), {{ width: image.width, height: image.height }}).getContext("2d");
          context.drawImage(image, 0, 0);
          return context.getImageData(0, 0, image.width, image.height).data;
        }}));
        let sum = 0, far = 0;
        for (let i = 0; i < one.length; i += 4) {{
          const off = [0, 1, 2].map(k => Math.abs(one[i + k] - other[i + k]));
          sum += off[0] + off[1] + off[2];
          far += Math.max(...off) > 48;
        }}
        return [sum / (one.length * 3 / 4), far / (one.length / 4)];
    }})()""")


def exact_hits(volume, rays, folder):
    """What `voxc trace` answers, once the oracle has agreed."""
    (folder / "rays.bin").write_bytes(rays)
    told = figures(folder / "trace.json", "trace", volume, "--rays", folder / "rays.bin", "--device", "cpu", "--check", len(rays) // 24,
                   "-o", folder / "hits.bin", "--outputs", "voxel,t,face,colour")
    error = told["error"]
    assert error["rays"] == len(rays) // 24 and error["missed"] + error["ghost"] + error["wrong"] + error["colour"] == 0, error
    return (folder / "hits.bin").read_bytes()


def render(volume, picture, size, samples, camera):
    """Takes a picture as pages do, and tells its exposure."""
    told = figures(Path(picture).with_suffix(".json"), "render", volume, "--device", "cpu", "--size", "{}x{}".format(*size),
                   "--samples", samples, "-o", picture, *camera.split())
    return told["exposure"]


def differences(hits, exact):
    return sum(hits[i:i + 24] != exact[i:i + 24] for i in range(0, len(exact), 24))


def other_voxels(hits, exact):
    return sum(hits[i:i + 12] != exact[i:i + 12] for i in range(0, len(exact), 24))
