//! The output of `eigenshade read`.

use eigenshade_cli::messages::print_message;
use eigenshade_cli::output::{self, Rows, exact};
use eigenshade_generator::reading::coefficients::Fit;
use eigenshade_generator::reading::modes::ModeCoefficients;
use eigenshade_generator::reading::observation::Observation;
use eigenshade_generator::reading::reader::{Channel, Reading};
use eigenshade_model::database::{Lights, Materials, Named};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::coefficient_csv::write_lights;
use eigenshade_table::{light, material};
use std::io::Write;
use std::path::Path;

/// The number of materials that the summary names.
const NAMED: usize = 3;
/// The unexplained share of the image's variance above which a note is printed.
const UNEXPLAINED: f64 = 0.1;

/// A reading with its inputs.
pub struct Answer<'a> {
    pub reading: &'a Reading,
    pub observation: &'a Observation,
    pub materials: &'a Materials,
    /// Components of the table, of which fewer may be in use.
    pub all_components: usize,
    /// Whether the image is a PNG, which has a transfer function.
    pub is_png: bool,
}

impl Answer<'_> {
    /// The CSV `quantity,name,index,r,g,b`.
    pub fn write(&self, out: &mut dyn Write) -> Result<()> {
        let mut table = Tidy(Rows::new(out, ["quantity", "name", "index", "r", "g", "b"])?);
        let (reading, observation) = (self.reading, self.observation);
        let channels = &reading.channels;
        let every =
            |value: &dyn Fn(&Channel) -> f64| -> Vec<f64> { channels.iter().map(value).collect() };
        for (name, value) in [
            ("pixels", observation.pixels as f64),
            ("components", observation.components() as f64),
            ("rank", reading.rank as f64),
            ("condition", reading.condition),
        ] {
            table.row("fit", name, 0, &[value])?;
        }
        table.row("fit", "noise", 0, &every(&|channel| channel.noise))?;
        table.row("fit", "exposure", 0, &every(&|channel| channel.posterior.0.exposure))?;
        let estimates: [(&str, Estimated); 3] = [
            ("scalar-product", |c| (&c.scalar_product.0, &c.scalar_product.1)),
            ("least-squares", |c| (&c.least_squares.0, &c.least_squares.1)),
            ("posterior", |c| (&c.posterior.0.d, &c.posterior.1)),
        ];
        for (name, of) in estimates {
            table.row("residual-rms", name, 0, &every(&|channel| of(channel).1.residual_rms))?;
            let relative = every(&|channel| of(channel).1.relative_residual);
            table.row("relative-residual", name, 0, &relative)?;
        }
        for (name, of) in estimates {
            let d: Vec<&Vec<f64>> = channels.iter().map(|channel| of(channel).0).collect();
            table.all("d", name, &d)?;
        }
        let deviations: Vec<&[f64]> =
            channels.iter().map(|channel| channel.posterior.0.deviations.as_slice()).collect();
        table.all("d-deviation", "posterior", &deviations)?;
        if let Some(best) = reading.candidates.first() {
            let lights: Vec<&[f64]> =
                best.channels.iter().map(|one| one.light.as_slice()).collect();
            table.all("light", &self.materials.entries[best.index].name, &lights)?;
        }
        for (place, candidate) in reading.candidates.iter().enumerate() {
            let name = &self.materials.entries[candidate.index].name;
            // Relative to the likeliest, because the constant has no meaning.
            let both = candidate.channels.iter().zip(&reading.candidates[0].channels);
            let evidence: Vec<f64> = both.map(|(one, best)| one.evidence - best.evidence).collect();
            table.row("material-evidence", name, place, &evidence)?;
            let residual = candidate.channels.iter().map(|one| one.residual_rms);
            table.row("material-residual-rms", name, place, &residual.collect::<Vec<_>>())?;
        }
        table.row("fit", "product-left", 0, &every(&|channel| channel.product.left))?;
        let converged = |channel: &Channel| f64::from(u8::from(channel.product.has_converged));
        table.row("fit", "product-converged", 0, &every(&converged))?;
        let lights: Vec<_> = channels.iter().map(|channel| &channel.product.light).collect();
        table.all("product-light", "", &lights)?;
        let materials: Vec<_> = channels.iter().map(|channel| &channel.product.material).collect();
        table.all("product-material", "", &materials)?;
        table.0.finish()
    }

    /// The light CSV of the best light, under this name.
    pub fn write_light(&self, path: &Path, name: &str) -> Result<()> {
        let Some(best) = self.reading.candidates.first() else { return Ok(()) };
        let last = best.channels.len() - 1;
        let rgb = [0, 1, 2].map(|c: usize| best.channels[c.min(last)].light.clone());
        let degree = rgb[0].len().isqrt().saturating_sub(1);
        let lights = Lights { degree, entries: vec![Named { name: name.to_owned(), rgb }] };
        output::write(Some(path), |out| write_lights(&lights, out))
    }

    /// The CSV `estimate,l,m,o,p,q,r,g,b` of the modes that exist.
    pub fn write_modes(&self, out: &mut dyn Write) -> Result<()> {
        let header = ["estimate", "l", "m", "o", "p", "q", "r", "g", "b"];
        let mut rows = Rows::new(out, header)?;
        let channels = &self.reading.channels;
        let estimates: [(&str, Vec<&ModeCoefficients>); 2] = [
            ("least-norm", channels.iter().map(|channel| &channel.least_norm).collect()),
            ("posterior", channels.iter().map(|channel| &channel.modes).collect()),
        ];
        for (name, c) in estimates {
            let (degree, order) = (c[0].degree, c[0].order);
            for (row, (l, m)) in light::indices(degree).enumerate() {
                for (column, (o, p, q)) in material::indices(order).enumerate() {
                    if q > l {
                        continue;
                    }
                    let value = |channel: usize| c[channel.min(c.len() - 1)].values[(row, column)];
                    let mut fields = vec![name.to_owned(), l.to_string(), m.to_string()];
                    fields.extend([o, p, q].map(|index| index.to_string()));
                    for channel in 0..3 {
                        fields.push(exact(finite(name, value(channel))?));
                    }
                    rows.row(&fields)?;
                }
            }
        }
        rows.finish()
    }
}

