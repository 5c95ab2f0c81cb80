// Interactive page of a run: sound, spectrogram and curves over time, and 3-D views of the disk and its modes.
// Without this script, the page still contains all results as text and pictures.
import './page.css'
import { clock, runs, unpacked } from './data.js'
import { Curves } from './curves.js'
import { Disk3D } from './disk3d.js'
import { MAX_DRAWN_DISPLACEMENT, Modes3D } from './modes3d.js'
import { Player } from './player.js'
import { Spectrogram } from './spectrogram.js'
import { Timeline } from './timeline.js'

const END_SPAN = 1 // [s], played by the buttons for the last second
const SLOW_SPEED = 0.1 // playback speed of slow motion
const LANDING_SPEED = 0.01 // playback speed of a landing
const LANDING_SPAN = [-0.005, 0.03] // [s], played around the loss of contact
const METER_MIN = -20 // [dB SPL], lower end of the level meters
const METER_MAX = 100 // [dB SPL], upper end of the level meters
const LINE_LEGEND = 'white: turns of the contact; blue, dashed: rocking; dotted: modes'

const $ = (selector, parent = document) => parent.querySelector(selector)
const still = matchMedia('(prefers-reduced-motion: reduce)')

function element(tag, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(tag), attributes)
  made.append(...children)
  return made
}

/** Show a message about a feature that does not work in this browser. */
function showNotice(text) {
  $('#notice').textContent = text
  $('#notice').hidden = !text
}

/** Show runs in `#workbench`; return an object with `player`, `timeline`, `runs`, `ready` and `close()`. */
function show(all) {
  document.documentElement.classList.add('alive')
  const player = new Player(all)
  const timeline = new Timeline(player.duration, player)
  const view = { player, timeline, runs: all, spectrograms: [], disks: [], open: true }
  view.close = () => {
    view.open = false
    player.close()
    view.disks.forEach(({ stage }) => stage.close())
    view.bodies?.forEach((body) => body.close())
  }
  timeline.onError = (error) => showNotice(`No sound: ${error.message}.`)
  window.sonify = view
  view.ready = fill(view)
  return view
}

async function fill(view) {
  const { player, timeline, runs: all } = view
  addTransport(player, timeline, all)
  await nextFrame() // show title and answers before decoding starts
  if (!view.open) return
  Object.assign(view, addDiskViews(all))
  view.disks.forEach((disk) => disk.draw(player.time))
  await nextFrame()
  if (!view.open) return
  const curves = addCurves(all, timeline)
  timeline.keys($('#workbench'))
  everyFrame(() => {
    if (!view.open) return false
    player.tick()
    timeline.draw()
    updateMeters(player)
    $('#clock').textContent = clock(player.time, timeline.span[1] - timeline.span[0])
    curves.forEach((one) => one.showValues(player.time))
    view.disks.forEach((disk) => disk.draw(player.time))
    view.bodies.forEach((body) => body.draw(performance.now() / 1000))
    return true
  })
  try {
    await addSpectrograms(view)
    await player.samples()
  } catch (error) {
    showNotice(`This browser cannot decode the sound (${error.message}); play the WAV files in the folder of this page instead.`)
  }
}

/** Wait until the browser has redrawn the page. */
function nextFrame() {
  return new Promise((done) => requestAnimationFrame(() => setTimeout(done)))
}

/** Call `draw()` at every screen refresh as long as it returns true. */
function everyFrame(draw) {
  const frame = () => {
    if (draw()) requestAnimationFrame(frame)
  }
  requestAnimationFrame(frame)
}

function addCopyButtons() {
  for (const button of document.querySelectorAll('button[data-copy]')) {
    const [name, source] = [button.textContent, $(button.dataset.copy)]
    button.addEventListener('click', async () => {
      try {
        await navigator.clipboard.writeText(source.textContent.trim())
        button.textContent = 'copied'
      } catch {
        getSelection().selectAllChildren(source)
        button.textContent = 'not allowed; press Ctrl+C to copy the selection'
      }
      setTimeout(() => (button.textContent = name), 2000)
    })
  }
}

