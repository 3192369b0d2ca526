//! Lights and materials, those from which a basis is made and others that it never saw; and the
//! bases of the settings, each computed once.

use super::settings::Recipe;
use eigenshade_generator::basis;
use eigenshade_generator::material::brdf::{Ggx, Lambertian, Measure, OrenNayar, Surface};
use eigenshade_generator::material::published_fits;
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use eigenshade_model::inputs::sheet::Sheet;
use eigenshade_model::window::Window;
use eigenshade_model::{parallel, shipped};
use eigenshade_table::effect::Effects;
use eigenshade_table::reduce::with_components;
use eigenshade_table::scene::Store;
use eigenshade_table::trim::trim;
use eigenshade_table::{Scene, Table, decode, material};
use std::borrow::Borrow;
use std::collections::HashMap;

/// Roughnesses of GGX.
const ROUGH: [f64; 10] = [0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0];
/// Roughnesses from which bases beyond the measured order are made, and values between them.
const EVEN: [f64; 5] = [0.2, 0.4, 0.6, 0.8, 1.0];
const BETWEEN: [f64; 3] = [0.25, 0.45, 0.85];
/// Every `LIGHT_STEP`-th light shines on them.
const LIGHT_STEP: usize = 3;

/// The lights and materials from which a basis is made, and those with which it is measured.
pub struct Scope {
    pub degree: usize,
    pub order: usize,
    pub lights: Lights,
    pub seen: Materials,
    pub unseen: Materials,
}

impl Scope {
    /// A scope without unseen materials: the measured ones up to their order, formulas above it.
    pub fn seen(degree: usize, order: usize) -> Result<Self> {
        let measured = shipped::materials()?;
        let seen = if order <= measured.order {
            measured.truncated(order)
        } else {
            projected(&ggx(&EVEN, &[0.04, 0.9])?, &[order]).remove(0)
        };
        Self::of(degree, seen)
    }

    /// The lights up to a degree on materials from which the basis is made.
    fn of(degree: usize, seen: Materials) -> Result<Self> {
        let (order, entries) = (seen.order, Vec::new());
        let lights = shipped::lights()?.truncated(degree);
        Ok(Self { degree, order, lights, seen, unseen: Materials { order, entries } })
    }

    /// Adds materials that the basis never saw: formulas and materials in color. Above the measured
    /// order the basis sees more formulas, but fewer lights shine on them.
    pub fn new(degree: usize, order: usize) -> Result<Self> {
        let scopes = Self::all(&[(degree, order)], usize::MAX)?;
        scopes.into_iter().next().ok_or_else(|| Error::new("no scope", "report it"))
    }

    /// [`new`](Self::new) for each of these degrees and orders. All orders of a material come from
    /// one integration, up to the measured order and above it. Scopes of an order above `unseen`
    /// have none of the materials that the basis never saw.
    pub fn all(sizes: &[(usize, usize)], unseen: usize) -> Result<Vec<Self>> {
        let highest = shipped::materials()?.order;
        let orders = sizes.iter().map(|&(_, order)| order).filter(|&order| order <= unseen);
        let (low, high): (Vec<usize>, Vec<usize>) = orders.partition(|&order| order <= highest);
        let mut unseen = projected(&ggx(&ROUGH, &[0.04, 0.9])?, &low);
        let color = shipped::unseen_materials()?;
        for materials in &mut unseen {
            materials.entries.extend(color.truncated(materials.order).entries);
        }
        let mut between = ggx(&BETWEEN, &[0.04, 0.5])?;
        between.extend(measured()?);
        unseen.extend(projected(&between, &high));
        let mut formulas = ggx(&EVEN, &[0.04, 0.9])?;
        formulas.extend(matte()?);
        let orders = sizes.iter().map(|&(_, order)| order);
        let beyond: Vec<usize> = orders.filter(|&order| order > highest).collect();
        let formulas = projected(&formulas, &beyond);
        let of_order =
            |all: &[Materials], order| all.iter().find(|one| one.order == order).cloned();
        let of_size = |&(degree, order): &(usize, usize)| {
            let mut scope = match of_order(&formulas, order) {
                Some(seen) => Self::of(degree, seen)?,
                None => Self::seen(degree, order)?,
            };
            if order > highest {
                let lights = scope.lights.entries.into_iter();
                scope.lights.entries = lights.step_by(LIGHT_STEP).collect();
            }
            let unseen = of_order(&unseen, order).unwrap_or(scope.unseen);
            Ok(Self { unseen, ..scope })
        };
        sizes.iter().map(of_size).collect()
    }
}

/// GGX with these roughnesses and reflectances; dielectrics have a matte base.
fn ggx(roughness: &[f64], f0: &[f64]) -> Result<Vec<Surface>> {
    let mut surfaces = Vec::new();
    for &f0 in f0 {
        let albedo = if f0 < 0.1 { 0.5 } else { 0.0 };
        for &roughness in roughness {
            let brdf = Ggx::new(roughness, f0, albedo)?;
            surfaces.push(Surface::gray(format!("ggx-{f0}-{roughness}"), Box::new(brdf)));
        }
    }
    Ok(surfaces)
}

