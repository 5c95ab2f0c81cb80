// Plays the stems of a run synchronously, as channels of a single source.
import stretching from 'text:signalsmith-stretch/SignalsmithStretch.mjs'
import { bytes } from './data.js'

const STRETCHER_LEAD = 0.05 // [s], between scheduling and playback, so that the stretcher starts cleanly
const FADE_IN = 0.1 // [s], so that a part of a sound starts without a click

export class Player {
  /** `runs` contain sounds {full_scale, tracks: {name: data URL}, audible: {sections, interval, gain}}; the gain [0.01 dB
   * re 1/Pa] makes the audible copy from the A-weighted pressure. */
  constructor(runs) {
    this.runs = runs
    this.run = 0
    this.scale = 'audible' // A-weighted and mastered, or 'true', the pressure at the same scale for all runs
    this.speed = 1
    this.keepPitch = false
    this.volume = 1
    this.muted = new Set()
    this.solo = null
    this.position = this.start
    this.loop = null // [from, to] that is repeated [s]
    this.playing = false
    this.decoded = new Map()
    this.listeners = []
  }

  get names() {
    return Object.keys(this.runs[this.run].sounds.tracks)
  }

  /** Time of the first sample in the page [s]; the page contains only the end of a long sound. */
  get start() {
    return Math.max(...this.runs.map((run) => run.start))
  }

  get duration() {
    return Math.max(...this.runs.map((run) => run.duration))
  }

  /** Return the samples of all stems, decoded once, as a list of {name, channels: [Float32Array]}. */
  async samples(run = this.run, scale = this.scale) {
    const key = `${run} ${scale}`
    if (!this.decoded.has(key)) this.decoded.set(key, scale === 'true' ? this.#decode(this.runs[run]) : this.#audible(run))
    return this.decoded.get(key)
  }

  async #decode(run) {
    const context = new OfflineAudioContext(1, 1, run.sample_rate)
    const tracks = Object.entries(run.sounds.tracks)
    return Promise.all(
      tracks.map(async ([name, url]) => {
        const buffer = await context.decodeAudioData(bytes(url))
        const channels = Array.from({ length: buffer.numberOfChannels }, (_, c) => buffer.getChannelData(c))
        if (run.start > 0) channels.forEach((channel) => fadeIn(channel, FADE_IN * run.sample_rate))
        return { name, channels }
      }),
    )
  }

