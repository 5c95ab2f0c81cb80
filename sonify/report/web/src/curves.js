// Curves of the motion below the spectrogram, in the listener's time.
import uPlot from 'uplot'
import 'uplot/dist/uPlot.min.css'
import { at, digits } from './data.js'

const AXIS = 64 // width of the scale on the left [px]

/** A panel of the timeline with `curves` [{name, unit, values, colour, dash}] over `t`. */
export class Curves {
  constructor(parent, title, t, curves, { log = false, height = 130 } = {}) {
    Object.assign(this, { t, curves })
    const style = getComputedStyle(document.documentElement)
    const ink = style.getPropertyValue('--ink').trim()
    const grid = style.getPropertyValue('--line').trim()
    const axis = { stroke: ink, grid: { stroke: grid, width: 1 }, ticks: { stroke: grid, width: 1 }, font: '11px system-ui, sans-serif' }
    this.plot = new uPlot(
      {
        width: this.#width(parent),
        height,
        padding: [6, 0, 0, 0],
        legend: { show: false },
        cursor: { show: false },
        scales: { x: { time: false, auto: false }, y: log ? { distr: 3, range: (_, low, high) => decades(low, high) } : {} },
        axes: [
          { ...axis, size: 28 },
          { ...axis, size: AXIS, ...(log ? { splits: powers } : {}), values: (_, ticks) => ticks.map((v) => (v === null ? '' : String(Number(v.toPrecision(4))))) },
        ],
        series: [{}, ...curves.map(({ colour, dash }) => ({ stroke: colour, width: 1.5, dash, points: { show: false } }))],
      },
      [t, ...curves.map(({ values }) => Array.from(values, (v) => (Number.isNaN(v) ? null : v)))], // null makes a gap
      parent,
    )
    this.element = this.plot.over
    this.label = parent.querySelector('.value')
    parent.querySelector('.title').textContent = title
    this.plot.root.setAttribute('role', 'img')
    this.plot.root.setAttribute('aria-label', `${title}, from ${this.#valuesText(t[0])} to ${this.#valuesText(t.at(-1))}`)
    new ResizeObserver(() => this.plot.setSize({ width: this.#width(parent), height })).observe(parent)
  }

  #width(parent) {
    return Math.max(parent.clientWidth, 120)
  }

  show(from, to) {
    this.plot.setScale('x', { min: from, max: to })
  }

  /** Show the values of the curves at a time next to the title. */
  showValues(time) {
    this.label.textContent = this.#valuesText(time)
  }

  #valuesText(time) {
    return this.curves
      .map(({ name, unit, values }) => [name, digits(at(this.t, values, time), unit)].filter(Boolean).join(' '))
      .join(', ')
  }
}

const decades = (low, high) => [10 ** Math.floor(Math.log10(low)), Math.min(10 ** Math.ceil(Math.log10(high)), 1e5)]

function powers(plot, axis, low, high) {
  const first = Math.ceil(Math.log10(low) - 1e-9)
  return Array.from({ length: Math.floor(Math.log10(high) + 1e-9) - first + 1 }, (_, i) => 10 ** (first + i))
}
