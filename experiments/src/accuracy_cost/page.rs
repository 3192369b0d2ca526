//! The page: which setting to choose, what it costs, and how costs grow.

use super::COMMAND;
use super::choice::{LIMITS, Lighting, cheapest, frame};
use super::figures::{growth_file, kinds, of_degree};
use super::growth::Growth;
use super::knobs::{DEGREE, HIGH_COMPONENTS, ORDER};
use super::machine::Machine;
use super::materials::MEASURED;
use super::method::{Errors, Spread};
use super::model::{self, MAPS, Row};
use super::points::Point;
use super::setting::{Scaling, Way};
use super::sheet::{MODEL, POINTS};
use super::words::{cost, exponent, limit as per_cent_limit, per_cent, setting, table};
use eigenshade_cli::messages::grouped;

/// The file name of the page.
pub const PAGE: &str = "accuracy-cost.md";

/// The page, in Markdown.
#[must_use]
pub fn page(points: &[Point], models: &[Row], growths: &[Growth]) -> String {
    let mut sections = vec![head(points, models), example(points)];
    sections.extend(Machine::ALL.map(|machine| of_machine(points, machine)));
    sections.push(degrees(points, models));
    sections.push(mathematics(points));
    sections.push(growing(growths));
    sections.join("\n")
}

fn head(points: &[Point], models: &[Row]) -> String {
    let mut surfaces: Vec<&str> = models.iter().map(|row| row.surface.as_str()).collect();
    surfaces.dedup();
    format!(
        "<!-- {COMMAND} -->\n\
         # What accuracy costs\n\n\
         `cargo run --release -p experiments -- accuracy-cost --out docs/accuracy-cost` turns every knob by itself and measures: {} settings, all in \
         [{POINTS}]({POINTS}). `--check docs/accuracy-cost` makes errors, bytes and instruction counts again and compares; times \
         are not compared.\n\n\
         **The error of the method** is that of a setting against the direct sum (15) of its own degree and order, in f64: rms over a \
         sphere's normals, of the image's peak, over the shipped lights on materials that the basis never saw: GGX of roughness 0.1 to 1, and two tables in the layout of MERL; above order 7, which the shipped \
         materials do not reach, every third light on GGX of roughnesses between those of the basis, and the same two tables. The tables below give its median, what 95 of 100 of these images do not exceed, and its worst; \"worst pixel\" is the largest error \
         of a single normal in any of the images. [{POINTS}]({POINTS}) has the errors over the materials of which the basis was made as well.\n\n\
         **The error of the model** is another thing: that of the direct sum of a degree and an order against the BRDF itself, integrated \
         under captured maps without any truncation ({} maps on {} surfaces: formulas from Lambertian to GGX of roughness 0.3, and {measured} measured materials of the MERL database, by the published fits of Low and others, ACM \
         Transactions on Graphics 31, 2012; [{MODEL}]({MODEL})). No setting of a degree and order can be nearer to a surface than that.\n\n\
         **A pixel** takes instructions on emulated boards, which do not wait as silicon does, and on x86-64 and WebAssembly times, \
         given as multiples of a pixel of the nine-term formula (Ramamoorthi and Hanrahan 2001) in the same run, arrays in the cache. They are of one machine; the \
         formula's own time there is in [{POINTS}]({POINTS}). Those of WebAssembly are with SIMD in Node, of modules of ten tables ([times.csv](../../crates/wasm/times.csv)). **A new light** is the way from its coefficients to the first \
         pixel, on a material that is folded in already; on x86-64 of a table that is read at run time, where one that is compiled in takes less than half of it \
         ([performance.md](../performance.md)). Where nothing was counted stands a dash. **Bytes** are of the table as `pack` writes it, and of what one \
         channel of an image holds from light to light: the folded material, d, and what a pixel reads. All is for one channel; color takes three.\n\n\
         Each row of the tables below is the cheapest setting whose method is below the limit for 95 of 100 images of unseen materials; of times \
         within five per cent of the least, the setting with the least error. Settings \
         below degree {DEGREE} and order {ORDER} are taken only where their model is below the limit too.\n\n\
         **To take a row** is to write its scene file ([tables/README.md](../../tables/README.md#scene-file)): a copy of `tables/sphere.toml` with the row's \
         `light.degree`, `material.order` and `basis.components` (of all, 1000 are enough), with `basis.cut = {{ trim = 3e-2 }}` for \"trimmed to 3e-2\" and \
         `{{ terms = 12 }}` for \"polynomials of 12 terms\". `eigenshade basis` makes the table, `pack` or a build script brings it to the device. \
         \"Within 1 %\" is `Basis::collapse_within` when the program runs, a baked map `Scene::bake`.\n",
        points.len(),
        MAPS.len(),
        surfaces.len(),
        measured = MEASURED.len(),
    )
}