  async #audible(run) {
    const { sounds, sample_rate: sampleRate } = this.runs[run]
    const stems = await this.samples(run, 'true')
    const size = stems[0].channels[0].length
    const gain = this.#gainSamples(run, size)
    return Promise.all(
      stems.map(async ({ name, channels }) => {
        const context = new OfflineAudioContext(channels.length, size, sampleRate)
        const buffer = context.createBuffer(channels.length, size, sampleRate)
        channels.forEach((channel, i) => buffer.copyToChannel(channel, i))
        const source = new AudioBufferSourceNode(context, { buffer })
        const filters = sounds.audible.sections.map((row) => new IIRFilterNode(context, { feedforward: row.slice(0, 3), feedback: row.slice(3) }))
        ;[source, ...filters, context.destination].reduce((from, to) => from.connect(to))
        source.start()
        const weighted = await context.startRendering()
        const heard = channels.map((_, c) => weighted.getChannelData(c).map((x, i) => x * gain[i]))
        return { name, channels: heard }
      }),
    )
  }

  /** Return the gain of the audible copy for every sample of the stems. */
  #gainSamples(run, size) {
    const { sounds, sample_rate: sampleRate } = this.runs[run]
    const { interval, gain } = sounds.audible
    const factor = Float32Array.from(gain, (level) => sounds.full_scale * 10 ** (level / 2000))
    const last = factor.length - 1
    return Float32Array.from({ length: size }, (_, i) => {
      const place = Math.min(Math.max(i / sampleRate / interval - 0.5, 0), last)
      const k = Math.min(Math.floor(place), last - 1)
      return last ? factor[k] + (place - k) * (factor[k + 1] - factor[k]) : factor[0]
    })
  }

  /** Pressure [Pa] represented by a sample of 1.0 of the stems at the current time. */
  get fullScale() {
    const { sounds, start } = this.runs[this.run]
    if (this.scale === 'true') return sounds.full_scale
    const { interval, gain } = sounds.audible
    const k = Math.round((this.time - start) / interval - 0.5)
    return 10 ** (-gain[Math.min(Math.max(k, 0), gain.length - 1)] / 2000)
  }

  get unit() {
    return this.scale === 'true' ? 'dB SPL' : 'dB(A)'
  }

  /** Factor that makes the true pressures of all runs comparable. */
  get #commonScale() {
    if (this.scale !== 'true') return 1
    return this.runs[this.run].sounds.full_scale / Math.max(...this.runs.map(({ sounds }) => sounds.full_scale))
  }

  /** Current time of the sound [s], from the audio clock minus the output latency. */
  get time() {
    if (!this.playing) return this.position
    const heard = this.context.currentTime - (this.context.outputLatency || 0)
    const time = this.from + Math.max(heard - this.since, 0) * this.speed
    if (this.loop && time >= this.loop[1]) {
      const [from, to] = this.loop
      return from + ((time - from) % (to - from))
    }
    return Math.min(time, this.duration)
  }

  async play() {
    if (this.playing) return
    this.context ??= new AudioContext({ sampleRate: this.runs[0].sample_rate })
    const running = this.context.resume()
    const timeout = new Promise((_, reject) => setTimeout(reject, 2000, new Error('this browser does not allow the page to play sound')))
    await Promise.race([running, timeout])
    if (this.position >= this.duration - 1e-3) this.position = this.start
    await this.#start()
    this.#changed()
  }

  async #start() {
    const stems = await this.samples()
    this.stop = this.speed !== 1 && this.keepPitch ? await this.#stretched(stems) : this.#plain(stems)
    this.playing = true
  }

  #plain(stems) {
    const across = stems[0].channels.length
    const buffer = this.context.createBuffer(stems.length * across, stems[0].channels[0].length, this.runs[this.run].sample_rate)
    stems.flatMap((stem) => stem.channels).forEach((channel, i) => buffer.copyToChannel(channel, i))
    const offset = this.runs[this.run].start
    const repeats = this.loop ? { loop: true, loopStart: this.loop[0] - offset, loopEnd: this.loop[1] - offset } : {}
    const source = new AudioBufferSourceNode(this.context, { buffer, playbackRate: this.speed, ...repeats })
    this.#mixed(source, stems)
    this.from = this.position
    this.since = this.context.currentTime + 0.01
    source.start(this.since, this.from - offset)
    return () => source.stop()
  }

  async #stretched(stems) {
    const channels = stems.flatMap((stem) => stem.channels)
    const options = { numberOfInputs: 1, numberOfOutputs: 1, outputChannelCount: [channels.length] }
    const stretch = await stretcher()
    const node = await stretch(this.context, options)
    await node.addBuffers(channels.map((channel) => channel.slice()))
    this.#mixed(node, stems)
    this.from = this.position
    this.since = this.context.currentTime + STRETCHER_LEAD + (await node.latency())
    const offset = this.runs[this.run].start
    const repeats = this.loop ? { loopStart: this.loop[0] - offset, loopEnd: this.loop[1] - offset } : {}
    node.schedule({ output: this.since, outputTime: this.since, input: this.from - offset, rate: this.speed, active: true, ...repeats })
    return () => {
      node.stop()
      node.disconnect()
    }
  }

  #mixed(source, stems) {
    const across = stems[0].channels.length
    const splitter = this.context.createChannelSplitter(stems.length * across)
    this.master?.disconnect()
    this.master = new GainNode(this.context)
    this.master.connect(this.context.destination)
    source.connect(splitter)
    this.strips = stems.map(({ name }, i) => {
      const gain = new GainNode(this.context)
      const meter = new AnalyserNode(this.context, { fftSize: 2048 })
      const merger = this.context.createChannelMerger(across)
      for (let c = 0; c < across; c++) splitter.connect(merger, i * across + c, c)
      merger.connect(gain).connect(meter).connect(this.master)
      return { name, gain, meter }
    })
    this.#setGains()
  }

  #setGains() {
    for (const { name, gain } of this.strips ?? []) gain.gain.value = this.sounds(name) ? 1 : 0
    if (this.master) this.master.gain.value = this.volume * this.#commonScale
  }

  /** Return whether a stem is audible (not muted). */
  sounds(name) {
    return this.solo ? this.solo === name : !this.muted.has(name)
  }

  /** Return the current level of a stem [dB SPL] over 2048 samples, or -Infinity if it is muted. */
  level(name) {
    const strip = this.playing && this.strips.find((one) => one.name === name)
    if (!strip) return -Infinity
    const block = new Float32Array(strip.meter.fftSize)
    strip.meter.getFloatTimeDomainData(block)
    const mean = block.reduce((sum, x) => sum + x * x, 0) / block.length
    return 20 * Math.log10((Math.sqrt(mean) * this.fullScale) / 20e-6)
  }

  pause() {
    if (!this.playing) return
    this.position = this.time
    this.playing = false
    this.stop()
    this.#changed()
  }

  async toggle() {
    return this.playing ? this.pause() : this.play()
  }

  /** Change the settings of the player; playback continues from the current position. */
  async set(change) {
    const gains = Object.keys(change).every((key) => ['solo', 'volume'].includes(key))
    const was = this.playing
    if (was && !gains) this.pause()
    Object.assign(this, change)
    this.position = Math.min(Math.max(this.position, this.start), this.duration)
    if (this.loop && (this.position < this.loop[0] || this.position >= this.loop[1])) this.position = this.loop[0]
    this.#setGains()
    if (was && !gains) await this.play()
    this.#changed()
  }

  async seek(time) {
    return this.set({ position: time })
  }

  mute(name) {
    if (!this.muted.delete(name)) this.muted.add(name)
    this.#setGains()
    this.#changed()
  }

  /** Call `note()` whenever a value shown by a control changes. */
  onChange(note) {
    this.listeners.push(note)
  }

  #changed() {
    this.listeners.forEach((note) => note())
  }

  /** Stop the sound and release the audio device. */
  close() {
    this.pause()
    this.context?.close()
  }

  /** Stop at the end; to be called at every screen refresh. */
  tick() {
    if (this.playing && !this.loop && this.time >= this.duration) this.pause()
  }
}

function fadeIn(channel, samples) {
  for (let i = 0; i < Math.min(samples, channel.length); i++) channel[i] *= (1 - Math.cos((Math.PI * i) / samples)) / 2
}

// The time stretcher runs in the page and in an audio thread; a page opened from disk can load it only from data: URLs.
async function stretcher() {
  const moduleUrl = `data:text/javascript;charset=utf-8,${encodeURIComponent(stretching)}`
  const { default: stretch } = await import(moduleUrl)
  return Object.assign(stretch, { moduleUrl })
}
