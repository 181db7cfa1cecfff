/** Words of the story strip, in Turkish. @type {typeof import('../en/story.js').story} */
export const story = {
  'story.title': 'Şunu dene',
  'story.shimmies': 'Bu tekerleği kendi lastiğinden başka hiçbir şey sallamıyor. Sönümü, salınım sönene dek artır.',
  'story.dies-out': 'Sönümleyici ve sırt, lastiğin verdiğinden çoğunu alıyor. Shimmy başlayana dek sönümü azalt.',
  'story.rattles': 'Boşluğun içinde tekerleği hiçbir yay tutmuyor, lastik onu orada sallıyor. Boşluğu kapat.',
  'story.grows': 'Bu modelin güvenilir olduğundan geniş salınıyor. Sönümü artır.',
  'story.rests': 'Onu salınımda tutan bir şey yok. Tekerleğe vur ve salınımın ne olacağına bak.',
};