/// An example of reading the tables, for the machine that most readers ask about.
fn example(points: &[Point]) -> String {
    let machine = Machine::M4f;
    let taken = |lighting| {
        let point = &points[cheapest(points, machine, lighting, 0.01)?];
        let price = point.prices.get(&machine)?;
        let whole = frame(point, machine, lighting)?;
        let counts = [price.pixel, price.light, Some(whole)];
        let [pixel, light, sum] =
            counts.map(|one| grouped(one.unwrap_or_default().round() as usize));
        let share = format!("{:.0} % of the cycles", 100.0 * whole / (64e6 / 60.0));
        Some((point, setting(&point.setting, point.method.terms), [pixel, light, sum, share]))
    };
    let Some((point, name, [pixel, _, sum, share])) = taken(Lighting::Still) else {
        return String::new();
    };
    let moving = taken(Lighting::Moving).map(|(_, name, [pixel, light, sum, share])| {
        format!(
            "Where it changes with every picture, {name}. A pixel takes {pixel} instructions, a new light {light}, a picture \
             9,216 x {pixel} + {light} = {sum}: {share}. "
        )
    });
    format!(
        "## In a minute\n\n\
         A Cortex-M4F of 64 MHz has 64,000,000 / 60 = 1,066,667 cycles for each of 60 pictures a second. Its tables say for an error of the \
         method below 1 % in 95 of 100 images of unseen materials: where the light stands still, {name}. A pixel takes {pixel} instructions, a picture of 96 x 96 pixels 9,216 times as many, {sum}: \
         {share} if each instruction took one. {}Multiply by the cycles that an instruction takes on the chip at hand. The error of the model \
         comes beside it: at degree {DEGREE} and order {ORDER} it is {} in the median, less on matte surfaces and more on gloss \
         ([below](#degree-and-order-the-error-of-the-model)).\n",
        moving.unwrap_or_default(),
        point.model.map_or("not known".into(), |model| per_cent(model.median)),
    )
}

fn of_machine(points: &[Point], machine: Machine) -> String {
    let (title, key) = (machine.title(), machine.key());
    let lines = [
        (Lighting::Still, "Where the light stands still, and only pixels count:"),
        (Lighting::Moving, "Where every picture of 96 x 96 pixels has a new light:"),
    ];
    let mut text = format!(
        "## {title}\n\n![{title}: error against the cost of a pixel]({key}.svg)\n\n\
         Grey: settings of degree {DEGREE}, order {ORDER}. Blue: those that no other beats. Dashed: the nine-term formula's cost, and the error of \
         the model at that degree and order.\n"
    );
    for (lighting, what) in lines {
        let rows: Vec<Vec<String>> =
            LIMITS.iter().map(|&limit| row(points, machine, lighting, limit)).collect();
        if rows.iter().all(|row| row.len() < 3 || row[2] == "—") {
            text.push_str(NOT_COUNTED);
            continue;
        }
        let header = header(machine, lighting);
        text.push_str(&format!("\n{what}\n\n{}", table(&header, &rows)));
    }
    if machine.counts() {
        text.push_str(BAKING);
    }
    text
}

