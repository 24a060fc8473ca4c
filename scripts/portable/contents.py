"""contents.py BUILD FOLDER VERSION TIME: whose work is in BUILD/portable beside voxc's, as FOLDER/licences, a file for each package of Debian,
and FOLDER/sbom.spdx.json, a bill of materials.

Asked are the linker, which wrote down what archives it read, and the compiler, which wrote down what headers it read."""
import hashlib
import json
import pathlib
import re
import shutil
import subprocess
import sys
import time

# Headers of these are of an interface that stays outside.
OUTSIDE = {"libc6-dev", "linux-libc-dev", "libc6-dev-arm64-cross", "linux-libc-dev-arm64-cross"}


def roots_of(build):
    """Where packages are that voxc is made of: this system and, for another processor, what scripts/sysroot.sh has made."""
    sysroots = re.findall(r"^VOXC_SYSROOT:\w+=(.+)$", (build / "CMakeCache.txt").read_text(), re.MULTILINE)
    return [pathlib.Path(root) for root in [*sysroots, "/"]]


def linked(build):
    """The archives that the linker read."""
    return {word for word in (build / "portable/linked.d").read_text().split() if word.endswith(".a") and word.startswith("/")}


def included(build):
    """The headers of packages that the compiler read for what is linked; those of tests are not."""
    headers, ours = set(), False
    folders = tuple(f"{root / 'usr'}/" for root in roots_of(build))
    for line in subprocess.run(["ninja", "-C", build, "-t", "deps"], capture_output=True, text=True, check=True).stdout.splitlines():
        if not line.startswith(" "):
            ours = re.match(r"(lib|tools|apps|CMakeFiles/voxc-portable)/?.*\.o: ", line) is not None
        elif ours and line.strip().startswith(folders):
            headers.add(line.strip())
    return headers


def owners(paths, root):
    """The packages in a root that files there are of."""
    wanted, found = {f"/{path.relative_to(root)}" for path in paths}, set()
    for listing in (root / "var/lib/dpkg/info").glob("*.list"):
        if not wanted.isdisjoint(listing.read_text().split("\n")):
            found.add(listing.stem.partition(":")[0])
    return found - OUTSIDE


def installed(files, roots):
    """(package, version, file of its copyright) of the packages that files are of, each in the first root that it lies in."""
    left = {pathlib.Path(file).resolve() for file in files}
    for root in roots:
        here = {path for path in left if path.is_relative_to(root)}
        left -= here
        names = "${Package} ${source:Package} ${source:Version}\n"
        query = ["dpkg-query", "--admindir", root / "var/lib/dpkg", "-W", "-f", names, *sorted(owners(here, root))]
        for line in subprocess.run(query, capture_output=True, text=True, check=True).stdout.splitlines():
            package, _, version = line.split()
            yield package, version, root / "usr/share/doc" / package / "copyright"


def made(build):
    """The same of what scripts/portable.sh has made of sources."""
    for changes in sorted((build / "portable/made").glob("*/debian/changelog")):
        package, version = re.match(r"(\S+) \((\S+)\)", changes.read_text()).groups()
        yield package, version, changes.parent / "copyright"


def write_licences(folder, rows):
    """Copies of what the packages say, and of the texts of licences that they refer to."""
    folder.mkdir(parents=True, exist_ok=True)
    texts = set()
    for package, _, copyright in rows:
        shutil.copyfile(copyright, folder / f"{package}.txt")
        texts |= set(re.findall(r"/usr/share/common-licenses/([\w.-]*\w)", copyright.read_text(errors="replace")))
    for text in sorted(texts):
        place = pathlib.Path("/usr/share/common-licenses") / text
        if place.exists():
            shutil.copyfile(place, folder / f"{text}.txt")


def bill(rows, version, moment):
    """The bill of materials, as SPDX 2.3."""
    def package(name, version, **more):
        return {"name": name, "SPDXID": f"SPDXRef-{re.sub('[^A-Za-z0-9.-]', '-', name)}", "versionInfo": version,
                "downloadLocation": "NOASSERTION", "filesAnalyzed": False, "licenseConcluded": "NOASSERTION", **more}

    own = package("voxc", version, licenseDeclared="Apache-2.0 WITH LLVM-exception", copyrightText="NOASSERTION")
    others = [package(name, of, supplier="Organization: Debian", licenseDeclared="NOASSERTION", copyrightText="NOASSERTION",
                      licenseComments=f"licences/{name}.txt",
                      externalRefs=[{"referenceCategory": "PACKAGE-MANAGER", "referenceType": "purl",
                                     "referenceLocator": f"pkg:deb/debian/{name}@{of}?distro=debian-12"}])
              for name, of, _ in rows]
    digest = hashlib.sha256(json.dumps([own, *others]).encode()).hexdigest()[:16]
    return {"spdxVersion": "SPDX-2.3", "dataLicense": "CC0-1.0", "SPDXID": "SPDXRef-DOCUMENT", "name": f"voxc-{version}",
            "documentNamespace": f"https://spdx.org/spdxdocs/voxc-{version}-{digest}",
            "creationInfo": {"created": time.strftime("%Y-%m-%dT%H:%M:%SZ", time.gmtime(moment)), "creators": ["Tool: voxc-portable"]},
            "packages": [own, *others],
            "relationships": [{"spdxElementId": "SPDXRef-DOCUMENT", "relationshipType": "DESCRIBES", "relatedSpdxElement": own["SPDXID"]},
                              *({"spdxElementId": own["SPDXID"], "relationshipType": "CONTAINS", "relatedSpdxElement": other["SPDXID"]}
                                for other in others)]}


def main():
    build, folder, version, moment = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2]), sys.argv[3], int(sys.argv[4])
    rows = sorted([*installed(linked(build) | included(build), roots_of(build)), *made(build)])
    folder.mkdir(parents=True, exist_ok=True)
    write_licences(folder / "licences", rows)
    (folder / "sbom.spdx.json").write_text(json.dumps(bill(rows, version, moment), indent=1) + "\n")


main()
