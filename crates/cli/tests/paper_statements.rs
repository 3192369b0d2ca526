//! What the page of the paper's figures says, in words and with "holds", on the shipped
//! data.

mod support;

#[path = "../../../tests/tolerances/mod.rs"]
mod tolerances;

use eigenshade_cli::paper::bound::Bounds;
use eigenshade_cli::paper::error::{Errors, needed};
use eigenshade_cli::paper::reconstruction::Reconstructions;
use eigenshade_cli::paper::report::ALIKE_FROM;
use eigenshade_cli::paper::report::claims::{Claim, claims, section};
use eigenshade_cli::paper::selected::Selected;
use eigenshade_cli::paper::study::{Modes, Study, Trial, place};
use eigenshade_cli::paper::variance::{SURFACES, Variance};
use eigenshade_generator::node_image::MaterialImages;
use eigenshade_generator::rotation::Rotation;
use eigenshade_generator::special::gauss_legendre;
use eigenshade_index::{light, mode};
use eigenshade_table::scene::Criterion;
use indicatif::ProgressBar;
use std::f64::consts::PI;
use std::sync::OnceLock;
use support::{numbers, repository, rows};

fn study() -> &'static (Study, Vec<Trial>) {
    static STUDY: OnceLock<(Study, Vec<Trial>)> = OnceLock::new();
    STUDY.get_or_init(|| {
        let study = Study::new(&ProgressBar::hidden()).expect("the shipped data");
        let trials = study.trials(&ProgressBar::hidden());
        (study, trials)
    })
}

fn errors() -> &'static Errors {
    static ERRORS: OnceLock<Errors> = OnceLock::new();
    ERRORS.get_or_init(|| Errors::new(&study().0, &study().1))
}

fn of(material: &str) -> &'static [f64] {
    let errors = errors().of_material(material, Criterion::ImageCentered, Modes::All);
    assert!(errors.len() > 100, "{material}");
    errors
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
        assert_eq!(count, expected);
        assert_eq!(mode::total(degree, order), expected);
    }
    assert_eq!((Modes::All.count(), Modes::Selected.count()), (3704, 1000));
}

/// The variance of the Lambertian modes of degree l is proportional to (2l + 1) A_l²,
/// A_l the coefficients of the clamped cosine (Ramamoorthi and Hanrahan 2001).
#[test]
fn degree_two_carries_the_lambertian_variance() {
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
    let beyond = Variance::new(&study().0).beyond(0);
    for (l, beyond) in beyond.iter().enumerate() {
        let expected = power[l + 1..].iter().sum::<f64>() / all;
        assert!((beyond - expected).abs() <= tolerances::LAMBERTIAN_SHARES, "{l}: {beyond}");
    }
    let [most, least] = tolerances::PAPER_LAMBERTIAN;
    assert!(beyond[2] < most && beyond[1] > least, "{beyond:?}");
}

/// The paper's three cuts leave out 0.7 to 0.75 %, one degree less some four times that.
#[test]
fn the_papers_degrees_leave_out_the_same_share() {
    let variance = Variance::new(&study().0);
    for (order, degree, name) in SURFACES {
        let beyond = variance.beyond(order);
        assert!(tolerances::PAPER_LEFT_OUT.contains(&beyond[degree]), "{name}: {beyond:?}");
        let ratio = beyond[degree - 1] / beyond[degree];
        assert!(ratio > tolerances::PAPER_ONE_DEGREE, "{name}: {beyond:?}");
    }
}

#[test]
fn both_criteria_are_alike() {
    for modes in Modes::BOTH {
        let of = |criterion| &errors().mean[place(criterion, modes)];
        let (centred, standard) = (of(Criterion::ImageCentered), of(Criterion::Standard));
        for (count, (centred, standard)) in
            centred.iter().zip(standard).enumerate().skip(ALIKE_FROM)
        {
            let ratio = standard / centred;
            assert!(tolerances::PAPER_ALIKE.contains(&ratio), "{modes:?}, {count}: {ratio}");
        }
        // Not below: the constant is a component of one only.
        assert!(standard[3] > tolerances::PAPER_UNLIKE * centred[3]);
    }
}

