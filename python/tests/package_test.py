# SPDX-License-Identifier: Apache-2.0
"""The package as a whole: its written files, its types, its wheel."""

import ast
import contextlib
import importlib.util
import inspect
import io
import os
import re
import shutil
import subprocess
import sys
import tarfile
import tempfile
import typing
import unittest
import zipfile
from pathlib import Path

import strainwave as sw
from strainwave import _commands, _library
from support import DATA, EXAMPLES, NOTEBOOKS, ROOT, code_cells, main, missing, python

PACKAGE = ROOT / "python" / "strainwave"
TYPING = Path(__file__).resolve().parent / "typing"
WRITTEN = ("strainwave._commands", "strainwave._evidence")  # by tools/write_python.py, which another test compares
CALLED = ("__init__", "__call__", "__getitem__", "__setitem__", "__delitem__")  # part of what a user calls
SIGNATURES = DATA / "python_signatures.txt"
SIGNATURES_HEAD = ("# Signatures of the public part of the Python package that is written by hand.\n"
                   "# STRAINWAVE_RENEW=1 python/tests/package_test.py Written writes them again: read the difference.\n")


class Bare(str):
    """An annotation that is shown without quotes."""

    def __repr__(self):
        return self.strip("'")


def signature(function):
    def bare(annotation):
        return Bare(annotation) if isinstance(annotation, str) else annotation

    found = inspect.signature(function)
    parameters = [one.replace(annotation=bare(one.annotation)) for one in found.parameters.values()]
    return found.replace(parameters=parameters, return_annotation=bare(found.return_annotation))


def signatures():
    """The members of a class are its own, because those of its bases differ between versions of Python."""
    values = {name: getattr(sw, name) for name in sw.__all__}
    # The mappings, and what they give, are objects of classes that have no name in the package.
    values.update({f"type({name})": type(values[name]) for name in ("materials", "sif")})
    values["sif[NAME]"] = type(sw.sif["plate-surface"])
    lines = []
    for name, value in values.items():
        if not callable(value) or value.__module__ in WRITTEN:
            continue
        if not inspect.isclass(value):
            lines.append(f"{name}{signature(value)}")
            continue
        lines.append(name)
        for member, kind in vars(value).items():
            if member.startswith("_") and member not in CALLED:
                continue
            if isinstance(kind, property):
                lines.append(f"{name}.{member}: property")
            elif callable(kind) or isinstance(kind, (classmethod, staticmethod)):
                lines.append(f"{name}.{member}{signature(getattr(value, member))}")
    return SIGNATURES_HEAD + "\n".join(sorted(lines)) + "\n"


class Written(unittest.TestCase):
    def test_identity_the_written_files_are_those_of_the_library(self):
        checked = subprocess.run([sys.executable, str(ROOT / "tools" / "write_python.py"), "--check"],
                                 capture_output=True, text=True, check=False)
        self.assertEqual(checked.returncode, 0, checked.stdout + checked.stderr)

    def test_identity_the_signatures_are_those_of_the_listing(self):
        if os.environ.get("STRAINWAVE_RENEW"):
            SIGNATURES.write_text(signatures())
        self.maxDiff = None
        self.assertEqual(signatures(), SIGNATURES.read_text(),
                         "If this is meant, run this test with STRAINWAVE_RENEW=1 in the environment")

    def test_identity_the_codes_of_errors_are_those_of_the_header(self):
        header = (ROOT / "include" / "strainwave" / "strainwave.h").read_text()
        codes = {name: int(code) for name, code in re.findall(r"SW_(\w+) = (\d+),? +/\*\*<", header)}
        for name in ("OPTION", "INPUT", "NO_ANSWER", "INTERNAL", "NO_MEMORY", "CALLBACK", "STOPPED"):
            self.assertEqual(getattr(_library, name), codes[name], name)

    def test_identity_every_public_name_is_there_and_documented(self):
        for name in sw.__all__:
            value = getattr(sw, name)
            if not name.startswith("_") and not isinstance(value, (str, tuple)):
                self.assertTrue(inspect.getdoc(value), name)

    def test_identity_the_syntax_is_that_of_python_3_9(self):
        for file in PACKAGE.rglob("*.py"):
            ast.parse(file.read_text(), str(file), feature_version=(3, 9))

    def test_identity_the_types_of_every_function_can_be_read(self):
        """typing.get_type_hints finds the names that an annotation uses."""
        functions = [value for value in vars(sw).values() if inspect.isfunction(value)]
        functions += [value for name, value in inspect.getmembers(sw.Drive, inspect.isfunction)]
        self.assertGreater(len(functions), 50)
        for function in functions:
            self.assertTrue(typing.get_type_hints(function) or function.__name__.startswith("__"), function)
        self.assertEqual(typing.get_type_hints(sw.Drive.stiffness)["return"],
                         sw.results.stiffness.StiffnessResult)
        with self.assertRaisesRegex(AttributeError, "has no attribute 'nothing'"):
            sw.results.nothing

    def test_behaviour_importing_the_package_imports_no_result(self):
        said = python("import sys, strainwave; print([name for name in sys.modules "
                      "if name.startswith('strainwave.results.') or name in ('pandas', 'matplotlib')])")
        self.assertEqual(said.stdout, "[]\n", said.stderr)

    def test_identity_new_takes_the_options_of_its_command(self):
        command = set(inspect.signature(_commands.new).parameters)
        self.assertEqual(set(inspect.signature(sw.new).parameters), command - {"texts", "progress"})

    def test_identity_the_version_is_that_of_the_sources(self):
        text = (ROOT / "CMakeLists.txt").read_text()
        self.assertEqual(sw.__version__,
                         re.search(r"project\(strainwave VERSION ([0-9.]+)", text).group(1))

    def test_behaviour_a_library_that_is_not_there_is_named(self):
        for path in ("/no/such/libstrainwave.so", "/dev/null"):
            ended = python("import strainwave", env={**os.environ, "STRAINWAVE_LIBRARY": path})
            self.assertEqual(ended.returncode, 1)
            self.assertIn(f"ImportError: strainwave: cannot load its library {path}", ended.stderr)

    def test_behaviour_optional_packages_are_named(self):
        ended = python("import sys; sys.modules['pandas'] = None; import strainwave as sw\n"
                       "try: sw.new().stiffness().to_frame()\n"
                       "except ImportError as error: print(error)\n"
                       "try: sw.new().sweep(vary=['load.torque=1 N*m..2 N*m:2']).to_frame()\n"
                       "except ImportError as error: print(error)")
        self.assertIn("to_frame() needs pandas", ended.stdout, ended.stderr)