function addTransport(player, timeline, all) {
  const plays = $('#play')
  const attempt = (promise) => Promise.resolve(promise).then(() => showNotice(''), timeline.onError)
  plays.addEventListener('click', () => attempt(player.toggle()))
  $('#speed').addEventListener('change', (event) => attempt(player.set({ speed: Number(event.target.value) })))
  $('#pitch').addEventListener('change', (event) => attempt(player.set({ keepPitch: event.target.checked })))
  $('#natural').addEventListener('change', (event) => attempt(player.set({ scale: event.target.checked ? 'true' : 'audible' })))
  $('#volume').addEventListener('input', (event) => attempt(player.set({ volume: Number(event.target.value) })))
  const atSpeed = (speed) => {
    $('#speed').value = String(speed)
    return attempt(player.set({ speed }))
  }
  $('#whole').addEventListener('click', () => {
    timeline.showAll()
    atSpeed(1)
  })
  $('#closer').addEventListener('click', () => timeline.zoom(0.5))
  $('#wider').addEventListener('click', () => timeline.zoom(2))
  const loopEnd = async (speed, [before, after] = [-END_SPAN, END_SPAN / 10]) => {
    const end = all[player.run].source_end
    timeline.select(end + before, end + after)
    await atSpeed(speed)
    return attempt(player.play())
  }
  $('#end').addEventListener('click', () => loopEnd(1))
  $('#slow').addEventListener('click', () => loopEnd(SLOW_SPEED))
  $('#landing').addEventListener('click', () => loopEnd(LANDING_SPEED, LANDING_SPAN))
  const showLanding = () => ($('#landing').hidden = !all[player.run].landing)
  player.onChange(showLanding)
  showLanding()
  $('#loop').addEventListener('click', () => timeline.setLooping(!timeline.looping))
  timeline.onLoop = (looping) => $('#loop').setAttribute('aria-pressed', String(looping))
  timeline.onShow = (from, to) => {
    $('#span').textContent = `${clock(from, to - from)} to ${clock(to, to - from)}`
  }
  timeline.showAll()
  if (all.length > 1) addRunChoice(player, all, attempt)
  player.onChange(() => {
    plays.setAttribute('aria-pressed', String(player.playing))
    plays.textContent = player.playing ? 'Pause' : 'Play'
  })
  buildMixer(player)
}

function addRunChoice(player, all, attempt) {
  all.forEach((run, i) => {
    const name = 'AB'[i]
    const radio = element('input', { type: 'radio', name: 'run', value: String(i), checked: i === 0 })
    radio.addEventListener('change', () => attempt(player.set({ run: i }).then(() => buildMixer(player))))
    $('#runs').append(element('label', {}, radio, ` ${name}: ${run.name}`))
  })
  $('#runs').hidden = false
}

function buildMixer(player) {
  const { inaudible } = player.runs[player.run].sounds
  $('#mixer').replaceChildren(
    ...player.names.map((name) => {
      const words = name.replaceAll('_', ' ')
      const faint = inaudible.includes(name) ? [element('small', { textContent: 'inaudible: always below the threshold of hearing' })] : []
      const mute = element('button', { type: 'button', textContent: 'mute', ariaPressed: 'false' })
      const solo = element('button', { type: 'button', textContent: 'solo', ariaPressed: 'false' })
      mute.setAttribute('aria-label', `mute ${words}`)
      solo.setAttribute('aria-label', `solo ${words}`)
      mute.addEventListener('click', () => player.mute(name))
      solo.addEventListener('click', () => player.set({ solo: player.solo === name ? null : name }))
      player.onChange(() => {
        mute.ariaPressed = String(player.muted.has(name))
        solo.ariaPressed = String(player.solo === name)
      })
      const meter = element('meter', { min: METER_MIN, max: METER_MAX, value: METER_MIN })
      meter.setAttribute('aria-label', `level of ${words}`)
      const level = element('span', { className: 'level' })
      const row = element('div', { className: 'strip' }, element('span', { className: 'name', textContent: words }), mute, solo, meter, level, ...faint)
      row.dataset.stem = name
      return row
    }),
  )
}

