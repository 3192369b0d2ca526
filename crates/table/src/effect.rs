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
///
/// A basis for some effects factors UᵀM in the same way as a basis for all of them, but only for
/// the orders o that its directional effects (l >= 1) contain: see [`factored`](Self::factored). If
/// `ambient` contains other orders, their coefficients are stored unfactored: one number for each
/// profile of m = 0 and coefficient.
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

    /// The largest order o that the set uses, for a material up to `order`: the largest factored
    /// order, or all of `order` if some coefficients are unfactored.
    #[must_use]
    pub const fn order(self, order: usize) -> usize {
        if self.unfactored_count(order) > 0 { order } else { self.factored_order(order) }
    }

    /// Whether a basis for this set factors the modes of order o.
    #[inline]
    #[must_use]
    pub const fn factored(self, o: usize) -> bool {
        if self.is_directional() { self.keeps(1, o) } else { o == 0 }
    }

    /// The largest order o <= `order` that a basis for this set factors; 0 if there is none.
    #[must_use]
    pub const fn factored_order(self, order: usize) -> usize {
        match order {
            0..=3 if self.has(Effect::Broad) => order,
            0..=3 => 0,
            _ if self.has(Effect::Gloss) => order,
            _ => self.factored_order(3),
        }
    }

    /// Whether the coefficient (o, p, q) is stored unfactored.
    #[must_use]
    pub const fn is_unfactored(self, o: usize, q: usize) -> bool {
        self.has(Effect::Ambient) && q == 0 && !self.factored(o)
    }

    /// The (o, p) of the unfactored coefficients (o, p, 0) up to `order`, in storage order.
    pub fn unfactored(self, order: usize) -> impl Iterator<Item = (usize, usize)> {
        let all = crate::material::indices(order);
        all.filter(move |&(o, _, q)| self.is_unfactored(o, q)).map(|(o, p, _)| (o, p))
    }

    /// Number of unfactored coefficients up to `order`.
    ///
    /// Returns `usize::MAX` if there are any and the order is above 2047, like
    /// [`material::count`](crate::material::count).
    #[must_use]
    pub const fn unfactored_count(self, order: usize) -> usize {
        if !self.has(Effect::Ambient) || self.is_all() {
            return 0;
        }
        if order > crate::material::MAX_ORDER {
            return usize::MAX;
        }
        let (mut count, mut o) = (0, 0);
        while o <= order {
            // p = 0, 2, ..., o.
            count += if self.is_unfactored(o, o % 2) { o / 2 + 1 } else { 0 };
            o += 1;
        }
        count
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
    fn kept_coefficients_of_degree_zero_are_factored_or_unfactored() {
        for effects in every().filter(|effects| effects.has(Effect::Ambient)) {
            for (o, _, q) in crate::material::indices(9).filter(|&(_, _, q)| q == 0) {
                assert!(effects.factored(o) != effects.is_unfactored(o, q), "{effects:?} {o}");
            }
            assert_eq!(effects.unfactored(9).count(), effects.unfactored_count(9), "{effects:?}");
        }
        for (effects, order) in every().flat_map(|one| (0..9).map(move |order| (one, order))) {
            let largest = (0..=order).rev().find(|&o| effects.factored(o)).unwrap_or(0);
            assert_eq!(effects.factored_order(order), largest, "{effects:?} {order}");
        }
        let matte: Effects = [Effect::Ambient, Effect::Diffuse].into_iter().collect();
        assert_eq!((matte.order(7), matte.factored_order(7), matte.unfactored_count(7)), (7, 0, 9));
        let rough = matte.with(Effect::Broad).without(Effect::Ambient);
        assert_eq!((rough.order(7), rough.factored_order(7), rough.unfactored_count(7)), (3, 3, 0));
        assert_eq!(Effects::ALL.unfactored_count(7), 0);
    }
}
