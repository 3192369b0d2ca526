"""The equations of the paper, by numpy alone."""

import copy

import eigenshade as es
import numpy as np
import pytest

LIGHT, MATERIAL = es.lights.park, es.materials.gold_metallic_paint


@pytest.fixture(scope="module")
def table():
    return es.Table("curet")


def modes(table, light, material):
    """c = L (x) b, channel by channel."""
    l, m, o, p, q = table.modes.T
    place = {tuple(index): k for k, index in enumerate(material.indices.tolist())}
    of_material = [place[index] for index in zip(o, p, q)]
    return light.coefficients[:, l * l + l + m] * material.coefficients[:, of_material]


def test_projection_is_the_product_with_the_rows_of_utm(table):
    d = table.project(LIGHT, MATERIAL)
    c = modes(table, LIGHT, MATERIAL)
    assert np.abs(c @ table.projection.T - d).max() <= 1e-12 * np.abs(d).max()


def test_the_rows_are_u_times_the_gram_matrix(table):
    U, gram = table.mode_coefficients, table.gram
    assert gram.shape == (len(table.modes),) * 2
    rows = U.T @ gram
    assert np.abs(rows - table.projection).max() <= 1e-9 * np.abs(rows).max()
    assert np.abs(rows @ U - np.eye(table.components)).max() <= 1e-9


def test_eigenimages_are_orthonormal_over_a_sphere(table):
    """By means over the normals of a sphere's picture, whose density is that of the slant's cosine."""
    nodes, weights = np.polynomial.legendre.leggauss(40)
    z, tilts = (nodes + 1) / 2, 2 * np.pi * np.arange(48) / 48
    r = np.sqrt(1 - z**2)
    normals = np.stack(
        [np.outer(r, np.cos(tilts)), np.outer(r, np.sin(tilts)), np.outer(z, np.ones(48))], axis=-1
    )
    images = table.eigenimages(normals.reshape(-1, 3))
    weights = np.repeat(weights * z, 48) / 48
    assert np.abs(images.T @ (weights[:, None] * images) - np.eye(table.components)).max() < 1e-7  # profile_tolerance


def test_a_lifted_image_projects_back(table):
    d = table.project(LIGHT, MATERIAL)
    c = table.lift(d)
    assert c.shape == (3, len(table.modes))
    assert np.abs(c @ table.projection.T - d).max() <= 1e-9 * np.abs(d).max()


def test_the_matrix_of_a_material_is_the_projection_of_every_light(table):
    matrix = table.matrix(MATERIAL)
    assert matrix.shape == (3, table.components, 100)
    for light in list(es.lights)[::5]:
        d = table.project(light, MATERIAL)
        found = np.einsum("ckn,cn->ck", matrix, light.truncated(9).coefficients)
        assert np.abs(found - d).max() <= 1e-12 * np.abs(d).max()


def test_the_gradient_of_a_fit_is_a_product_with_the_matrix(table):
    """Against central differences of the error of a picture in one coefficient of the light."""
    rng = np.random.default_rng(7)
    normals = rng.normal(size=(50, 3))
    normals[:, 2] = np.abs(normals[:, 2])
    design = table.eigenimages(normals) @ table.matrix(MATERIAL)[0]
    seen = table.shade(LIGHT, MATERIAL, normals)[:, 0]

    def error(light):
        picture = table.shade(es.Light(light), MATERIAL, normals)[:, 0]
        return ((picture - seen) ** 2).sum()

    light = rng.normal(size=100)
    gradient = 2 * design.T @ (design @ light - seen)
    step = 1e-4
    for k in range(0, 100, 9):
        moved = np.zeros(100)
        moved[k] = step
        found = (error(light + moved) - error(light - moved)) / (2 * step)
        assert abs(found - gradient[k]) <= 1e-6 * np.abs(gradient).max()


def test_a_turned_light_is_the_light_of_turned_directions():
    """Degree 1 is a vector: L_1^-1, L_1^0, L_1^1 are -y, z and -x."""
    light = es.Light([0, 1, 2, 3])
    yaw, pitch, roll = 0.3, -0.7, 1.1
    (sy, cy), (sx, cx), (sz, cz) = ((np.sin(a), np.cos(a)) for a in (yaw, pitch, roll))
    about_y = np.array([[cy, 0, sy], [0, 1, 0], [-sy, 0, cy]])
    about_x = np.array([[1, 0, 0], [0, cx, -sx], [0, sx, cx]])
    about_z = np.array([[cz, -sz, 0], [sz, cz, 0], [0, 0, 1]])
    x, y, z = about_y @ about_x @ about_z @ [-3, -1, 2]
    turned = light.rotated(yaw=yaw, pitch=pitch, roll=roll).coefficients[0]
    assert np.allclose(turned, [0, -y, z, -x], atol=1e-14)
    one_by_one = light.rotated(roll=roll).rotated(pitch=pitch).rotated(yaw=yaw)
    assert np.allclose(one_by_one.coefficients[0], turned, atol=1e-14)


def test_a_matte_material_reflects_its_albedo():
    """Under even light of radiance 1 the irradiance of a matte surface is its albedo."""
    even = es.Light([np.sqrt(4 * np.pi)])
    found = es.Table().shade(even, es.Material.lambertian([0.2, 0.5, 0.8]), [[0, 0, 1], [0.6, 0, 0.8]])
    assert np.allclose(found, [[0.2, 0.5, 0.8]] * 2, rtol=1e-6)


def test_a_fit_finds_a_material_again():
    rng = np.random.default_rng(3)
    directions = rng.uniform(0, np.pi / 2, size=(4000, 4))
    directions[:, 1::2] *= 4
    found = es.Material.fit(directions, np.full((4000, 3), 0.3 / np.pi), order=2)
    assert np.allclose(found.coefficients[:, 0], es.Material.lambertian(0.3).coefficients[:, 0], rtol=1e-3)
    assert np.abs(found.coefficients[:, 1:]).max() < 1e-3


