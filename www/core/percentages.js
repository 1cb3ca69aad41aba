/**
 * Shares as whole percent.
 */

/** Shares as whole percent that sum to 100; all 0 where nothing is held back. @param {number[]} shares 0 to 1 */
export function percentages(shares) {
  if (shares.reduce((sum, share) => sum + share, 0) < 0.5) return shares.map(() => 0);
  const exact = shares.map((share) => share * 100);
  const whole = exact.map(Math.floor);
  const order = exact.map((_, i) => i).sort((a, b) => exact[b] - whole[b] - (exact[a] - whole[a]));
  let missing = 100 - whole.reduce((sum, x) => sum + x, 0);
  for (const i of order) if (missing-- > 0) whole[i] += 1;
  return whole;
}
