//! A moment of a motion as bytes.
//!
//! Layout, little endian: magic, format version, hash of the model's tables, then every number of the cursor in turn,
//! then a hash of all that.

use super::{
    codec::{Codec, Reader, Writer},
    cursor::Cursor,
};
use crate::{
    error::{Code, Error, Result},
    model::{Description, Gear},
};

const MAGIC: &[u8; 8] = b"shimmy\0\x01";

/// The moment `time` of a cursor.
pub(super) fn write<S: Gear<N>, const N: usize>(cursor: &Cursor<S, N>, time: f64) -> Vec<u8> {
    let mut writer = Writer(MAGIC.to_vec());
    writer.bits(&mut kind(cursor));
    writer.number(&mut time.clone());
    cursor.clone().code(&mut writer);
    let sum = hash(&writer.0);
    writer.0.extend(sum.to_le_bytes());
    writer.0
}

/// The cursor and the time of a snapshot; `like` gives what is not in it (tolerances, method).
pub(super) fn read<S: Gear<N>, const N: usize>(bytes: &[u8], like: &Cursor<S, N>) -> Result<(Cursor<S, N>, f64)> {
    let name = like.tables.description.name;
    let refused = |what: &str| {
        Error::new(Code::BadSnapshot, "bytes", what, format!("a snapshot of a {} run with the same settings", name))
    };
    let Some((body, sum)) = bytes.split_last_chunk::<8>() else { return Err(refused("too few bytes")) };
    let Some(rest) = body.strip_prefix(MAGIC) else { return Err(refused("bytes of something else")) };
    if u64::from_le_bytes(*sum) != hash(body) {
        return Err(refused("damaged bytes"));
    }
    let mut reader = Reader { rest, whole: true };
    let (mut model, mut time) = (0, 0.0);
    reader.bits(&mut model);
    if model != kind(like) {
        return Err(refused("a snapshot of another model, method or tolerance"));
    }
    reader.number(&mut time);
    let mut cursor = like.clone();
    let sound = cursor.code(&mut reader);
    // A snapshot has no past: changes are counted from here.
    cursor.applied = 0;
    let within = (cursor.integrator.step_start()..=cursor.integrator.time()).contains(&time);
    let alive = sound && cursor.integrator.is_sound_at(time);
    if !(alive && reader.whole && reader.rest.is_empty() && within) {
        return Err(refused("damaged bytes"));
    }
    Ok((cursor, time))
}

/// Tells runs apart that cannot take up each other's motions: by their model, the version of its tables, and their
/// settings.
fn kind<S: Gear<N>, const N: usize>(cursor: &Cursor<S, N>) -> u64 {
    let Description { name, table, state, parts, .. } = cursor.tables.description;
    let names = table.iter().map(|p| p.name).chain(state.iter().map(|s| s.name));
    let [damper, law] = [parts.damper, parts.control].map(Option::unwrap_or_default);
    let follows = if parts.tread_follows { "follows" } else { "" };
    let tables = [name, damper, law, follows].into_iter().chain(names).collect::<Vec<_>>().join(" ");
    let settings = cursor.integrator.settings().flat_map(u64::to_le_bytes);
    hash(&tables.into_bytes().into_iter().chain(settings).collect::<Vec<u8>>())
}

/// FNV-1a: finds accidents, not intent.
fn hash(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}
