"""The programs of the pages run, and give arrays of the shapes that they state."""

from pathlib import Path

import numpy as np
import pytest

ROOT = Path(__file__).parents[3]


@pytest.mark.parametrize("page", ["README.md", "crates/python/README.md"])
def test_the_first_program_of_a_page_runs(page):
    text = (ROOT / page).read_text()
    program = text.split("```python\n", 1)[1].split("```", 1)[0]
    names = {}
    exec(compile(program, page, "exec"), names)
    assert names["image"].shape == (240, 240, 4) and names["image"].dtype == np.float32
    assert names["d"].shape == (3, 160)
    if "design" in names:
        # Without a mean image the projection is linear in the light.
        products = np.einsum("ckl,cl->ck", names["design"], names["light"].truncated(9).coefficients)
        assert np.allclose(products, names["d"], rtol=0, atol=1e-12 * abs(names["d"]).max())


def test_the_reading_of_the_page_finds_its_material():
    text = (ROOT / "crates/python/README.md").read_text()
    blocks = [part.split("```", 1)[0] for part in text.split("```python\n")[1:]]
    [first, reading] = [block for block in blocks if "es.Table()" in block or "table.read(" in block]
    names = {"np": np}
    exec(compile(first + reading, "README.md", "exec"), names)
    assert names["reading"].materials[0][0] == "gold-metallic-paint"
    assert names["reading"].light.coefficients.shape == (3, 100)
