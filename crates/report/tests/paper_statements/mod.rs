//! Every number that `docs/paper.md` states outside its generated tables: from the committed CSV
//! files, which `report paper --check docs/paper` compares with what it computes.

mod averages;

use crate::paper_oracle::{sheet, study};
use eigenshade_table::{material, mode};
use report::paper::tables::needed;
use report::paper::variance::{SURFACES, Variance};
use report::paper::{Modes, ORDER};
use report::sheet::Sheet;
use std::f64::consts::PI;

/// Shares of the Lambertian modes' variance against the closed form: sums of ten numbers.
const LAMBERTIAN_SHARES: f64 = 2e-15;

/// Mean image-centered errors of all modes: a row for each number of components.
fn errors(of: &str) -> Sheet {
    sheet(&format!("error_by_{of}"))
}

/// The errors with this many components, by material or light.
fn with(errors: &Sheet, count: usize) -> Vec<f64> {
    errors.columns[1..].iter().map(|name| errors.numbers(name)[count]).collect()
}

/// Asserts that the page's number is the rounded figure; `unit` is one of its last digit.
#[track_caller]
fn states(found: f64, stated: f64, unit: f64) {
    assert!((found - stated).abs() <= 0.501 * unit, "{found}, not {stated}");
}

/// Rank correlation (Spearman), where equal numbers share their lowest rank.
fn rank_correlation(a: &[f64], b: &[f64]) -> f64 {
    let [a, b] = [a, b].map(|values| {
        let below = |value: &f64| values.iter().filter(|other| *other < value).count() as f64;
        let middle = 0.5 * (values.len() as f64 - 1.0);
        values.iter().map(|value| below(value) - middle).collect::<Vec<f64>>()
    });
    let product = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    product(&a, &b) / (product(&a, &a) * product(&b, &b)).sqrt()
}

/// The numbers of modes, by counting them.
#[test]
fn modes_are_as_many_as_in_the_paper() {
    for ((order, degree, _), expected) in SURFACES.into_iter().zip([9, 464, 2264]) {
        let mut count = 0;
        for o in 0..=order {
            for p in (0..=o).filter(|p| (o - p) % 2 == 0) {
                for q in (0..=p).filter(|q| (p - q) % 2 == 0) {
                    count += (q..=degree).map(|l| 2 * l + 1).sum::<usize>();
                }
            }
        }
        assert_eq!([count, mode::total(degree, order)], [expected; 2]);
    }
    assert_eq!((Modes::All.count(), Modes::Selected.count()), (3704, 1000));
    assert_eq!((study().luminances.len(), study().grays.len()), (26, 61));
}

/// The variance of the Lambertian modes of degree l is proportional to (2l + 1) A_l², where A_l are
/// the coefficients of the clamped cosine (Ramamoorthi and Hanrahan 2001).
#[test]
fn lambertian_variance_is_that_of_the_clamped_cosine() {
    let factorial = |n: i32| (1..=n).map(f64::from).product::<f64>();
    let cosine = |l: i32| match l {
        1 => 2.0 * PI / 3.0,
        odd if odd % 2 == 1 => 0.0,
        even => {
            let sign = if even % 4 == 0 { -1.0 } else { 1.0 };
            let half = factorial(even / 2);
            let ratio = factorial(even) / (2f64.powi(even) * half * half);
            sign * 2.0 * PI / f64::from((even + 2) * (even - 1)) * ratio
        }
    };
    let power: Vec<f64> = (0..=9).map(|l| f64::from(2 * l + 1) * cosine(l) * cosine(l)).collect();
    let all: f64 = power.iter().sum();
    for (l, beyond) in Variance::new(study()).beyond(0).iter().enumerate() {
        let expected = power[l + 1..].iter().sum::<f64>() / all;
        assert!((beyond - expected).abs() <= LAMBERTIAN_SHARES, "{l}: {beyond}");
    }
}

/// The paper's three cuts are the first that leave out less than 1 %, and leave out the same share;
/// one degree less leaves out over four times as much.
#[test]
fn the_papers_degrees_carry_the_variance() {
    for (_, degree, name) in SURFACES {
        let beyond = sheet("variance_beyond").only("surface", name).numbers("beyond");
        states(beyond[degree], 0.0072, 6e-4);
        assert!(beyond[degree - 1] > 0.01 && beyond[degree - 1] > 4.0 * beyond[degree], "{name}");
    }
    // Of one order o, little lies beyond l = o + 2.
    let variance = sheet("variance");
    let [l, o, value] = ["l", "o", "variance"].map(|column| variance.numbers(column));
    let share = |order: usize| {
        let order = order as f64;
        let rows = || (0..l.len()).filter(|&k| o[k] == order);
        let far: f64 = rows().filter(|&k| l[k] > order + 2.0).map(|k| value[k]).sum();
        far / rows().map(|k| value[k]).sum::<f64>()
    };
    states((1..ORDER).map(share).fold(0.0, f64::max), 0.017, 1e-3);
}

