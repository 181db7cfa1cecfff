/** Of the page with its state; of a file on this machine its name alone. */
export function addressOfPage() {
  const { protocol, href, pathname, hash } = location;
  return protocol === 'file:' ? pathname.slice(pathname.lastIndexOf('/') + 1) + hash : href;
}
