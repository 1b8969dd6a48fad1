# SPDX-License-Identifier: Apache-2.0
"""Interrupts, threads, processes, the end of the interpreter, memory, and wrong calls: none ends
the interpreter by a signal."""

import functools
import inspect
import json
import multiprocessing
import os
import signal
import subprocess
import sys
import threading
import time
import unittest

import strainwave as sw
from strainwave import _library
from support import EXAMPLES, main, python, trials

CURVE = str(EXAMPLES / "catalogue_size25.toml")
SHAFT = str(EXAMPLES / "solid_shaft.toml")

# Work of about a minute, which a progress callback can stop.
LONG = """
import signal, sys, threading, time
import numpy as np, strainwave as sw
drive = sw.read(sys.argv[1])
def long(**more):
    return drive.batch({"load.torque": np.linspace(10, 20, 2_000_000)}, ["intact.stiffness"], threads=1, **more)
"""


def stiffness(path):
    return sw.read(path).stiffness().intact.stiffness.value


class Interrupts(unittest.TestCase):
    def interrupted(self, code):
        """Sends Ctrl-C while the code runs; returns what was printed, and how long it took."""
        running = subprocess.Popen([sys.executable, "-u", "-c", LONG + code, CURVE], text=True,
                                   stdout=subprocess.PIPE, stderr=subprocess.PIPE)
        self.addCleanup(running.kill)  # a program that does not stop must not outlive the test
        self.assertEqual(running.stdout.readline(), "begins\n")
        time.sleep(0.3)
        begin = time.monotonic()
        running.send_signal(signal.SIGINT)
        out, error = running.communicate(timeout=30)
        self.assertLess(time.monotonic() - begin, 10)
        self.assertEqual(running.returncode, 0, error)
        self.assertNotIn("Exception ignored", error)
        return out

    def test_behaviour_control_c_in_a_batch(self):
        self.assertEqual(self.interrupted(
            "print('begins')\ntry: long()\nexcept KeyboardInterrupt: print('stopped')\n"), "stopped\n")

    def test_behaviour_control_c_in_a_command(self):
        self.assertEqual(self.interrupted(
            "print('begins')\n"
            "try: drive.torsion(draws=100_000)\n"
            "except KeyboardInterrupt: print('stopped')\n"), "stopped\n")

    def test_behaviour_a_handler_of_the_user(self):
        self.assertEqual(self.interrupted(
            "class Mine(Exception): pass\n"
            "def handler(*_): raise Mine\n"
            "signal.signal(signal.SIGINT, handler)\nprint('begins')\n"
            "try: long()\nexcept Mine: print('mine')\n"), "mine\n")

    def test_behaviour_the_main_thread_stops_while_another_computes(self):
        self.assertEqual(self.interrupted(
            "threading.Thread(target=long, daemon=True).start()\nprint('begins')\n"
            "try: time.sleep(60)\nexcept KeyboardInterrupt: print('stopped')\n"), "stopped\n")

    def test_behaviour_the_interpreter_ends_amid_a_run(self):
        for options in ("", "progress=lambda fraction: None"):
            ended = python(LONG + f"threading.Thread(target=lambda: long({options}), daemon=True)"
                           ".start()\ntime.sleep(0.3)\n", CURVE)
            self.assertEqual((ended.returncode, ended.stderr), (0, ""))


class Parallel(unittest.TestCase):
    def test_identity_threads_share_a_drive(self):
        drive = sw.read(CURVE)
        want = drive.stiffness().to_dict()
        found = []
        threads = [threading.Thread(target=lambda: found.append(drive.stiffness().to_dict()))
                   for _ in range(8)]
        for thread in threads:
            thread.start()
        for thread in threads:
            thread.join()
        self.assertEqual(found, [want] * 8)

    def test_behaviour_the_lock_is_released(self):
        """While one thread computes, another runs Python."""
        drive = sw.read(CURVE)
        count = 0
        done = threading.Event()

        def compute():
            drive.torsion(compare=True)
            done.set()

        thread = threading.Thread(target=compute)
        thread.start()
        while not done.wait(0.001):
            count += 1
        thread.join()
        self.assertGreater(count, 5)

    def test_identity_forked_and_spawned_processes(self):
        want = stiffness(SHAFT)
        for method in ("fork", "spawn"):
            with multiprocessing.get_context(method).Pool(2) as pool:
                self.assertEqual(pool.map(stiffness, [SHAFT] * 4), [want] * 4)

    def test_behaviour_drives_go_to_other_processes(self):
        with multiprocessing.get_context("fork").Pool(2) as pool:
            found = pool.map(sw.Drive.stiffness, [sw.read(SHAFT)] * 3)
        self.assertEqual({answer.intact.stiffness.value for answer in found}, {stiffness(SHAFT)})