#[test]
fn both_criteria_are_alike_from_five_components_on() {
    let errors = sheet("error");
    for suffix in ["", "_1000"] {
        let [centered, standard] =
            ["image_centered", "standard"].map(|name| errors.numbers(&format!("{name}{suffix}")));
        let ratios: Vec<f64> = standard.iter().zip(&centered).map(|(a, b)| a / b).collect();
        assert!(ratios[5..].iter().all(|ratio| (0.999..1.026).contains(ratio)), "{ratios:?}");
        assert!(ratios[1..5].iter().all(|ratio| *ratio > 1.0), "{ratios:?}");
        states(ratios[1..5].iter().fold(0.0, |most, ratio| ratio.max(most)), 2.2, 0.1);
    }
}

#[test]
fn few_materials_take_five_components() {
    let errors = errors("material");
    let rotated = sheet("error_rotated");
    let within = |sheet: &Sheet, count: usize| {
        let names = errors.columns[1..].iter();
        names.filter(|name| sheet.numbers(name)[count] <= 0.1).count()
    };
    assert_eq!([5, 6, 8, 10].map(|count| within(&errors, count)), [2, 5, 49, 60]);
    assert_eq!([5, 6].map(|count| within(&rotated, count)), [32, 44]);
    // Plaster b is the mattest.
    let plaster = errors.numbers("11-plaster-b");
    assert!(with(&errors, 5).iter().filter(|error| **error <= plaster[5]).count() == 1);
    assert!(plaster[5] < 0.1 && plaster[10] < 0.02, "{plaster:?}");
}

#[test]
fn velvet_takes_nine_components() {
    let (errors, rotated) = (errors("material"), sheet("error_rotated"));
    let velvet = errors.numbers("07-velvet");
    assert_eq!((needed(&velvet, 0.1), needed(&rotated.numbers("07-velvet"), 0.1)), (9, 9));
    // Among those of Fig. 3 from 5 on, component 8 takes off most.
    let taken = |component: usize| velvet[component] - velvet[component + 1];
    assert!((5..12).all(|component| taken(component) <= taken(8)));
    states(taken(8), 0.105, 1e-3);
}

/// Thirty to fifty components take leather from 1 % to 0.1 %.
#[test]
fn leather_takes_thirty_to_fifty_components() {
    let leather = errors("material").numbers("05-leather");
    assert!(leather[20] > 0.015 && leather[30] < 0.01 && leather[50] < 0.0011, "{leather:?}");
    assert!((20..=30).contains(&needed(&leather, 0.01)));
}

/// Under most lights a few components have the shading, and some tens the highlight.
#[test]
fn leathers_highlight_is_a_matter_of_the_light() {
    let highlights = sheet("highlight");
    let mut counts = highlights.numbers("components");
    assert_eq!(highlights.only("light", "studio").numbers("components"), [36.0]);
    counts.sort_by(f64::total_cmp);
    assert_eq!((counts.len(), counts[0], counts[13], counts[25]), (26, 5.0, 18.0, 37.0));
    let [leather, velvet] =
        ["05-leather", "07-velvet"].map(|name| sheet("reconstruction").only("material", name));
    let right_from = |course: &Sheet| {
        let shares = course.numbers("brightest");
        shares.iter().rposition(|share| (share - 1.0).abs() > 0.1).expect("a wrong one") + 1
    };
    // Over the pixels of the plate it is the same number as over the normals of the list.
    assert_eq!((right_from(&leather), right_from(&velvet)), (36, 45));
    // Ten and thirty components lack the highlight, fifty have it; the rim of velvet takes more.
    let [bright, rim] = [&leather, &velvet].map(|course| course.numbers("brightest"));
    assert!(bright[10] < 0.85 && bright[30] < 0.9 && bright[50] > 0.95, "{bright:?}");
    assert!(rim[30] < 0.9 && rim[50] < bright[50], "{rim:?}");
    let errors = [leather, velvet].map(|course| course.numbers("error")[10]);
    assert!(errors[0] < 0.04 && errors[1] < 0.02, "{errors:?}");
}

/// With five components the light matters more than the material; light from behind is missed.
#[test]
fn the_error_of_five_components_is_that_of_the_light() {
    let [lights, materials] = ["light", "material"].map(errors);
    let spread = |errors: &[f64]| {
        let most = errors.iter().copied().fold(0.0, f64::max);
        let least = errors.iter().copied().fold(f64::INFINITY, f64::min);
        [least, most, most / least]
    };
    let [least, most, ratio] = spread(&with(&lights, 5));
    assert_eq!([lights.numbers("city")[5], lights.numbers("blender-sunrise")[5]], [least, most]);
    states(least, 0.026, 1e-3);
    states(most, 0.505, 1e-3);
    states(ratio, 19.0, 1.0);
    states(spread(&with(&materials, 5))[2], 3.5, 0.1);
    let fronts: Vec<f64> = study().luminances.iter().map(|light| light[2] / light[0]).collect();
    states(rank_correlation(&fronts, &with(&lights, 5)), -0.78, 0.01);
    assert_eq!(fronts.iter().filter(|front| **front < 0.0).count(), 22);
}

