"""Claim: in a real browser the page of a run plays, seeks, zooms, mutes and turns as documented,
and is accessible.

Source: the README's description of the page; WCAG 2.2 AA. Oracle: the output samples of the mixer,
compared with the decoded files; the pixels of the canvases; axe-core. Skipped if Chromium is
missing.
"""

import time
import tomllib

import numpy as np
import pytest
import soundfile
from browser import CHROMIUM, until
from servers import address_of

from sonify import load_scene, run
from sonify.studio.application import serve

playwright = pytest.importorskip(
    "playwright.sync_api", reason="needs the extra `browser`"
)
pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(CHROMIUM is None, reason="needs Chromium"),
]
ARGUMENTS = [
    "--no-sandbox",
    "--use-angle=swiftshader",
    "--enable-unsafe-swiftshader",
    "--disable-background-networking",
]
WIDTHS = (360, 1280, 1920)
SCREENS = {(1366, 768): 4000, (390, 844): 7000}
"""Width and height of a screen [px], and the greatest height of the folded page [px]."""

HEARD = """async () => {
  // The last samples that left the mixer, where in the sum of the stems they are, and where the playhead says it is.
  const { player } = sonify
  const stems = await player.samples()
  const sum = new Float32Array(stems[0].channels[0].length)
  for (const { channels } of stems) channels[0].forEach((x, i) => (sum[i] += x))
  const probe = new AnalyserNode(player.context, { fftSize: 4096 })
  player.master.connect(probe)
  await new Promise((done) => setTimeout(done, 400))
  const out = new Float32Array(4096)
  probe.getFloatTimeDomainData(out)
  const rate = player.context.sampleRate
  const says = Math.round((player.time + (player.context.outputLatency || 0)) * rate) - out.length
  let [best, lag] = [-Infinity, 0]
  for (let d = -6000; d <= 6000; d++) {
    let [dot, power] = [0, 1e-30]
    for (let i = 0; i < out.length; i += 3) {
      const x = sum[says + d + i] ?? 0
      dot += x * out[i]
      power += x * x
    }
    if (dot / Math.sqrt(power) > best) [best, lag] = [dot / Math.sqrt(power), d]
  }
  const norm = Math.sqrt(out.reduce((s, x, i) => s + (i % 3 ? 0 : x * x), 0))
  return { late: lag / rate, likeness: best / norm }
}"""
LOUDEST = """async () => {
  const probe = new AnalyserNode(sonify.player.context, { fftSize: 4096 })
  sonify.player.master.connect(probe)
  await new Promise((done) => setTimeout(done, 300))
  const out = new Float32Array(4096)
  probe.getFloatTimeDomainData(out)
  return Math.max(...out.map(Math.abs))
}"""
READY = "() => window.sonify && sonify.spectrograms.length > 0 && document.querySelector('#loading').hidden"
PIXELS = """(canvas) => {
  const copy = document.createElement('canvas')
  Object.assign(copy, { width: 80, height: 60 })
  copy.getContext('2d').drawImage(canvas, 0, 0, 80, 60)
  return [...copy.getContext('2d').getImageData(0, 0, 80, 60).data]
}"""


@pytest.fixture(scope="module")
def folder(tmp_path_factory):
    scene = load_scene("published").replace("numerics.accuracy=draft")
    return run(scene, tmp_path_factory.mktemp("page") / "published").out


@pytest.fixture(scope="module")
def browser():
    with playwright.sync_playwright() as started:
        chromium = started.chromium.launch(executable_path=CHROMIUM, args=ARGUMENTS)
        yield chromium
        chromium.close()


@pytest.fixture
def open_page(browser, folder):
    """Return open_page(width, ...) -> page; fail at teardown if its console reported anything."""
    contexts = []
    said = []

    def open_page(width=1280, script="", height=900, **options):
        viewport = {"width": width, "height": height}
        contexts.append(browser.new_context(viewport=viewport, **options))
        page = contexts[-1].new_page()
        page.on(
            "console",
            lambda message: (
                said.append(message.text)
                if message.type in ("error", "warning")
                else None
            ),
        )
        page.on("pageerror", lambda error: said.append(str(error)))
        page.add_init_script(script)
        page.goto((folder / "report.html").as_uri())
        return page

    yield open_page
    for context in contexts:
        context.close()
    assert said == []


