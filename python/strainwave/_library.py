# SPDX-License-Identifier: Apache-2.0
"""The C interface (strainwave.h) by ctypes: its declarations, and calls that raise exceptions.

Nothing else in the package knows ctypes.  A call releases the lock of the interpreter.  A call from
the main thread runs in a thread of its own: a signal, such as that of Ctrl-C, then runs its handler
at once, and if the handler raises an exception, the computation is asked to stop.
"""

from __future__ import annotations

import atexit
import ctypes
import json
import keyword
import os
import threading
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_ssize_t, c_void_p
from pathlib import Path
from typing import Any, Callable, Collection, Mapping, Optional, Sequence, Union

from .errors import Error, InputError, InternalError, OptionError, SolverError

OPTION, INPUT, NO_ANSWER, INTERNAL, NO_MEMORY, CALLBACK, STOPPED = 2, 3, 4, 70, 71, 74, 130
ROW_CODES = 5

Progress = Callable[[float], object]  # receives the completed fraction, 0 to 1


class Text(ctypes.Structure):
    """sw_text; `owner` keeps the bytes of a text that Python owns."""

    _fields_ = [("data", c_void_p), ("size", c_size_t)]
    owner: bytes


def text(value: str) -> Text:
    """Text in UTF-8 that lives as long as the returned structure."""
    owner = value.encode("utf-8", "surrogateescape")
    made = Text(ctypes.cast(c_char_p(owner), c_void_p), len(owner))
    made.owner = owner
    return made


def string(value: Text) -> str:
    """The text as str; bytes that are not UTF-8 become the sign of replacement."""
    return ctypes.string_at(value.data, value.size).decode("utf-8", "replace") if value.size else ""


NEXT = ctypes.CFUNCTYPE(c_ssize_t, c_void_p, c_void_p, c_size_t)
CLOSE = ctypes.CFUNCTYPE(None, c_void_p)


class Source(ctypes.Structure):
    _fields_ = [("next", NEXT), ("close", CLOSE), ("context", c_void_p)]


class Attachment(ctypes.Structure):
    _fields_ = [("name", Text), ("text", Text)]


FIND = ctypes.CFUNCTYPE(c_int, c_void_p, Text, POINTER(Source))


class Attachments(ctypes.Structure):
    _fields_ = [("array", POINTER(Attachment)), ("count", c_size_t), ("find", FIND),
                ("context", c_void_p)]


REPORT = ctypes.CFUNCTYPE(c_int, c_void_p, c_double)


class ProgressCall(ctypes.Structure):
    _fields_ = [("report", REPORT), ("context", c_void_p)]


class BatchTask(ctypes.Structure):
    _fields_ = [("paths", POINTER(Text)), ("n_paths", c_size_t), ("values", c_void_p),
                ("n_rows", c_size_t), ("outputs", POINTER(Text)), ("n_outputs", c_size_t),
                ("method", Text), ("threads", c_int)]


class TableEvidence(ctypes.Structure):
    _fields_ = [("cracks", c_int), ("points", c_int), ("largest_error", c_double)]


# Result and arguments of each function; a function that can fail returns an error.
_FUNCTIONS: dict[str, tuple[Any, list[Any]]] = {
    "sw_version": (c_char_p, []),
    "sw_commands": (c_void_p, [POINTER(Text)]),
    "sw_read": (c_void_p, [Text, Text, POINTER(Attachments), POINTER(c_void_p)]),
    "sw_edit": (c_void_p, [Text, Text, POINTER(Text), POINTER(Text)]),
    "sw_drive_fields": (c_void_p, [c_void_p, POINTER(Text)]),
    "sw_run": (c_void_p, [c_void_p, Text, Text, POINTER(Attachment), c_size_t,
                          POINTER(ProgressCall), POINTER(c_void_p)]),
    "sw_answer_usable": (c_int, [c_void_p]),
    "sw_answer_document": (c_void_p, [c_void_p, Text, POINTER(Text)]),
    "sw_batch_with_evidence": (c_void_p, [c_void_p, POINTER(BatchTask), POINTER(ProgressCall),
                                          c_void_p, c_void_p, POINTER(Text),
                                          POINTER(TableEvidence)]),
    "sw_error_code": (c_int, [c_void_p]),
    "sw_error_text": (Text, [c_void_p, c_int]),
    "sw_error_line": (c_size_t, [c_void_p]),
    "sw_error_column": (c_size_t, [c_void_p]),
    "sw_drive_free": (None, [c_void_p]),
    "sw_answer_free": (None, [c_void_p]),
    "sw_error_free": (None, [c_void_p]),
    "sw_text_free": (None, [Text]),
}