class Memory(unittest.TestCase):
    def test_behaviour_a_drive_is_freed_once(self):
        """Also if somebody calls what the interpreter calls at the end."""
        freed = []
        handle = _library.Handle(5, freed.append)
        handle.__del__()
        del handle
        self.assertEqual(freed, [5])

    def test_behaviour_reading_and_running_keeps_no_memory(self):
        """After 300 rounds, 1000 more rounds must not need 2 MiB; 2 kB lost a round would show.  The environment
        variable STRAINWAVE_LONG asks for 100 000 rounds, so that 20 bytes lost a round would show."""
        rounds = 100_000 if os.environ.get("STRAINWAVE_LONG") else 1000
        ended = python("""
import resource, sys
import strainwave as sw
def round():
    drive = sw.read(sys.argv[1])
    drive["load.torque"] = "5 N*m"
    answer = drive.stiffness()
    answer.document("text")
    drive.batch({"load.torque": [1.0, -1.0]}, ["intact.stiffness"])
    try: drive["load.torque"] = "5 kg"
    except sw.InputError: pass
    try: drive.stiffness(method="exact")
    except sw.InputError: pass
def resident():
    with open("/proc/self/statm") as file: return int(file.read().split()[1]) * resource.getpagesize()
for _ in range(300): round()
before = resident()
for _ in range(int(sys.argv[2])): round()
print((resident() - before) / 2**20)
""", SHAFT, str(rounds), timeout=1500)
        self.assertEqual(ended.returncode, 0, ended.stderr)
        self.assertLess(float(ended.stdout), 2)


DRIVE = sw.read(SHAFT)
WRONG = [None, True, 0, -1, 1 << 70, 1.5, float("nan"), float("inf"), 1j, "", "x", "\0", "\ud800", "ä" * 9,
         b"x", b"\xff", [], [None], ["x"], [1, [2]], (), {}, {"x": 1}, {1: 2}, set(), object(), len, type,
         DRIVE, sw, NotImplemented, ..., range(3), memoryview(b"x"), iter([])]
# Functions that are not commands, each with one wrong argument.
OWN = [
    ("read", lambda x: sw.read(x)), ("parse", lambda x: sw.parse(x)),
    ("parse name", lambda x: sw.parse(DRIVE.text, x)),
    ("parse tables", lambda x: sw.parse("format = 'strainwave-drive/1'", "x", x)),
    ("get", lambda x: DRIVE[x]), ("set path", lambda x: DRIVE.copy().__setitem__(x, "3 mm")),
    ("set value", lambda x: DRIVE.copy().__setitem__("output_shaft.length", x)),
    ("delete", lambda x: DRIVE.copy().__delitem__(x)), ("edit", lambda x: DRIVE.copy().edit(x)),
    ("append", lambda x: DRIVE.copy().cracks.append(x)),
    ("append depth", lambda x: DRIVE.copy().cracks.append("output_shaft", kind="annular", depth=x)),
    ("cracks", lambda x: DRIVE.cracks[x]), ("document", lambda x: DRIVE.stiffness().document(x)),
    ("save", lambda x: DRIVE.stiffness().save("/nonexistent/x", x)),
    ("batch values", lambda x: DRIVE.batch(x, ["intact.stiffness"])),
    ("batch row", lambda x: DRIVE.batch({"load.torque": x}, ["intact.stiffness"])),
    ("batch outputs", lambda x: DRIVE.batch({"load.torque": [1.0]}, x)),
    ("batch threads", lambda x: DRIVE.batch({"load.torque": [1.0]}, ["intact.stiffness"], threads=x)),
    ("batch out", lambda x: DRIVE.batch({"load.torque": [1.0]}, ["intact.stiffness"], out=x)),
    ("sif", lambda x: sw.sif[x]), ("sif field", lambda x: sw.sif["plate-surface"](tension=x)),
    ("material", lambda x: sw.materials[x]), ("new", lambda x: sw.new(size=x)),
    ("quantity", lambda x: float(sw.Quantity(x, x))),
]
EXPECTED = (sw.Error, TypeError, ValueError, KeyError, IndexError, AttributeError, OSError, OverflowError)