#[test]
fn glossy_materials_take_more_components() {
    let square = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
    let gloss = |material: &Vec<f64>| square(&material[material::count(3)..]) / square(material);
    let glosses: Vec<f64> = study().grays.iter().map(gloss).collect();
    states(rank_correlation(&glosses, &with(&errors("material"), 10)), 0.91, 0.01);
}

#[test]
fn the_truncation_harms_the_sum_more_than_the_basis() {
    let selected = sheet("selected_modes");
    let value = |name: &str| {
        let row = selected.rows.iter().find(|row| row.text("quantity") == name).expect(name);
        row.text("value")
    };
    let number = |name: &str| value(name).parse::<f64>().expect("a number");
    let by_degree = (0..=9).map(|l| number(&format!("modes_kept_of_degree_{l}")));
    assert_eq!((number("modes_kept"), by_degree.sum()), (1001.0, 1001.0));
    assert_eq!(number("largest_order_kept"), 7.0);
    assert!((8..=9).all(|l| number(&format!("modes_kept_of_degree_{l}")) == 0.0));
    states(1.0 - number("mode_variance_left_out"), 0.952, 1e-3);
    states(number("image_error_median"), 0.0217, 1e-4);
    states(number("image_error_mean"), 0.0415, 1e-4);
    states(number("image_error_largest"), 0.577, 1e-3);
    let worst = ["light", "material"].map(|of| value(&format!("image_error_largest_{of}")));
    assert_eq!(worst, ["blender-studio", "07-velvet"]);
    let components = ["components_of_all_modes", "components_of_selected_modes"].map(number);
    assert_eq!(components, [218.0, 147.0]);
    states(number("error_of_all_components"), 1.41e-4, 1e-6);
    states(number("image_error_mean") / number("error_of_all_components"), 294.0, 1.0);
    let errors = sheet("error");
    let [all, some] = ["image_centered", "image_centered_1000"].map(|name| errors.numbers(name));
    // Ten components of all modes are as good as the sum of 1,000.
    assert_eq!(needed(&all, number("image_error_mean")), 10);
    assert!((0..=11).all(|count| some[count] <= 1.02 * all[count]));
    states(some[50] / all[50], 1.5, 0.1);
}

#[test]
fn twelve_eigenimages_leave_little() {
    states(sheet("eigenimages").numbers("left")[11], 0.0194, 1e-4);
}

/// The uncorrelated sum is no bound, and the bound is half of the triangle bound or less.
#[test]
fn every_image_reaches_every_accuracy() {
    let bounds = sheet("bound").of(Modes::All);
    let column = |name: &str| bounds.numbers(name);
    assert!(column("images").iter().all(|images| *images == 1586.0));
    assert!(column("most_terms").iter().all(|terms| *terms <= 3646.0));
    let pairs = |a: &str, b: &str| column(a).into_iter().zip(column(b)).collect::<Vec<_>>();
    assert!(pairs("largest_error", "accuracy").iter().all(|(error, limit)| error <= limit));
    assert!(pairs("sufficient_terms", "median_terms").iter().all(|(fewer, terms)| fewer <= terms));
    assert!(column("median_bound_over_triangle").iter().all(|ratio| *ratio < 0.5));
    assert!(column("exceeding_uncorrelated").iter().all(|share| *share > 0.1));
    let excess = column("largest_error_over_uncorrelated");
    assert!(excess.iter().all(|excess| *excess > 1.3));
    states(excess.into_iter().fold(0.0, f64::max), 2.22, 0.01);
    assert_eq!(column("accuracy")[2], 0.01);
    states(column("median_terms")[2] / column("sufficient_terms")[2], 2.3, 0.1);
    let selected = sheet("bound").of(Modes::Selected).numbers("images");
    assert!(selected[1] > 0.0 && selected[2..].iter().all(|images| *images == 0.0));
}

/// Pixels are those of a picture of 176 across, where those of the rim are covered in part: their
/// error is within a twentieth of that of the nodes.
#[test]
fn rendered_spheres_are_as_accurate_as_stated() {
    let all = sheet("bound_spheres");
    assert_eq!(all.rows.len(), 3 * 4);
    for sphere in all.rows.chunks(4) {
        let mut fewer = 0.0;
        for (row, stated) in sphere.iter().zip([0.1, 0.03, 0.01, 0.003]) {
            let [terms, accuracy, bound, error, pixel_error, largest] =
                ["terms", "accuracy", "bound", "error", "pixel_error", "largest_pixel_error"]
                    .map(|column| row.number(column).expect("a number"));
            assert_eq!(accuracy, stated);
            // The fewest terms: no term is a twentieth of the bound.
            assert!(bound <= accuracy && bound > 0.95 * accuracy, "{row:?}");
            assert!(error <= bound && pixel_error <= bound && error > 0.0, "{row:?}");
            assert!((pixel_error / error - 1.0).abs() <= 0.05 && largest > pixel_error, "{row:?}");
            assert!(terms > fewer && terms < 3646.0, "{row:?}");
            fewer = terms;
        }
    }
}
