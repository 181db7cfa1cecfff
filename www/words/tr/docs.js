import { damperDocs } from './damper-docs.js';

/** What the parameters mean, in Turkish, by their names in the engine's table. @type {Readonly<Record<string, string>>} */
export const docs = {
  velocity: 'Taksi hızı; bir çalışma boyunca sabittir. ẏ = vψ + (e − a)ψ̇ − (v/σ)y denklemine, bir de sırtın sönümüne κ/v olarak girer (Somieski 1997). 0’dan büyük her değer geçerlidir.',
  casterLength: 'Kaster boyu (mekanik iz): temas merkezi dönme ekseninin arkasındaysa artıdır. Yanal kuvvetin koludur, −e F_y; ẏ’ye (e − a)ψ̇ olarak girer (Somieski 1997). Sonlu her değer geçerlidir.',
  halfContactLength: 'Lastiğin yere değdiği boyun yarısı. ẏ’ye (e − a)ψ̇ olarak girer (Somieski 1997). 0’dan büyük her değer geçerlidir.',
  relaxationLength: 'Lastiğin gevşeme boyu; şekil değişimi bu boyda söner: ẏ’de −(v/σ)y, kayma açısı α = arctan(y/σ), doğrusal takımda y/σ (Somieski 1997; onun verilerinde 3a). 0’dan büyük her değer geçerlidir.',
  momentOfInertia: 'Dönme eksenine göre atalet momenti: I_z ψ̈ bütün momentlerin toplamıdır (Somieski 1997). 0’dan büyük her değer geçerlidir.',
  torsionalStiffness: 'Burulma rijitliği: tekerleği geri çeviriyorsa artıdır. Momenti −k s(ψ); boşluk yoksa s = ψ (Somieski 1997; o c yazar). 0 ve üstündeki her değer geçerlidir.',
  dampingConstant: 'Burulma sönüm katsayısı: enerji alıyorsa artıdır. Momenti −cψ̇ (Somieski 1997; o k yazar). 0 ve üstündeki her değer geçerlidir.',
  verticalForce: 'Tekerleğe binen düşey kuvvet F_z: yanal kuvvet ve doğrultma momenti onunla orantılıdır (Somieski 1997). 0 ve üstündeki her değer geçerlidir.',
  sideForceDerivative: 'Küçük kayma açısında yanal kuvvetin eğimi, birim düşey kuvvet başına: varsa δ sınır açısına kadar F_y = c_Fα F_z α (Somieski 1997). 0 ve üstündeki her değer geçerlidir.',
  aligningMomentDerivative: 'Küçük kayma açısında doğrultma momentinin eğimi, birim düşey kuvvet başına: orada M_z = −c_Mα F_z α (Somieski 1997). 0 ve üstündeki her değer geçerlidir.',
  sideForceLimitAngle: 'Yanal kuvvetin artık büyümediği kayma açısı: ötesinde F_y = ±c_Fα F_z δ (Somieski 1997). 0’dan büyük her değer geçerlidir; 90° ve üstüne hiç erişilmez.',
  aligningMomentLimitAngle: 'Ötesinde doğrultma momentinin kalmadığı kayma açısı: içinde M_z = −c_Mα F_z (α_g/π) sin(πα/α_g) (Somieski 1997). 0’dan büyük her değer geçerlidir; 90° ve üstüne hiç erişilmez.',
  treadWidthMomentConstant: 'Sırtın genişliğinden gelen sönüm: momenti −(κ/v)ψ̇ (Somieski 1997; onun verilerinde κ = 0,15 a² c_Fα F_z). 0 ve üstündeki her değer geçerlidir.',
  'friction.moment': 'Dönme eksenindeki kuru sürtünme: momenti −M_f sign ψ̇; tekerlek dururken onu yerinde tutmaya yeten kadar, en çok M_f (Somieski 1997, k₀). Doğrusal kuram onu hesaba katmaz. 0 ve üstündeki her değer geçerlidir; 0, sürtünme yok demektir.',
  freeplayAngle: 'Boşluk; yayın etki etmediği aralığın yarısı: ±ψ_fp ötesinde s(ψ) = ψ − ψ_fp sign ψ, içinde 0 (Atabay 2012, böl. 6). 0 ve üstündeki her değer geçerlidir.',
  touchdownVelocity: 'Teker değdiği andaki hız, t = 0 (80 m/s seçilmiştir). Hızın yerine geçer. finalVelocity üstündeki her değer geçerlidir.',
  deceleration: 'Koşu boyunca hızın saniyede azaldığı: v(t) = v₀ − bt (3 m/s² seçilmiştir); yük öne kaymaz. 0’dan büyük her değer geçerlidir.',
  finalVelocity: 'Koşunun bittiği hız; ondan sonra değişmez (5 m/s seçilmiştir). 0’dan büyük, teker değme hızından küçük her değer geçerlidir.',
  liftFraction: 'Teker değdiği anda kanatların ağırlıktan taşıdığı pay λ: F_z(v) = F_z[1 − λ(v/v₀)²]. 0’dan 1’e dek, 1 dışında her değer geçerlidir.',
  ...damperDocs,
};