@unittest.skipIf(missing("mypy"), missing("mypy"))
class Types(unittest.TestCase):
    def mypy(self, *files):
        return subprocess.run([sys.executable, "-m", "mypy", "--strict", "--no-incremental",
                               "--no-error-summary", *map(str, files)],
                              cwd=ROOT, capture_output=True, text=True, check=False).stdout

    def test_identity_package_and_right_uses_are_accepted(self):
        self.assertEqual(self.mypy(PACKAGE, TYPING / "right.py"), "")

    def test_identity_the_code_of_the_notebooks_is_accepted(self):
        with tempfile.TemporaryDirectory() as folder:
            files = [Path(folder, f"notebook_{notebook.stem}.py") for notebook in NOTEBOOKS]
            for notebook, file in zip(NOTEBOOKS, files):
                file.write_text("\n".join("".join(cell["source"]) + "\n" for cell in code_cells(notebook)))
            self.assertEqual(len(files), 8)
            self.assertEqual(self.mypy(*files), "")

    def test_input_each_wrong_use_is_refused(self):
        lines = (TYPING / "wrong.py").read_text().splitlines()
        want = {place for place, line in enumerate(lines, 1) if line.endswith("# wrong")}
        said = self.mypy(TYPING / "wrong.py")
        found = {int(line) for line in re.findall(r"wrong\.py:(\d+): error", said)}
        self.assertEqual(found, want, said)


def backend(root=ROOT):
    place = root / "python" / "backend" / "strainwave_backend.py"
    made = importlib.util.spec_from_file_location("strainwave_backend", place)
    module = importlib.util.module_from_spec(made)
    made.loader.exec_module(module)
    return module


