// Spectrogram of the visible time span, computed at screen resolution with long windows for low frequencies and
// short windows for high frequencies.
import FFT from 'fft.js'

const MIN_FREQUENCY = 10 // [Hz]
const RANGE = 65 // [dB], between the darkest and the brightest colour
const SILENCE = -300 // [dB], level of samples that are zero
const MAX_BAND_DIFFERENCE = 50 // [dB], between the brightest levels of low and high frequencies
const BLEND = [300, 3000] // [Hz], range in which window and brightest level change from those of low to those of high frequencies
const MIN_TICK_DISTANCE = 80 // [px], between the times below the panel
const REDRAW_INTERVAL = 200 // [ms], while the picture is being computed
const WORK_TIME = 12 // [ms], of computation between two screen refreshes

export class Spectrogram {
  /** `samples` Float32Array, 1.0 is `fullScale` [Pa]; `colours`: 256 x 3 bytes; `lines` drawn over it: [{name, t, f, style}].
   * The picture of these samples determines the colour scale of all others; `onScale(text)` receives its description. */
  constructor(canvas, samples, { sampleRate, colours, lines, delay, fullScale, start }) {
    Object.assign(this, { canvas, samples, sampleRate, colours, lines, delay, fullScale, start })
    this.element = canvas.parentElement
    this.overlay = this.element.querySelector('canvas.lines')
    this.axis = this.element.nextElementSibling
    this.showLines = true
    this.done = Promise.resolve()
  }

  get highest() {
    return this.sampleRate / 2
  }

  /** Convert a frequency to a height in the panel, 0 at the bottom and 1 at the top; `frequency` is the inverse. */
  height(frequency) {
    return Math.log(frequency / MIN_FREQUENCY) / Math.log(this.highest / MIN_FREQUENCY)
  }

  frequency(height) {
    return MIN_FREQUENCY * (this.highest / MIN_FREQUENCY) ** height
  }

  show(from, to) {
    this.span = [from, to]
    this.#drawAxis(from, to)
    const job = (this.job = { samples: this.samples }) // other jobs stop, unless they determine the colour scale
    this.first ??= this.#draw(job, from, to)
    this.done = this.first.then(() => this.#draw(job, from, to))
  }

  /** Show other samples with the same colour scale. */
  set mix(samples) {
    this.samples = samples
    this.show(...this.span)
  }

  async #draw(job, from, to) {
    if (this.scale && (job !== this.job || job.done)) return
    const width = Math.max(this.element.clientWidth, 1)
    const height = Math.max(this.element.clientHeight, 1)
    const bands = this.#bands((to - from) / width, height)
    const level = new Float32Array(width * height).fill(-Infinity)
    let rest = performance.now()
    let painted = rest
    for (let column = 0; column < width; column++) {
      const time = from + ((column + 0.5) / width) * (to - from)
      for (let row = 0; row < height; row++) level[row * width + column] = 0 // the bands are added with their weights
      for (const band of bands) band.read(job.samples, (time - this.start) * this.sampleRate, level, column, width)
      if (performance.now() - rest > WORK_TIME) {
        await new Promise(requestAnimationFrame)
        if (this.scale && job !== this.job) return
        rest = performance.now()
        if (rest - painted > REDRAW_INTERVAL) {
          this.#paint(level, bands, width, height)
          painted = performance.now()
        }
      }
    }
    const scale = this.#paint(level, bands, width, height)
    this.#drawLines(from, to)
    job.done = true
    if (this.scale) return
    this.scale = scale
    this.onScale?.(this.#scaleDescription(scale))
  }

  #bands(perColumn, height) {
    const long = windowSize(16 * perColumn * this.sampleRate, 512, 16384)
    const short = Math.max(long >> 3, 256)
    const [from, to] = BLEND.map((frequency) => Math.round(height * (1 - this.height(frequency))))
    const weight = (row) => Math.min(Math.max((from - row) / (from - to), 0), 1)
    return [
      new Band(this, short, [0, from], height, weight),
      new Band(this, long, [to, height], height, (row) => 1 - weight(row)),
    ]
  }

