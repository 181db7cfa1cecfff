//! Cells of a map one by one, by the eigenvalues of the model's Jacobian.

use super::{Cells, MapSpec};
use crate::error::Result;

/// Cells that are made at once: some tenths of a millisecond.
const AT_ONCE: usize = 32;

/// Makes some more cells.
pub(super) fn advance(spec: &MapSpec, cells: &mut Cells) -> Result<()> {
    let tile = spec.tile;
    for index in cells.made..(cells.made + AT_ONCE).min(cells.stable.len()) {
        let x = spec.centre(0, tile.column + index % tile.columns);
        let y = spec.centre(1, tile.row + index / tile.columns);
        let eigenvalues = spec.plane.eigenvalues([x, y])?;
        let leading = eigenvalues[0];
        cells.note(index, leading.re, leading.im.abs())?;
        cells.stable[index] = u8::from(leading.re < 0.0);
        cells.stable_count += usize::from(leading.re < 0.0);
        cells.made += 1;
    }
    Ok(())
}
