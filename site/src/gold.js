// The egg's gold: its linear base color, metallic and roughness.

export const GOLD = { color: [1, 0.72, 0.3], metallic: 1, roughness: 0.4 };