/// The d of an estimate, and its fit.
type Estimated = fn(&Channel) -> (&Vec<f64>, &Fit);

/// Rows of one number or three.
struct Tidy<'a>(Rows<'a>);

impl Tidy<'_> {
    /// One value for each channel, or one for all.
    fn row(&mut self, quantity: &str, name: &str, index: usize, values: &[f64]) -> Result<()> {
        // Infinite by definition where the rank is not full, and for an image of one value.
        let is_measure = name == "condition" || quantity == "relative-residual";
        for &value in values.iter().filter(|value| !(is_measure && **value == f64::INFINITY)) {
            finite(quantity, value)?;
        }
        let value = |channel: usize| exact(values[channel.min(values.len() - 1)]);
        let [r, g, b] = [0, 1, 2].map(value);
        self.0.row([quantity, name, &index.to_string(), &r, &g, &b])
    }

    /// A list for each channel, or one for all.
    fn all<T: AsRef<[f64]>>(&mut self, quantity: &str, name: &str, lists: &[T]) -> Result<()> {
        for index in 0..lists[0].as_ref().len() {
            let values: Vec<f64> = lists.iter().map(|list| list.as_ref()[index]).collect();
            self.row(quantity, name, index, &values)?;
        }
        Ok(())
    }
}

/// Refuses a result that is not finite.
fn finite(what: &str, value: f64) -> Result<f64> {
    if value.is_finite() {
        return Ok(value);
    }
    let remedy = "scale the image, the lights and the materials toward 1";
    Err(Error::new(format!("the result `{what}` is {value}"), remedy))
}

/// Prints a summary to standard error.
pub fn summarize(answer: &Answer<'_>) {
    let (reading, observation) = (answer.reading, answer.observation);
    let components = observation.components();
    print_message(format_args!(
        "{components} components, rank {}, condition {:.1e}",
        reading.rank, reading.condition
    ));
    let names: &[&str] = if reading.channels.len() == 1 { &["gray"] } else { &["r", "g", "b"] };
    for (name, channel) in names.iter().zip(&reading.channels) {
        let (squares, posterior) = (channel.least_squares.1, channel.posterior.1);
        print_message(format_args!(
            "{name}: noise {:.2e}; unexplained share of the image's variance: {:.2e} by least \
             squares, {:.2e} by the posterior mean",
            channel.noise, squares.relative_residual, posterior.relative_residual
        ));
        let (left, all) = (squares.relative_residual, answer.all_components);
        if left > UNEXPLAINED && left.is_finite() && components < all {
            print_message(format_args!(
                "note: {name}: {components} of {all} components leave {:.0} % of the image's \
                 variance; use more with --components",
                100.0 * left
            ));
        } else if left > UNEXPLAINED {
            let also =
                if answer.is_png { ", their frame and --transfer" } else { " and their frame" };
            print_message(format_args!(
                "note: {name}: the image does not look like one of this table with these normals; \
                 check the normals{also}"
            ));
        }
        if !channel.product.has_converged {
            print_message(format_args!(
                "{name}: the product of light and material in the modes has not converged"
            ));
        }
    }
    let best = reading.candidates.first().map_or(0.0, |candidate| candidate.evidence);
    let nearest: Vec<String> = reading
        .candidates
        .iter()
        .take(NAMED)
        .map(|candidate| {
            let name = &answer.materials.entries[candidate.index].name;
            format!("{name} ({:.1})", candidate.evidence - best)
        })
        .collect();
    print_message(format_args!(
        "nearest materials of {} (log evidence): {}",
        reading.candidates.len(),
        nearest.join(", ")
    ));
}
