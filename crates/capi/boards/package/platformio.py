"""Adds the library of the board's processor to what PlatformIO links."""

import os
import sys

Import("env")  # noqa: F821

board = env.BoardConfig()  # noqa: F821
names = [board.get("build.mcu", ""), board.get("build.cpu", "")]
source = os.path.join(os.getcwd(), "src")
folder = next((os.path.join(source, n) for n in names if n and os.path.isdir(os.path.join(source, n))), None)
if folder is None:
    sys.exit("eigenshade has no library for %s: see its README.md" % " or ".join(filter(None, names)))
flags = env.Flatten([env.get(name, []) for name in ("ASFLAGS", "CCFLAGS", "LINKFLAGS")])  # noqa: F821
if "-mfloat-abi=softfp" in flags:
    inside = [name for name in sorted(os.listdir(folder)) if name.endswith("softfp")]
    folder = os.path.join(folder, *inside[:1])
env.Append(LIBPATH=[folder], LIBS=["eigenshade"])  # noqa: F821
