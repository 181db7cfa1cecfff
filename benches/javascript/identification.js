// Generations a second of an identification: 60 individuals, 4 records of 500 samples, 11 parameters of the modified
// Bouc–Wen damper, on one core.

/** What a search is given. @param {any} shimmy @param {string} model */
export function search(shimmy, model) {
  const motions = [
    { amplitude: 0.015, frequency: 2.5 },
    { amplitude: 0.002, endAmplitude: 0.02, frequency: 2 },
    { amplitude: 0.005, frequency: 1, endFrequency: 8 },
    { amplitude: 0.008, frequency: 4 },
  ];
  const records = motions.map((excitation, i) =>
    shimmy.damperRecord({ damper: { model, command: 0.5 * i }, excitation, cycles: 3, samples: 500, noise: 0.02, seed: i }),
  );
  // Of the Bouc–Wen element's scale no record tells: A is held, and so is what the model does not need here.
  const bounds = { 'bouc-wen': { amplitude: [120, 120] }, 'modified-bouc-wen': { amplitude: [301, 301] } }[model] ?? {};
  return { model, records, bounds, population: 60, generations: 1_000_000, polish: false };
}

/** @param {any} shimmy @param {number} seconds */
export function identifications(shimmy, seconds) {
  const rows = [];
  for (const model of ['bouc-wen', 'modified-bouc-wen', 'current-dependent-bouc-wen']) {
    const spec = search(shimmy, model);
    // As candidates change on the way, so does their cost: several seeds, each from its beginning.
    let generations = 0;
    let time = 0;
    for (let seed = 1; time < 1000 * seconds; seed += 1) {
      const search = new shimmy.Identification({ ...spec, seed });
      const began = performance.now();
      for (let i = 0; i < 60 && !search.done; i += 1, generations += 1) search.step();
      time += performance.now() - began;
      search.free();
    }
    rows.push({ model, perSecond: (1000 * generations) / time });
  }
  return rows;
}
