/**
 * Hands a file over: as a download, or, where the browser saves none from a page (an installed page on an iPhone, a
 * browser within another app), through the system's own sheet.
 *
 * @typedef {{ document: Document, navigator: Navigator & { standalone?: boolean } }} Place
 *
 * @param {Blob} blob
 * @param {string} name
 * @param {Place} [place]
 * @returns {Promise<'saved' | 'shared' | 'cancelled'>}
 */
export async function download(blob, name, { document, navigator } = window) {
  const link = document.createElement('a');
  const canSave = 'download' in link && navigator.standalone !== true;
  const file = new File([blob], name, { type: blob.type });
  if (!canSave && navigator.canShare?.({ files: [file] })) return share(navigator, file);
  const address = URL.createObjectURL(blob);
  link.href = address;
  link.download = name;
  link.hidden = true;
  document.body.append(link);
  link.click();
  link.remove();
  // Some browsers begin to read only after the click has been dealt with.
  setTimeout(() => URL.revokeObjectURL(address), 60_000);
  return 'saved';
}

/** @param {Navigator} navigator @param {File} file */
async function share(navigator, file) {
  try {
    await navigator.share({ files: [file], title: file.name });
    return 'shared';
  } catch (error) {
    // Whoever closes the system's sheet has changed their mind: that is no failure.
    if (error instanceof Error && error.name === 'AbortError') return 'cancelled';
    throw error;
  }
}
