// Dormand and Prince's 5(4) pair (J. Comp. Appl. Math. 6, 1980), by hand for three states: as fast as plain JavaScript
// gets, with every stage unrolled, no array made in a step, and the first stage reused as the last.

const C = [
  [1 / 5],
  [3 / 40, 9 / 40],
  [44 / 45, -56 / 15, 32 / 9],
  [19372 / 6561, -25360 / 2187, 64448 / 6561, -212 / 729],
  [9017 / 3168, -355 / 33, 46732 / 5247, 49 / 176, -5103 / 18656],
  [35 / 384, 0, 500 / 1113, 125 / 192, -2187 / 6784, 11 / 84],
];
const [[A21], [A31, A32], [A41, A42, A43], [A51, A52, A53, A54], [A61, A62, A63, A64, A65], [B1, , B3, B4, B5, B6]] = C;
const E1 = B1 - 5179 / 57600, E3 = B3 - 7571 / 16695, E4 = B4 - 393 / 640;
const E5 = B5 + 92097 / 339200, E6 = B6 - 187 / 2100, E7 = -1 / 40;

/**
 * Takes the state from each time to the next, landing on every one.
 * @param {(rate: Float64Array, state: Float64Array) => void} system
 * @param {number[]} initial
 * @param {number[]} times
 * @param {number} tolerance relative; the absolute one is a hundredth of it
 */
export function dormandPrince(system, initial, times, tolerance) {
  const absolute = tolerance / 100;
  const state = Float64Array.from(initial), next = new Float64Array(3);
  let k1 = new Float64Array(3), k7 = new Float64Array(3);
  const k2 = new Float64Array(3), k3 = new Float64Array(3), k4 = new Float64Array(3);
  const k5 = new Float64Array(3), k6 = new Float64Array(3);
  let now = 0, step = 1e-5, steps = 0, evaluations = 1;
  const states = [];
  system(k1, state);
  for (const end of times) {
    while (now < end) {
      const last = now + step >= end;
      const h = last ? end - now : step;
      for (let i = 0; i < 3; i++) next[i] = state[i] + h * A21 * k1[i];
      system(k2, next);
      for (let i = 0; i < 3; i++) next[i] = state[i] + h * (A31 * k1[i] + A32 * k2[i]);
      system(k3, next);
      for (let i = 0; i < 3; i++) next[i] = state[i] + h * (A41 * k1[i] + A42 * k2[i] + A43 * k3[i]);
      system(k4, next);
      for (let i = 0; i < 3; i++) next[i] = state[i] + h * (A51 * k1[i] + A52 * k2[i] + A53 * k3[i] + A54 * k4[i]);
      system(k5, next);
      for (let i = 0; i < 3; i++) {
        next[i] = state[i] + h * (A61 * k1[i] + A62 * k2[i] + A63 * k3[i] + A64 * k4[i] + A65 * k5[i]);
      }
      system(k6, next);
      for (let i = 0; i < 3; i++) {
        next[i] = state[i] + h * (B1 * k1[i] + B3 * k3[i] + B4 * k4[i] + B5 * k5[i] + B6 * k6[i]);
      }
      system(k7, next);
      evaluations += 6;
      let sum = 0;
      for (let i = 0; i < 3; i++) {
        const wrong = h * (E1 * k1[i] + E3 * k3[i] + E4 * k4[i] + E5 * k5[i] + E6 * k6[i] + E7 * k7[i]);
        const weighed = wrong / (absolute + tolerance * Math.max(Math.abs(state[i]), Math.abs(next[i])));
        sum += weighed * weighed;
      }
      const error = Math.sqrt(sum / 3);
      const change = Math.min(5, Math.max(0.2, 0.9 * error ** -0.2));
      if (error <= 1) {
        now = last ? end : now + h;
        state.set(next);
        [k1, k7] = [k7, k1];
        steps++;
        if (!last) step = h * change;
      } else {
        step = h * Math.min(1, change);
      }
    }
    states.push(Float64Array.from(state));
  }
  return { states, steps, evaluations };
}
