// The data embedded in the page; arrays are little-endian floats in base64.

/** The runs on this page: one in a report, two in a comparison. */
export function runs() {
  return [...document.querySelectorAll('script.run')].map((script) => unpacked(JSON.parse(script.textContent)))
}

/** Return a value of JSON with its arrays decoded. */
export function unpacked(value) {
  if (Array.isArray(value)) return value.map(unpacked)
  if (value === null || typeof value !== 'object') return value
  if (value.base64 !== undefined) return array(value)
  return Object.fromEntries(Object.entries(value).map(([key, item]) => [key, unpacked(item)]))
}

const KINDS = { float64: Float64Array, float32: Float32Array, int16: Int16Array, uint32: Uint32Array, uint8: Uint8Array }

function array({ base64, dtype }) {
  const bytes = Uint8Array.from(atob(base64), (c) => c.charCodeAt(0))
  return new KINDS[dtype](bytes.buffer)
}

/** Return the bytes of a data URL. */
export function bytes(url) {
  return Uint8Array.from(atob(url.slice(url.indexOf(',') + 1)), (c) => c.charCodeAt(0)).buffer
}

/** Return the index i with t[i] <= time < t[i + 1], clipped to the array. */
export function place(t, time) {
  let low = 0
  let high = t.length - 1
  while (high - low > 1) {
    const middle = (low + high) >> 1
    if (t[middle] <= time) low = middle
    else high = middle
  }
  return low
}

/** Return the linearly interpolated value of a column at a time; it is constant outside its range. */
export function at(t, column, time) {
  const i = place(t, time)
  const share = Math.min(Math.max((time - t[i]) / (t[i + 1] - t[i]), 0), 1)
  return column[i] + share * (column[i + 1] - column[i])
}

/** Format a number with three digits, or return 'none' if it is not a number. */
export function digits(value, unit) {
  return Number.isNaN(value) ? 'none' : `${Number(value.toPrecision(3))} ${unit}`
}

/** Format a time with the digits that are useful in a view of `span` seconds. */
export function clock(time, span = 1) {
  return `${time.toFixed(Math.min(Math.max(Math.ceil(3 - Math.log10(span)), 1), 6))} s`
}
