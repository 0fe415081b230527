#!/usr/bin/python3
"""Holds the includes to the layout: data flows one way, and the bodies of a module are its own.

usage: scripts/check_includes.py [ROOT]

 1. A module includes only modules that TABLE allows, in include/berm/M, src/M and the DEPENDS of berm_module.
 2. A private header (not under include/berm) is included only by the module, program or test folder it lies in.
    The tests of a module may use the private headers of that module.
 3. A public header includes no private one.
 4. The modules of LEAN use the standard library and the libraries named there, nothing else.

Prints one line per violation and exits with 1 if there is any.
"""
import pathlib
import re
import sys

# Module -> modules that it may include beside itself. docs/design.md shows the same table.
TABLE = {
    "core": set(),
    "geometry": {"core"},
    "ground": {"core", "geometry"},
    "snow": {"core", "geometry"},
    "piste": {"core", "geometry"},
    "edge": {"core", "geometry"},
    "odometry": {"core", "geometry"},
    "map": {"core", "geometry"},
    "io": {"core"},
    "view": {"core", "geometry", "io", "map", "render"},
    "sim": {"core", "geometry", "io"},
    "eval": {"core", "io"},
    "report": {"core", "io"},
    "render": {"core", "geometry"},
    "pipeline": {"core", "geometry", "ground", "snow", "piste", "edge", "odometry", "map", "io", "render"},
}
# Modules that users embed: what their includes in angle brackets may start with, beside the standard library.
LEAN = {
    "core": ("Eigen/",),
    "geometry": ("Eigen/", "tsl/"),
    "ground": ("Eigen/", "tsl/"),
    "snow": ("Eigen/", "tsl/"),
    "piste": ("Eigen/", "tsl/"),
    "edge": ("Eigen/", "tsl/"),
    "odometry": ("Eigen/", "ceres/", "nanoflann", "tsl/"),
}
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]')
STANDARD = re.compile(r"[a-z_]+")
MODULE_CALL = re.compile(r"berm_module\(\s*(\w+)(.*?)\)", re.S)
SUFFIXES = {".hpp", ".cpp", ".h", ".hh", ".cc", ".inl"}


def sources(folder):
    return sorted(p for p in folder.rglob("*") if p.suffix in SUFFIXES) if folder.is_dir() else []


def includes(path):
    for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
        match = INCLUDE.match(line)
        if match:
            yield number, match.group(1) == "<", match.group(2)


def modules_of(root):
    found = set()
    for base in (root / "include/berm", root / "src"):
        if base.is_dir():
            found |= {p.name for p in base.iterdir() if p.is_dir() and sources(p)}
    return found


def check_public_include(root, module, name):
    """Problem with `#include "berm/..."` (or in angle brackets) in `module`; module None may use all."""
    if not (root / "include" / name).is_file():
        return f"{name}: there is no such public header"
    other = name.split("/")[1]
    if module is not None and other != module and other not in TABLE.get(module, set()):
        allowed = ", ".join(sorted(TABLE.get(module, set()))) or "no other module"
        return f"{name}: {module} may include {allowed}, not {other}"
    return None


def check_file(root, path, module, private_folders):
    """Violations of one file. `module` is None for programs and tests, which may use every public header."""
    public = (root / "include") in path.parents
    for number, angled, name in includes(path):
        problem = None
        if name.startswith("berm/"):
            problem = check_public_include(root, module, name)
        elif ".." in pathlib.PurePosixPath(name).parts:
            problem = f"{name}: leaves the folder; a private header is never included from another module"
        elif not angled:
            if public:
                problem = f"{name}: a public header includes public headers only, as berm/MODULE/NAME.hpp"
            elif not any((folder / name).is_file() for folder in private_folders):
                problem = f"{name}: not a private header of {path.parent.relative_to(root)}"
        elif module in LEAN and not STANDARD.fullmatch(name):
            if not name.startswith(LEAN[module]):
                problem = f"{name}: {module} builds with the standard library and {', '.join(LEAN[module])} alone"
        if problem:
            yield f"{path.relative_to(root)}:{number}: {problem}"


def check_depends(root, module):
    cmake = root / "src" / module / "CMakeLists.txt"
    if not cmake.is_file():
        return
    for match in MODULE_CALL.finditer(cmake.read_text(encoding="utf-8")):
        words = match.group(2).split()
        depends = words[words.index("DEPENDS") + 1:] if "DEPENDS" in words else []
        for word in depends:
            if word in ("SOURCES", "PUBLIC", "PRIVATE"):
                break
            if word not in TABLE.get(match.group(1), set()):
                yield f"{cmake.relative_to(root)}: {match.group(1)} may not depend on {word}"


def check(root):
    """All violations in the tree at `root`, in a fixed order."""
    problems = []
    for module in sorted(modules_of(root)):
        if module not in TABLE:
            problems.append(f"module {module} is not in the table of scripts/check_includes.py and docs/design.md")
            continue
        own = root / "src" / module
        for path in sources(root / "include/berm" / module) + sources(own):
            problems += check_file(root, path, module, [path.parent, own])
        problems += check_depends(root, module)
    for face in ("apps", "bench", "examples", "tests"):
        for path in sources(root / face):
            tested = path.relative_to(root).parts[1] if face == "tests" else ""
            folders = [path.parent, root / face]
            if face == "bench":
                folders.append(root / "tests")  # made scans are in tests/support
            if tested in TABLE:
                folders += [root / "src", root / "src" / tested]
                problems += check_private_of_others(root, path, tested)
            if tested == "apps":
                folders.append(root / "apps/berm")
            problems += check_file(root, path, None, folders)
    return problems


def check_private_of_others(root, path, tested):
    for number, angled, name in includes(path):
        first = name.split("/")[0]
        if not angled and first in TABLE and first != tested and (root / "src" / name).is_file():
            yield f"{path.relative_to(root)}:{number}: {name}: private to {first}, this tests {tested}"


def main():
    root = pathlib.Path(sys.argv[1] if len(sys.argv) > 1 else pathlib.Path(__file__).parent.parent).resolve()
    problems = check(root)
    print("\n".join(problems) if problems else "includes follow the table")
    return 1 if problems else 0


if __name__ == "__main__":
    sys.exit(main())