def library_file() -> Path:
    """The shared library: that of the variable STRAINWAVE_LIBRARY, or the one beside this module."""
    named = os.environ.get("STRAINWAVE_LIBRARY")
    return Path(named) if named else Path(__file__).with_name("libstrainwave.so.0")


def _load() -> ctypes.CDLL:
    file = library_file()
    try:
        loaded = ctypes.CDLL(str(file))
    except OSError as error:
        raise ImportError(
            f"strainwave: cannot load its library {file}: {error}. Install the package by "
            "`pip install --no-index .`, or name a library in STRAINWAVE_LIBRARY.") from error
    for name, (result, arguments) in _FUNCTIONS.items():
        try:
            function = getattr(loaded, name)
        except AttributeError as error:
            raise ImportError(f"strainwave: {file} has no function {name}; it is the library of an "
                              "older version. Build the library anew.") from error
        function.restype = result
        function.argtypes = arguments
    return loaded


_library = _load()


def version() -> str:
    """Version of the library."""
    named: bytes = _library.sw_version()
    return named.decode()


class _Stop(Exception):
    """The library reports that it was stopped."""


def _argument(path: str, options: Collection[str]) -> str:
    """The path of an error; an option, which the library spells in several ways, by the name of
    Python's argument."""
    option = (path[2:] if path.startswith("--") else path).replace("-", "_")
    if option not in options:
        return path
    return option + "_" if keyword.iskeyword(option) else option


def _exception(error: int, options: Collection[str]) -> Exception:
    code: int = _library.sw_error_code(error)
    message, file, field, value, rule = (string(_library.sw_error_text(error, part))
                                         for part in range(5))
    if code in (INPUT, OPTION):
        kind = OptionError if code == OPTION else InputError
        return kind(message, file=file, path=_argument(field, options), value=value, rule=rule,
                    line=_library.sw_error_line(error), column=_library.sw_error_column(error))
    if code == NO_ANSWER:
        return SolverError(message)
    if code == NO_MEMORY:
        return MemoryError(message)
    if code == STOPPED:
        return _Stop(message)
    if code == CALLBACK:
        return Error(message)
    return InternalError(message)


def _succeed(error: Optional[int], options: Collection[str] = ()) -> None:
    """Raises what the library reports of a call that takes these options."""
    if error:
        try:
            exception = _exception(error, options)
        finally:
            _library.sw_error_free(error)
        raise exception


def _taken(given: Text) -> str:
    """The text, which is freed."""
    try:
        return string(given)
    finally:
        _library.sw_text_free(given)


class _Running:
    """The calls that run now.  The interpreter must not end amid a callback, so its end stops them
    and waits."""

    def __init__(self) -> None:
        self.ending = False
        self._count = 0
        self._changed = threading.Condition()

    def __enter__(self) -> None:
        with self._changed:
            self._count += 1

    def __exit__(self, *_: object) -> None:
        with self._changed:
            self._count -= 1
            self._changed.notify_all()

    def end(self) -> None:
        self.ending = True
        with self._changed:
            self._changed.wait_for(lambda: self._count == 0, timeout=5.0)


