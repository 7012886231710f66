/**
 * Sine, cosine, arc tangent and power that give the same bits in every JavaScript engine: built from + − × ÷ and square roots
 * alone, which ECMAScript rounds exactly, where it leaves `Math.sin` and its kin to the engine.
 */

/** π/2 in three parts, the first two of 33 bits, so that k times them is exact for k < 2²⁰ (Cody & Waite 1980). */
const HALF_PI_1 = 1.5707963267341256;
const HALF_PI_2 = 6.077100506303966e-11;
const HALF_PI_3 = 2.0222662487959506e-21;
const TWO_OVER_PI = 0.6366197723675814;
const TWO_PI = 6.283185307179586;

/** Beyond this angle the three parts are not enough; whole turns, rounded to a double, are taken off first. */
const REDUCIBLE = 1e6;

/** 1.5 · 2⁵²: added and taken off, it rounds |t| < 2⁵¹ to an integer, halves to the even one: −t to minus what t goes to. */
const ROUNDING = 6755399441055744;

/**
 * Writes cosine and sine of the angle `to[0]`, rad, to `to[1]` and `to[2]`; an array, so that no number is boxed on the way.
 *
 * The angle is taken modulo π/2 with a remainder r, |r| ≤ π/4, and the rounding of r in a tail (Cody & Waite, Software Manual for the
 * Elementary Functions, 1980); then the Taylor series of both. The relative error is below 2.4e-16 for angles up to 1e6, measured at the
 * doubles next to all multiples of π/2, too. Beyond, the angle is taken modulo 2π rounded to a double: the absolute error is about 4e-17
 * times the angle, so that from 1e17 on only the range [−1, 1] is left. Angles that are not finite give NaN.
 */
export function cosSin(to: Float64Array): void {
  const angle = to[0]!;
  const x = angle > REDUCIBLE || angle < -REDUCIBLE ? angle % TWO_PI : angle;
  const k = x * TWO_OVER_PI + ROUNDING - ROUNDING;
  const a = x - k * HALF_PI_1;
  const b = k * HALF_PI_2;
  const high = a - b;
  const low = k * HALF_PI_3 - (a - high - b);
  const r = high - low;
  const tail = high - r - low;
  const s = r * r;
  // Taylor series of r + tail, |r| ≤ π/4: of the sine to r¹⁷, the next term is below 10⁻¹⁹ of the result …
  const s8 = 1 / 6227020800 + s * (-1 / 1307674368000 + s * (1 / 355687428096000));
  const odd = -1 / 6 + s * (1 / 120 + s * (-1 / 5040 + s * (1 / 362880 + s * (-1 / 39916800 + s * s8))));
  const sine = r + (r * s * odd + tail * (1 - 0.5 * s));
  // … of the cosine to r¹⁸; 1 − r²/2 is kept in two parts, so that its rounding does not count.
  const c8 = -1 / 87178291200 + s * (1 / 20922789888000 + s * (-1 / 6402373705728000));
  const even = 1 / 24 + s * (-1 / 720 + s * (1 / 40320 + s * (-1 / 3628800 + s * (1 / 479001600 + s * c8))));
  const half = 0.5 * s;
  const most = 1 - half;
  const cosine = most + (1 - most - half + (s * s * even - r * tail));
  const quadrant = k & 3;
  const c = (quadrant & 1) === 0 ? cosine : sine;
  to[1] = quadrant === 1 || quadrant === 2 ? -c : c;
  const t = (quadrant & 1) === 0 ? sine : cosine;
  to[2] = x === 0 ? x : quadrant > 1 ? -t : t;
}

const turn = /* @__PURE__ */ new Float64Array(3);

/** Sine of an angle in radians; method and accuracy as `cosSin`. */
export function sin(x: number): number {
  turn[0] = x;
  cosSin(turn);
  return turn[2]!;
}

/** Cosine of an angle in radians; method and accuracy as `cosSin`. */
export function cos(x: number): number {
  turn[0] = x;
  cosSin(turn);
  return turn[1]!;
}

const PI = Math.PI;
const PI_TAIL = 1.2246467991473532e-16;
const HALF_PI = 1.5707963267948966;