#[test]
fn components_for_matte_velvet_and_leather() {
    let (plaster, velvet, leather) = (of("11-plaster-b"), of("07-velvet"), of("05-leather"));
    // Matte: five leave less than 10 %, of one pair of materials alone.
    let mattest = errors().materials().all(|(_, errors)| errors[5] >= plaster[5]);
    let [five, ten] = tolerances::PAPER_PLASTER;
    assert!(mattest && plaster[5] < five && plaster[10] < ten);
    let within = |count: usize| errors().materials().filter(|(_, e)| e[count] <= 0.1).count();
    assert!(within(5) <= 5 && within(8) >= 40 && within(10) >= 58);
    // Velvet: not with five, and component 8 is the step.
    let [five, eight, nine] = tolerances::PAPER_VELVET;
    assert!(velvet[5] > five && velvet[8] > eight && velvet[9] < nine);
    let table = &study().0.tables[0];
    assert_eq!(table.components[8].order, 0);
    // Leather: 30 to 50 take it from 1 % to 0.1 %.
    let [twenty, thirty, fifty] = tolerances::PAPER_LEATHER;
    assert!(leather[20] > twenty && leather[30] < thirty && leather[50] < fifty);
    assert!(matches!(needed(leather, 0.01), Some(20..=30)));
}

/// Leather's highlight: a few components have the shading, 50 the highlight.
#[test]
fn leathers_highlight_takes_thirty_to_fifty() {
    let (study, trials) = study();
    let found = Reconstructions::new(study, trials).expect("the shipped data");
    let leather = &found.courses[1];
    assert_eq!(leather.names, ["05-leather", "studio"]);
    let [ten, thirty, fifty] = tolerances::PAPER_HIGHLIGHT;
    assert!(leather.brightest[10] < ten && leather.brightest[30] < thirty);
    assert!(leather.brightest[50] > fifty);
    let velvet = &found.courses[0];
    let shading = [leather.errors[10], velvet.errors[10]];
    assert!(shading[0] < tolerances::PAPER_SHADING[0] && shading[1] < tolerances::PAPER_SHADING[1]);
    assert!(velvet.brightest[30] < thirty);
    assert!(velvet.brightest[50] < leather.brightest[50], "its rim takes more");
}

/// With five components the light matters more than the material, and light from behind
/// is what is missed.
#[test]
fn the_error_of_five_components_is_that_of_the_light() {
    let spread = |errors: Vec<f64>| {
        let sorted = errors.iter().fold([f64::INFINITY, 0.0], |[low, high]: [f64; 2], &error| {
            [low.min(error), high.max(error)]
        });
        sorted[1] / sorted[0]
    };
    let lights = spread(errors().lights().map(|(_, errors)| errors[5]).collect());
    let materials = spread(errors().materials().map(|(_, errors)| errors[5]).collect());
    assert!(lights > tolerances::PAPER_LIGHT_MATTERS * materials, "{lights} {materials}");
    let correlation = errors().correlation(5);
    assert!(tolerances::PAPER_CORRELATION.contains(&correlation), "{correlation}");
}

#[test]
fn the_truncation_harms_the_sum_more_than_the_basis() {
    let (study, trials) = study();
    let selected = Selected::new(study, trials);
    assert_eq!(selected.kept, 1001);
    assert_eq!(selected.by_degree.iter().sum::<usize>(), 1001);
    let [median, mean, worst] = selected.image_error;
    assert!(
        tolerances::PAPER_SELECTED.contains(&median) && worst > tolerances::PAPER_SELECTED_WORST
    );
    assert!(mean > errors().mean[0][10]);
    assert!(selected.floor < tolerances::PAPER_FLOOR && selected.components == [218, 147]);
    let [all, some] = [0, 2].map(|basis| &errors().mean[basis]);
    for count in 0..=10 {
        assert!(some[count] < tolerances::PAPER_SELECTED_FEW * all[count], "{count}");
    }
    assert!(some[50] > tolerances::PAPER_SELECTED_MANY * all[50]);
}

/// Every partial sum of every image, all modes and the selected ones.
#[test]
fn the_bound_holds_and_the_uncorrelated_sum_is_none() {
    let (study, trials) = study();
    let bounds = Bounds::new(study, trials, &ProgressBar::hidden());
    assert_eq!(bounds.violations, 0);
    assert_eq!(bounds.compared, 1586 * (3705 + 1002));
    for row in bounds.rows.iter().filter(|row| row.modes == Modes::All) {
        assert_eq!(row.reached, 1586);
        assert!(row.error <= row.accuracy, "{}", row.accuracy);
        let [share, excess] = tolerances::PAPER_NO_BOUND;
        assert!(row.exceeded > share && row.excess > excess, "{}", row.accuracy);
        assert!(row.sufficient <= row.terms[1] && row.triangle < tolerances::PAPER_TRIANGLE);
    }
    assert_eq!(bounds.zero_modes, 58);
}

