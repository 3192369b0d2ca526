//! The materials and textures of glTF.

use crate::accessor::{Accessors, broken};
use crate::asset::{Asset, Map, Material, Wrap};
use crate::buffers;
use crate::image::Image;
use crate::texture::{Kind, Texture};
use eigenshade_model::error::{Error, Result};
use eigenshade_model::inputs::input_file::InputFile;
use gltf::Document;
use gltf::image::Source;
use gltf::material::AlphaMode;
use gltf::texture::{Info, TextureTransform, WrappingMode};
use std::collections::{BTreeSet, HashMap};

/// The cutoff of a material whose opacity is to be blended.
const BLENDED: f32 = 0.5;

/// The most texels of all textures together.
const MOST_TEXELS: u64 = 1 << 26;

/// Adds the materials that the triangles of an asset have: glTF's default as number 0, and those of
/// the file from 1 on.
pub(crate) fn read(
    file: &InputFile,
    document: &Document,
    accessors: &Accessors<'_>,
    asset: &mut Asset,
) -> Result<()> {
    let used: BTreeSet<u32> = asset.material_of.iter().copied().collect();
    let mut reader = Reader {
        file,
        accessors,
        textures: Vec::new(),
        of_image: HashMap::new(),
        texels: 0,
        ignored: BTreeSet::new(),
    };
    asset.materials.push(Material::default());
    for (number, material) in (1..).zip(document.materials()) {
        asset.materials.push(match used.contains(&number) {
            true => reader.material(&material)?,
            false => Material::default(),
        });
    }
    if !reader.ignored.is_empty() {
        let list: Vec<&str> = reader.ignored.into_iter().collect();
        file.warn(format!("ignored: {}", list.join(", ")));
    }
    asset.textures = reader.textures;
    Ok(())
}

struct Reader<'a> {
    file: &'a InputFile,
    accessors: &'a Accessors<'a>,
    textures: Vec<Texture>,
    of_image: HashMap<(usize, Kind), usize>,
    texels: u64,
    ignored: BTreeSet<&'static str>,
}

impl Reader<'_> {
    fn material(&mut self, material: &gltf::Material<'_>) -> Result<Material> {
        let pbr = material.pbr_metallic_roughness();
        let factors =
            [&pbr.base_color_factor()[..], &[pbr.metallic_factor(), pbr.roughness_factor()]];
        if let Some(factor) = factors.concat().iter().find(|factor| !(0.0..=1.0).contains(*factor))
        {
            let index = material.index().unwrap_or_default();
            return Err(broken(format!(
                "material {index} has a factor of {factor}, not in [0, 1]"
            )));
        }
        if let Some(strength) = material.occlusion_texture().map(|of| of.strength())
            && !(0.0..=1.0).contains(&strength)
        {
            let what = format!("a material has an occlusion strength of {strength}, not in [0, 1]");
            return Err(broken(what));
        }
        if material.emissive_factor().iter().any(|factor| *factor > 0.0) {
            self.ignored.insert("emitted light");
        }
        if material.alpha_mode() == AlphaMode::Blend {
            self.ignored
                .insert("transparency (opacity from 1/2 on is drawn, and the rest is a hole)");
        }
        Ok(Material {
            base_color: pbr.base_color_factor(),
            metallic: pbr.metallic_factor(),
            roughness: pbr.roughness_factor(),
            base_color_map: self.of_info(pbr.base_color_texture(), Kind::Color)?,
            metallic_roughness_map: self
                .of_info(pbr.metallic_roughness_texture(), Kind::Numbers)?,
            occlusion_map: match material.occlusion_texture() {
                Some(of) => {
                    let map = self.map(&of.texture(), of.tex_coord(), None, Kind::Numbers)?;
                    Some((map, of.strength()))
                }
                None => None,
            },
            normal_map: match material.normal_texture() {
                Some(of) => {
                    let map = self.map(&of.texture(), of.tex_coord(), None, Kind::Normals)?;
                    Some((map, of.scale()))
                }
                None => None,
            },
            cutoff: match material.alpha_mode() {
                AlphaMode::Opaque => None,
                AlphaMode::Mask => Some(material.alpha_cutoff().unwrap_or(BLENDED)),
                AlphaMode::Blend => Some(BLENDED),
            },
            is_double_sided: material.double_sided(),
        })
    }

    fn of_info(&mut self, info: Option<Info<'_>>, kind: Kind) -> Result<Option<Map>> {
        let Some(info) = info else { return Ok(None) };
        let transform = info.texture_transform();
        let set = transform.as_ref().and_then(TextureTransform::tex_coord);
        let set = set.unwrap_or_else(|| info.tex_coord());
        self.map(&info.texture(), set, transform, kind).map(Some)
    }

    fn map(
        &mut self,
        texture: &gltf::Texture<'_>,
        set: u32,
        transform: Option<TextureTransform<'_>>,
        kind: Kind,
    ) -> Result<Map> {
        if set > 1 {
            self.ignored.insert("texture coordinates beyond the second set");
        }
        let sampler = texture.sampler();
        let wrap = [sampler.wrap_s(), sampler.wrap_t()].map(|mode| match mode {
            WrappingMode::Repeat => Wrap::Repeat,
            WrappingMode::MirroredRepeat => Wrap::Mirror,
            WrappingMode::ClampToEdge => Wrap::Clamp,
        });
        let texture = self.texture(&texture.source(), kind)?;
        let plain = Map::plain(texture);
        let transform = transform.map_or(plain.transform, |of| {
            let ([u, v], [wide, tall], (s, c)) = (of.offset(), of.scale(), of.rotation().sin_cos());
            [[c * wide, s * tall, u], [-s * wide, c * tall, v]]
        });
        Ok(Map { set: (set as usize).min(1), transform, wrap, ..plain })
    }

    fn texture(&mut self, image: &gltf::Image<'_>, kind: Kind) -> Result<usize> {
        let key = (image.index(), kind);
        if let Some(found) = self.of_image.get(&key) {
            return Ok(*found);
        }
        let named = |error: Error| error.of(format_args!("image {}", image.index()));
        let decoded = match image.source() {
            Source::View { view, .. } => {
                Image::decode(self.accessors.view(&view)?).map_err(named)?
            }
            Source::Uri { uri, .. } => {
                Image::decode(&buffers::bytes(self.file, uri)?).map_err(named)?
            }
        };
        let texture = Texture::new(decoded, kind);
        self.texels += texture.size().iter().product::<usize>() as u64;
        self.file.at_most(self.texels, MOST_TEXELS, "texels")?;
        self.textures.push(texture);
        self.of_image.insert(key, self.textures.len() - 1);
        Ok(self.textures.len() - 1)
    }
}
