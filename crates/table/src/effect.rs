//! Effects: sets of irradiance modes with a visible meaning.
//!
//! An image is linear in its modes, so it is the sum of the images of its effects.

/// A set of irradiance modes with a visible meaning.
///
/// Every mode (l, o, p, q) belongs to exactly one effect: see [`Effect::of`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(
    feature = "files",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Effect {
    /// l = 0: the response to the mean of the light over all directions.
    Ambient,
    /// l >= 1, o = 0: how a Lambertian material responds to directional light.
    Diffuse,
    /// l >= 1, 1 <= o <= 3: rough, backscattering and rim lobes.
    Broad,
    /// l >= 1, o >= 4: highlights.
    Gloss,
}

impl Effect {
    /// All four effects.
    pub const ALL: [Self; 4] = [Self::Ambient, Self::Diffuse, Self::Broad, Self::Gloss];

    /// The effect of the modes of degree l and order o.
    #[inline]
    #[must_use]
    pub const fn of(l: usize, o: usize) -> Self {
        match (l, o) {
            (0, _) => Self::Ambient,
            (_, 0) => Self::Diffuse,
            (_, 1..=3) => Self::Broad,
            _ => Self::Gloss,
        }
    }

    /// Sets the coefficients of a light that have no part in this effect to zero.
    ///
    /// The image of the masked light on the [masked](Self::mask_material) material is the image of
    /// the effect; the images of all four sum to the whole. Coefficients are floats or mantissas.
    ///
    /// ```
    /// use eigenshade_table::effect::Effect;
    ///
    /// let mut light = [3.5, 0.2, 1.0, -0.4];
    /// Effect::Diffuse.mask_light(&mut light);
    /// assert_eq!(light, [0.0, 0.2, 1.0, -0.4]);
    /// ```
    pub fn mask_light<S: Default>(self, coefficients: &mut [S]) {
        for (place, coefficient) in coefficients.iter_mut().enumerate() {
            // L_0^0 comes first.
            if (place == 0) != (self == Self::Ambient) {
                *coefficient = S::default();
            }
        }
    }

    /// Sets the coefficients of a material that have no part in this effect to zero: see
    /// [`mask_light`](Self::mask_light).
    pub fn mask_material<S: Default>(self, coefficients: &mut [S]) {
        let mut mode = (0, 0, 0);
        for coefficient in coefficients {
            if self != Self::Ambient && Self::of(1, mode.0) != self {
                *coefficient = S::default();
            }
            mode = crate::material::following(mode);
        }
    }

    /// The effect's name in a scene file and on the command line.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Ambient => "ambient",
            Self::Diffuse => "diffuse",
            Self::Broad => "broad",
            Self::Gloss => "gloss",
        }
    }

    const fn bit(self) -> u8 {
        1 << self as u8
    }
}

/// A set of effects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Effects(u8);

impl Effects {
    /// The empty set.
    pub const NONE: Self = Self(0);

    /// All effects.
    pub const ALL: Self = Self(0b1111);

