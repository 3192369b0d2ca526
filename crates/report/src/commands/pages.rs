//! `report pages`: the generated tables and charts of the documentation.

use eigenshade_model::error::Result;
use report::accuracy_cost::{self, Measured};
use report::pages::{Part, fill, table_of};
use report::paper::tables;
use report::sheet::Sheet;
use report::{figures, highlights, material_errors, paper, shadow_table, stability};
use std::path::Path;

/// The pages that show CSV files of their folder as they are.
const AS_THEY_ARE: [(&str, &[&str]); 4] = [
    ("benches/README.md", &["counts.csv", "peers.csv"]),
    ("docs/accuracy.md", &["float-errors.csv", "metallic-roughness.csv", "unseen.csv"]),
    ("docs/objects.md", &["objects.csv"]),
    ("docs/reading.md", &["reading-estimates.csv", "reading-scenes.csv"]),
];

/// Makes them from the committed CSV files, from the repository's root.
pub fn write() -> Result<()> {
    let docs = Path::new("docs");
    for (page, names) in AS_THEY_ARE {
        let page = Path::new(page);
        let part =
            |name: &&'static str| Ok((*name, table_of(&Sheet::read(&page.with_file_name(name))?)));
        fill(page, &names.iter().map(part).collect::<Result<Vec<Part>>>()?)?;
    }
    let energies = Sheet::read(&super::inputs().join("merl.energy.csv"))?;
    let cases = Sheet::read(&docs.join("stability.csv"))?;
    let parts = [("energies", material_errors::energies(&energies)), stability::summary(&cases)];
    fill(&docs.join("accuracy.md"), &parts)?;
    let errors = highlights::read(&docs.join("highlights.csv"))?;
    fill(&docs.join("highlights.md"), &highlights::parts(&errors))?;

    let shadows = Sheet::read(&docs.join("shadows.csv"))?;
    fill(&docs.join("shadows.md"), &[shadow_table::part(&shadows)])?;
    fill(Path::new("README.md"), &[shadow_table::limits(&shadows)])?;

    let folder = docs.join("accuracy-cost");
    let measured = Measured::read(&folder)?;
    fill(&docs.join("costs.md"), &accuracy_cost::report::tables(&measured))?;
    figures::write(&accuracy_cost::report::charts::all(&measured)?, &folder)?;

    let folder = docs.join("paper");
    let sheets = tables::read(&folder)?;
    fill(&docs.join("paper.md"), &tables::parts(&sheets))?;
    figures::write(&paper::charts(&sheets)?, &folder)
}
