"""Image irradiance of real materials under captured light.

>>> import eigenshade as es
>>> table = es.Table()
>>> image = table.render(es.lights.lobby.rotated(yaw=0.5), es.materials.gold_metallic_paint, size=64)
>>> image.shape, image.dtype
((64, 64, 4), dtype('float32'))

"(n)" is an equation of P. Nillius and J.-O. Eklundh, "Phenomenological Eigenfunctions for Image
Irradiance", ICCV 2003.
"""

from . import _eigenshade
from ._eigenshade import Light, Material, Reading, Table, __version__

__all__ = ["Light", "Material", "Reading", "Table", "lights", "materials"]


class Named:
    """Lights or materials by name: ``lights.lobby``, ``lights["blender-courtyard"]``, or one by one."""

    def __init__(self, kind, entries):
        self._kind = kind
        self._entries = {entry.name: entry for entry in entries}

    def __getitem__(self, name):
        try:
            return self._entries[name]
        except KeyError:
            raise KeyError(self._missing(name)) from None

    def __contains__(self, name):
        return name in self._entries

    def keys(self):
        return self._entries.keys()

    def __getattr__(self, name):
        if name.startswith("_"):
            raise AttributeError(name)
        for entry in self._entries.values():
            if _attribute(entry.name) == name:
                return entry
        raise AttributeError(self._missing(name.replace("_", "-")))

    def _missing(self, name):
        return _eigenshade.missing(self._kind, str(name), list(self._entries))

    def __dir__(self):
        return sorted(name for name in map(_attribute, self._entries) if name.isidentifier())

    def __iter__(self):
        return iter(self._entries.values())

    def __len__(self):
        return len(self._entries)

    def __repr__(self):
        return f"<{len(self)} shipped {self._kind}s>"


def _attribute(name):
    return "".join(letter if letter.isalnum() else "_" for letter in name)


lights = Named("light", _eigenshade.lights())
materials = Named("material", _eigenshade.materials(7))