/// Replaces a table for moving light.
const NOT_COUNTED: &str = "\nOf no setting there both a pixel and a new light have been counted, so there is no table for \
                           moving light.\n";

/// What the counts of the boards leave out.
const BAKING: &str = "\nFlash, and RAM with the stack, are of the program that was counted: any material is folded in when it starts. A new light of a \
                      baked map of N x N has not been counted: it takes that of its polynomials, and 5 N² of their pixels.\n";

/// Whether a table shows the memory of the counted program.
fn has_program(machine: Machine, lighting: Lighting) -> bool {
    machine.counts() && lighting == Lighting::Moving
}

fn header(machine: Machine, lighting: Lighting) -> Vec<String> {
    let unit = machine.unit();
    let mut header = [
        "method below",
        "take",
        "method: median",
        "95 of 100",
        "worst",
        "worst pixel",
        "model, median",
        &format!("a pixel, {unit}"),
        "a new light",
        "96 x 96 pixels",
        "table, bytes",
        "RAM, bytes",
    ]
    .map(str::to_owned)
    .to_vec();
    if has_program(machine, lighting) {
        header.extend(["program: flash", "RAM and stack"].map(str::to_owned));
    }
    header
}

fn row(points: &[Point], machine: Machine, lighting: Lighting, limit: f64) -> Vec<String> {
    let found = cheapest(points, machine, lighting, limit);
    let limit = per_cent_limit(limit);
    let Some(point) = found.map(|k| &points[k]) else {
        let mut row = vec![limit, "nothing that has been counted".to_owned()];
        row.resize(header(machine, lighting).len(), "—".to_owned());
        return row;
    };
    let price = point.prices.get(&machine).copied().unwrap_or_default();
    let number = |value: Option<f64>| match value {
        None => "—".to_owned(),
        Some(value) if machine.counts() => grouped(value.round() as usize),
        Some(value) => cost(value),
    };
    let Errors { rms, largest } = point.method.unseen;
    let mut row = vec![
        limit,
        setting(&point.setting, point.method.terms),
        per_cent(rms.median),
        per_cent(rms.most),
        per_cent(rms.worst),
        per_cent(largest.worst),
        point.model.map_or("—".into(), |model| per_cent(model.median)),
        number(price.pixel),
        number(price.light),
        number(frame(point, machine, lighting)),
        grouped(point.bytes.table),
        grouped(point.bytes.state),
    ];
    if has_program(machine, lighting) {
        let bytes = [price.flash, price.ram];
        row.extend(bytes.map(|bytes| bytes.map_or("—".to_owned(), grouped)));
    }
    row
}

fn degrees(points: &[Point], models: &[Row]) -> String {
    let mut names: Vec<String> = models.iter().map(|row| row.surface.clone()).collect();
    names.dedup();
    let rows: Vec<Vec<String>> = model::sizes()
        .into_iter()
        .map(|(degree, order)| {
            let mut row = vec![format!("{degree}, {order}")];
            if let Some(Spread { median, worst, .. }) = model::spread(models, degree, order) {
                row.extend([per_cent(median), per_cent(worst)]);
            }
            let of = |name: &String| {
                let found = models
                    .iter()
                    .find(|one| (&one.surface, one.degree, one.order) == (name, degree, order));
                found.map_or("—".into(), |one| per_cent(Spread::of(&one.errors).median))
            };
            row.extend(names.iter().map(of));
            row
        })
        .collect();
    let dear = model::sizes().into_iter().filter(|&size| of_degree(points, models, size).is_none());
    let dear: Vec<String> = dear.map(|(degree, order)| format!("{degree}, {order}")).collect();
    let missing = match dear.join(" and ") {
        names if names.is_empty() => String::new(),
        names => {
            format!(" Of {names} no setting is: {HIGH_COMPONENTS} components leave more than that.")
        }
    };
    let mut header = vec!["degree, order".to_owned(), "median".into(), "worst".into()];
    header.extend(names);
    format!(
        "## Degree and order: the error of the model\n\n\
         ![the model's error against the cost of a pixel](degrees.svg)\n\n\
         Against direct integration under {}: rms of the peak, over all surfaces and maps, and each surface's median over the maps. In the chart a \
         degree and order costs what its cheapest setting does whose method is three times nearer than its model.{missing}\n\n{}",
        MAPS.join(", "),
        table(&header, &rows)
    )
}