@pytest.fixture
def page(open_page):
    page = open_page()
    page.wait_for_function(READY, timeout=60_000)
    return page


def box(page, selector):
    page.locator(selector).first.scroll_into_view_if_needed()
    return page.locator(selector).first.bounding_box()


def test_the_playhead_is_where_the_sound_is(page):
    page.evaluate("sonify.player.seek(17.0)")
    page.click("#play")
    page.wait_for_function("sonify.player.playing")
    heard = page.evaluate(HEARD)
    assert heard["likeness"] > 0.99
    assert abs(heard["late"]) < 0.03
    drawn = page.evaluate(
        """() => { sonify.timeline.draw()
        const { span, player, panels } = sonify.timeline
        return (parseFloat(panels[0].head.style.left) / 100) * (span[1] - span[0]) + span[0] - player.time }"""
    )
    assert abs(drawn) < 0.03


@pytest.mark.parametrize("keep", [False, True])
def test_slow_play_takes_its_time(page, keep):
    page.evaluate(
        f"sonify.player.set({{ position: 17, speed: 0.1, keepPitch: {str(keep).lower()} }})"
    )
    page.click("#play")
    page.wait_for_function("sonify.player.playing")
    page.wait_for_timeout(300)
    clocks = "[sonify.player.time, sonify.player.context.currentTime]"
    before = page.evaluate(clocks)
    assert page.evaluate(LOUDEST) > 1e-4
    page.wait_for_timeout(1000)
    after = page.evaluate(clocks)
    assert (after[0] - before[0]) / (after[1] - before[1]) == pytest.approx(
        0.1, abs=0.01
    )


def test_stems_are_muted_and_heard_alone(page):
    page.evaluate("sonify.player.seek(10.0)")
    page.click("#play")
    page.wait_for_function("sonify.player.playing")
    names = page.evaluate("sonify.player.names")
    assert page.evaluate(LOUDEST) > 1e-3
    for name in names:
        page.click(f'[data-stem="{name}"] button:has-text("mute")')
    page.evaluate("sonify.player.seek(10.0)")
    assert page.evaluate(LOUDEST) == 0.0
    page.click(f'[data-stem="{names[1]}"] button:has-text("solo")')
    assert page.evaluate(LOUDEST) > 1e-4
    assert (
        page.locator(f'[data-stem="{names[1]}"] .level').inner_text().endswith("dB(A)")
    )


def test_click_drag_and_button_land_where_they_say(page):
    whole = page.evaluate("sonify.player.duration")
    area = box(page, ".spectrogram")
    x = area["x"]
    y = area["y"] + area["height"] / 2
    page.mouse.click(x + area["width"] / 4, y)
    assert page.evaluate("sonify.player.time") == pytest.approx(
        whole / 4, abs=2 * whole / area["width"]
    )
    page.mouse.move(x + area["width"] / 2, y)
    page.mouse.down()
    page.mouse.move(x + 3 * area["width"] / 4, y, steps=4)
    page.mouse.up()
    span = page.evaluate("sonify.timeline.span")
    assert span == pytest.approx(
        [whole / 2, 3 * whole / 4], abs=2 * whole / area["width"]
    )
    page.click("#end")
    end = page.evaluate("sonify.runs[0].source_end")
    assert page.evaluate("sonify.timeline.span") == pytest.approx([end - 1, end + 0.1])
    page.evaluate("sonify.timeline.show(18.0, 18.0)")
    assert page.evaluate(
        "sonify.timeline.span[1] - sonify.timeline.span[0]"
    ) == pytest.approx(1e-3)


def test_the_spectrogram_shows_the_mode_where_it_is(page):
    """The brightest row after the motion matches a mode within two bins of the window, 23 Hz each,
    and one row, 2 %."""
    page.evaluate("sonify.timeline.show(20, 22)")
    page.evaluate("sonify.spectrograms[0].done")
    frequency = page.evaluate(
        """() => { const s = sonify.spectrograms[0], c = s.canvas
        const d = c.getContext('2d').getImageData(c.width >> 1, 0, 1, c.height).data
        let best = 0
        for (let i = 0; i < c.height; i++) if (d[4 * i] + d[4 * i + 1] > d[4 * best] + d[4 * best + 1]) best = i
        return s.frequency(1 - (best + 0.5) / c.height) }"""
    )
    modes = page.evaluate("[...sonify.runs[0].lines.modes]")
    assert min(abs(frequency - f) - 2 * 24 - 0.02 * f for f in modes) < 0


