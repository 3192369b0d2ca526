"""Links the library of the board's processor. Named in library.json."""

import os
import sys

Import("env")  # noqa: F821

env = env  # noqa: F821
names = [env.BoardConfig().get(key, "") for key in ("build.mcu", "build.cpu")]
folders = [os.path.join(os.getcwd(), "src", name) for name in names if name]
folder = next(filter(os.path.isdir, folders), None)
if folder is None:
    sys.exit("eigenshade has no library for %s: see its README.md" % " or ".join(names))
if "-mfloat-abi=softfp" in env.Flatten([env.get("CCFLAGS", []), env.get("LINKFLAGS", [])]):
    # Its folder is inside.
    folder = next((each.path for each in os.scandir(folder) if each.is_dir()), folder)
env.Append(LIBPATH=[folder], LIBS=["eigenshade"])