  #paint(level, bands, width, height) {
    this.canvas.width = width
    this.canvas.height = height
    const context = this.canvas.getContext('2d')
    const image = context.createImageData(width, height)
    const scale = this.scale ?? brightest(level, bands, width)
    for (let row = 0; row < height; row++) {
      const top = this.#top(scale, row / height)
      for (let i = row * width; i < (row + 1) * width; i++) {
        const shade = Math.round(Math.min(Math.max((level[i] - top) / RANGE + 1, 0), 1) * 255)
        for (let c = 0; c < 3; c++) image.data[4 * i + c] = this.colours[3 * shade + c]
        image.data[4 * i + 3] = 255
      }
    }
    context.putImageData(image, 0, 0)
    return scale
  }

  // Return the level [dB] of the brightest colour at a distance below the upper edge.
  #top([high, low], depth) {
    const [from, to] = BLEND.map((frequency) => this.height(frequency))
    const share = Math.min(Math.max((1 - depth - from) / (to - from), 0), 1)
    return low + share * (high - low)
  }

  #scaleDescription([high, low]) {
    const spl = (level) => `${Math.round(level + 20 * Math.log10(this.fullScale / 20e-6)) + 0} dB SPL`
    return `The brightest colour corresponds to a sine of ${spl(low)} below ${BLEND[0]} Hz and of ${spl(high)} above ${BLEND[1] / 1000} kHz; black is ${RANGE} dB lower.`
  }

  #drawLines(from, to) {
    const { clientWidth: width, clientHeight: height } = this.element
    const ratio = window.devicePixelRatio || 1
    Object.assign(this.overlay, { width: width * ratio, height: height * ratio })
    const context = this.overlay.getContext('2d')
    context.scale(ratio, ratio)
    this.#ticks(context, width, height)
    if (!this.showLines) return
    for (const { t, f, colour, dash } of this.lines) {
      for (const [style, thick] of [['#000', 3], [colour, 1.4]]) {
        context.beginPath()
        Object.assign(context, { strokeStyle: style, lineWidth: thick })
        context.setLineDash(dash)
        let joined = false // NaN makes a gap in the line
        for (let i = 0; i < t.length; i++) {
          const x = ((t[i] + this.delay - from) / (to - from)) * width
          const y = height * (1 - this.height(f[i]))
          if (joined) context.lineTo(x, y)
          else context.moveTo(x, y)
          joined = Number.isFinite(f[i])
        }
        context.stroke()
      }
    }
  }

  /** Write the times below the panel. */
  #drawAxis(from, to) {
    const ticks = niceTicks(from, to, Math.max(this.element.clientWidth / MIN_TICK_DISTANCE, 1))
    this.axis.replaceChildren(
      ...ticks.times.map((time) => {
        const tick = document.createElement('span')
        const share = (time - from) / (to - from)
        tick.textContent = `${time.toFixed(ticks.digits)} s`
        tick.style.left = `${100 * share}%`
        tick.className = share < 0.03 ? 'first' : share > 0.97 ? 'last' : ''
        return tick
      }),
    )
  }

  #ticks(context, width, height) {
    Object.assign(context, { font: '11px system-ui, sans-serif', lineWidth: 1 })
    for (let decade = MIN_FREQUENCY; decade < this.highest; decade *= 10) {
      for (const factor of [1, 2, 5]) {
        const frequency = factor * decade
        if (frequency >= this.highest) continue
        const y = height * (1 - this.height(frequency))
        context.fillStyle = '#fff8'
        context.fillRect(0, y, 6, 1)
        if (y < 14 || y > height - 8) continue
        const text = frequency >= 1000 ? `${frequency / 1000} kHz` : `${frequency} Hz`
        context.strokeStyle = '#000'
        context.lineWidth = 3
        context.strokeText(text, 9, y + 4)
        context.fillStyle = '#fff'
        context.fillText(text, 9, y + 4)
      }
    }
  }
}

/** Return at most `count` round times from `from` to `to` with the number of their decimals. */
function niceTicks(from, to, count) {
  const least = (to - from) / count
  const decade = 10 ** Math.floor(Math.log10(least))
  const step = decade * [1, 2, 5, 10].find((factor) => factor * decade >= least * (1 - 1e-9))
  const first = Math.ceil(from / step - 1e-9)
  const times = Array.from({ length: Math.floor(to / step + 1e-9) - first + 1 }, (_, i) => (first + i) * step)
  return { times, digits: Math.max(-Math.floor(Math.log10(step) + 1e-9), 0) }
}

function brightest(level, bands, width) {
  const tops = bands.map(({ first, last }) => loudest(level.subarray(first * width, last * width)))
  return tops.map((top) => Math.max(top, Math.max(...tops) - MAX_BAND_DIFFERENCE, SILENCE + RANGE))
}

function loudest(levels) {
  let top = -Infinity
  for (const value of levels) if (value > top) top = value
  return top
}

function windowSize(wanted, least, most) {
  return 2 ** Math.round(Math.log2(Math.min(Math.max(wanted, least), most)))
}

// Rows first <= row < last of the picture, computed with a Hann window of `size` samples and added with their weights.
class Band {
  constructor(spectrogram, size, [first, last], height, weight) {
    Object.assign(this, { size, first, last })
    this.weights = Float32Array.from({ length: last - first }, (_, i) => weight(first + i))
    this.fft = new FFT(size)
    this.taper = Float64Array.from({ length: size }, (_, i) => (Math.SQRT2 * (1 - Math.cos((2 * Math.PI * i) / size))) / size)
    this.input = new Float64Array(size)
    this.output = this.fft.createComplexArray()
    const bin = (row) => (spectrogram.frequency(1 - row / height) / spectrogram.sampleRate) * size
    this.rows = Array.from({ length: last - first }, (_, i) => [bin(first + i + 1), bin(first + i)])
  }

  read(samples, centre, level, column, width) {
    const start = Math.round(centre - this.size / 2)
    for (let i = 0; i < this.size; i++) this.input[i] = (samples[start + i] ?? 0) * this.taper[i]
    this.fft.realTransform(this.output, this.input)
    this.rows.forEach(([low, high], i) => {
      level[(this.first + i) * width + column] += this.weights[i] * 10 * Math.log10(this.#power(low, high) + 10 ** (SILENCE / 10))
    })
  }

  // Return the greatest power of the bins between two positions, or the interpolated power if there is none.
  #power(low, high) {
    const power = (k) => this.output[2 * k] ** 2 + this.output[2 * k + 1] ** 2
    const last = this.size / 2 - 1
    let most = 0
    for (let k = Math.ceil(low); k <= Math.min(high, last); k++) most = Math.max(most, power(k))
    if (most) return most
    const k = Math.min(Math.floor((low + high) / 2), last - 1)
    const share = (low + high) / 2 - k
    return (1 - share) * power(k) + share * power(k + 1)
  }
}