def test_a_zoomed_spectrogram_keeps_its_colours(page):
    """A mode that rings after the end is the loudest of the zoomed view, but no brighter there.

    Its level changes by 2 dB of 65 within the longer window, and the colours have 510 steps in all.
    """
    brightest = """([from, to, time]) => {
      sonify.timeline.show(from, to)
      return sonify.spectrograms[0].done.then(() => {
        const c = sonify.spectrograms[0].canvas
        const x = Math.round(((time - from) / (to - from)) * c.width)
        const copy = new OffscreenCanvas(1, c.height).getContext('2d')
        copy.drawImage(c, -x, 0)
        const d = copy.getImageData(0, 0, 1, c.height).data
        return Math.max(...Array.from({ length: c.height }, (_, i) => d[4 * i] + d[4 * i + 1]))
      }) }"""
    whole = page.evaluate("[0, sonify.player.duration, 21]")
    seen = page.evaluate(brightest, whole)
    assert 100 < seen < 480
    assert page.evaluate(brightest, [20, 22, 21]) == pytest.approx(seen, abs=40)


def test_the_spectrogram_is_that_of_the_audible_mix(page):
    """Without any cause it is black, and with all again what it was."""
    names = page.evaluate("sonify.player.names")
    page.evaluate("sonify.spectrograms[0].done")
    canvas = page.locator(".spectrogram canvas").first
    whole = canvas.evaluate(PIXELS)
    for name in names:
        page.click(f'[data-stem="{name}"] button:has-text("mute")')
    page.evaluate("sonify.spectrograms[0].done")
    silent = canvas.evaluate(PIXELS)
    assert len(set(silent)) <= 4
    assert max(silent[:3]) < 10, "silence is black"
    page.click(f'[data-stem="{names[-1]}"] button:has-text("solo")')
    page.evaluate("sonify.spectrograms[0].done")
    alone = canvas.evaluate(PIXELS)
    assert len(set(alone)) > 4
    assert alone != whole
    page.click(f'[data-stem="{names[-1]}"] button:has-text("solo")')
    for name in names:
        page.click(f'[data-stem="{name}"] button:has-text("mute")')
    page.evaluate("sonify.spectrograms[0].done")
    assert canvas.evaluate(PIXELS) == whole


def test_muting_before_the_first_picture_keeps_its_colour_scale(page):
    """The scale is that of all stems, although all are muted while it is determined."""
    page.evaluate("sonify.spectrograms[0].done")
    canvas = page.locator(".spectrogram canvas").first
    whole = canvas.evaluate(PIXELS)
    scales = page.evaluate(
        """async () => {
      const s = sonify.spectrograms[0]
      const before = s.scale
      s.scale = s.first = undefined
      s.show(...s.span)
      sonify.player.names.forEach((name) => sonify.player.mute(name))
      await s.done
      return [before, s.scale] }"""
    )
    assert scales[0] == scales[1]
    assert max(canvas.evaluate(PIXELS)[:3]) < 10, "silence is black"
    page.evaluate("sonify.player.names.forEach((name) => sonify.player.mute(name))")
    page.evaluate("sonify.spectrograms[0].done")
    assert canvas.evaluate(PIXELS) == whole


def test_the_page_plays_audible_wav(page, folder):
    """The stems with filter and gain add up to audible.wav, to 1 % of its level and the step of
    16 bits for each stem."""
    first, last = 480_000, 500_000
    heard = page.evaluate(
        f"""sonify.player.samples().then((stems) => {{
        const sum = new Array({last - first}).fill(0)
        for (const {{ channels }} of stems)
          for (let i = {first}; i < {last}; i++) sum[i - {first}] += channels[0][i]
        return sum }})"""
    )
    expected, _ = soundfile.read(folder / "audible.wav")
    expected = expected[first:last, 0]  # the other channel is a second ear
    gain = page.evaluate(
        f"10 ** (sonify.runs[0].sounds.audible.gain[{first // 48}] / 2000)"
    )
    step = page.evaluate("sonify.runs[0].sounds.full_scale") * gain / 2**15
    rms = np.sqrt(np.mean(expected**2))
    assert np.sqrt(np.mean((np.array(heard) - expected) ** 2)) < 0.01 * rms + step
    assert rms > 20 * step