/** atan(j / 8), rounded, and the remainders of that rounding. */
const ATAN = [
  0, 0.12435499454676144, 0.24497866312686414, 0.35877067027057225, 0.4636476090008061, 0.5585993153435624,
  0.6435011087932844, 0.7188299996216245, 0.7853981633974483,
];
const ATAN_TAIL = [
  0, -3.1253241424539383e-18, 1.0698755618734451e-17, -2.4623815582638635e-17, 2.2698777452961687e-17,
  -5.4556305485916264e-18, 1.5834785051444286e-17, -2.1478388444456983e-17, 3.061616997868383e-17,
];

/**
 * Arc tangent of small / large, 0 ≤ small ≤ large, as value + tail in `arc`: with c = j/8 next to the quotient,
 * atan(q) = atan(c) + atan((q − c)/(1 + q·c)), whose argument is at most 1/16, where the series needs seven terms.
 */
const arc = { value: 0.5, tail: 0.5 };

function arcTangent(small: number, large: number): void {
  const j = Math.round((8 * small) / large);
  if (j === 0) {
    const q = small / large;
    arc.value = q;
    arc.tail = q * arcSeries(q * q);
    return;
  }
  const c = j / 8;
  const u = (small - c * large) / (large + c * small);
  arc.value = ATAN[j]!;
  arc.tail = ATAN_TAIL[j]! + (u + u * arcSeries(u * u));
}

/** atan(u)/u − 1 as a series in s = u². */
function arcSeries(s: number): number {
  return s * (-1 / 3 + s * (1 / 5 + s * (-1 / 7 + s * (1 / 9 + s * (-1 / 11 + s * (1 / 13 - s / 15))))));
}

/**
 * The angle of the vector (x, y) in radians, in [−π, π], with the signs of zero and infinity that ECMAScript gives `Math.atan2`.
 *
 * The smaller coordinate over the larger, next to a table of atan(j/8) in two parts each (Muller, Elementary Functions, 2016), then put
 * into its quadrant with π in two parts. Relative error below 4.5e-16 unless the result is subnormal.
 */
export function atan2(y: number, x: number): number {
  if (Number.isNaN(x) || Number.isNaN(y)) {
    return NaN;
  }
  const negativeY = y < 0 || Object.is(y, -0);
  const negativeX = x < 0 || Object.is(x, -0);
  // Powers of two keep the quotient clear of overflow and of subnormal numbers.
  let ax = negativeX ? -x : x;
  let ay = negativeY ? -y : y;
  if (ax === Infinity || ay === Infinity) {
    ax = ax === Infinity ? 1 : 0;
    ay = ay === Infinity ? 1 : 0;
  } else if (ax > 1e300 || ay > 1e300) {
    ax *= 0.00390625;
    ay *= 0.00390625;
  } else if (ax < 1e-290 && ay < 1e-290) {
    ax *= 1.2676506002282294e30;
    ay *= 1.2676506002282294e30;
  }
  const angle = quadrantAngle(ax, ay, negativeX);
  return negativeY ? -angle : angle;
}

/** The angle of (±ax, ay) in [0, π]. */
function quadrantAngle(ax: number, ay: number, negativeX: boolean): number {
  if (ay === 0) {
    return negativeX ? PI : 0;
  }
  if (ay > ax) {
    arcTangent(ax, ay);
    return negativeX ? HALF_PI + arc.value + (PI_TAIL / 2 + arc.tail) : HALF_PI - arc.value + (PI_TAIL / 2 - arc.tail);
  }
  arcTangent(ay, ax);
  return negativeX ? PI - arc.value + (PI_TAIL - arc.tail) : arc.value + arc.tail;
}

/** ln 2 in two parts, the first of 32 bits, so that k times it is exact. */
const LN2_1 = 0.6931471803691238;
const LN2_2 = 1.9082149292705877e-10;

const word = /* @__PURE__ */ new DataView(/* @__PURE__ */ new ArrayBuffer(8));

/** 2^k for −1022 ≤ k ≤ 1023. */
function powerOfTwo(k: number): number {
  word.setUint32(0, (k + 1023) << 20);
  word.setUint32(4, 0);
  return word.getFloat64(0);
}

/** The result of `log`: value + tail, where the tail is only the rounding error of the value. */
const logarithm = { value: 0.5, tail: 0.5 };

