/** What the parameters mean, in Turkish, by their names in the engine's table. @type {Readonly<Record<string, string>>} */
export const docs = {
  velocity: 'Taksi hızı; bir çalışma boyunca sabittir. 0’dan büyük her değer geçerlidir.',
  casterLength: 'Kaster boyu (mekanik iz): temas merkezi dönme ekseninin arkasındaysa artıdır. Sonlu her değer geçerlidir.',
  halfContactLength: 'Lastiğin yere değdiği boyun yarısı. 0’dan büyük her değer geçerlidir.',
  relaxationLength: 'Lastiğin gevşeme boyu; yayımlanmış verilerde 3a’dır. 0’dan büyük her değer geçerlidir.',
  momentOfInertia: 'Dönme eksenine göre atalet momenti. 0’dan büyük her değer geçerlidir.',
  torsionalStiffness: 'Burulma rijitliği: tekerleği geri çeviriyorsa artıdır. 0 ve üstündeki her değer geçerlidir.',
  dampingConstant: 'Burulma sönüm katsayısı: enerji alıyorsa artıdır. 0 ve üstündeki her değer geçerlidir.',
  verticalForce: 'Tekerleğe binen düşey kuvvet. 0 ve üstündeki her değer geçerlidir.',
  sideForceDerivative: 'Küçük kayma açısında yanal kuvvetin eğimi, birim düşey kuvvet başına. 0 ve üstündeki her değer geçerlidir.',
  aligningMomentDerivative: 'Küçük kayma açısında doğrultma momentinin eğimi, birim düşey kuvvet başına. 0 ve üstündeki her değer geçerlidir.',
  sideForceLimitAngle: 'Yanal kuvvetin artık büyümediği kayma açısı. 0’dan büyük her değer geçerlidir; 90° ve üstüne hiç erişilmez.',
  aligningMomentLimitAngle: 'Ötesinde doğrultma momentinin kalmadığı kayma açısı. 0’dan büyük her değer geçerlidir; 90° ve üstüne hiç erişilmez.',
  treadWidthMomentConstant: 'Sırtın genişliğinden gelen sönüm; κ/v olarak etki eder. Yayımlanmış verilerde 0,15 a² c_Fα F_z’dir. 0 ve üstündeki her değer geçerlidir.',
  freeplayAngle: 'Boşluk: yayın etki etmediği aralığın yarısı. 0 ve üstündeki her değer geçerlidir.',
};
