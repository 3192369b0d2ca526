//! Writes the series in roughness from which glTF materials are computed, in floats and integers.

use crate::files::{read_lines, write_output};
use eigenshade_table::material;
use std::fmt::Write as _;

const PATH: &str = "tables/inputs/metallic-roughness.csv";

/// The exponent of an order whose coefficients are all zero.
const OF_ZEROS: i32 = -40;

/// Polynomials that the products with roughness² need less than the parts themselves.
const SPARED: usize = 2;

/// The numbers of one part, by polynomial k and coefficient.
type Part = Vec<Vec<f64>>;

/// Writes `metallic_roughness.rs` to the output folder.
///
/// # Errors
///
/// If the file cannot be read or lacks lines.
pub fn write() -> Result<(), String> {
    let lines = read_lines(PATH)?;
    let lines: Vec<Vec<&str>> = lines.iter().map(|line| line.split(',').collect()).collect();
    let mut source = String::new();
    for order in [7, 12] {
        let parts = parts(&lines, order)?;
        floats(&mut source, order, &parts);
        integers(&mut source, order, &parts);
    }
    write_output("metallic_roughness.rs", &source)
}

/// The parts matte, rim and metal of an order.
fn parts(lines: &[Vec<&str>], order: usize) -> Result<[Part; 3], String> {
    let count = material::count(order);
    let mut parts = [const { Vec::new() }; 3];
    let of_order = |line: &&Vec<&str>| line[0].parse() == Ok(order);
    let rows: Vec<&Vec<&str>> = lines.iter().filter(of_order).collect();
    if rows.is_empty() || !rows.len().is_multiple_of(count) || rows.iter().any(|row| row.len() != 8)
    {
        return Err(format!("{PATH}: order {order} lacks lines"));
    }
    for rows in rows.chunks(count) {
        for (part, column) in parts.iter_mut().zip(5..) {
            let number = |row: &&Vec<&str>| {
                row[column].parse::<f64>().map_err(|_| format!("{PATH}: `{}`", row.join(",")))
            };
            part.push(rows.iter().map(number).collect::<Result<Vec<f64>, String>>()?);
        }
    }
    // The matte part does not depend on roughness.
    parts[0].truncate(1);
    Ok(parts)
}

fn floats(source: &mut String, order: usize, [matte, rim, metal]: &[Part; 3]) {
    let rounded = |part: &Part| -> Vec<Vec<f32>> {
        part.iter().map(|row| row.iter().map(|&number| number as f32).collect()).collect()
    };
    let (count, terms) = (rim[0].len(), rim.len());
    let (matte, rim, metal) = (&rounded(matte)[0], rounded(rim), rounded(metal));
    let _ = writeln!(
        source,
        "static ORDER_{order}: Series<{count}, {terms}> = \
         Series {{ matte: {matte:?}, rim: {rim:?}, metal: {metal:?} }};"
    );
}

/// A part times the roughness, 0.6 + 0.4 x.
fn by_roughness(part: &Part) -> Part {
    let mut product = vec![vec![0.0; part[0].len()]; part.len() + 1];
    for (k, row) in part.iter().enumerate() {
        // x T_k = (T_(k+1) + T_|k-1|) / 2.
        for (to, factor) in [(k, 0.6), (k + 1, 0.2), (k.abs_diff(1), 0.2)] {
            product[to].iter_mut().zip(row).for_each(|(to, from)| *to += factor * from);
        }
    }
    product
}

/// The parts times roughness², which are about as large at any roughness. Rounding would otherwise
/// show in pictures of rough materials, which are darker. Each part of each o has an exponent,
/// below which the sum of its terms' sizes stays. The numbers of higher polynomials are smaller;
/// they are stored finer by as many bits as they leave free.
fn integers(source: &mut String, order: usize, [matte, rim, metal]: &[Part; 3]) {
    let scaled = |part: &Part| -> Part {
        let mut product = by_roughness(&by_roughness(part));
        product.truncate(part.len() - SPARED);
        product
    };
    let parts = &[matte.clone(), scaled(rim), scaled(metal)];
    let (count, orders, terms) = (parts[1][0].len(), order + 1, parts[1].len());
    let exponents = parts.each_ref().map(|part| -> Vec<i32> {
        let of_order = |o: usize| {
            let start = if o == 0 { 0 } else { material::count(o - 1) };
            let size = |i: usize| part.iter().map(|row| row[i].abs()).sum::<f64>();
            let largest = (start..material::count(o)).map(size).fold(0.0, f64::max);
            if largest > 0.0 { largest.log2().floor() as i32 + 1 } else { OF_ZEROS }
        };
        (0..=order).map(of_order).collect()
    });
    // A number as a fraction of 2^exponent.
    let places: Vec<usize> = material::indices(order).map(|(o, ..)| o).collect();
    let fraction = |part: usize, k: usize, i: usize| {
        parts[part][k][i] * f64::from(-exponents[part][places[i]]).exp2()
    };
    let free = |k: usize| -> i32 {
        let sizes = (0..count).flat_map(|i| [1, 2].map(|part| fraction(part, k, i).abs()));
        -(sizes.fold(0.0, f64::max).log2().floor() as i32 + 1)
    };
    let finer: Vec<i32> = (0..terms).map(free).collect();
    let mantissas = [0, 1, 2].map(|part| -> Part {
        let mantissa = |k: usize, i: usize| {
            let finer = if part == 0 { 0 } else { finer[k] };
            let scaled = fraction(part, k, i) * f64::from(15 + finer).exp2();
            scaled.round().clamp(-32_767.0, 32_767.0)
        };
        let row = |k: usize| (0..count).map(|i| mantissa(k, i)).collect();
        (0..parts[part].len()).map(row).collect()
    });
    let whole = |part: &Part| -> Vec<Vec<i16>> {
        part.iter().map(|row| row.iter().map(|&number| number as i16).collect()).collect()
    };
    let [matte, rim, metal] = mantissas.each_ref().map(whole);
    let matte = &matte[0];
    let _ = writeln!(
        source,
        "static ORDER_{order}_Q15: IntegerSeries<{count}, {orders}, {terms}> = IntegerSeries {{ \
         exponents: {exponents:?}, finer: {finer:?}, \
         matte: {matte:?}, rim: {rim:?}, metal: {metal:?} }};"
    );
}