_running = _Running()
atexit.register(_running.end)
if hasattr(os, "register_at_fork"):

    def _forked() -> None:
        global _running
        atexit.unregister(_running.end)
        _running = _Running()
        atexit.register(_running.end)

    os.register_at_fork(after_in_child=_forked)


class _Call:
    """One call that can be followed and stopped."""

    def __init__(self, function: Callable[[Any], Any], progress: Optional[Progress],
                 options: Collection[str] = ()) -> None:
        self._function = function
        self._progress = progress
        self._options = options
        self._error: Optional[int] = None
        self._fault: Optional[BaseException] = None
        self._stop = False

    def run(self) -> None:
        """Runs the call; raises what the library reports, or what the progress function raised."""
        if threading.current_thread() is threading.main_thread():
            self._run_interruptible()
        else:
            self._run()
        error, self._error = self._error, None
        if error and _running.ending:
            # Python ends a thread without a word by SystemExit.  The traceback of another exception
            # would be written while the interpreter ends, which may abort the process.
            _library.sw_error_free(error)
            raise SystemExit
        if self._fault is not None:
            if error:
                _library.sw_error_free(error)
            raise self._fault
        _succeed(error, self._options)

    def _run(self) -> None:
        with _running:
            try:
                self._error = self._function(ctypes.byref(ProgressCall(REPORT(self._report), None)))
            except BaseException as fault:  # of ctypes, such as an argument of a wrong type
                self._fault = fault

    def _run_interruptible(self) -> None:
        thread = threading.Thread(target=self._run, name="strainwave")
        try:
            thread.start()
        except RuntimeError:  # the interpreter ends, or the system has no more threads
            self._run()
            return
        while thread.is_alive():
            try:
                thread.join()
            except BaseException as fault:  # of the handler of a signal
                if self._fault is None:
                    self._fault = fault
                self._stop = True

    def _report(self, _context: object, fraction: float) -> int:
        if self._progress is not None and not self._stop:
            try:
                self._progress(fraction)
            except BaseException as fault:
                self._fault = fault
                self._stop = True
        return 1 if self._stop or _running.ending else 0


class Handle:
    """A pointer that the library owns, freed with this object."""

    def __init__(self, pointer: int, free: Callable[[int], None]) -> None:
        self.pointer = pointer
        self._free = free

    def __del__(self) -> None:
        free, pointer = getattr(self, "_free", None), getattr(self, "pointer", None)
        if free is not None and pointer:
            self.pointer = 0
            free(pointer)


def commands() -> list[dict[str, Any]]:
    """The commands with their options and documents."""
    made = Text()
    _succeed(_library.sw_commands(ctypes.byref(made)))
    listed: list[dict[str, Any]] = json.loads(_taken(made))
    return listed


class _Finder:
    """Hands out the texts that a drive names, and keeps those that were found."""

    def __init__(self, find: Callable[[str], Optional[bytes]]) -> None:
        self.found: dict[str, str] = {}
        self.fault: Optional[BaseException] = None
        self._find = find
        self._texts: dict[int, list[bytes]] = {}
        self._next, self._close = NEXT(self._read), CLOSE(lambda _context: None)
        self.function = FIND(self._open)

    def _open(self, _context: object, name: Text, source: Any) -> int:
        try:
            wanted = string(name)
            content = self._find(wanted)
            if content is None:
                return 1
            self.found[wanted] = content.decode("utf-8", "surrogateescape")
            key = len(self._texts) + 1
            self._texts[key] = [content]
            source[0].next, source[0].close, source[0].context = self._next, self._close, key
            return 0
        except BaseException as fault:
            self.fault = fault
            return 1

    def _read(self, key: int, to: int, size: int) -> int:
        rest = self._texts[key]
        piece, rest[0] = rest[0][:size], rest[0][size:]
        ctypes.memmove(to, piece, len(piece))
        return len(piece)


