/** Words of the knobs, in Turkish. @type {typeof import('../en/controls.js').controls} */
export const controls = {
  'dock.name': 'Değerler',
  'dock.choose': 'Sürgünün ayarladığı değer',
  'dock.all': '{count} değerin hepsi',
  'dock.all.short': 'Hepsi ({count})',
  'dock.close': 'Kapat',
  'dock.reset': 'Hepsini sıfırla',

  'knob.reset': '{name} yeniden {value}',
  'knob.far': 'Sürgünün {min} – {max} aralığının çok dışında.',
  'knob.number': '{name}, tam sayısal değer',

  'parameter.velocity': 'Hız',
  'parameter.casterLength': 'Kaster',
  'parameter.halfContactLength': 'Yarım temas boyu',
  'parameter.relaxationLength': 'Gevşeme boyu',
  'parameter.momentOfInertia': 'Atalet momenti',
  'parameter.torsionalStiffness': 'Rijitlik',
  'parameter.dampingConstant': 'Sönüm',
  'parameter.verticalForce': 'Düşey kuvvet',
  'parameter.sideForceDerivative': 'Yanal kuvvet eğimi',
  'parameter.aligningMomentDerivative': 'Doğrultma momenti eğimi',
  'parameter.sideForceLimitAngle': 'Yanal kuvvet sınırı',
  'parameter.aligningMomentLimitAngle': 'Doğrultma momenti sınırı',
  'parameter.treadWidthMomentConstant': 'Sırt genişliği sabiti',
  'parameter.freeplayAngle': 'Boşluk, yarısı',

  'refused.above': '{name} {limit} değerinden büyük olmalı. {kept} olarak kaldı.',
  'refused.atLeast': '{name} en az {limit} olmalı. {kept} olarak kaldı.',
  'refused.tooLarge': '{name} hesaplanamayacak kadar büyük. {kept} olarak kaldı.',
  'refused.notANumber': 'Bu bir sayı değil. {name} {kept} olarak kaldı.',
  'refused.other': '{name} için izin verilen: {allowed}. {kept} olarak kaldı.',
};