function updateMeters(player) {
  const { unit } = player
  for (const row of document.querySelectorAll('.strip')) {
    const level = player.level(row.dataset.stem)
    $('meter', row).value = Math.max(level, METER_MIN)
    $('.level', row).textContent = level > METER_MIN ? `${level.toFixed(0)} ${unit}` : `< ${METER_MIN} ${unit}`
  }
}

async function addSpectrograms(view) {
  const { runs: all, player, timeline } = view
  for (const [i, run] of all.entries()) {
    const stems = await player.samples(i, 'true')
    if (!view.open) return
    const sum = (heard) => {
      const samples = new Float32Array(stems[0].channels[0].length)
      for (const { channels } of heard) for (let n = 0; n < samples.length; n++) samples[n] += channels[0][n]
      return samples
    }
    const { rates, modes } = run.lines ?? {}
    const lines = rates ? [
      { t: rates.t, f: rates.precession, colour: '#fff', dash: [] },
      { t: rates.t, f: rates.nutation, colour: '#56b4e9', dash: [7, 4] },
      ...[...modes].map((f) => ({ t: [0, run.motion.t.at(-1)], f: [f, f], colour: '#fff', dash: [1, 5] })),
    ] : []
    const panel = element('div', { className: 'panel spectrogram' }, element('canvas'), element('canvas', { className: 'lines' }))
    const title = element('span', { className: 'title', textContent: all.length > 1 ? `${'AB'[i]}: ${run.name} ` : 'Spectrogram ' })
    const key = element('span', { className: 'value', textContent: rates ? LINE_LEGEND : '' })
    const axis = element('div', { className: 'times', ariaHidden: 'true' })
    $('#loading').before(element('p', { className: 'caption' }, title, key), panel, axis)
    makeTimeSlider(panel, `${run.seen} ${key.textContent}`, player)
    const spectrogram = new Spectrogram($('canvas', panel), sum(stems), {
      sampleRate: run.sample_rate, colours: run.colours, lines, delay: run.delay, fullScale: run.sounds.full_scale, start: run.start,
    })
    spectrogram.onScale = (words) => $('#levels')?.append(' ', words)
    view.spectrograms.push(spectrogram)
    timeline.add(spectrogram)
    let shown = player.names.join()
    const showUnmuted = () => {
      if (shown === (shown = player.names.filter((name) => player.sounds(name)).join())) return
      spectrogram.mix = sum(stems.filter(({ name }) => player.sounds(name)))
    }
    player.onChange(showUnmuted)
    showUnmuted()
    $('#lines').addEventListener('change', (event) => {
      spectrogram.showLines = event.target.checked
      spectrogram.show(...timeline.span)
    })
    let sized = false // the first call only reports the size
    new ResizeObserver(() => {
      if (sized) spectrogram.show(...timeline.span)
      sized = true
    }).observe(panel)
  }
  $('#loading').hidden = true
}

/** Make a panel a slider for the playback time, controlled by the keys of the timeline. */
function makeTimeSlider(panel, label, player) {
  panel.tabIndex = 0
  panel.setAttribute('role', 'slider')
  panel.setAttribute('aria-label', label)
  panel.setAttribute('aria-valuemin', player.start)
  panel.setAttribute('aria-valuemax', player.duration)
  const update = () => {
    panel.setAttribute('aria-valuenow', player.time)
    panel.setAttribute('aria-valuetext', clock(player.time))
  }
  update()
  player.onChange(update)
}