def read_drive(content: str, name: str,
               find: Callable[[str], Optional[bytes]]) -> tuple[Handle, dict[str, str]]:
    """Reads a drive.

    Args:
        content: TOML
        name: name of the text in messages
        find: returns the text that a drive names, such as a compliance table, or None

    Returns:
        the drive, and the texts that it names by their names
    """
    finder = _Finder(find)
    attachments = Attachments(None, 0, finder.function, None)
    pointer = c_void_p()
    error = _library.sw_read(text(content), text(name), ctypes.byref(attachments),
                             ctypes.byref(pointer))
    if finder.fault is not None:
        if error:
            _library.sw_error_free(error)
        if pointer.value:
            _library.sw_drive_free(pointer)
        raise finder.fault
    _succeed(error)
    assert pointer.value
    return Handle(pointer.value, _library.sw_drive_free), finder.found


def edit(content: str, path: str, value: Optional[str]) -> str:
    """The text of a drive with one field set, or removed."""
    made = Text()
    given = None if value is None else text(value)
    _succeed(_library.sw_edit(text(content), text(path),
                              None if given is None else ctypes.byref(given), ctypes.byref(made)))
    return _taken(made)


def drive_fields(drive: Handle) -> Any:
    """The fields of a drive with units, as a result repeats them."""
    made = Text()
    _succeed(_library.sw_drive_fields(drive.pointer, ctypes.byref(made)))
    return json.loads(_taken(made))


def run(drive: Optional[Handle], command: str, options: str, texts: Mapping[str, str],
        progress: Optional[Progress] = None, names: Collection[str] = ()) -> Handle:
    """Runs a command and returns its answer.

    Args:
        options: JSON
        names: names of all options that the command has, for the path of an error
    """
    kept = [(text(name), text(content)) for name, content in texts.items()]
    attached = (Attachment * len(kept))(*(Attachment(*pair) for pair in kept))
    answer = c_void_p()
    command_text, options_text = text(command), text(options)
    call = _Call(lambda told: _library.sw_run(drive.pointer if drive else None, command_text,
                                              options_text, attached, len(kept), told,
                                              ctypes.byref(answer)), progress, names)
    try:
        call.run()
    except BaseException:
        _library.sw_answer_free(answer)  # it came together with a signal
        raise
    assert answer.value
    return Handle(answer.value, _library.sw_answer_free)


def document(answer: Handle, name: str) -> str:
    """A document of an answer."""
    made = Text()
    _succeed(_library.sw_answer_document(answer.pointer, text(name), ctypes.byref(made)))
    return _taken(made)


def batch(drive: Handle, paths: Sequence[str], values: int, n_rows: int, outputs: Sequence[str],
          method: str, threads: int, numbers: int, codes: int,
          progress: Optional[Progress]) -> tuple[list[str], TableEvidence]:
    """Evaluates a drive for each row of values.

    Args:
        values: address of doubles, shape (n_rows, n_paths)
        numbers: address of doubles, shape (n_rows, n_outputs)
        codes: address of C ints, shape (n_rows)

    Returns:
        the message of the first row with each code, or an empty text; and the error of the tables
        that the rows read, with `points` 0 if there is none
    """
    kept_paths, kept_outputs = [text(path) for path in paths], [text(name) for name in outputs]
    kept_method = text(method)
    task = BatchTask((Text * len(kept_paths))(*kept_paths), len(kept_paths), values, n_rows,
                     (Text * len(kept_outputs))(*kept_outputs), len(kept_outputs), kept_method,
                     threads)
    faults = (Text * ROW_CODES)()
    tables = TableEvidence()
    try:
        _Call(lambda told: _library.sw_batch_with_evidence(
            drive.pointer, ctypes.byref(task), told, numbers, codes, faults, ctypes.byref(tables)),
            progress).run()
    finally:
        said = [_taken(fault) for fault in faults]
    return said, tables


PathLike = Union[str, os.PathLike[str]]
