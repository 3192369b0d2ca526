"""The core, with the options that the environment has."""

import os

from SCons.Script import DefaultEnvironment

env = DefaultEnvironment()
processor, linked = (os.environ[name].split() for name in ("PROCESSOR", "LINKED"))
env.Append(
    CPPPATH=[os.environ["CORE"]],
    CCFLAGS=[*processor, "-ffunction-sections", "-fdata-sections"],
    CXXFLAGS=["-fno-exceptions", "-fno-rtti", "-fno-threadsafe-statics"],
    LINKFLAGS=[*processor, *linked, "-Wl,--gc-sections"],
    LIBS=["m"],
)