    /// Adds an effect to the set.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        Self(self.0 | effect.bit())
    }

    /// Removes an effect from the set.
    #[must_use]
    pub const fn without(self, effect: Effect) -> Self {
        Self(self.0 & !effect.bit())
    }

    /// The intersection of two sets.
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self(self.0 & others.0)
    }

    /// The set with these bits, or `None` if a bit belongs to no effect. Bit k is the k-th effect
    /// of [`Effect::ALL`].
    #[must_use]
    pub const fn from_bits(bits: u16) -> Option<Self> {
        if bits > Self::ALL.0 as u16 { None } else { Some(Self(bits as u8)) }
    }

    /// The bits of the set. Bit k is the k-th effect of [`Effect::ALL`].
    #[must_use]
    pub const fn bits(self) -> u16 {
        self.0 as u16
    }

    /// Whether the set contains an effect.
    #[inline]
    #[must_use]
    pub const fn has(self, effect: Effect) -> bool {
        self.0 & effect.bit() != 0
    }

    /// Whether the set contains every effect.
    #[inline]
    #[must_use]
    pub const fn is_all(self) -> bool {
        self.0 == Self::ALL.0
    }

    /// Whether the set contains the modes of degree l and order o.
    #[inline]
    #[must_use]
    pub const fn keeps(self, l: usize, o: usize) -> bool {
        self.has(Effect::of(l, o))
    }

    /// Whether the set contains an effect of degrees l >= 1.
    #[must_use]
    pub const fn is_directional(self) -> bool {
        self.0 & !Effect::Ambient.bit() != 0
    }

    /// The largest degree l that the set contains, for light up to `degree`.
    #[must_use]
    pub const fn degree(self, degree: usize) -> usize {
        if self.is_directional() { degree } else { 0 }
    }

    /// The largest order o that the set contains for directional light, or else for ambient light, of
    /// a material up to `order`.
    #[must_use]
    pub const fn order(self, order: usize) -> usize {
        match order {
            _ if !self.is_directional() && self.has(Effect::Ambient) => order,
            4.. if self.has(Effect::Gloss) => order,
            0..=3 if self.has(Effect::Broad) => order,
            4.. if self.has(Effect::Broad) => 3,
            _ => 0,
        }
    }
}

impl FromIterator<Effect> for Effects {
    fn from_iter<I: IntoIterator<Item = Effect>>(effects: I) -> Self {
        effects.into_iter().fold(Self::NONE, Self::with)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn every() -> impl Iterator<Item = Effects> {
        (0..16).filter_map(Effects::from_bits)
    }

    #[test]
    fn each_mode_belongs_to_one_effect() {
        for (l, o) in (0..5).flat_map(|l| (0..9).map(move |o| (l, o))) {
            let holders = Effect::ALL.iter().filter(|&&one| Effects::NONE.with(one).keeps(l, o));
            assert_eq!(holders.count(), 1, "{l} {o}");
        }
        assert_eq!(Effect::of(1, 0), Effect::Diffuse);
        assert_eq!(
            [1, 3, 4].map(|o| Effect::of(1, o)),
            [Effect::Broad, Effect::Broad, Effect::Gloss]
        );
        assert_eq!(Effects::from_bits(16), None);
    }

    #[test]
    fn degree_and_order_are_the_largest_of_their_modes() {
        // Every effect has modes of these.
        for effects in every().filter(|&one| one != Effects::NONE) {
            for (degree, order) in [(1, 4), (2, 4), (3, 8)] {
                let modes = (0..=degree).flat_map(|l| (0..=order).map(move |o| (l, o)));
                let kept = modes.filter(|&(l, o)| effects.keeps(l, o));
                // Ambient light beside directional light has the same orders.
                let kept = kept.filter(|&(l, _)| l > 0 || !effects.is_directional());
                let largest = kept.fold([0; 2], |[l, o], mode| [l.max(mode.0), o.max(mode.1)]);
                assert_eq!([effects.degree(degree), effects.order(order)], largest, "{effects:?}");
            }
        }
        let [matte, rough, shiny] = [[Effect::Diffuse], [Effect::Broad], [Effect::Gloss]]
            .map(|effects| effects.into_iter().collect::<Effects>());
        assert_eq!([0, 2, 3, 7].map(|order| matte.order(order)), [0; 4]);
        assert_eq!([0, 2, 3, 7].map(|order| rough.order(order)), [0, 2, 3, 3]);
        assert_eq!([0, 2, 3, 7].map(|order| shiny.order(order)), [0, 0, 0, 7]);
    }

    /// The four images of a light on a material are the images of its modes.
    #[test]
    fn masks_keep_the_modes_of_their_effect() {
        for effect in Effect::ALL {
            let (mut light, mut material) = ([1; 16], [1; 30]);
            effect.mask_light(&mut light);
            effect.mask_material(&mut material);
            for ((l, _), &of_light) in crate::light::indices(3).zip(&light) {
                for ((o, _, _), &of_material) in crate::material::indices(6).zip(&material) {
                    let kept = of_light * of_material == 1;
                    assert_eq!(kept, Effect::of(l, o) == effect, "{effect:?} {l} {o}");
                }
            }
        }
    }
}
