"""The package has the program's numbers. EIGENSHADE is the program."""

import csv
import os
import struct
import subprocess
import zlib
from pathlib import Path

import eigenshade as es
import numpy as np
import pytest

LIGHT, MATERIAL = es.lights.park, es.materials.gold_metallic_paint


def program(*arguments):
    done = subprocess.run([os.environ["EIGENSHADE"], *map(str, arguments)], capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return list(csv.DictReader(line for line in done.stdout.splitlines() if not line.startswith("#")))


def rgb(rows):
    return np.array([[float(row[channel]) for row in rows] for channel in "rgb"])


def test_projection_is_the_programs_bit_for_bit():
    rows = program("project", "--table", "color", "-l", "park", "-m", "gold-metallic-paint")
    assert (es.Table().project(LIGHT, MATERIAL) == rgb(rows)).all()


def test_irradiance_is_the_programs_bit_for_bit(tmp_path):
    assert (es.Table().shade(LIGHT, MATERIAL, NORMALS).T == shaded(tmp_path)).all()


def test_a_turned_light_is_the_programs(tmp_path):
    """The program turns by Rz Ry Rz."""
    found = es.Table().shade(LIGHT.rotated(yaw=0.5), MATERIAL, NORMALS).T
    assert np.abs(found - shaded(tmp_path, "--rotate", "0,0.5,0")).max() <= 1e-14 * np.abs(found).max()


NORMALS = np.array([[0, 0, 1], [0.6, 0, 0.8], [-0.48, 0.64, 0.6]])


def shaded(folder, *options):
    """The program's irradiance of the normals in f64."""
    file = folder / "normals.csv"
    np.savetxt(file, NORMALS, delimiter=",", header="x,y,z", comments="")
    pair = ["-l", LIGHT.name, "-m", MATERIAL.name]
    way = ["--table", "color", "--method", "eigen", "--format", "f64", *options]
    return rgb(program("shade", *pair, "-n", file, *way))


def test_a_reading_is_the_programs(tmp_path):
    table = es.Table("curet")
    normals, inside = sphere(64)
    seen = table.shade(es.lights.studio, es.materials["01-felt"], normals[inside])
    reading = table.read(seen, normals[inside])
    image, of_normals = tmp_path / "image.csv", tmp_path / "normals.csv"
    for file, rows, header in [(image, seen, "r,g,b"), (of_normals, normals[inside], "x,y,z")]:
        np.savetxt(file, rows, delimiter=",", header=header, comments="", fmt="%.17g")
    rows = program("read", image, "-n", of_normals, "--table", "curet")
    d = [row for row in rows if row["quantity"] == "d" and row["name"] == "posterior"]
    assert np.allclose(reading.d, rgb(d), rtol=1e-9, atol=1e-9 * np.abs(reading.d).max())
    names = [row["name"] for row in rows if row["quantity"] == "material-evidence"]
    assert [name for name, _ in reading.materials] == names
    assert reading.pixels == inside.sum()


def sphere(size):
    """The normals of the picture of a sphere, and where it is."""
    place = (2 * np.arange(size) + 1 - size) / (size - 1)
    x, y = np.meshgrid(place, -place)
    inside = x**2 + y**2 < 1
    z = np.sqrt(np.where(inside, 1 - x**2 - y**2, 0))
    return np.stack([x, y, z], axis=-1), inside


def test_a_picture_is_the_images_of_its_normals_in_f32():
    picture = es.Table("sphere").render(LIGHT, MATERIAL, 64)
    normals, inside = sphere(64)
    expected = es.Table("sphere").shade(LIGHT, MATERIAL, normals[inside])
    assert picture.dtype == np.float32
    assert np.abs(picture[inside, :3] - expected).max() <= 2e-6 * expected.max()
    assert (picture[..., 3] > 0)[inside].all() and picture[0, 0].tolist() == [0, 0, 0, 0]


@pytest.mark.parametrize("sources", [1, 4])
def test_sources_add_highlights(sources):
    table, copper = es.Table("sphere"), es.Material.gltf("#b87333", metallic=1, roughness=0.3)
    sharp = table.render(es.lights.lobby, copper, 64, sources=sources)
    assert sharp[..., :3].max() > 1.2 * table.render(es.lights.lobby, copper, 64)[..., :3].max()


SCENES = Path(__file__).parents[3] / "tests" / "scenes"


def test_a_scene_becomes_the_programs_table(tmp_path):
    file = tmp_path / "order.bin"
    scene = SCENES / "order.toml"
    subprocess.run([os.environ["EIGENSHADE"], "basis", "--scene", scene, "--out", file], check=True)
    made, written = es.Table.make(scene), es.Table.load(file)
    assert (made.eigenimages(NORMALS) == written.eigenimages(NORMALS)).all()
    assert (made.projection == written.projection).all()


def test_a_map_becomes_a_light(tmp_path):
    """An even map of radiance 0.5: a single coefficient, 0.5 sqrt(4 pi)."""
    file = tmp_path / "even.pfm"
    file.write_bytes(b"PF\n256 128\n-1.0\n" + np.full((128, 256, 3), 0.5, "<f4").tobytes())
    light = es.Light.load(file, degree=4)
    expected = np.zeros((3, 25))
    expected[:, 0] = 0.5 * np.sqrt(4 * np.pi)
    assert light.name == "even" and np.abs(light.coefficients - expected).max() < 2e-4
    with pytest.raises(ValueError, match="a map has one light; leave `name` out"):
        es.Light.load(file, name="even")


def test_a_light_csv_has_its_lights_and_the_degree_that_is_asked(tmp_path):
    file = tmp_path / "lights.csv"
    file.write_text("name,l,m,r,g,b\na,0,0,1,1,1\nb,0,0,1,2,3\n")
    assert es.Light.load(file, name="b").coefficients.tolist() == [[1], [2], [3]]
    with pytest.raises(ValueError, match="its lights end at degree 0"):
        es.Light.load(file, name="b", degree=1)
    with pytest.raises(ValueError, match="it has 2 entries"):
        es.Light.load(file)


def test_a_file_of_materials_is_the_programs(tmp_path):
    file = tmp_path / "metal.csv"
    options = ["--base-color", "0.9,0.6,0.3", "--metallic", "1", "--roughness", "0.5"]
    program("material", "gltf", *options, "--order", "7", "--out", file)
    read, made = es.Material.load(file), es.Material.gltf([0.9, 0.6, 0.3], metallic=1, roughness=0.5)
    assert np.abs(read.coefficients - made.coefficients).max() <= 1e-8 * made.coefficients.max()
    assert read.gloss["roughness"] == made.gloss["roughness"] == 0.5
    assert np.allclose(made.gloss["f0"], [0.9, 0.6, 0.3]) and np.allclose(made.gloss["albedo"], 0)
    with pytest.raises(ValueError, match="its materials have order 7, not 8"):
        es.Material.load(file, order=8)


def test_what_is_ignored_in_a_file_is_a_warning(tmp_path):
    """White sky in a square PNG of 8 bits, where it is clipped."""

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", 8, 8, 8, 2, 0, 0, 0)
    rows = (b"\0" + b"\xff" * 24) * 8
    chunks = [chunk(b"IHDR", header), chunk(b"IDAT", zlib.compress(rows)), chunk(b"IEND", b"")]
    file = tmp_path / "sky.png"
    file.write_bytes(b"\x89PNG\r\n\x1a\n" + b"".join(chunks))
    with pytest.warns(UserWarning) as warned:
        es.Light.load(file)
    assert [one.filename for one in warned] == [__file__] * 2
    shape, clipped = (str(one.message) for one in warned)
    assert shape.endswith("sky.png: it is not twice as wide as high; it is read as equirectangular")
    assert "sky.png: light is clipped at white" in clipped and "; use an .hdr or .exr map" in clipped