fn mathematics(points: &[Point]) -> String {
    let rows: Vec<Vec<String>> = points
        .iter()
        .filter(|point| point.knob == "mathematics" || plain(point))
        .map(|point| {
            let price = point.prices.get(&Machine::Host).and_then(|price| price.pixel);
            let name = match point.setting.scaling {
                Scaling::None => "normals arrive scaled".to_owned(),
                scaling => format!("`{scaling}`"),
            };
            let errors = point.method.seen.rms;
            let number = price.map_or("—".to_owned(), cost);
            vec![name, per_cent(errors.median), per_cent(errors.worst), number]
        })
        .collect();
    let header = ["root by", "median", "worst", "a pixel, nine-term pixels"].map(str::to_owned);
    format!(
        "## Mathematics of set-up\n\n\
         Normals of lengths 0.37 to 2.3, scaled before they are shaded, 50 components in `f32` on x86-64. No pixel calls anything else of \
         it. `libm` takes the processor's own root; `single` is Newton's method in f32, without any table, for processors that have none, `tabled` the same \
         from 64 numbers, a step less; \
         `micromath`'s roots are off by some per cent, and so are the normals.\n\n{}",
        table(&header, &rows)
    )
}

/// Whether this is the reference setting of the mathematical comparison.
fn plain(point: &Point) -> bool {
    let recipe = super::setting::Recipe::first(DEGREE, ORDER, 50);
    point.setting == super::setting::Setting::of(recipe) && point.setting.way == Way::Polynomial
}

fn growing(growths: &[Growth]) -> String {
    let mut text = "## How it grows\n\nExponents fitted to the larger half of the sizes, beside the one that theory says. Other sizes: degree 9, order 7, 50 \
                    components, `f32`; orders of formulas. Bytes and multiplications are compared by `--check`, and the exponents of bytes. The theory of a time is the fitted exponent of its multiplications at the same sizes: \
                    with 50 components a higher degree or order makes polynomials longer, but adds no azimuths. A time grows less than that by what a call takes anyway. Times are of one machine and one run. All are in [growth.csv](growth.csv).\n\n"
        .to_owned();
    let rows: Vec<Vec<String>> = growths
        .iter()
        .map(|growth| {
            let sizes = growth.points.first().zip(growth.points.last());
            vec![
                format!("{}, {}", growth.measure, growth.unit),
                growth.quantity.to_owned(),
                sizes.map_or(String::new(), |(a, b)| {
                    format!("{} to {}", cost_of(a.0), cost_of(b.0))
                }),
                growth.exponent().map_or("—".into(), |found| format!("{found:.2}")),
                growth.theory.map_or("—".into(), exponent),
                growth.reason.to_owned(),
            ]
        })
        .collect();
    let header = ["what", "against", "sizes", "fitted", "theory", "because"].map(str::to_owned);
    text.push_str(&table(&header, &rows));
    text.push('\n');
    for (quantity, unit) in kinds(growths) {
        let file = growth_file(quantity, unit);
        text.push_str(&format!("![growth with {quantity}, {unit}]({file})\n"));
    }
    text
}

fn cost_of(size: f64) -> String {
    grouped(size.round() as usize)
}