# A drive that the command can answer; the others take the shaft.
ANSWERED = {"laminate": "composite_cup", "inspect": "inspected_shaft", "grow": "growing_shaft", "life": "life_size25",
            "duty": "duty_size25", "sensitivity": "article_scatter", "reliability": "article_scatter",
            "torsion": "catalogue_size25", "calibrate": "catalogue_size25", "transmission": "catalogue_size25",
            "turn": "cracked_size25", "oval": "cracked_size25", "modes": "joint_size25", "frf": "joint_size25",
            "simulate": "joint_size25", "backbone": "joint_size25", "accuracy": "robot_axis"}
LONGEST = 0.05  # s; a call that computes longer than this was not refused, and is stopped


class Stopped(BaseException):
    """A call took too long."""


def stop(*_):
    raise Stopped


def calls_of(command):
    """Calls of a command with one wrong argument: pairs of a name and a function."""
    name = command["name"].replace(" ", "_")
    if command["takes"] == "drive":
        function = getattr(sw.read(EXAMPLES / f"{ANSWERED.get(name, 'solid_shaft')}.toml"), name)
    else:
        function = getattr(sw._commands, name)
    given = json.loads(next(text for trial, text in trials() if trial == command["name"]))
    signature = inspect.signature(function).parameters
    needed = {parameter: given[parameter] for parameter, about in signature.items() if about.default is about.empty}
    for parameter in signature:
        for wrong in WRONG:
            yield f"{name} {parameter} {wrong!a:.40}", functools.partial(function, **{**needed, parameter: wrong})


def tried(calls, names):
    """Makes the calls and writes the name of each before it begins; 1 if a call raises an exception
    of another kind than expected, 0 otherwise."""
    signal.signal(signal.SIGALRM, stop)
    for name, call in calls:
        os.write(names, f"{name}\n".encode())
        try:
            try:
                signal.setitimer(signal.ITIMER_REAL, LONGEST)
                call()
            except (*EXPECTED, Stopped):
                pass
            except BaseException:
                return 1
            finally:
                signal.setitimer(signal.ITIMER_REAL, 0)
        except Stopped:  # while the call ended by itself
            pass
    return 0


@unittest.skipUnless(hasattr(os, "fork"), "needs fork")
class WrongCalls(unittest.TestCase):
    def test_input_no_wrong_call_ends_the_interpreter(self):
        """Each argument of each command, and each other function, with each wrong value; each command and
        each other function in a process of its own."""
        groups = [calls_of(command) for command in _library.commands()]
        groups += [[(f"{name} {wrong!a:.40}", functools.partial(call, wrong)) for wrong in WRONG]
                   for name, call in OWN]
        count = 0
        for calls in groups:
            reader, writer = os.pipe()
            child = os.fork()
            if child == 0:
                os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
                os._exit(tried(calls, writer))
            os.close(writer)
            with open(reader, encoding="ascii") as written:
                names = written.read().splitlines()
            _, status = os.waitpid(child, 0)
            code = os.waitstatus_to_exitcode(status)
            self.assertGreaterEqual(code, 0, f"{names[-1:]} ended by signal {-code}")
            self.assertEqual(code, 0, f"{names[-1:]} raised another kind of exception")
            count += len(names)
        self.assertGreater(count, 5000)


if __name__ == "__main__":
    main()
