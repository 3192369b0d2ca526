//! Prepares a setting in integers for timing.

use super::{PIXELS, Work};
use crate::accuracy_cost::images::Image;
use crate::accuracy_cost::shading::hemisphere;
use eigenshade::quantised;
use eigenshade_model::error::{Error, Result};
use eigenshade_shading::integer_shader;
use eigenshade_shading::integer_shader::{Integer, OwnedQuantised};
use eigenshade_shading::shader::fault;
use eigenshade_table::{Table, quantize};
use std::hint::black_box;

pub(super) struct Integers<Q> {
    basis: OwnedQuantised<Q>,
    degree: usize,
    light: (Vec<Q>, i32),
    transfer: (Vec<Q>, Vec<i16>),
    d: (Vec<i32>, i32),
    normals: Vec<quantised::Normal<Q>>,
}

impl<Q: Integer> Integers<Q> {
    pub(super) fn new(table: &Table, image: &Image) -> Result<Self> {
        let (degree, order) = (table.gram.degree, table.gram.order);
        let own = |numbers: &[i32]| numbers.iter().map(|&n| Q::of(n)).collect::<Vec<Q>>();
        let basis = OwnedQuantised::new(table, Q::FORMAT.tolerance())
            .map_err(|error| Error::new(error.to_string(), "take another format"))?;
        let view = basis.view().map_err(fault)?;
        let ((_, light), (_, material)) = image.within(degree, order);
        let (mantissas, exponents) = quantize::material(order, material, Q::FORMAT);
        let mantissas = own(&mantissas);
        let material = quantised::Material::new(order, &exponents, &mantissas).map_err(fault)?;
        let (mantissas, exponent) = quantize::row(light, Q::FORMAT.bits(), i64::MAX);
        let light = (own(&mantissas), i32::from(exponent));
        let mut workspace = vec![Q::Wide::default(); view.workspace_len()];
        let mut transfer = (vec![Q::default(); view.transfer_len()], vec![0; view.profiles()]);
        view.fold_into(&material, &mut workspace, &mut transfer.0, &mut transfer.1)
            .map_err(fault)?;
        let mut d = (vec![0; view.components()], 0);
        let folded = quantised::Transfer::new(&transfer.0, &transfer.1);
        let as_light = quantised::Light::new(degree, light.1, &light.0).map_err(fault)?;
        d.1 = view.relight_into(&folded, &as_light, &mut d.0).map_err(fault)?;
        let normals = integer_shader::normals(&hemisphere(PIXELS))?;
        Ok(Self { degree, light, transfer, d, normals, basis })
    }

    pub(super) fn works(&self) -> Result<[Work<'_>; 2]> {
        let view = self.basis.view().map_err(fault)?;
        let (mantissas, exponent) = (&self.d.0, self.d.1);
        let scene =
            view.collapse_into(mantissas, exponent, vec![0; view.scene_len()]).map_err(fault)?;
        let mut out = vec![0; PIXELS];
        let pixels = Box::new(move || {
            for (out, &normal) in out.iter_mut().zip(black_box(&self.normals)) {
                *out = scene.shade(normal);
            }
            black_box(&out);
        });
        let mut d = mantissas.clone();
        let mut buffer = vec![0; view.scene_len()];
        let light = Box::new(move || {
            let transfer = quantised::Transfer::new(&self.transfer.0, &self.transfer.1);
            let light = quantised::Light::new(self.degree, self.light.1, black_box(&self.light.0));
            let done = light
                .and_then(|light| view.relight_into(&transfer, &light, &mut d))
                .and_then(|exponent| view.collapse_into(&d, exponent, &mut buffer[..]).map(|_| ()));
            black_box((done.is_ok(), &buffer));
        });
        Ok([pixels, light])
    }
}