function addCurves(all, timeline) {
  const panel = () => {
    const place = element('div', { className: 'panel' }, element('p', {}, element('span', { className: 'title' }), ' ', element('span', { className: 'value' })))
    $('#curves').append(place)
    return place
  }
  const makers = all.filter(({ motion }) => motion).map((run, i) => {
    const t = run.motion.t.map((time) => time + run.delay)
    const who = all.length > 1 ? `${'AB'[i]}: ` : ''
    const { rates } = run.lines
    const heard = rates.t.map((time) => time + run.delay)
    return [
      () => new Curves(panel(), `${who}Rates [Hz]`, heard, [
        { name: 'precession', unit: 'Hz', values: rates.precession, colour: theme('--first') },
        { name: 'nutation', unit: 'Hz', values: rates.nutation, colour: theme('--second'), dash: [7, 4] },
      ], { log: true }),
      () => new Curves(panel(), `${who}Inclination [degrees]`, t, [{ unit: 'degrees', values: run.motion.inclination.map((b) => (b * 180) / Math.PI), colour: theme('--first') }]),
      () => new Curves(panel(), `${who}Normal force [N]`, t, [{ unit: 'N', values: run.motion.normal, colour: theme('--third') }]),
      () => new Curves(panel(), `${who}Energy [mJ]`, t, [{ unit: 'mJ', values: run.motion.energy.map((e) => 1e3 * e), colour: theme('--second') }]),
      run.landing && (() => new Curves(panel(), `${who}Gap under the rim as the disk lands [µm]`, run.landing.t.map((time) => time + run.delay), [{ unit: 'µm', values: run.landing.gap, colour: theme('--third') }])),
    ]
  })
  const made = makers[0].flatMap((_, k) => makers.flatMap((of) => of[k]?.() ?? [])) // put panels to be compared next to each other
  made.forEach((one) => timeline.add(one))
  return made
}

const theme = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim()

function addDiskViews(all) {
  try {
    const moving = all.filter(({ motion }) => motion)
    $('.hero').classList.toggle('pair', moving.length > 1)
    const disks = moving.map((run, i) => {
      const canvas = element('canvas', { className: 'orbit', tabIndex: 0 })
      canvas.setAttribute('role', 'img')
      canvas.setAttribute('aria-label', `The disk ${moving.length > 1 ? `of ${run.name} ` : ''}on its table at the playback time. Arrow keys turn the view; plus and minus zoom in and out.`)
      const caption = moving.length > 1 ? [element('figcaption', { textContent: `${'AB'[i]}: ${run.name}` })] : []
      $('#disks').append(element('figure', {}, ...caption, canvas))
      return new Disk3D(canvas, run)
    })
    const name = all.length > 1 ? ` (A: ${all[0].name})` : ''
    return { disks, bodies: [addModeView(all[0].shapes, '', name), addModeView(all[0].table, 'table-', name)].filter(Boolean) }
  } catch (error) {
    $('#three').classList.add('without')
    $('#three-notice').textContent = `This browser cannot draw 3-D views (${error.message}); the pictures below show the motion and the modes.`
    return { disks: [], bodies: [] }
  }
}

function addModeView(given, whose, name) {
  if (!given || !given.shapes.length) return undefined
  const canvas = $(`#${whose}mode-canvas`)
  const [choice, swing] = [$(`#${whose}mode`), $(`#${whose}swing`)]
  let modes // created when first visible
  let seen = false
  const observer = new IntersectionObserver(([{ isIntersecting }]) => (seen = isIntersecting))
  observer.observe(canvas)
  given.captions.forEach((caption, i) => choice.append(element('option', { value: String(i), textContent: caption })))
  const pick = (number) => {
    modes?.pick(number)
    canvas.setAttribute('aria-label', `The shape of mode ${given.captions[number]}. Arrow keys turn the view.`)
  }
  choice.addEventListener('change', (event) => pick(Number(event.target.value)))
  pick(0)
  $(`#${whose}exaggerated`).textContent = `Displacements are exaggerated: the largest is ${Math.round(100 * MAX_DRAWN_DISPLACEMENT)} % of the radius. Bright parts move most.`
  swing.checked = !still.matches
  $(`#${whose}modes3d`).hidden = false
  $(`#${whose}modes3d h2`).append(name)
  const draw = (seconds) => {
    if (!seen) return
    if (!modes) {
      modes = new Modes3D(canvas, given)
      modes.pick(Number(choice.value))
    }
    modes.draw(seconds, still.matches || !swing.checked)
  }
  const close = () => {
    observer.disconnect()
    modes?.stage.close()
  }
  return { draw, close }
}

const embedded = runs()
if (embedded.length) {
  addCopyButtons()
  show(embedded).ready.catch((error) => {
    showNotice(`The page cannot show this run interactively (${error.message}); the text and pictures below are complete.`)
    throw error
  })
}
window.showRuns = (given) => show(given.map(unpacked)) // for the studio, which loads the data of its runs
