// Interactive page of a run: sound, spectrogram and curves over time, and 3-D views of the disk and its modes.
// Without this script the page still contains all results as text and pictures.
import './page.css'
import { clock, runs } from './data.js'
import { Curves } from './curves.js'
import { Disk3D } from './disk3d.js'
import { EXAGGERATED, Modes3D } from './modes3d.js'
import { Player } from './player.js'
import { Spectrogram } from './spectrogram.js'
import { Timeline } from './timeline.js'

const LAST = 1 // [s]: the last stretch before the end
const SLOW = 0.1 // speed of slow motion
const QUIET = -20 // [dB SPL]: the lower end of a level meter
const LOUD = 100
const LINES = 'white: turns of the contact; blue, dashed: rocking; dotted: modes'

const $ = (selector, parent = document) => parent.querySelector(selector)
const still = matchMedia('(prefers-reduced-motion: reduce)')

function element(tag, attributes = {}, ...children) {
  const made = Object.assign(document.createElement(tag), attributes)
  made.append(...children)
  return made
}

/** Show a message about a feature that does not work in this browser. */
function say(text) {
  $('#notice').textContent = text
  $('#notice').hidden = !text
}

async function start() {
  document.documentElement.classList.add('alive')
  copies()
  await frame() // show title and answer before decoding starts
  const all = runs()
  const player = new Player(all)
  const timeline = new Timeline(player.duration, player)
  timeline.onError = (error) => say(`No sound: ${error.message}.`)
  window.sonify = { player, timeline, runs: all, spectrograms: [] }
  transport(player, timeline, all)
  const scenes = three(all)
  scenes.disks.forEach((disk) => disk.draw(player.time))
  await frame()
  const curves = motion(all, timeline)
  timeline.keys($('#workbench'))
  loop(() => {
    player.tick()
    timeline.draw()
    meters(player)
    $('#clock').textContent = clock(player.time, timeline.span[1] - timeline.span[0])
    curves.forEach((one) => one.tell(player.time))
    scenes.disks.forEach((disk) => disk.draw(player.time))
    scenes.bodies.forEach((draw) => draw(performance.now() / 1000))
  })
  try {
    await spectrograms(all, player, timeline)
    await player.samples()
  } catch (error) {
    say(`The sound cannot be decoded by this browser (${error.message}); the WAV files beside this page can be played.`)
  }
}

/** Wait until the browser has redrawn the page. */
function frame() {
  return new Promise((done) => requestAnimationFrame(() => setTimeout(done)))
}

function loop(draw) {
  const frame = () => {
    draw()
    requestAnimationFrame(frame)
  }
  requestAnimationFrame(frame)
}

function copies() {
  for (const button of document.querySelectorAll('button[data-copy]')) {
    const [name, source] = [button.textContent, $(button.dataset.copy)]
    button.addEventListener('click', async () => {
      try {
        await navigator.clipboard.writeText(source.textContent.trim())
        button.textContent = 'copied'
      } catch {
        getSelection().selectAllChildren(source)
        button.textContent = 'not allowed: it is selected, press Ctrl-C'
      }
      setTimeout(() => (button.textContent = name), 2000)
    })
  }
}

function transport(player, timeline, all) {
  const plays = $('#play')
  const attempt = (promise) => Promise.resolve(promise).then(() => say(''), timeline.onError)
  plays.addEventListener('click', () => attempt(player.toggle()))
  $('#speed').addEventListener('change', (event) => attempt(player.set({ speed: Number(event.target.value) })))
  $('#pitch').addEventListener('change', (event) => attempt(player.set({ keepPitch: event.target.checked })))
  $('#scale').addEventListener('change', (event) => attempt(player.set({ scale: event.target.value })))
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
  const loopEnd = async (speed) => {
    const end = all[player.run].source_end
    timeline.select(end - LAST, end + LAST / 10)
    await atSpeed(speed)
    return attempt(player.play())
  }
  $('#end').addEventListener('click', () => loopEnd(1))
  $('#slow').addEventListener('click', () => loopEnd(SLOW))
  $('#loop').addEventListener('click', () => timeline.setLooping(!timeline.looping))
  timeline.onLoop = (looping) => $('#loop').setAttribute('aria-pressed', String(looping))
  timeline.onShow = (from, to) => {
    $('#span').textContent = `${clock(from, to - from)} to ${clock(to, to - from)}`
  }
  timeline.showAll()
  if (all.length > 1) choice(player, all, attempt)
  player.onChange(() => {
    plays.setAttribute('aria-pressed', String(player.playing))
    plays.textContent = player.playing ? 'Pause' : 'Play'
  })
  mixer(player)
}