/// A fixed set of terms left out, averaged over all rotations of one light: different
/// (l, m) add in squares, and within one the triangle inequality gives the bound.
#[test]
fn on_average_over_rotations_degrees_and_orders_add() {
    let (study, _) = study();
    let dropped: Vec<bool> = study.selection.iter().map(|kept| !kept).collect();
    let velvet = study.materials.entries.iter().position(|entry| entry.name == "07-velvet");
    let grey = study.greys[velvet.expect("it is there")].clone();
    let left = MaterialImages::new(&study.gram, &dropped, &[grey]);
    let captured = &study.luminances[4];
    // Exact for products of two D of degree 9.
    let (mut mean, mut most) = (0.0, 0.0f64);
    for (z, weight) in gauss_legendre::rule(10, -1.0, 1.0) {
        for (beta, gamma) in (0..19).flat_map(|beta| (0..19).map(move |gamma| (beta, gamma))) {
            let angle = |k: i32| 2.0 * PI * f64::from(k) / 19.0;
            let rotation = Rotation { alpha: z.acos(), beta: angle(beta), gamma: angle(gamma) };
            let energy = left.image(&rotation.turn(9, captured), 0).energy();
            mean += weight / 722.0 * energy;
            most = most.max(energy);
        }
    }
    let expected: f64 = light::indices(9)
        .map(|(l, m)| {
            let power = (-l.cast_signed()..=l.cast_signed())
                .map(|n| captured[light::position(l, n)].powi(2))
                .sum::<f64>();
            let mut unit = vec![0.0; 100];
            unit[light::position(l, m)] = 1.0;
            power / (2 * l + 1) as f64 * left.image(&unit, 0).energy()
        })
        .sum();
    assert!((mean / expected - 1.0).abs() <= tolerances::MEAN_OVER_ROTATIONS, "{mean} {expected}");
    // Only on average: single rotations exceed it.
    assert!(most > tolerances::PAPER_SINGLE_ROTATION * expected, "{most} {expected}");
}

/// Spheres rendered to a stated accuracy, from the file that the page shows.
#[test]
fn rendered_spheres_are_as_accurate_as_stated() {
    let path = repository().join("docs/paper/bound_spheres.csv");
    let text = std::fs::read_to_string(path).expect("a text");
    let header = "light,material,terms,accuracy,bound,error,pixel_error,largest_pixel_error";
    let rows = rows(&text, header);
    assert_eq!(rows.len(), 3 * 4);
    for sphere in rows.chunks(4) {
        for (row, stated) in sphere.iter().zip([0.1, 0.03, 0.01, 0.003]) {
            let numbers = numbers(std::slice::from_ref(row), 5);
            let [accuracy, bound, error, pixel_error, largest] = numbers[..] else { panic!() };
            assert_eq!(accuracy, stated);
            // The fewest terms: one less would be worth seeing.
            assert!(
                bound <= accuracy && bound > tolerances::PAPER_BOUND_USED * accuracy,
                "{row:?}"
            );
            assert!(error <= bound && pixel_error <= bound && error > 0.0, "{row:?}");
            assert!((pixel_error / error - 1.0).abs() <= tolerances::PIXEL_ERROR, "{row:?}");
            assert!(largest > pixel_error, "{row:?}");
        }
        let terms: Vec<usize> = sphere.iter().map(|row| row[2].parse().unwrap()).collect();
        assert!(terms.is_sorted_by(|a, b| a < b) && terms[3] < 3646, "{terms:?}");
    }
}

/// The word follows the figures: with others it is another.
#[test]
fn verdicts_are_those_of_the_figures() {
    let (study, trials) = study();
    let new = || {
        let errors = Errors::new(study, trials);
        (Variance::new(study), errors, Reconstructions::new(study, trials).expect("the data"))
    };
    let verdicts = |(variance, errors, courses): &(Variance, Errors, Reconstructions)| {
        let claims = claims(variance, errors, courses);
        let words = section(&claims);
        let expected = |claim: &Claim| {
            let word = if claim.holds { "holds" } else { "differs" };
            words.contains(&format!("| {word}: {} |", claim.found))
        };
        assert!(claims.iter().all(expected));
        claims.iter().map(|claim| claim.holds).collect::<Vec<_>>()
    };
    let shipped = new();
    assert_eq!(verdicts(&shipped), [true, true, true, true, false, false, true]);
    let (mut variance, mut errors, mut courses) = shipped;
    for by_degree in &mut variance.by_mode {
        by_degree[9] += 1.0;
    }
    errors.mean[1].iter_mut().for_each(|error| *error *= 1.1);
    for errors in &mut errors.by_material[0] {
        errors[6] = 0.09;
    }
    courses.courses[1].brightest[60] = 0.8;
    let doctored = (variance, errors, courses);
    assert_eq!(verdicts(&doctored), [false, false, false, false, true, true, false]);
}
