// Time span shown by all panels, and its control by pointer and keys.

const MIN_SPAN = 1e-3 // [s]
const MIN_DRAG = 4 // [px], below which a pointer movement counts as a click

export class Timeline {
  constructor(duration, player) {
    this.duration = duration
    this.player = player
    this.panels = []
    this.start = player.start
    this.span = [this.start, duration]
  }

  get looping() {
    return Boolean(this.player.loop)
  }

  /** `panel` has an `element`, the area of the time span, and a method `show(from, to)`. */
  add(panel) {
    this.panels.push(panel)
    const head = document.createElement('div')
    head.className = 'playhead'
    panel.element.append(head)
    panel.head = head
    this.#listen(panel.element)
    panel.show(...this.span)
  }

  show(from, to) {
    const width = Math.min(Math.max(to - from, MIN_SPAN), this.duration - this.start)
    const start = Math.min(Math.max(from, this.start), this.duration - width)
    this.span = [start, start + width]
    this.panels.forEach((panel) => panel.show(...this.span))
    this.onShow?.(...this.span)
    if (this.looping) this.setLooping(true)
    this.draw()
  }

  /** Show a time span and play it in a loop. */
  select(from, to) {
    this.show(from, to)
    this.setLooping(true)
  }

  showAll() {
    this.show(this.start, this.duration)
    this.setLooping(false)
  }

  setLooping(looping) {
    const [from, to] = this.span
    this.player.set({ loop: looping ? [from, Math.min(to, this.duration)] : null })
    this.onLoop?.(looping)
  }

  zoom(factor, about = this.player.time) {
    const [from, to] = this.span
    const middle = about >= from && about <= to ? about : (from + to) / 2
    this.show(middle - (middle - from) * factor, middle + (to - middle) * factor)
  }

  /** Move the playheads of all panels to the position of the player; the view follows during playback. */
  draw() {
    const [from, to] = this.span
    const { time, playing } = this.player
    if (playing && time > to && time < this.duration) return this.show(time, time + (to - from))
    const share = (time - from) / (to - from)
    for (const { head } of this.panels) {
      head.hidden = share < 0 || share > 1
      head.style.left = `${100 * share}%`
    }
  }

  #time(element, event) {
    const box = element.getBoundingClientRect()
    const share = (event.clientX - box.left) / box.width
    return this.span[0] + Math.min(Math.max(share, 0), 1) * (this.span[1] - this.span[0])
  }

  #listen(element) {
    let start = null
    const mark = document.createElement('div')
    mark.className = 'selection'
    mark.hidden = true
    element.append(mark)
    element.addEventListener('pointerdown', (event) => {
      if (event.button === 0) start = { x: event.clientX, time: this.#time(element, event) }
      element.setPointerCapture(event.pointerId)
    })
    element.addEventListener('pointermove', (event) => {
      if (!start) return
      const box = element.getBoundingClientRect()
      mark.hidden = Math.abs(event.clientX - start.x) < MIN_DRAG
      mark.style.left = `${Math.min(event.clientX, start.x) - box.left}px`
      mark.style.width = `${Math.abs(event.clientX - start.x)}px`
    })
    element.addEventListener('pointerup', (event) => {
      if (!start) return
      const time = this.#time(element, event)
      if (mark.hidden) this.player.seek(time)
      else this.select(Math.min(time, start.time), Math.max(time, start.time))
      start = null
      mark.hidden = true
    })
    element.addEventListener('pointercancel', () => {
      start = null
      mark.hidden = true
    })
    element.addEventListener('dblclick', () => this.showAll())
    element.addEventListener(
      'wheel',
      (event) => {
        if (!event.ctrlKey && !event.shiftKey) return
        event.preventDefault()
        this.zoom(Math.exp(event.deltaY / 300), this.#time(element, event))
      },
      { passive: false },
    )
  }

  /** Handle keys inside `element`, except in input fields and lists. */
  keys(element) {
    const step = () => (this.span[1] - this.span[0]) / 20
    const does = {
      ' ': () => this.player.toggle(),
      ArrowLeft: () => this.player.seek(this.player.time - step()),
      ArrowRight: () => this.player.seek(this.player.time + step()),
      Home: () => this.player.seek(this.start),
      End: () => this.player.seek(this.duration),
      '+': () => this.zoom(0.5),
      '=': () => this.zoom(0.5),
      '-': () => this.zoom(2),
      0: () => this.showAll(),
    }
    element.addEventListener('keydown', (event) => {
      const busy = event.target.closest('button, select, input, canvas.orbit, a, summary')
      if (!does[event.key] || event.ctrlKey || event.metaKey || event.altKey || busy) return
      event.preventDefault()
      Promise.resolve(does[event.key]()).catch((error) => this.onError?.(error))
    })
  }
}
