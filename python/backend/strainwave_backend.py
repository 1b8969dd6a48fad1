# SPDX-License-Identifier: Apache-2.0
"""Builds the wheel and the source archive of the Python package (PEP 517, PEP 660).

The backend needs only the standard library, CMake and a compiler, so that
`pip install --no-index .` works without a network.  The wheel has no compiled Python module: one
wheel serves every Python from 3.9 on.

The library is built in build/wheel.  The setting `library=PATH` (pip's --config-settings) packs that
library instead.  The library contains SUNDIALS, and with it the engine for stiff motions, if the
machine has its headers and its libraries for static linking (Debian's libsundials-dev).
"""

import base64
import gzip
import hashlib
import io
import os
import pathlib
import platform
import re
import shutil
import subprocess
import sys
import sysconfig
import tarfile
import time
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[2]
PACKAGE = ROOT / "python" / "strainwave"
LIBRARY = "libstrainwave.so.0"
# Debian packages whose code the library contains; their licences go into the wheel.
CONTAINED = ("libfmt-dev", "libtomlplusplus-dev", "nlohmann-json3-dev", "libeigen3-dev",
             "libboost-dev", "libstdc++-12-dev")
SUNDIALS = "libsundials-dev"


def _version():
    text = (ROOT / "CMakeLists.txt").read_text(encoding="utf-8")
    return re.search(r"project\(strainwave VERSION ([0-9.]+)", text).group(1)


def _metadata():
    return (f"Metadata-Version: 2.1\nName: strainwave\nVersion: {_version()}\n"
            "Summary: Stiffness, damage, life and dynamics of strain wave gears with cracks\n"
            "License: Apache-2.0\nRequires-Python: >=3.9\nRequires-Dist: numpy>=1.21\n"
            "Provides-Extra: frames\nRequires-Dist: pandas; extra == 'frames'\n"
            "Provides-Extra: plots\nRequires-Dist: matplotlib; extra == 'plots'\n"
            "Description-Content-Type: text/markdown\n\n"
            + (ROOT / "docs" / "guide" / "python.md").read_text(encoding="utf-8"))


def _has_sundials():
    """Whether SUNDIALS can be linked into the library."""
    triplet = sysconfig.get_config_var("MULTIARCH") or f"{platform.machine()}-linux-gnu"
    archives = [pathlib.Path(folder, "libsundials_cvode.a")
                for folder in (f"/usr/lib/{triplet}", "/usr/lib64", "/usr/lib", "/usr/local/lib")]
    headers = [pathlib.Path(folder, "cvode", "cvode.h")
               for folder in ("/usr/include", "/usr/local/include")]
    return any(file.is_file() for file in archives) and any(file.is_file() for file in headers)


def _contained(library):
    """The packages whose code a library contains."""
    # A message of CVODE; a library that only calls CVODE does not contain it.
    return CONTAINED + ((SUNDIALS,) if b"cvode_mem = NULL illegal" in library else ())


def _built_library(settings):
    """The shared library, built unless the settings name one."""
    named = settings.get("library")
    if named:
        return pathlib.Path(named).resolve()
    build = ROOT / "build" / "wheel"
    maker = ["-G", "Ninja"] if shutil.which("ninja") else []
    subprocess.run(["cmake", "-S", str(ROOT), "-B", str(build), *maker,
                    "-D", "CMAKE_BUILD_TYPE=Release", "-D", "STRAINWAVE_BUILD_TESTS=OFF",
                    "-D", "STRAINWAVE_SELF_CONTAINED=ON", "-D", "CMAKE_UNITY_BUILD=ON",
                    "-D", f"STRAINWAVE_SUNDIALS={'ON' if _has_sundials() else 'OFF'}",
                    "-D", "CMAKE_UNITY_BUILD_BATCH_SIZE=0"], check=True)
    subprocess.run(["cmake", "--build", str(build), "--target", "strainwave_shared", "--parallel",
                    str(os.cpu_count() or 1)], check=True)
    return build / LIBRARY


def _stripped(library):
    """The bytes of the library without its local symbols."""
    strip = shutil.which("strip")
    if not strip:
        return library.read_bytes()
    made = ROOT / "build" / f"{LIBRARY}.stripped.{os.getpid()}"
    made.parent.mkdir(exist_ok=True)
    try:
        subprocess.run([strip, "--strip-unneeded", "-o", str(made), str(library)], check=True)
        return made.read_bytes()
    finally:
        made.unlink(missing_ok=True)


def _platform(library):
    """The platform tag: manylinux of the newest version of glibc that the library asks for."""
    given = sysconfig.get_platform().replace("-", "_").replace(".", "_")
    libc, running = platform.libc_ver()
    if not given.startswith("linux_") or libc != "glibc":
        return given
    asked = re.findall(rb"GLIBC_(\d+)\.(\d+)", library)
    newest = max(((int(major), int(minor)) for major, minor in asked),
                 default=tuple(int(part) for part in running.split(".")[:2]))
    return given.replace("linux_", f"manylinux_{newest[0]}_{newest[1]}_")


