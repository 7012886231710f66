/**
 * Elementary functions in integer arithmetic: numbers are BigInts in units of 2^−320. Written from the series alone, as a reference
 * for the fast ones, which it shares no code with.
 */
const BITS = 320n;
const ONE = 1n << BITS;

const mul = (a: bigint, b: bigint): bigint => (a * b) >> BITS;
const div = (a: bigint, b: bigint): bigint => (a << BITS) / b;

/** A double, exactly. */
export function exact(x: number): bigint {
  const view = new DataView(new ArrayBuffer(8));
  view.setFloat64(0, x);
  const bits = view.getBigUint64(0);
  const exponent = Number((bits >> 52n) & 0x7ffn);
  const mantissa = (bits & 0xfffffffffffffn) | (exponent === 0 ? 0n : 1n << 52n);
  const shift = BigInt(Math.max(exponent, 1) - 1075) + BITS;
  const size = shift >= 0n ? mantissa << shift : mantissa >> -shift;
  return x < 0 ? -size : size;
}

/** |approximate − truth| / |truth|. */
export function relativeError(approximate: number, truth: bigint): number {
  const size = truth < 0n ? -truth : truth;
  const off = exact(approximate) - truth;
  if (size === 0n) {
    return off === 0n ? 0 : Infinity;
  }
  return Number(((off < 0n ? -off : off) << 120n) / size) / 2 ** 120;
}

function arcTangentSeries(x: bigint): bigint {
  const square = mul(x, x);
  let sum = 0n;
  let term = x;
  for (let n = 1n; term !== 0n; n += 2n) {
    sum += term / n;
    term = -mul(term, square);
  }
  return sum;
}

/** Machin 1706. */
export const PI = 4n * (4n * arcTangentSeries(ONE / 5n) - arcTangentSeries(ONE / 239n));

function sineSeries(x: bigint): bigint {
  const square = mul(x, x);
  let sum = 0n;
  let term = x;
  for (let n = 2n; term !== 0n && term !== -1n; n += 2n) {
    sum += term;
    term = -mul(term, square) / (n * (n + 1n));
  }
  return sum;
}

export function exactSin(x: bigint): bigint {
  const turn = 2n * PI;
  let r = ((x % turn) + turn) % turn;
  const negative = r > PI;
  r = negative ? r - PI : r;
  r = 2n * r > PI ? PI - r : r;
  return negative ? -sineSeries(r) : sineSeries(r);
}

export function exactCos(x: bigint): bigint {
  return exactSin(x + PI / 2n);
}

/** atan(y / x) for x, y > 0; the argument is halved until the series is quick. */
export function exactAtan(y: bigint, x: bigint): bigint {
  if (y > x) {
    return PI / 2n - exactAtan(x, y);
  }
  let t = div(y, x);
  let doublings = 0n;
  while (t > ONE / 16n) {
    t = div(t, ONE + squareRoot(ONE + mul(t, t)));
    doublings += 1n;
  }
  return arcTangentSeries(t) << doublings;
}

function squareRoot(x: bigint): bigint {
  const target = x << BITS;
  let root = 1n << BigInt((target.toString(2).length + 1) >> 1);
  for (;;) {
    const next = (root + target / root) >> 1n;
    if (next >= root) {
      return root;
    }
    root = next;
  }
}

/** ln x for x > 0: x = 2^k · m, ln m = 2 atanh((m − 1)/(m + 1)). */
function exactLog(x: bigint): bigint {
  const k = BigInt(x.toString(2).length) - 1n - BITS;
  const m = k >= 0n ? x >> k : x << -k;
  return k * LN2 + arcHyperbolic(m);
}

function arcHyperbolic(m: bigint): bigint {
  const s = div(m - ONE, m + ONE);
  const square = mul(s, s);
  let sum = 0n;
  let term = s;
  for (let n = 1n; term !== 0n && term !== -1n; n += 2n) {
    sum += term / n;
    term = mul(term, square);
  }
  return 2n * sum;
}

const LN2 = arcHyperbolic(2n * ONE);

export function exactPow(base: number, exponent: number): bigint {
  const x = mul(exact(exponent), exactLog(exact(base)));
  const k = x / LN2;
  const r = x - k * LN2;
  let sum = 0n;
  let term = ONE;
  for (let n = 1n; term !== 0n && term !== -1n; n += 1n) {
    sum += term;
    term = mul(term, r) / n;
  }
  return k >= 0n ? sum << k : sum >> -k;
}
