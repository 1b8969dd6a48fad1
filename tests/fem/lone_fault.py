#!/usr/bin/python3
# SPDX-License-Identifier: Apache-2.0
"""Runs the tests of MpiSession that need two ranks.

    lone_fault.py TEST_PROGRAM

If the second rank has a fault while the first waits for it, both end after the waiting time of the test, 0.5 s,
with one message.  If the first is only late, both continue.
"""

import os
import subprocess
import sys
import time

LONGEST = 10  # [s]; waiting time of the program, of which the test uses a twentieth
program, = sys.argv[1:]
environment = dict(os.environ, OMP_NUM_THREADS="1", OMPI_ALLOW_RUN_AS_ROOT="1",
                   OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
for test, message, ends in (("IdentityLoneFaultTogether", "rank 1: a fault in the work", True),
                            ("IdentityLoneFaultLastCode", "a fault at last", True),
                            ("IdentityLateRankIsWaitedFor", "a fault at last", False)):
    start = time.monotonic()
    # If both ranks did not end, this would not return.
    ended = subprocess.run(["mpirun", "--oversubscribe", "-n", "2", program, f"--gtest_filter=MpiSession.{test}"],
                           env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, timeout=60)
    taken = time.monotonic() - start
    said = ended.stdout.count(message)
    if (ended.returncode != 0) != ends or said != 1 or "not ended" in ended.stdout:
        sys.exit(f"{test}: code {ended.returncode}, {said} times {message!r}:\n{ended.stdout}")
    if ends and taken > LONGEST:
        sys.exit(f"{test}: ended after {taken:.1f} s only")
    print(f"{test}: {taken:.1f} s, code {ended.returncode}")