def _licences(contained):
    """Licence texts by their file names: ours, and those of the packages whose code is contained."""
    texts = {"LICENSE": (ROOT / "LICENSE").read_bytes()}
    for package in contained:
        file = pathlib.Path("/usr/share/doc", package, "copyright")
        if file.is_file():
            texts[f"{package}.txt"] = file.read_bytes()
        else:
            print(f"The licence of {package} is not at {file}; add it before you pass the wheel on.",
                  file=sys.stderr)
    return texts


def _date():
    """Date of all files in an archive, so that the same sources give the same bytes."""
    return int(os.environ.get("SOURCE_DATE_EPOCH", "315532800"))


def _wheel(folder, library, files):
    """Writes a wheel for the bytes of a library; returns its file name."""
    tag = f"py3-none-{_platform(library)}"
    version = _version()
    info = f"strainwave-{version}.dist-info"
    files = dict(files)
    files[f"{info}/METADATA"] = _metadata().encode()
    files[f"{info}/WHEEL"] = ("Wheel-Version: 1.0\nGenerator: strainwave\nRoot-Is-Purelib: false\n"
                              f"Tag: {tag}\n").encode()
    files[f"{info}/top_level.txt"] = b"strainwave\n"
    for name, text in _licences(_contained(library)).items():
        files[f"{info}/licenses/{name}"] = text
    record = []
    for name, content in sorted(files.items()):
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record.append(f"{name},sha256={digest},{len(content)}\n")
    record.append(f"{info}/RECORD,,\n")
    files[f"{info}/RECORD"] = "".join(record).encode()
    name = f"strainwave-{version}-{tag}.whl"
    date = time.gmtime(max(_date(), 315532800))[:6]
    with zipfile.ZipFile(pathlib.Path(folder, name), "w", zipfile.ZIP_DEFLATED, compresslevel=9) as to:
        for path, content in sorted(files.items()):
            entry = zipfile.ZipInfo(path, date)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if path.endswith(".so.0") else 0o644) << 16
            entry.create_system = 3
            to.writestr(entry, content)
    return name


def _modules():
    """The files of the package by their paths in a wheel."""
    return {f"strainwave/{path.relative_to(PACKAGE).as_posix()}": path.read_bytes()
            for pattern in ("**/*.py", "py.typed") for path in PACKAGE.glob(pattern)}


def get_requires_for_build_wheel(config_settings=None):
    return []


get_requires_for_build_sdist = get_requires_for_build_editable = get_requires_for_build_wheel


def prepare_metadata_for_build_wheel(metadata_directory, config_settings=None):
    info = pathlib.Path(metadata_directory, f"strainwave-{_version()}.dist-info")
    info.mkdir()
    (info / "METADATA").write_text(_metadata(), encoding="utf-8")
    return info.name


prepare_metadata_for_build_editable = prepare_metadata_for_build_wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    library = _stripped(_built_library(config_settings or {}))
    return _wheel(wheel_directory, library,
                  {**_modules(), f"strainwave/{LIBRARY}": library})


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """The package stays in the tree, with the library beside it."""
    library = _stripped(_built_library(config_settings or {}))
    (PACKAGE / LIBRARY).write_bytes(library)
    return _wheel(wheel_directory, library,
                  {"strainwave.pth": f"{PACKAGE.parent}\n".encode()})


def _sources():
    """The files of the source archive: those that git tracks, or all but what was built."""
    try:
        listed = subprocess.run(["git", "-C", str(ROOT), "ls-files", "-z"], check=True,
                                capture_output=True).stdout.decode().split("\0")
        names = [name for name in listed if name and (ROOT / name).is_file()]
    except (OSError, subprocess.CalledProcessError):
        names = [path.relative_to(ROOT).as_posix() for path in ROOT.rglob("*") if path.is_file()]
        names = [name for name in names if not re.search(r"(^build/|__pycache__/|\.so\.0$)", name)]
    return sorted(names)


def build_sdist(sdist_directory, config_settings=None):
    stem = f"strainwave-{_version()}"
    raw = io.BytesIO()
    with tarfile.open(fileobj=raw, mode="w", format=tarfile.PAX_FORMAT) as to:
        def add(name, content, mode):
            entry = tarfile.TarInfo(f"{stem}/{name}")
            entry.size, entry.mtime, entry.mode = len(content), _date(), mode
            to.addfile(entry, io.BytesIO(content))

        add("PKG-INFO", _metadata().encode(), 0o644)
        for name in _sources():
            path = ROOT / name
            add(name, path.read_bytes(), 0o755 if os.access(path, os.X_OK) else 0o644)
    file = pathlib.Path(sdist_directory, f"{stem}.tar.gz")
    with file.open("wb") as to, gzip.GzipFile(filename="", mode="wb", fileobj=to, mtime=_date()) as packed:
        packed.write(raw.getvalue())
    return file.name
