/** What tells whether a browser has relaxed SIMD. */

/** A module that multiplies and adds two numbers at once, relaxed, and does nothing else. */
export const probe = Uint8Array.of(
  0, 0x61, 0x73, 0x6d, 1, 0, 0, 0, // \0asm, version 1
  1, 8, 1, 0x60, 3, 0x7b, 0x7b, 0x7b, 1, 0x7b, // types: three v128 to one
  3, 2, 1, 0, // functions: one of that type
  0x0a, 0x0d, 1, 0x0b, 0, 0x20, 0, 0x20, 1, 0x20, 2, 0xfd, 0x87, 2, 0x0b, // code: f64x2.relaxed_madd of its three locals
);

export const hasRelaxedSimd = () => WebAssembly.validate(probe);
