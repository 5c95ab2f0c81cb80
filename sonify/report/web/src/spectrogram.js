// The spectrogram of what is seen, computed for the time and the screen that show it: low tones through a long window,
// high ones through a short one.
import FFT from 'fft.js'

const LOWEST = 10 // [Hz]
const SPLIT = 1000 // [Hz]: above it, the short window
const RANGE = 65 // [dB] from the darkest to the brightest, which is the loudest of each band
const APART = 50 // [dB]: the quieter band is shown as loud as it is from so far below the louder one on
const SEEN = 200 // [ms] between two looks at a picture that grows
const BUSY = 12 // [ms] of work between two frames of the screen

export class Spectrogram {
  /** `samples` Float32Array, 1 is `fullScale` [Pa]; `colours` 256 x 3 bytes; `lines` over it: [{name, t, f, style}];
   * `onPainted(words)` is told what the colours mean. */
  constructor(canvas, samples, { sampleRate, colours, lines, delay, fullScale, start }) {
    Object.assign(this, { canvas, samples, sampleRate, colours, lines, delay, fullScale, start })
    this.element = canvas.parentElement
    this.overlay = this.element.querySelector('canvas.lines')
    this.showLines = true
    this.done = Promise.resolve()
  }

  get highest() {
    return this.sampleRate / 2
  }

  /** The height of a frequency over the panel, 0 at the bottom and 1 at the top, and back. */
  height(frequency) {
    return Math.log(frequency / LOWEST) / Math.log(this.highest / LOWEST)
  }

  frequency(height) {
    return LOWEST * (this.highest / LOWEST) ** height
  }

  show(from, to) {
    this.span = [from, to]
    this.job = {} // a job that is not this one any more stops
    this.done = this.#draw(this.job, from, to)
  }

  async #draw(job, from, to) {
    const width = Math.max(this.element.clientWidth, 1)
    const height = Math.max(this.element.clientHeight, 1)
    const bands = this.#bands((to - from) / width, height)
    const level = new Float32Array(width * height).fill(-Infinity)
    let rest = performance.now()
    let painted = rest
    for (let column = 0; column < width; column++) {
      const time = from + ((column + 0.5) / width) * (to - from)
      for (const band of bands) band.read(this.samples, (time - this.start) * this.sampleRate, level, column, width)
      if (performance.now() - rest > BUSY) {
        await new Promise(requestAnimationFrame)
        if (job !== this.job) return
        rest = performance.now()
        if (rest - painted > SEEN) {
          this.#paint(level, bands, width, height)
          painted = performance.now()
        }
      }
    }
    this.#paint(level, bands, width, height)
    this.#drawLines(from, to)
  }

  #bands(perColumn, height) {
    const long = windowSize(16 * perColumn * this.sampleRate, 512, 16384)
    const short = Math.max(long >> 3, 256)
    const split = Math.round(height * (1 - this.height(SPLIT)))
    return [
      new Band(this, short, 0, split, height),
      new Band(this, long, split, height, height),
    ]
  }

  #paint(level, bands, width, height) {
    this.canvas.width = width
    this.canvas.height = height
    const context = this.canvas.getContext('2d')
    const image = context.createImageData(width, height)
    const tops = bands.map(({ first, last }) => loudest(level.subarray(first * width, last * width)))
    const brightest = tops.map((top) => Math.max(top, Math.max(...tops) - APART))
    this.onPainted?.(this.#meaning(brightest))
    for (const [b, { first, last }] of bands.entries()) {
      const rows = level.subarray(first * width, last * width)
      const top = brightest[b]
      for (let i = 0; i < rows.length; i++) {
        const shade = Math.round(Math.min(Math.max((rows[i] - top) / RANGE + 1, 0), 1) * 255)
        const at = 4 * (first * width + i)
        for (let c = 0; c < 3; c++) image.data[at + c] = this.colours[3 * shade + c]
        image.data[at + 3] = 255
      }
    }
    context.putImageData(image, 0, 0)
  }

  #meaning([high, low]) {
    const spl = (level) => `${(level + 20 * Math.log10(this.fullScale / 20e-6)).toFixed(0)} dB SPL`
    return `brightest: a sine of ${spl(low)} below 1 kHz, ${spl(high)} above; black: ${RANGE} dB less`
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
        let joined = false // the line has a gap where it is not a number
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

  #ticks(context, width, height) {
    Object.assign(context, { font: '11px system-ui, sans-serif', lineWidth: 1 })
    for (let decade = LOWEST; decade < this.highest; decade *= 10) {
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

function loudest(levels) {
  let top = -Infinity
  for (const value of levels) if (value > top) top = value
  return top
}

function windowSize(wanted, least, most) {
  return 2 ** Math.round(Math.log2(Math.min(Math.max(wanted, least), most)))
}

// The rows first <= row < last of the picture, seen through a Hann window of `size` samples.
class Band {
  constructor(spectrogram, size, first, last, height) {
    Object.assign(this, { size, first, last })
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
      level[(this.first + i) * width + column] = 10 * Math.log10(this.#power(low, high) + 1e-30)
    })
  }

  // The greatest power of the bins between two places, or the one in between, straight from bin to bin.
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