def test_normals_keep_their_places(table):
    normals = np.random.default_rng(5).normal(size=(4, 6, 3))
    normals[..., 2] = np.abs(normals[..., 2])
    flat = normals.reshape(-1, 3)
    assert (table.eigenimages(normals).reshape(24, -1) == table.eigenimages(flat)).all()
    assert (table.shade(LIGHT, MATERIAL, normals).reshape(24, 3) == table.shade(LIGHT, MATERIAL, flat)).all()
    assert table.mean_image(normals).tolist() == np.zeros((4, 6)).tolist()
    assert table.shade(LIGHT, MATERIAL, [0, 0, 1]).shape == (3,)


def test_a_window_scales_degrees_and_leaves_no_sources():
    light = es.lights.lobby.truncated(2).windowed(4)
    scale = [1, np.sinc(1 / 4) ** 4, np.sinc(2 / 4) ** 4]
    expected = es.lights.lobby.truncated(2).coefficients * np.repeat(scale, [1, 3, 5])
    assert np.allclose(light.coefficients, expected, rtol=1e-12)
    assert len(es.lights.lobby.sources) > 0 and len(light.sources) == 0


def test_a_mask_and_a_gray_picture_are_read(table):
    normals = np.random.default_rng(6).normal(size=(40, 50, 3))
    normals[..., 2] = np.abs(normals[..., 2])
    picture = table.shade(LIGHT, MATERIAL, normals)[..., 0]
    whole = table.read(picture, normals, noise=1e-6)
    assert whole.d.shape == (1, table.components) and whole.pixels == 2000
    assert np.allclose(whole.d[0], table.project(LIGHT, MATERIAL)[0], atol=1e-3 * np.abs(whole.d).max())
    mask = np.ones((40, 50))
    mask[:10] = 0
    spoiled = picture.copy()
    spoiled[:10] = 7
    masked = table.read(spoiled, normals, mask, noise=1e-6)
    assert masked.pixels == 1500
    assert np.allclose(masked.d, whole.d, atol=1e-3 * np.abs(whole.d).max())


def test_a_table_of_higher_order_takes_materials_of_its_order():
    chrome = es.Material.shipped("chrome", order=12)
    assert chrome.order == 12 and len(chrome.indices) == chrome.coefficients.shape[1]
    assert es.Table("pbr").project(LIGHT, chrome).shape == (3, es.Table("pbr").components)


@pytest.mark.parametrize(
    "wrong, text",
    [
        (lambda: es.Light([1, 2, 3]), "a light of 3 coefficients; give 1, 4, 9"),
        (lambda: es.Light([np.nan]), "coefficients of a light have a NaN; give finite numbers"),
        (lambda: es.Light(np.zeros((2, 4))), "have the shape [2, 4]"),
        (lambda: es.Material([1, 2, 3]), "a material of 3 coefficients"),
        (lambda: es.Material.gltf("#xyz"), "the color \"#xyz\""),
        (lambda: es.Material.gltf(0.5, metallic=2), "metallic is 2; give 0 to 1"),
        (lambda: es.Table("cube"), "`cube` is not a shipped table"),
        (lambda: es.Table().render(LIGHT, MATERIAL, 1), "1 pixels across; ask for 2 to 8192"),
        (lambda: es.Table().shade(LIGHT, MATERIAL, [0, 0, -1]), "normal 0 is (0, 0, -1)"),
        (lambda: es.Table().read([1.0], [[0, 0, 1]]), "1 pixels for 160 components"),
        (lambda: es.Table().read(np.ones((3, 4, 4)), np.ones((4, 4, 3))), "a picture of shape [3, 4, 4]"),
        (lambda: es.Table().read(np.ones((2, 3)), np.ones((3, 2, 3))), "a picture of shape [2, 3]"),
        (lambda: es.Table().read(np.ones(4), np.ones((4, 3)), [1, 1]), "a mask of shape [2]"),
        (lambda: es.Table().read(np.ones(4), np.ones((4, 3)), [1, 1, 1, -1]), "a weight of -1"),
        (lambda: es.Table().read(np.ones(4), np.ones((4, 3)), noise=0), "a noise of 0"),
        (lambda: es.Table().read(np.zeros(4), np.ones((4, 3))), "all pixels that count are black"),
        (lambda: es.Material.shipped("moon"), "no shipped material `moon`; use `maroon-plastic`, or a name"),
        (lambda: es.Material.shipped("chrome", order=9), "do not have order 9; ask for 7, or for 12"),
        (lambda: es.Light.load("no.exr"), "no.exr"),
        (lambda: es.lights.lobby.rotated(yaw=np.inf), "an angle is not finite"),
    ],
)
def test_what_is_wrong_is_a_value_error_that_says_what_to_do(wrong, text):
    with pytest.raises(ValueError) as error:
        wrong()
    assert text in str(error.value)
    assert "; " in str(error.value)


def test_names_are_attributes_and_keys():
    assert es.lights.lobby.name == es.lights["lobby"].name == "lobby"
    assert len(es.lights) == len(list(es.lights)) == len(es.lights.keys())
    assert "lobby" in es.lights and "moon" not in es.lights
    assert "gold_metallic_paint" in dir(es.materials)
    assert copy.copy(es.lights)["lobby"].name == "lobby"
    with pytest.raises(AttributeError, match="no shipped light `moon`"):
        es.lights.moon
    with pytest.raises(KeyError, match="no shipped material `chrom`; use `chrome`, `chrome-steel`, or a name"):
        es.materials["chrom"]
