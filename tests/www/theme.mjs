// A theme for drawings under test: each token a color of its own, so that a stroke tells what it means.

/** @type {import('../../www/style/theme.js').Theme} */
export const theme = {
  scheme: 'light', page: '#f4f3ee', surface: '#ffffff', raised: '#eceae3', ground: '#e6e3da', rule: '#d3d0c6', ink: '#14202b',
  ink2: '#4a5864', psi: '#0057b8', y: '#087049', force: '#7d5f00', unstable: '#bf1147', stable: '#41576b', freeplay: '#f2c230',
  freeplayText: '#6b5200', ghost: '#5f6b76', sans: 'Inter', serif: 'STIX Two Text', size: 13, line: 1,
};