fn matte() -> Result<Vec<Surface>> {
    Ok(vec![
        Surface::gray("lambertian".into(), Box::new(Lambertian::new(0.8)?)),
        Surface::gray("oren-nayar-0.35".into(), Box::new(OrenNayar::new(0.8, 0.35)?)),
    ])
}

/// The surfaces of the model's error: formulas from matte to glossy, and measured materials.
pub fn modelled() -> Result<Vec<Surface>> {
    let mut surfaces = matte()?;
    surfaces.extend(ggx(&[0.5, 0.3], &[0.04])?);
    surfaces.extend(ggx(&[0.7, 0.4], &[0.9])?);
    surfaces.extend(measured()?);
    Ok(surfaces)
}

/// Published fits to materials of the MERL database, one of each kind, from felt to paint, with
/// lobes wider than 0.05 rad. Sharper lobes are beyond any degree and order here.
const MEASURED: [&str; 7] = [
    "pink-felt",
    "teflon",
    "neoprene-rubber",
    "red-plastic",
    "silver-paint",
    "fruitwood-241",
    "purple-paint",
];
/// The window of the shipped coefficients in color, `material --window`.
const WINDOW: Window = Window::SincFourth { width: 40.0 };

/// Coefficients with the window of the shipped ones in color.
pub fn windowed(mut material: Named) -> Named {
    for channel in &mut material.rgb {
        for (b, (o, ..)) in channel.iter_mut().zip(material::indices(usize::MAX)) {
            *b *= WINDOW.factor(o);
        }
    }
    material
}

/// All measured materials that are shipped as parameters of a model.
pub fn published() -> Result<Vec<Surface>> {
    let text = include_str!("../../../../tables/inputs/merl-abc.csv");
    let file = InputFile::of_text(text, "tables/inputs/merl-abc.csv");
    Ok(published_fits::of_sheet(&Sheet::read(file, "name,kd_r,..")?)?.unwrap_or_default())
}

/// The measured materials, in color.
fn measured() -> Result<Vec<Surface>> {
    let mut surfaces = published()?;
    surfaces.retain(|surface| MEASURED.contains(&&*surface.name));
    surfaces.sort_by_key(|surface| MEASURED.iter().position(|name| *name == surface.name));
    Ok(surfaces)
}

pub fn projected<S: Borrow<Surface> + Sync>(surfaces: &[S], orders: &[usize]) -> Vec<Materials> {
    let projected = parallel::map(surfaces.len(), &(), |k| {
        let surface: &Surface = surfaces[k].borrow();
        surface.project_orders(orders, Measure::Projected)
    });
    let of_order = |(k, &order): (usize, &usize)| {
        let entries = projected.iter().map(|of_surface| of_surface[k].material.clone());
        Materials { order, entries: entries.collect() }
    };
    orders.iter().enumerate().map(of_order).collect()
}

/// A table for each set of effects, with as many components as a recipe asks for.
pub struct Bases(HashMap<Effects, Table>);

impl Bases {
    /// Makes the bases that these recipes of one scope start from.
    pub fn new(scope: &Scope, recipes: impl IntoIterator<Item = Recipe>) -> Result<Self> {
        let mut most: HashMap<Effects, usize> = HashMap::new();
        for recipe in recipes {
            let count = most.entry(recipe.effects).or_default();
            *count = (*count).max(recipe.components.unwrap_or(usize::MAX));
        }
        let table = |(effects, components): (Effects, usize)| {
            let mut scene = scene(scope.degree, scope.order, components)?;
            scene.effects.wanted.retain(|&effect| effects.has(effect));
            Ok((effects, basis::build(&scene, &scope.lights, &scope.seen)?))
        };
        Ok(Self(most.into_iter().map(table).collect::<Result<_>>()?))
    }

    /// The table of a recipe, which must be one of those given at first.
    pub fn table(&self, recipe: &Recipe) -> Result<Table> {
        let whole = self.0.get(&recipe.effects);
        let whole = whole.ok_or_else(|| Error::new("a basis is missing", "report it"))?;
        let count = recipe.components.unwrap_or(usize::MAX);
        let mut table = with_components(whole, |number, _| number < count);
        if let Some(share) = recipe.trim {
            trim(&mut table, share);
        }
        table.scene.basis.trim = recipe.trim;
        Ok(table)
    }
}

/// The scene of the table of CUReT at another degree and order, with at most this many components.
pub fn scene(degree: usize, order: usize, components: usize) -> Result<Scene> {
    let table = decode(shipped::CURET).map_err(|error| Error::new(error.to_string(), "report it"));
    let mut scene = table?.scene;
    scene.light.degree = degree;
    scene.material.order = order;
    scene.basis.components = Some(components);
    scene.basis.store = Store::Projection;
    Ok(scene)
}
