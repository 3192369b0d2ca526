//! Which layer of an OpenEXR file is the picture: a file may have several, in one part or in many.

use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use exr::meta::header::Header;
use exr::prelude::Vec2;

/// What programs call the layer that is the picture, and not a part of it.
const WHOLE: [&str; 6] = ["combined", "beauty", "rgba", "rgb", "color", "main"];

/// Names that a message lists.
const LISTED: usize = 8;

/// The channels of one layer.
pub(crate) struct ExrLayer {
    /// The index of its part.
    pub(crate) part: usize,
    /// The indices of red, green and blue in the part, or three times that of gray.
    pub(crate) color: [usize; 3],
    /// The index of the opacity.
    pub(crate) opacity: Option<usize>,
    name: String,
    /// The lowest is the picture.
    rank: (bool, u8),
}

impl ExrLayer {
    /// The layer to read: the one without a name, or else one with a name like `Combined` or
    /// `beauty`, or else the first; gray only if none has color. A warning names it if there are
    /// others.
    pub(crate) fn of(headers: &[Header], file: &InputFile) -> Result<Self> {
        let all: Vec<Self> = (0..headers.len()).flat_map(|part| in_part(headers, part)).collect();
        let names: Vec<_> = all.iter().map(|layer| layer.name.clone()).collect();
        let chosen = all.into_iter().min_by_key(|layer| layer.rank);
        let chosen = chosen.ok_or_else(|| without_color(headers))?;
        if names.len() > 1 {
            let more = if names.len() > LISTED { ", .." } else { "" };
            file.warn(format!(
                "it has the layers {}{more}: {} is read; save another one alone to use it",
                names[..names.len().min(LISTED)].join(", "),
                chosen.name
            ));
        }
        Ok(chosen)
    }
}

/// The layers of a part that have color, or gray, with a sample for each pixel.
fn in_part(headers: &[Header], part: usize) -> Vec<ExrLayer> {
    let header = &headers[part];
    let channels = &header.channels.list;
    if header.deep || channels.iter().any(|channel| channel.sampling != Vec2(1, 1)) {
        return Vec::new();
    }
    let names: Vec<String> = channels.iter().map(|channel| channel.name.to_string()).collect();
    let of_part = header.own_attributes.layer_name.as_ref().map(ToString::to_string);
    let of_part = of_part.filter(|_| headers.len() > 1).unwrap_or_default();
    let find = |prefix: &str, name: &str| {
        names.iter().position(|one| one.strip_prefix(prefix) == Some(name))
    };
    let layer = |prefix: &str, [r, g, b]: [&str; 3]| {
        let color = [find(prefix, r)?, find(prefix, g)?, find(prefix, b)?];
        let name = prefix.strip_suffix('.').unwrap_or(&of_part).to_owned();
        let last = name.rsplit('.').next().unwrap_or_default().to_ascii_lowercase();
        let rank = match () {
            () if name.is_empty() => 0,
            () if WHOLE.contains(&last.as_str()) => 1,
            () => 2,
        };
        let name = if name.is_empty() { [r, g, b].join(", ") } else { name };
        let opacity = find(prefix, "A");
        Some(ExrLayer { part, color, opacity, name, rank: (r == "Y", rank) })
    };
    let prefixes = names.iter().filter_map(|name| name.strip_suffix('R'));
    let prefixes = prefixes.filter(|prefix| prefix.is_empty() || prefix.ends_with('.'));
    let mut layers: Vec<_> = prefixes.filter_map(|prefix| layer(prefix, ["R", "G", "B"])).collect();
    // Y is luminance beside RY and BY, and a component of color beside X and Z. Z alone is depth.
    let has = |name: &str| find("", name).is_some();
    if !has("RY") && !has("X") {
        layers.extend(layer("", ["Y"; 3]));
    }
    layers
}

fn without_color(headers: &[Header]) -> Error {
    let names: Vec<_> = headers
        .iter()
        .flat_map(|header| header.channels.list.iter())
        .map(|channel| channel.name.to_string())
        .take(LISTED)
        .collect();
    Error::new(
        format!("its channels are {}, without R, G, B", names.join(", ")),
        "export it with the channels R, G, B, or Y alone if it is gray, one sample a pixel",
    )
}