function choice(player, all, attempt) {
  all.forEach((run, i) => {
    const name = 'AB'[i]
    const radio = element('input', { type: 'radio', name: 'run', value: String(i), checked: i === 0 })
    radio.addEventListener('change', () => attempt(player.set({ run: i }).then(() => mixer(player))))
    $('#runs').append(element('label', {}, radio, ` ${name}: ${run.name}`))
  })
  $('#runs').hidden = false
}

function mixer(player) {
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
      const meter = element('meter', { min: QUIET, max: LOUD, value: QUIET })
      meter.setAttribute('aria-label', `level of ${words}`)
      const level = element('span', { className: 'level' })
      const row = element('div', { className: 'strip' }, element('span', { className: 'name', textContent: words }), mute, solo, meter, level, ...faint)
      row.dataset.stem = name
      return row
    }),
  )
}

function meters(player) {
  const { unit } = player
  for (const row of document.querySelectorAll('.strip')) {
    const level = player.level(row.dataset.stem)
    $('meter', row).value = Math.max(level, QUIET)
    $('.level', row).textContent = level > QUIET ? `${level.toFixed(0)} ${unit}` : `< ${QUIET} ${unit}`
  }
}

async function spectrograms(all, player, timeline) {
  for (const [i, run] of all.entries()) {
    const stems = await player.samples(i, 'true')
    const mix = () => {
      const samples = new Float32Array(stems[0].channels[0].length)
      const heard = stems.filter(({ name }) => player.sounds(name))
      for (const { channels } of heard) for (let n = 0; n < samples.length; n++) samples[n] += channels[0][n]
      return samples
    }
    const { rates, modes } = run.lines
    const lines = [
      { t: rates.t, f: rates.precession, colour: '#fff', dash: [] },
      { t: rates.t, f: rates.nutation, colour: '#56b4e9', dash: [7, 4] },
      ...[...modes].map((f) => ({ t: [0, run.motion.t.at(-1)], f: [f, f], colour: '#fff', dash: [1, 5] })),
    ]
    const panel = element('div', { className: 'panel spectrogram' }, element('canvas'), element('canvas', { className: 'lines' }))
    const title = element('span', { className: 'title', textContent: all.length > 1 ? `${'AB'[i]}: ${run.name} ` : 'Spectrogram ' })
    const key = element('span', { className: 'value', textContent: LINES })
    $('#loading').before(element('p', { className: 'caption' }, title, key), panel)
    seeks(panel, `${run.seen} ${LINES}`, player)
    const spectrogram = new Spectrogram($('canvas', panel), mix(), {
      sampleRate: run.sample_rate, colours: run.colours, lines, delay: run.delay, fullScale: run.sounds.full_scale, start: run.start,
    })
    spectrogram.onScale = (words) => $('#levels').append(' ', words)
    const audible = () => player.names.filter((name) => player.sounds(name)).join()
    let shown = audible()
    player.onChange(() => {
      if (shown === (shown = audible())) return
      spectrogram.mix = mix()
    })
    window.sonify.spectrograms.push(spectrogram)
    timeline.add(spectrogram)
    $('#lines').addEventListener('change', (event) => {
      spectrogram.showLines = event.target.checked
      spectrogram.show(...timeline.span)
    })
    let sized = false // the first call only states the size
    new ResizeObserver(() => {
      if (sized) spectrogram.show(...timeline.span)
      sized = true
    }).observe(panel)
  }
  $('#loading').hidden = true
}

