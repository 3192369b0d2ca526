//! Effects: sets of irradiance modes that a person can see. An image is linear in its modes,
//! so it is the sum of the images of its effects.

/// A set of irradiance modes that a person can see.
///
/// Every mode (l, o, p, q) belongs to one: see [`Effect::of`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[cfg_attr(
    feature = "serde",
    derive(serde::Serialize, serde::Deserialize),
    serde(rename_all = "kebab-case")
)]
pub enum Effect {
    /// l = 0: what light from all around does.
    Ambient,
    /// l >= 1, o = 0: what a Lambertian material shows of the light's directions.
    Diffuse,
    /// l >= 1, 1 <= o <= 3: rough, backscattering and rim lobes.
    Broad,
    /// l >= 1, o >= 4: highlights.
    Gloss,
}

impl Effect {
    /// Every effect.
    pub const ALL: [Self; 4] = [Self::Ambient, Self::Diffuse, Self::Broad, Self::Gloss];

    /// That of the modes of degree l and order o.
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

    /// Its name in a scene file and on a command line.
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

/// Some of the effects.
///
/// A basis of some effects factors UᵀM as one of all does, for the orders o that its
/// directional effects (l >= 1) take: [`factored`](Self::factored). What `ambient` takes of
/// other orders stands apart, one number for each profile of m = 0 and coefficient.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
pub struct Effects(u8);

impl Effects {
    /// None of them.
    pub const NONE: Self = Self(0);

    /// All of them.
    pub const ALL: Self = Self(0b1111);

    /// These and one more.
    #[must_use]
    pub const fn with(self, effect: Effect) -> Self {
        Self(self.0 | effect.bit())
    }

    /// These without one.
    #[must_use]
    pub const fn without(self, effect: Effect) -> Self {
        Self(self.0 & !effect.bit())
    }

    /// Those of both.
    #[must_use]
    pub const fn and(self, others: Self) -> Self {
        Self(self.0 & others.0)
    }

    /// The effects of these bits, from the first of [`Effect::ALL`] up; `None` if there are
    /// others.
    #[must_use]
    pub const fn from_bits(bits: u16) -> Option<Self> {
        if bits > Self::ALL.0 as u16 { None } else { Some(Self(bits as u8)) }
    }

    /// Their bits, from the first of [`Effect::ALL`] up.
    #[must_use]
    pub const fn bits(self) -> u16 {
        self.0 as u16
    }

    /// Whether an effect is among them.
    #[inline]
    #[must_use]
    pub const fn has(self, effect: Effect) -> bool {
        self.0 & effect.bit() != 0
    }

    /// Whether they are all.
    #[inline]
    #[must_use]
    pub const fn is_all(self) -> bool {
        self.0 == Self::ALL.0
    }

    /// Whether modes of degree l and order o are in them.
    #[inline]
    #[must_use]
    pub const fn keeps(self, l: usize, o: usize) -> bool {
        self.has(Effect::of(l, o))
    }

    /// Whether any of them is of degrees l >= 1.
    #[must_use]
    pub const fn is_directional(self) -> bool {
        self.0 & !Effect::Ambient.bit() != 0
    }

    /// The largest degree l that they take of light of `degree`.
    #[must_use]
    pub const fn degree(self, degree: usize) -> usize {
        if self.is_directional() { degree } else { 0 }
    }

    /// The largest order o that they take of a material of `order`: that of their factors, or
    /// all of it where coefficients stand apart.
    #[must_use]
    pub const fn order(self, order: usize) -> usize {
        if self.apart_count(order) > 0 { order } else { self.factored_order(order) }
    }

    /// Whether a basis of these effects factors the modes of order o.
    #[inline]
    #[must_use]
    pub const fn factored(self, o: usize) -> bool {
        if self.is_directional() { self.keeps(1, o) } else { o == 0 }
    }

    /// The largest order o, of those up to `order`, that a basis of these effects factors;
    /// 0 if there is none.
    #[must_use]
    pub const fn factored_order(self, order: usize) -> usize {
        match order {
            0..=3 if self.has(Effect::Broad) => order,
            0..=3 => 0,
            _ if self.has(Effect::Gloss) => order,
            _ => self.factored_order(3),
        }
    }

    /// Whether the coefficient (o, p, q) stands apart.
    #[must_use]
    pub const fn is_apart(self, o: usize, q: usize) -> bool {
        self.has(Effect::Ambient) && q == 0 && !self.factored(o)
    }

    /// The (o, p) of the coefficients (o, p, 0) up to `order` that stand apart, in storage
    /// order.
    pub fn apart(self, order: usize) -> impl Iterator<Item = (usize, usize)> {
        let all = crate::material::indices(order);
        all.filter(move |&(o, _, q)| self.is_apart(o, q)).map(|(o, p, _)| (o, p))
    }

    /// Number of coefficients up to `order` that stand apart; `usize::MAX` if some do and the
    /// order is above 2047, as [`material::count`](crate::material::count) has it.
    #[must_use]
    pub const fn apart_count(self, order: usize) -> usize {
        if !self.has(Effect::Ambient) || self.is_all() {
            return 0;
        }
        if order > crate::material::MOST {
            return usize::MAX;
        }
        let (mut count, mut o) = (0, 0);
        while o <= order {
            // p = 0, 2, ..., o.
            count += if self.is_apart(o, o % 2) { o / 2 + 1 } else { 0 };
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
    fn what_is_kept_of_degree_zero_is_factored_or_apart() {
        for effects in every().filter(|effects| effects.has(Effect::Ambient)) {
            for (o, _, q) in crate::material::indices(9).filter(|&(_, _, q)| q == 0) {
                assert!(effects.factored(o) != effects.is_apart(o, q), "{effects:?} {o}");
            }
            assert_eq!(effects.apart(9).count(), effects.apart_count(9), "{effects:?}");
        }
        for (effects, order) in every().flat_map(|one| (0..9).map(move |order| (one, order))) {
            let largest = (0..=order).rev().find(|&o| effects.factored(o)).unwrap_or(0);
            assert_eq!(effects.factored_order(order), largest, "{effects:?} {order}");
        }
        let matte: Effects = [Effect::Ambient, Effect::Diffuse].into_iter().collect();
        assert_eq!((matte.order(7), matte.factored_order(7), matte.apart_count(7)), (7, 0, 9));
        let rough = matte.with(Effect::Broad).without(Effect::Ambient);
        assert_eq!((rough.order(7), rough.factored_order(7), rough.apart_count(7)), (3, 3, 0));
        assert_eq!(Effects::ALL.apart_count(7), 0);
    }
}
