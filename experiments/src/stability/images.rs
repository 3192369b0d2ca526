//! Images for several cases.

use eigenshade::{Basis, Light, Material, Scalar};
use eigenshade_shading::owned_basis::OwnedBasis;
use eigenshade_shading::shader::{OwnedNormals, Shader};
use eigenshade_table::Table;

/// d by projection, and by a transfer of the material and a new light.
pub fn coefficients<S: Scalar>(
    basis: &Basis<'_, S>,
    light: &[f64],
    material: &[f64],
) -> [Vec<S>; 2] {
    let rounded = |values: &[f64]| values.iter().map(|&value| S::from_f64(value)).collect();
    let (light, material): (Vec<S>, Vec<S>) = (rounded(light), rounded(material));
    let light = Light::new(&light).expect("coefficients");
    let material = Material::new(&material).expect("coefficients");
    let mut workspace = vec![S::ZERO; basis.workspace_len()];
    let mut transfer = vec![S::ZERO; basis.transfer_len()];
    let [mut projected, mut relit] = [(); 2].map(|()| vec![S::ZERO; basis.components()]);
    basis.project_into(&light, &material, &mut workspace, &mut projected).expect("sizes");
    basis.transfer_into(&material, &mut workspace, &mut transfer).expect("sizes");
    basis.relight_into(&transfer, &light, &mut relit).expect("sizes");
    [projected, relit]
}

/// The image of a table with all components, from the collapsed polynomials.
pub fn shaded<S: Scalar + Into<f64>>(
    table: &Table,
    light: &[f64],
    material: &[f64],
    normals: &[[f64; 3]],
) -> Vec<f64> {
    let owned = OwnedBasis::<S>::new(table);
    let mut shader = Shader::new(owned.basis().expect("a basis"), usize::MAX);
    let (degree, order) = (table.gram.degree, table.gram.order);
    let image = shader.polynomial((degree, light), (order, material), &OwnedNormals::new(normals));
    image.expect("coefficients that fit").into_iter().map(Into::into).collect()
}