/** Make a panel a slider for the playing time, with the keys of the timeline. */
function seeks(panel, label, player) {
  panel.tabIndex = 0
  panel.setAttribute('role', 'slider')
  panel.setAttribute('aria-label', label)
  panel.setAttribute('aria-valuemin', player.start)
  panel.setAttribute('aria-valuemax', player.duration)
  const tell = () => {
    panel.setAttribute('aria-valuenow', player.time)
    panel.setAttribute('aria-valuetext', clock(player.time))
  }
  tell()
  player.onChange(tell)
}

function motion(all, timeline) {
  const panel = () => {
    const place = element('div', { className: 'panel' }, element('p', {}, element('span', { className: 'title' }), ' ', element('span', { className: 'value' })))
    $('#curves').append(place)
    return place
  }
  const makers = all.map((run, i) => {
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
    ]
  })
  const made = makers[0].flatMap((_, k) => makers.map((of) => of[k]())) // place panels to be compared side by side
  made.forEach((one) => timeline.add(one))
  return made
}

const theme = (name) => getComputedStyle(document.documentElement).getPropertyValue(name).trim()

function three(all) {
  try {
    const disks = all.map((run, i) => {
      const canvas = element('canvas', { className: 'orbit', tabIndex: 0 })
      canvas.setAttribute('role', 'img')
      canvas.setAttribute('aria-label', `The disk ${all.length > 1 ? `of ${run.name} ` : ''}on its table at the time that is heard. Arrow keys turn the view, plus and minus bring it nearer and farther.`)
      if (all.length > 1) $('#disks').append(element('p', { className: 'caption' }, `${'AB'[i]}: ${run.name}`))
      $('#disks').append(canvas)
      return new Disk3D(canvas, run)
    })
    const name = all.length > 1 ? ` (A: ${all[0].name})` : ''
    return { disks, bodies: [shapes(all[0].shapes, '', name), shapes(all[0].table, 'table-', name)].filter(Boolean) }
  } catch (error) {
    $('#three').classList.add('without')
    $('#three-notice').textContent = `This browser draws no 3-D (${error.message}); the pictures below show the motion and the modes.`
    return { disks: [], bodies: [] }
  }
}

function shapes(given, whose, name) {
  if (!given || !given.shapes.length) return undefined
  const canvas = $(`#${whose}mode-canvas`)
  const [choice, swing] = [$(`#${whose}mode`), $(`#${whose}swing`)]
  let modes // made when it is first seen
  let seen = false
  new IntersectionObserver(([{ isIntersecting }]) => (seen = isIntersecting)).observe(canvas)
  given.captions.forEach((caption, i) => choice.append(element('option', { value: String(i), textContent: caption })))
  const pick = (number) => {
    modes?.pick(number)
    canvas.setAttribute('aria-label', `The shape of mode ${given.captions[number]}. Arrow keys turn the view.`)
  }
  choice.addEventListener('change', (event) => pick(Number(event.target.value)))
  pick(0)
  $(`#${whose}exaggerated`).textContent = `Exaggerated to ${Math.round(100 * EXAGGERATED)} % of the radius where it moves most; bright is far.`
  swing.checked = !still.matches
  $(`#${whose}modes3d`).hidden = false
  $(`#${whose}modes3d h2`).append(name)
  return (seconds) => {
    if (!seen) return
    if (!modes) {
      modes = new Modes3D(canvas, given)
      modes.pick(Number(choice.value))
    }
    modes.draw(seconds, still.matches || !swing.checked)
  }
}

start().catch((error) => {
  say(`The page cannot show this run interactively (${error.message}); what follows is complete without that.`)
  throw error
})