class Wheel(unittest.TestCase):
    """Packs the library of this build; ./check --long also builds the library of a wheel."""

    def test_identity_the_same_bytes_twice(self):
        settings = {"library": str(_library.library_file())}
        with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as other:
            name = backend().build_wheel(one, settings)
            self.assertEqual(backend().build_wheel(other, settings), name)
            self.assertEqual(Path(one, name).read_bytes(), Path(other, name).read_bytes())
            archive = backend().build_sdist(one)
            backend().build_sdist(other)
            self.assertEqual(Path(one, archive).read_bytes(), Path(other, archive).read_bytes())
            with tarfile.open(Path(one, archive)) as packed:
                names = set(packed.getnames())
        stem = archive[:-len(".tar.gz")]
        for needed in ("PKG-INFO", "CMakeLists.txt", "pyproject.toml", "LICENSE",
                       "python/strainwave/drive.py", "src/c_api/c_api.cpp"):
            self.assertTrue(f"{stem}/{needed}" in names, needed)

    def test_behaviour_contents_and_tag(self):
        with tempfile.TemporaryDirectory() as folder:
            name = backend().build_wheel(folder, {"library": str(_library.library_file())})
            self.assertRegex(name, r"^strainwave-[0-9.]+-py3-none-(manylinux_2_\d+|linux)_\w+\.whl$")
            with zipfile.ZipFile(Path(folder, name)) as packed:
                names = packed.namelist()
                info = f"strainwave-{sw.__version__}.dist-info"
                record = packed.read(f"{info}/RECORD").decode()
                metadata = packed.read(f"{info}/METADATA").decode()
        modules = {f"strainwave/{path.relative_to(PACKAGE)}" for path in PACKAGE.rglob("*.py")}
        self.assertLessEqual(modules | {"strainwave/py.typed", "strainwave/libstrainwave.so.0",
                                        f"{info}/licenses/LICENSE"}, set(names))
        self.assertEqual({line.split(",")[0] for line in record.splitlines()}, set(names))
        self.assertIn("Requires-Dist: numpy", metadata)
        for extra, needed in (("frames", "pandas"), ("plots", "matplotlib")):
            self.assertIn(f"Provides-Extra: {extra}\nRequires-Dist: {needed}; extra == '{extra}'", metadata)

    def test_behaviour_the_licences_are_those_of_the_code_inside(self):
        """SUNDIALS is named if its code is in the library, and not if the library only calls it."""
        inside = b"\0cvode_mem = NULL illegal.\0"
        with tempfile.TemporaryDirectory() as folder:
            for code, named in ((inside, True), (b"\0CVodeInit\0libsundials_cvode.so.6\0", False)):
                library = Path(folder, "library.so")
                library.write_bytes(_library.library_file().read_bytes() + code)
                module = backend()
                module._stripped = Path.read_bytes  # strip would drop what follows the sections
                with contextlib.redirect_stderr(io.StringIO()) as said:
                    wheel = module.build_wheel(folder, {"library": str(library)})
                with zipfile.ZipFile(Path(folder, wheel)) as packed:
                    licences = " ".join(packed.namelist()) + said.getvalue()
                self.assertEqual("libsundials-dev" in licences, named)

    def test_behaviour_an_editable_package_follows_its_tree(self):
        """In a copy of the package, because the library is put beside its modules."""
        with tempfile.TemporaryDirectory() as folder:
            for name in ("python/strainwave", "python/backend"):
                shutil.copytree(ROOT / name, Path(folder, name),
                                ignore=shutil.ignore_patterns("__pycache__", "*.so.0"))
            for name in ("CMakeLists.txt", "LICENSE", "docs/guide/python.md"):
                Path(folder, name).parent.mkdir(parents=True, exist_ok=True)
                shutil.copy(ROOT / name, Path(folder, name))
            wheel = backend(Path(folder)).build_editable(folder, {"library": str(_library.library_file())})
            with zipfile.ZipFile(Path(folder, wheel)) as packed:
                path = packed.read("strainwave.pth").decode().strip()
            clean = {**os.environ, "PYTHONPATH": path}
            del clean["STRAINWAVE_LIBRARY"]
            said = python("import strainwave as sw; print(sw.__file__, sw.__version__)", env=clean)
        self.assertEqual(said.stdout.split(), [str(Path(path, "strainwave", "__init__.py")), sw.__version__],
                         said.stderr)

    def test_behaviour_installed_without_a_network(self):
        """In a fresh environment whose only other packages are those of the system."""
        with tempfile.TemporaryDirectory() as folder:
            wheel = backend().build_wheel(folder, {"library": str(_library.library_file())})
            environment = Path(folder, "v")
            subprocess.run([sys.executable, "-m", "venv", "--system-site-packages", environment],
                           check=True, capture_output=True)
            clean = {name: value for name, value in os.environ.items()
                     if name not in ("PYTHONPATH", "STRAINWAVE_LIBRARY")}
            subprocess.run([environment / "bin" / "pip", "install", "--no-index", "--quiet",
                            Path(folder, wheel)], check=True, env=clean, capture_output=True)
            said = subprocess.run(
                [environment / "bin" / "python", "-c",
                 "import sys, strainwave as sw; print(sw.__file__); "
                 "print(sw.read(sys.argv[1]).stiffness().intact.stiffness.value)",
                 EXAMPLES / "article.toml"], check=True, env=clean, cwd=folder, text=True,
                capture_output=True).stdout.splitlines()
        self.assertTrue(said[0].startswith(str(environment)))
        self.assertEqual(float(said[1]),
                         sw.read(EXAMPLES / "article.toml").stiffness().intact.stiffness.value)


if __name__ == "__main__":
    main()