def test_a_switch_plays_the_true_pressure(page, folder):
    """Its largest sample is that of sound.wav, and the audible copy is another one."""
    largest = """sonify.player.samples().then((stems) => {
      const sum = new Float32Array(stems[0].channels[0].length)
      for (const { channels } of stems) channels[0].forEach((x, i) => (sum[i] += x))
      return sum.reduce((most, x) => Math.max(most, Math.abs(x)), 0) })"""
    audible = page.evaluate(largest)
    page.check("#natural")
    peak = np.abs(soundfile.read(folder / "sound.wav")[0]).max()
    assert page.evaluate(largest) == pytest.approx(peak, abs=1e-3)
    assert abs(audible - peak) > 0.01


def test_the_times_below_the_spectrogram_are_those_of_the_view(page):
    """A tick is at the share of the view that its text states."""
    page.evaluate("sonify.timeline.show(17.2, 18.4)")
    places = page.evaluate(
        """[...document.querySelectorAll('.times span')].map((tick) =>
        [parseFloat(tick.textContent), parseFloat(tick.style.left) / 100])"""
    )
    assert len(places) >= 4
    for seconds, share in places:
        assert 17.2 + 1.2 * share == pytest.approx(seconds, abs=1e-6)


def test_the_spectrogram_of_noise_has_no_seam(page):
    """The mean level of six rows differs from that of the six rows above by less than 2 dB; a
    change of the window by a factor of 8 would be a step of 9 dB. The colour scale is that of the
    picture before the noise."""
    rows = page.evaluate(
        """async () => {
      const s = sonify.spectrograms[0]
      await s.done
      let seed = 1
      s.mix = Float32Array.from({ length: s.samples.length }, () => {
        seed = (seed * 48271) % 2147483647
        return 0.1 * (seed / 1073741823.5 - 1)
      })
      await s.done
      const { width, height } = s.canvas
      const pixels = s.canvas.getContext('2d').getImageData(0, 0, width, height).data
      const shades = new Map(Array.from({ length: 256 }, (_, i) => [s.colours.slice(3 * i, 3 * i + 3).join(), i]))
      const mean = (row) => {
        let sum = 0
        for (let x = row * width; x < (row + 1) * width; x++) sum += shades.get(pixels.slice(4 * x, 4 * x + 3).join())
        return (65 / 255) * (sum / width)
      }
      return Array.from({ length: height }, (_, row) => [s.frequency(1 - row / height), mean(row)]) }"""
    )
    _, level = np.array(rows).T
    six = np.convolve(level, np.full(6, 1 / 6), "valid")
    assert np.ptp(six) > 3, "the windows do differ"
    assert np.abs(six[6:] - six[:-6]).max() < 2


def test_keys_do_what_the_page_says(page):
    """Tab reaches the spectrogram; a stretch is chosen, looped and left without a pointer."""
    for _ in range(20):
        page.keyboard.press("Tab")
        if page.evaluate("document.activeElement.classList.contains('spectrogram')"):
            break
    assert page.evaluate("document.activeElement.getAttribute('role')") == "slider"
    page.keyboard.press("End")
    assert page.evaluate("sonify.player.time") == pytest.approx(
        page.evaluate("sonify.player.duration")
    )
    page.keyboard.press("Home")
    page.keyboard.press("+")
    assert page.evaluate("sonify.timeline.span") == pytest.approx(
        [0, page.evaluate("sonify.player.duration / 2")]
    )
    page.keyboard.press("ArrowRight")
    assert page.evaluate("sonify.player.time") > 0
    page.focus("#loop")
    page.keyboard.press("Enter")
    assert page.evaluate("sonify.player.loop") == page.evaluate("sonify.timeline.span")
    page.keyboard.press("Tab")
    page.keyboard.press("Enter")
    assert page.evaluate("sonify.player.loop") is None
    assert page.evaluate("sonify.timeline.span[1]") == page.evaluate(
        "sonify.player.duration"
    )
    page.focus(".claims summary")
    page.keyboard.press("Enter")
    assert page.locator(".claims details").first.evaluate("(claim) => claim.open")


