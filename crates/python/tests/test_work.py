"""Long work: progress, Ctrl-C and threads."""

import fcntl
import os
import pty
import re
import signal
import struct
import subprocess
import sys
import termios
import threading
import time
from pathlib import Path

import eigenshade as es
import numpy as np
import pytest

LIGHT, MATERIAL = es.lights.park, es.materials.gold_metallic_paint
TABLES = Path(__file__).parents[3] / "tables"


def make(_):
    es.Table.make(TABLES / "pbr-32.toml")


def find_sources(folder):
    file = folder / "lamps.pfm"
    texels = np.random.default_rng(1).exponential(size=(256, 512, 3)) ** 4
    file.write_bytes(b"PF\n512 256\n-1.0\n" + texels.astype("<f4").tobytes())
    es.Light.load(file, sources=16)


def shade(_):
    es.Table().shade(LIGHT, MATERIAL, np.tile([0.6, 0.0, 0.8], (2_000_000, 1)))


def render(_):
    es.Table("pbr").render(LIGHT, MATERIAL, size=8192)


def read(_):
    normals = np.random.default_rng(2).normal(size=(1_000_000, 3))
    normals[:, 2] = np.abs(normals[:, 2])
    es.Table().read(normals[:, 2], normals)


@pytest.mark.parametrize("work", [make, find_sources, shade, render, read])
def test_ctrl_c_ends_work(work, tmp_path):
    # A process in the background begins with the signal ignored.
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    timer = threading.Timer(0.3, os.kill, [os.getpid(), signal.SIGINT])
    start = time.monotonic()
    try:
        timer.start()
        with pytest.raises(KeyboardInterrupt):
            while True:  # Until it is interrupted, however fast the machine is.
                work(tmp_path)
    finally:
        timer.cancel()
        signal.signal(signal.SIGINT, before)
    assert time.monotonic() - start < 1.3
    time.sleep(1)
    before = time.process_time()
    time.sleep(1)
    assert time.process_time() - before < 0.1


def test_other_threads_run_during_long_work():
    turns, is_done = 0, threading.Event()

    def count():
        nonlocal turns
        while not is_done.wait(0.01):
            turns += 1

    thread = threading.Thread(target=count, daemon=True)
    thread.start()
    shade(None)
    is_done.set()
    thread.join()
    assert turns >= 3


def test_short_calls_do_not_wait_for_long_ones():
    table = es.Table("sphere")
    thread = threading.Thread(target=make, args=[None])
    thread.start()
    time.sleep(0.3)
    start = time.monotonic()
    table.shade(LIGHT, MATERIAL, [0, 0, 1])
    waited = time.monotonic() - start
    assert thread.is_alive()
    thread.join()
    assert waited < 0.5


def test_a_terminal_shows_a_bar():
    """One step for each azimuth up to degree 32."""
    terminal, end = pty.openpty()
    fcntl.ioctl(end, termios.TIOCSWINSZ, struct.pack("HHHH", 24, 80, 0, 0))
    code = f"import eigenshade; eigenshade.Table.make({str(TABLES / 'pbr-32.toml')!r})"
    terminal_type = {**os.environ, "TERM": "xterm"}
    process = subprocess.Popen([sys.executable, "-c", code], stderr=end, env=terminal_type)
    os.close(end)
    shown = b""
    try:
        while part := os.read(terminal, 4096):
            shown += part
    except OSError:
        pass  # The end is closed.
    os.close(terminal)
    assert process.wait() == 0
    assert b"eigenimages [" in shown
    steps = [int(step) for step in re.findall(rb"(\d+)/33", shown)]
    assert steps and steps == sorted(steps)


def test_many_short_calls_share_threads():
    table = es.Table("sphere")

    def threads_after_a_call():
        table.shade(LIGHT, MATERIAL, [0, 0, 1])
        return len(os.listdir("/proc/self/task"))

    before = threads_after_a_call()
    # A call that is slow, on a busy machine, has a thread for its spinner.
    assert max(threads_after_a_call() for _ in range(2000)) <= before + 1


def test_a_forked_process_has_threads_of_its_own():
    table = es.Table("sphere")
    expected = table.shade(LIGHT, MATERIAL, [0, 0, 1])
    child = os.fork()
    if child == 0:
        signal.alarm(60)
        os._exit(not (table.shade(LIGHT, MATERIAL, [0, 0, 1]) == expected).all())
    assert os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]) == 0
