//! Numbers to bytes and back.

/// Writes numbers out, or reads them back into their places: the order is the same, so it is told once.
pub(crate) trait Codec {
    /// One number.
    fn number(&mut self, value: &mut f64);
    /// One count, set of bits, or index.
    fn bits(&mut self, value: &mut u64);
}

/// Collects bytes.
pub(super) struct Writer(pub Vec<u8>);

impl Codec for Writer {
    fn number(&mut self, value: &mut f64) {
        self.0.extend(value.to_le_bytes());
    }
    fn bits(&mut self, value: &mut u64) {
        self.0.extend(value.to_le_bytes());
    }
}

/// Takes bytes apart.
pub(super) struct Reader<'a> {
    pub rest: &'a [u8],
    /// No bytes were missing, and all numbers are finite.
    pub whole: bool,
}

impl Reader<'_> {
    fn next(&mut self) -> [u8; 8] {
        let Some((first, rest)) = self.rest.split_first_chunk() else {
            self.whole = false;
            return [0; 8];
        };
        self.rest = rest;
        *first
    }
}

impl Codec for Reader<'_> {
    fn number(&mut self, value: &mut f64) {
        *value = f64::from_le_bytes(self.next());
        self.whole &= value.is_finite();
    }
    fn bits(&mut self, value: &mut u64) {
        *value = u64::from_le_bytes(self.next());
    }
}