def pixels_when(canvas, condition):
    """Return the pixels of a canvas once they meet a condition, or after a minute."""
    deadline = time.monotonic() + 60
    while (
        not condition(pixels := canvas.evaluate(PIXELS)) and time.monotonic() < deadline
    ):
        canvas.page.wait_for_timeout(100)
    return pixels


def test_disk_and_modes_move(page):
    for canvas, change in (
        ("#disks canvas", "sonify.player.seek(10.05)"),
        ("#mode-canvas", "0"),
    ):
        handle = page.locator(canvas)
        handle.scroll_into_view_if_needed()
        before = pixels_when(handle, lambda pixels: len(set(pixels)) > 20)
        assert len(set(before)) > 20

        def moved(pixels, before=before):
            return sum(a != b for a, b in zip(before, pixels, strict=True)) > 100

        page.evaluate(change)
        assert moved(pixels_when(handle, moved))
    page.uncheck("#swing")
    canvas = page.locator("#mode-canvas")
    picked = canvas.evaluate(PIXELS)
    page.select_option("#mode", index=3)
    assert pixels_when(canvas, lambda pixels: pixels != picked) != picked


@pytest.mark.parametrize("width", WIDTHS)
def test_it_fits_the_screen(open_page, width, tmp_path):
    page = open_page(width)
    page.wait_for_function(READY, timeout=60_000)
    assert page.evaluate("document.documentElement.scrollWidth") <= width
    shot = page.screenshot(path=tmp_path / f"{width}.png")
    assert len(shot) > 10_000


@pytest.mark.parametrize("screen", SCREENS)
def test_the_first_screen_shows_the_answer_and_the_disk(open_page, screen):
    """Title, answer, Play button, disk and spectrogram are visible without scrolling."""
    width, height = screen
    page = open_page(width, height=height)
    page.wait_for_function(READY, timeout=60_000)
    for part in ("h1", ".lead", "#play", "#disks canvas", ".spectrogram"):
        place = page.locator(part).first.bounding_box()
        assert place["width"] > 0
        assert 0 <= place["y"] < place["y"] + place["height"] <= height, part
    assert page.locator(".lead").inner_text().endswith(".")
    assert page.evaluate("document.documentElement.scrollHeight") <= SCREENS[screen]


def test_a_selected_stretch_loops_and_stays_in_view(page):
    page.click("#end")
    page.wait_for_function("sonify.player.playing")
    span = page.evaluate("sonify.timeline.span")
    page.wait_for_timeout(2500)
    assert page.evaluate("sonify.player.playing")
    assert page.evaluate("sonify.timeline.span") == span
    assert span[0] <= page.evaluate("sonify.player.time") <= span[1] + 0.1
    page.click("#slow")
    page.wait_for_function("sonify.player.playing")
    assert page.evaluate("sonify.player.speed") == 0.1
    assert page.locator("#landing").is_hidden()  # a motion in a vacuum does not land
    page.click("#loop")
    assert not page.evaluate("sonify.timeline.looping")


@pytest.mark.parametrize(("scheme", "width"), [("light", 390), ("dark", 1280)])
def test_it_can_be_used_by_everyone(open_page, scheme, width):
    axe = pytest.importorskip(
        "axe_playwright_python.sync_playwright", reason="needs the extra `browser`"
    )
    page = open_page(width, color_scheme=scheme)
    page.wait_for_function(READY, timeout=60_000)
    page.evaluate(
        "document.querySelectorAll('details').forEach((part) => (part.open = true))"
    )
    found = axe.Axe().run(
        page, options={"runOnly": ["wcag2a", "wcag2aa", "wcag21aa", "wcag22aa"]}
    )
    assert [
        (v["id"], v["nodes"][0]["html"][:200]) for v in found.response["violations"]
    ] == []


def test_scene_and_command_are_copied(open_page):
    page = open_page(permissions=["clipboard-read", "clipboard-write"])
    page.wait_for_function(READY, timeout=60_000)
    page.evaluate(
        "document.querySelectorAll('details').forEach((part) => (part.open = true))"
    )
    for place in ("scene", "command"):
        page.click(f'button[data-copy="#{place}"]')
        page.wait_for_selector("button:has-text('copied')")
        held = page.evaluate("navigator.clipboard.readText()")
        assert held == page.locator(f"#{place}").inner_text().strip()
    assert load_scene("published").replace(
        "numerics.accuracy=draft"
    ).document == tomllib.loads(page.locator("#scene").inner_text())


