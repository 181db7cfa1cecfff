/** @typedef {import('../record/records.js').Record_} Measured */

/**
 * Records with every so manieth sample only, so that there are not too many in all.
 * @param {readonly Measured[]} records
 * @param {number} most
 * @returns {Measured[]}
 */
export function thinned(records, most) {
  const all = records.reduce((sum, { force }) => sum + force.length, 0);
  const stride = Math.ceil(all / most);
  if (stride <= 1) return [...records];
  return records.map((record) => ({
    ...record, interval: stride * record.interval, displacement: every(record.displacement, stride), force: every(record.force, stride), velocity: record.velocity && every(record.velocity, stride),
  }));
}

/** @param {Float64Array} values @param {number} stride */
const every = (values, stride) => Float64Array.from({ length: Math.ceil(values.length / stride) }, (_, i) => values[i * stride]);