/**
 * Writes the natural logarithm of a positive finite number to `logarithm`. x = 2^k · m with m in [√½, √2); ln m = 2·atanh(f/(2 + f)), f = m
 * − 1 (Muller, Elementary Functions, 2016). The quotient is carried with its remainder, so that the leading term 2s is exact to twice the
 * digits. |2s| < 0.35 < |k ln 2| unless k = 0, so the rounding error of their sum is found exactly by subtracting the larger one first.
 */
function log(x: number): void {
  const subnormal = x < 2.2250738585072014e-308;
  word.setFloat64(0, subnormal ? x * 18014398509481984 : x);
  const high = word.getUint32(0);
  let k = (high >>> 20) - 1023 - (subnormal ? 54 : 0);
  word.setUint32(0, (high & 0xfffff) | 0x3ff00000);
  let m = word.getFloat64(0);
  if (m > Math.SQRT2) {
    m *= 0.5;
    k += 1;
  }
  const f = m - 1;
  const d = 2 + f;
  const s = f / d;
  const sHigh = upperHalf(s);
  const dHigh = upperHalf(d);
  const dLow = f - (dHigh - 2);
  const rest = (f - sHigh * dHigh - sHigh * dLow) / d;
  const z = s * s;
  const series = 2 * s * z * atanhSeries(z);
  const lead = k * LN2_1;
  const most = lead + 2 * sHigh;
  const left = lead - most + 2 * sHigh + (2 * rest + series + k * LN2_2);
  const value = most + left;
  logarithm.value = value;
  logarithm.tail = left - (value - most);
}

/** (atanh(s)/s − 1)/s² as a series in z = s² ≤ 0.0295. */
function atanhSeries(z: number): number {
  const z8 = 1 / 17 + z * (1 / 19 + z * (1 / 21 + z * (1 / 23 + z * (1 / 25))));
  return 1 / 3 + z * (1 / 5 + z * (1 / 7 + z * (1 / 9 + z * (1 / 11 + z * (1 / 13 + z * (1 / 15 + z * z8))))));
}

/** The upper 26 bits of a number. */
function upperHalf(x: number): number {
  const t = x * 134217729;
  return t - (t - x);
}

/** e^(x + tail), |tail| small: k = round(x / ln 2), ln 2 in two parts (Cody & Waite 1980), then the Taylor series for |r| ≤ 0.35 to r¹⁴. */
function exp(x: number, tail: number): number {
  if (x > 709.9) {
    return Infinity;
  }
  if (x < -745.2) {
    return 0;
  }
  const k = Math.round(x / Math.LN2);
  const r = x - k * LN2_1 - k * LN2_2 + tail;
  const r10 = 1 / 3628800 + r * (1 / 39916800 + r * (1 / 479001600 + r * (1 / 6227020800 + r * (1 / 87178291200))));
  const r5 = 1 / 120 + r * (1 / 720 + r * (1 / 5040 + r * (1 / 40320 + r * (1 / 362880 + r * r10))));
  const value = 1 + (r + r * r * (1 / 2 + r * (1 / 6 + r * (1 / 24 + r * r5))));
  const half = k >> 1;
  return value * powerOfTwo(half) * powerOfTwo(k - half);
}

/**
 * base to the power of exponent, for base ≥ 0 and finite exponents; NaN for a negative base.
 *
 * e^(exponent · ln base), where the logarithm and the product are each carried with their rounding errors (Dekker 1971). The relative error
 * is below 2e-16 while |exponent · ln base| ≤ 8, and 1e-14 up to the ends of the range of doubles; too large gives Infinity, too small 0.
 */
export function pow(base: number, exponent: number): number {
  if (exponent === 0) {
    return 1;
  }
  if (!(base >= 0) || Number.isNaN(exponent)) {
    return NaN;
  }
  if (base === 1) {
    return 1;
  }
  if (base === 0 || base === Infinity) {
    return exponent > 0 === (base === 0) ? 0 : Infinity;
  }
  log(base);
  const eHigh = upperHalf(exponent);
  const lHigh = upperHalf(logarithm.value);
  const product = exponent * logarithm.value;
  const error =
    eHigh * lHigh -
    product +
    eHigh * (logarithm.value - lHigh) +
    (exponent - eHigh) * lHigh +
    (exponent - eHigh) * (logarithm.value - lHigh);
  return exp(product, error + exponent * logarithm.tail);
}