@pytest.fixture(scope="module")
def address(folder):
    """Return the address at which the folder of the run is served."""
    return address_of(serve, folder.parent, "127.0.0.1", 0)


def test_a_served_page_plays_and_stretches_under_its_policy(browser, folder, address):
    """Chromium logs every violation of the Content-Security-Policy to the console."""
    said = []
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.on("console", lambda message: said.append(message.text))
    page.on("pageerror", lambda error: said.append(str(error)))
    page.goto(f"{address}runs/{folder.name}/")
    until(page, f"({READY})()")
    page.evaluate("sonify.player.set({ position: 17, speed: 0.1, keepPitch: true })")
    page.click("#play")
    until(page, "sonify.player.playing")
    assert page.evaluate(LOUDEST) > 1e-4
    page.evaluate(
        "document.querySelectorAll('details').forEach((part) => (part.open = true))"
    )
    page.locator("figure img").first.scroll_into_view_if_needed()  # loads once visible
    until(page, "document.querySelector('figure img').naturalWidth > 0")
    refused = [
        text for text in said if "Content Security Policy" in text or "violates" in text
    ]
    assert refused == []
    outside = "fetch('http://127.0.0.1:9/').then(() => 'sent', (error) => error.name)"
    assert page.evaluate(outside) == "TypeError"
    assert any("Content Security Policy" in text for text in said)
    page.goto(address)
    assert page.locator("td", has_text="passed").count() == 1
    until(page, f"({READY})()")
    page.close()


def test_two_runs_are_heard_in_turn_on_one_axis_of_time(browser, address):
    page = browser.new_page(viewport={"width": 1280, "height": 900})
    page.goto(address)
    until(page, f"({READY})()")
    page.check("input[name=b]")
    until(page, f"({READY})() && sonify.spectrograms.length == 2")
    one, other = (
        canvas.bounding_box() for canvas in page.locator("#disks canvas").all()
    )
    assert one["y"] == other["y"], "the disks are side by side"
    assert one["x"] + one["width"] <= other["x"]
    page.evaluate("sonify.player.seek(10.0)")
    page.click("#play")
    until(page, "sonify.player.playing")
    before = page.evaluate("sonify.player.time")
    page.click("input[name=run][value='1']")
    until(page, "sonify.player.run === 1 && sonify.player.playing")
    assert page.evaluate(LOUDEST) > 1e-3
    assert before < page.evaluate("sonify.player.time") < before + 10
    assert (
        len(
            set(
                page.evaluate(
                    "sonify.timeline.panels.map((panel) => panel.head.style.left)"
                )
            )
        )
        == 1
    )
    page.close()


def test_nothing_swings_for_those_who_want_it_still(open_page):
    page = open_page(reduced_motion="reduce")
    page.wait_for_function(READY, timeout=60_000)
    assert not page.is_checked("#swing")


def test_a_browser_without_3d_says_so(open_page):
    page = open_page(
        script="HTMLCanvasElement.prototype.getContext = new "
        "Proxy(HTMLCanvasElement.prototype.getContext, "
        "{ apply: (f, self, [kind, ...rest]) => kind.startsWith('webgl') ? null : f.call(self, "
        "kind, ...rest) })"
        "; console.error = console.warn = () => {}"
    )
    page.wait_for_function(READY, timeout=60_000)
    assert "cannot draw 3-D views" in page.locator("#three-notice").inner_text()


def test_a_browser_that_keeps_silent_says_so(open_page):
    page = open_page(
        script="AudioContext.prototype.resume = () => new Promise(() => {})"
    )
    page.wait_for_function(READY, timeout=60_000)
    page.click("#play")
    page.wait_for_selector("#notice:not([hidden])", timeout=60_000)
    assert page.locator("#notice").inner_text().startswith("No sound: ")


def test_a_browser_that_decodes_nothing_still_tells_everything(open_page):
    page = open_page(
        script="OfflineAudioContext.prototype.decodeAudioData = () => Promise.reject(new "
        "Error('no'))"
    )
    page.wait_for_selector("#notice:not([hidden])", timeout=60_000)
    assert "cannot decode" in page.locator("#notice").inner_text()
    assert page.locator("h2:has-text('Findings')").is_visible()
