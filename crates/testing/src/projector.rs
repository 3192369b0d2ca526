//! A basis of either kind in f64, with methods that allocate their buffers.

use eigenshade_shading::owned_basis::{AnyBasis, OwnedBasis};
use eigenshade_table::Table;

pub struct Projector {
    owned: OwnedBasis<f64>,
}

impl Projector {
    pub fn new(table: &Table) -> Self {
        Self { owned: OwnedBasis::new(table) }
    }

    /// d for a light and a material of the table's degree and order.
    pub fn project(&self, light: &[f64], material: &[f64]) -> Vec<f64> {
        let basis = self.owned.any().expect("a basis");
        let span = self.owned.basis().expect("a span");
        let light = eigenshade::Light::new(span.degree(), light).expect("coefficients");
        let material = eigenshade::Material::new(span.order(), material).expect("coefficients");
        match basis {
            AnyBasis::Sphere(basis) => {
                let (mut d, mut workspace) =
                    (vec![0.0; basis.components()], vec![0.0; basis.workspace_len()]);
                basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
                d
            }
            AnyBasis::General(basis) => {
                let (mut d, mut workspace) =
                    (vec![0.0; basis.components()], vec![0.0; basis.workspace_len()]);
                basis.project_into(&light, &material, &mut workspace, &mut d).expect("sizes");
                d
            }
        }
    }

    /// The mean image plus Σ d_i U_i at unit normals, from the collapsed scene.
    pub fn shade(&self, d: &[f64], normals: &[[f64; 3]]) -> Vec<f64> {
        let length = self.owned.basis().expect("a span").scene_len();
        let scene = match self.owned.any().expect("a basis") {
            AnyBasis::Sphere(basis) => basis.collapse_into(d, vec![0.0; length]),
            AnyBasis::General(basis) => {
                let mut workspace = vec![0.0; basis.workspace_len()];
                basis.collapse_into(d, &mut workspace, vec![0.0; length])
            }
        };
        let scene = scene.expect("components");
        let at =
            |&[x, y, z]: &[f64; 3]| scene.shade(eigenshade::Normal::new(x, y, z).expect("visible"));
        normals.iter().map(at).collect()
    }

    /// U_i at unit normals, without the mean image.
    pub fn eigenimage(&self, number: usize, normals: &[[f64; 3]]) -> Vec<f64> {
        let unit: Vec<f64> = (0..=number).map(|k| f64::from(u8::from(k == number))).collect();
        let (of_unit, of_none) = (self.shade(&unit, normals), self.shade(&[], normals));
        of_unit.iter().zip(of_none).map(|(with, without)| with - without).collect()
    }
}
