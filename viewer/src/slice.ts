// The plane of incidence: directions in it, and how values are drawn.

/** A value as it is drawn: itself, or its cube root, under which highlights and the rest are seen together. */
export function scaled(value: number, scale: string): number {
  return scale === 'cube root' ? Math.cbrt(value) : value;
}

/** A unit vector in the plane of incidence; positive angles [rad] lie on the mirror's side, for light comes from the other. */
export function inPlane(theta: number): [number, number, number] {
  return [-Math.sin(theta), 0, Math.cos(theta)];
}

/** Channels that are drawn: all up to four; of more those nearest to 650, 550 and 450 nm, else the first, the middle and the last. */
export function shownChannels(channels: readonly string[], wavelengths: readonly number[]): { channel: number; name: string; tint: string }[] {
  const count = channels.length;
  const pick = (picks: number[], tints: string[]): { channel: number; name: string; tint: string }[] => picks.map((channel, k) => ({ channel, name: channels[channel] ?? String(channel), tint: tints[k] ?? 'grey' }));
  if (count === 1) return pick([0], ['grey']);
  if (count === 3) return pick([0, 1, 2], ['red', 'green', 'blue']);
  if (count <= 4) return pick(channels.map((_, k) => k), ['blue', 'green', 'red', 'grey']);
  if (wavelengths.length === count) {
    const nearest = (nm: number): number => wavelengths.reduce((best, value, k) => (Math.abs(value - nm) < Math.abs(wavelengths[best]! - nm) ? k : best), 0);
    return pick([nearest(650), nearest(550), nearest(450)], ['red', 'green', 'blue']);
  }
  return pick([0, count >> 1, count - 1], ['red', 'green', 'blue']);
}
