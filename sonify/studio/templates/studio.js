"use strict";
const $ = (id) => document.getElementById(id);
const OPENING = ""; // place of the shipped run
const STORE = "sonify-studio";
const isEditable = Boolean($("scene-form"));
const sliderSteps = 1000;
let controls = [];
let changed = {};
let abort = null; // of the running request
let analysis = null; // of the request that analyses a recording
let takesAbort = null; // of the request that writes takes
let view = null; // the workbench
let shown = { a: null, b: null }; // places of the runs in the workbench
let former = null; // place of the run that was shown as A before the present one
let recording = null; // data of the recording
let began = 0; // time of the start of the running request [ms]
let displays = 0; // number of calls of display()

const rounded = (value) => Number(value.toPrecision(4));
const path = (place) => place.split("/").map(encodeURIComponent).join("/");

function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

// What survives a reload

function stored() {
  try {
    return JSON.parse(localStorage.getItem(STORE)) ?? {};
  } catch {
    return {};
  }
}

function store(values) {
  try {
    localStorage.setItem(STORE, JSON.stringify({ ...stored(), ...values }));
  } catch {
    // without storage, a reload starts anew
  }
}

// Runs in the workbench

const loaded = new Map();

async function dataOf(place) {
  if (!loaded.has(place)) {
    const answer = await fetch(place === OPENING ? "opening" : `data/${path(place)}`);
    if (!answer.ok) throw new Error("this run has no page");
    loaded.set(place, await answer.json());
    if (loaded.size > 4) loaded.delete(loaded.keys().next().value);
  }
  return loaded.get(place);
}

function rowOf(place) {
  return document.querySelector(`#run-list tr[data-place="${CSS.escape(place)}"]`);
}

/** Return a run or a recording with its end at the end of another run. */
function aligned(other, run) {
  const shift = run.source_end - other.source_end;
  const { start, duration, source_end, delay } = other;
  return { ...other, start: start + shift, duration: duration + shift, source_end: source_end + shift, delay: delay + shift };
}

/** Show run `a` and, if given, run `b` or the recording; keep position and settings unless given. */
async function display(places, { position, plays } = {}) {
  const number = ++displays;
  if (shown.a !== null && shown.a !== places.a) former = shown.a;
  shown = { a: places.a, b: places.b ?? null };
  const named = async (place) => ({ ...(await dataOf(place)), name: rowOf(place)?.dataset.name ?? "toy" });
  const given = [await named(shown.a)];
  if (shown.b !== null) given.push(aligned(await named(shown.b), given[0]));
  else if (recording) given.push(aligned({ ...recording, colours: given[0].colours }, given[0]));
  if (number !== displays) return;
  const isTrueScale = document.querySelector("#natural")?.checked;
  position ??= view?.player.position;
  if (view?.player.playing) [position, plays] = [view.player.time, plays ?? true];
  view?.close();
  $("bench").replaceChildren($("workbench-template").content.cloneNode(true));
  $("curves-and-modes").replaceChildren(document.querySelector("#bench .desk"));
  const row = rowOf(shown.a);
  $("run-name").textContent = given[0].name;
  $("run-headline").textContent = row?.dataset.headline ?? given[0].headline ?? "";
  $("comparison").textContent = shown.b === null ? "" : comparison(row, rowOf(shown.b));
  offerComparison();
  markChoice();
  store({ a: shown.a, b: shown.b });
  const made = (view = window.showRuns(given));
  made.player.onChange(() => made.player.playing && $("live")?.pause());
  await made.ready;
  if (number !== displays) return;
  if (isTrueScale) document.querySelector("#natural").click();
  if (position) await made.player.seek(position);
  if (plays) await made.player.play();
}

/** Return sentences on length and loudness of run B relative to run A, from their rows in the list. */
function comparison(a, b) {
  const value = (row, name) => (row?.dataset[name] ? Number(row.dataset[name]) : NaN);
  const [end, other] = [value(a, "end"), value(b, "end")];
  const seconds = other - end;
  const louder = Math.round(value(b, "level") - value(a, "level"));
  const parts = [];
  if (Math.abs(seconds) < 0.005 * end) parts.push(`lasts ${rounded3(other)} s, as long as A`);
  else if (seconds) parts.push(`lasts ${rounded3(other)} s, ${rounded3(Math.abs(seconds))} s ${seconds > 0 ? "longer" : "shorter"} than A`);
  if (louder === 0) parts.push("is as loud as A");
  else if (louder) parts.push(`is ${Math.abs(louder)} dB ${louder > 0 ? "louder" : "quieter"} than A at the listener`);
  if (!parts.length) return "";
  const hint = louder ? " To hear the difference in loudness, tick “as loud as it is”." : "";
  const excessive = [a, b].flatMap((row, i) => (row?.dataset.excessive ? ["AB"[i]] : []));
  const reserve = excessive.length ? ` But in ${excessive.join(" and ")} the table takes more power than the disk loses: its sound is too loud.` : "";
  return `B ${parts.join(", and ")}.${reserve}${hint}`;
}

const rounded3 = (value) => Number(value.toPrecision(3));

/** Offer to compare run A with the run that was shown before it. */
function offerComparison() {
  const name = former !== null && rowOf(former)?.dataset.name;
  $("compare-box").hidden = shown.b !== null || !name || former === shown.a;
  if (name) $("compare").textContent = `Compare with ${name}`;
}

function attempt(promise) {
  promise.catch((error) => showFault(`The run cannot be shown: ${error.message}.`));
}

function markChoice() {
  for (const which of ["a", "b"]) {
    for (const radio of document.querySelectorAll(`#run-list input[name=${which}]`)) {
      radio.checked = radio.value === shown[which];
    }
  }
}

$("run-list").addEventListener("change", ({ target }) => {
  if (target.name === "a") attempt(display({ ...shown, a: target.value }));
  if (target.name === "b") attempt(display({ ...shown, b: target.value }));
});

$("run-list").addEventListener("click", ({ target }) => {
  if (target.name === "b" && target.value === shown.b) attempt(display({ a: shown.a })); // a second click removes B
});

$("compare").addEventListener("click", () => attempt(display({ a: shown.a, b: former })));

async function refreshList() {
  const answer = await fetch("list", { cache: "no-store" });
  if (answer.ok) $("run-list").innerHTML = await answer.text();
  markChoice();
}

/** Show the runs of the last visit, or the first run. */
async function openFirst() {
  await refreshList(); // the browser shows an old list after its Back button
  const before = stored();
  const exists = (place) => place === OPENING || Boolean(rowOf(place));
  const first = [...document.querySelectorAll("#run-list input[name=a]:not(:disabled)")][0]?.value;
  const a = typeof before.a === "string" && exists(before.a) ? before.a : isEditable ? OPENING : first;
  if (a === undefined) return;
  await display({ a, b: typeof before.b === "string" && exists(before.b) ? before.b : null });
}

// Controls of the scene

function fromSlider(control, position) {
  const share = position / sliderSteps;
  if (control.logarithmic) return rounded(control.low * (control.high / control.low) ** share);
  return rounded(control.low + (control.high - control.low) * share);
}

function toSlider(control, value) {
  if (!(value > 0) && control.logarithmic) return 0;
  const share = control.logarithmic
    ? Math.log(value / control.low) / Math.log(control.high / control.low)
    : (value - control.low) / (control.high - control.low);
  return Math.round(sliderSteps * Math.min(Math.max(share, 0), 1));
}

const nameOf = (control) => (control.unit ? `${control.label} [${control.unit}]` : control.label);

function change(control, value) {
  changed[control.key] = value;
  store({ scene: $("scene").value, changed });
  showFault("", control.key);
}

function numberField(control) {
  const id = `control-${control.key}`;
  const label = element("label", { htmlFor: id, textContent: nameOf(control), title: control.meaning });
  const number = element("input", { type: "number", id, step: "any" });
  const slider = element("input", { type: "range", min: 0, max: sliderSteps, step: 1 });
  slider.setAttribute("aria-label", `${nameOf(control)}, slider`);
  if (control.optional) number.placeholder = "none";
  const write = (value) => {
    if (value !== undefined) number.value = value === null ? "" : rounded(value * control.factor);
    slider.setAttribute("aria-valuetext", number.value || "none");
  };
  const value = control.key in changed ? changed[control.key] : control.value;
  write(value);
  slider.value = toSlider(control, value);
  slider.addEventListener("input", () => {
    write(fromSlider(control, Number(slider.value)));
    change(control, fromSlider(control, Number(slider.value)));
  });
  number.addEventListener("input", () => {
    const typed = number.value === "" ? null : rounded(Number(number.value) / control.factor);
    if (typed !== null) slider.value = toSlider(control, typed);
    write();
    change(control, typed);
  });
  return [label, number, slider];
}

function choiceField(control) {
  const id = `control-${control.key}`;
  const label = element("label", { htmlFor: id, textContent: control.label, title: control.meaning });
  const list = element("select", { id });
  for (const [value, textContent] of Object.entries(control.choices)) {
    list.append(element("option", { value, textContent }));
  }
  list.value = control.key in changed ? changed[control.key] : control.value;
  list.addEventListener("change", () => {
    change(control, list.value);
    if (control.key === "surface") showRemarks(list.value ? ["Friction and roughness remain those of the scene; change them, too, if another table has others."] : []);
  });
  return [label, list];
}

async function showControls(values = {}) {
  const option = $("scene").selectedOptions[0];
  $("summary").textContent = option.dataset.summary;
  const answer = await fetch(`controls/${encodeURIComponent(option.value)}`);
  controls = await answer.json();
  changed = values;
  store({ scene: option.value, changed });
  showFault("");
  showRemarks([]);
  const fields = (isMain) =>
    controls
      .filter((control) => control.is_main === isMain)
      .map((control) => {
        const parts = Object.keys(control.choices).length ? choiceField(control) : numberField(control);
        const fault = element("span", { id: `fault-${control.key}`, className: "fault" });
        parts[1].setAttribute("aria-describedby", fault.id);
        return element("div", { className: "field" }, ...parts, fault);
      });
  $("controls").replaceChildren(...fields(true));
  $("further-controls").replaceChildren(...fields(false));
}

function showFault(sentence, key = "") {
  const field = key && $(`control-${key}`);
  if (!field) {
    if ($("fault")) $("fault").textContent = sentence;
    return;
  }
  $(`fault-${key}`).textContent = sentence;
  field.setAttribute("aria-invalid", sentence ? "true" : "false");
  if (!sentence) return;
  field.closest("details")?.setAttribute("open", "");
  field.focus();
}

function showRemarks(lines) {
  $("remarks").textContent = lines.join(" ");
}

// Runs

async function* linesOf(response) {
  const reader = response.body.pipeThrough(new TextDecoderStream()).getReader();
  let text = "";
  for (;;) {
    const { value, done } = await reader.read();
    if (done) return;
    text += value;
    const lines = text.split("\n");
    text = lines.pop();
    for (const line of lines) yield JSON.parse(line);
  }
}

function progressText(status) {
  if (status.before) return `waiting for ${status.before} earlier ${status.before > 1 ? "jobs" : "job"}`;
  return status.line || "starting";
}

function showProgress(status) {
  $("doing").textContent = progressText(status);
  const seconds = Math.round((performance.now() - began) / 1000);
  const expected = status.exceeded ? `more than the ${status.expected} expected` : `about ${status.expected} in all`;
  $("elapsed").textContent = status.expected ? `${seconds} s so far; ${expected} on two idle cores` : "";
  if (status.share === null || status.share === undefined) $("progress").removeAttribute("value");
  else $("progress").value = status.share;
}

function busy(on) {
  $("run").disabled = on;
  $("stop").hidden = !on;
  $("progress-box").hidden = !on;
  if (on) began = performance.now();
  if (on) showProgress({ line: "", share: null });
}

/** Play a sound while it is rendered; the Play button of the workbench pauses it. */
function playLive(address) {
  view?.player.pause();
  $("live").src = address;
  $("live").play().catch(() => {});
}

function endLive() {
  $("live").pause();
  $("live").removeAttribute("src");
  $("live").load();
}

async function finishRun(status) {
  const plays = !$("live").paused && !$("live").ended;
  const position = plays ? $("live").currentTime : 0;
  await refreshList();
  await dataOf(status.place);
  const now = plays ? $("live").currentTime : position;
  endLive();
  await display({ a: status.place, b: shown.b }, { position: now, plays });
}

async function runScene(event) {
  event?.preventDefault();
  if (abort) return;
  for (const control of controls) showFault("", control.key);
  showFault("");
  showRemarks([]);
  abort = new AbortController();
  busy(true);
  let streams = false;
  try {
    const body = JSON.stringify({ scene: $("scene").value, values: changed });
    const response = await fetch("runs", { method: "POST", body, signal: abort.signal });
    if (!response.ok) {
      const status = await response.json();
      showFault(status.error, status.key);
      return;
    }
    for await (const status of linesOf(response)) {
      if (status.error) showFault(status.error, status.key);
      const notices = status.notices ?? status.result?.notices;
      if (notices) showRemarks(notices);
      if (status.streams && !streams) playLive(status.stream);
      streams ||= status.streams;
      if (status.done) await finishRun(status);
      else if (!status.error) showProgress(status);
    }
  } catch (error) {
    showFault(error.name === "AbortError" ? "The run was cancelled." : "The studio does not respond; is it still running?");
  } finally {
    abort = null;
    endLive();
    busy(false);
  }
}

// Takes

async function writeTakes(event) {
  event.preventDefault();
  const state = $("takes-state");
  if (takesAbort) return;
  takesAbort = new AbortController();
  $("takes-files").replaceChildren();
  $("takes-write").disabled = true;
  $("takes-stop").hidden = false;
  state.textContent = "starting";
  try {
    const last = $("takes-last").value;
    const body = JSON.stringify({
      scene: $("scene").value,
      values: changed,
      takes: Number($("takes-count").value),
      last: last === "" ? null : Number(last),
      audible: $("takes-audible").checked,
    });
    const response = await fetch("takes", { method: "POST", body, signal: takesAbort.signal });
    if (!response.ok) {
      state.textContent = (await response.json()).error;
      return;
    }
    for await (const status of linesOf(response)) {
      state.textContent = status.error ?? (status.done ? `Written into the folder ${status.place}:` : progressText(status));
      if (!status.done) continue;
      $("takes-files").replaceChildren(...status.result.files.map((name) => takeItem(`runs/${path(status.place)}/${encodeURIComponent(name)}`, name)));
    }
  } catch (error) {
    state.textContent = error.name === "AbortError" ? "The takes were cancelled." : "The studio does not respond; is it still running?";
  } finally {
    takesAbort = null;
    $("takes-write").disabled = false;
    $("takes-stop").hidden = true;
  }
}

/** Return a list item with a link to a file and, for a sound, a player. */
function takeItem(href, name) {
  const link = element("a", { href, download: name, textContent: name });
  if (!name.endsWith(".wav")) return element("li", {}, link);
  const player = element("audio", { controls: true, preload: "none", src: href });
  player.setAttribute("aria-label", `Play ${name}`);
  return element("li", {}, player, link);
}

// Recordings

function wavOf(sound) {
  const samples = sound.getChannelData(0);
  const bytes = new DataView(new ArrayBuffer(44 + 2 * samples.length));
  const text = (at, word) => [...word].forEach((letter, i) => bytes.setUint8(at + i, letter.charCodeAt(0)));
  text(0, "RIFF");
  bytes.setUint32(4, 36 + 2 * samples.length, true);
  text(8, "WAVEfmt ");
  bytes.setUint32(16, 16, true);
  bytes.setUint16(20, 1, true);
  bytes.setUint16(22, 1, true);
  bytes.setUint32(24, sound.sampleRate, true);
  bytes.setUint32(28, 2 * sound.sampleRate, true);
  bytes.setUint16(32, 2, true);
  bytes.setUint16(34, 16, true);
  text(36, "data");
  bytes.setUint32(40, 2 * samples.length, true);
  for (let i = 0; i < samples.length; i++) {
    bytes.setInt16(44 + 2 * i, Math.round(32767 * Math.min(Math.max(samples[i], -1), 1)), true);
  }
  return bytes.buffer;
}

/** Return a file as WAV if the browser can decode it, and as it is otherwise. */
async function decoded(file) {
  const context = new AudioContext({ sampleRate: 48000 });
  try {
    return wavOf(await context.decodeAudioData(await file.arrayBuffer()));
  } catch {
    return file;
  } finally {
    context.close();
  }
}

async function analyse(file, span = {}) {
  const state = $("recording-state");
  $("drop").scrollIntoView({ block: "nearest" });
  $("recording").replaceChildren();
  state.textContent = "reading the recording";
  analysis?.abort();
  const { signal } = (analysis = new AbortController());
  $("recording-stop").hidden = false;
  try {
    const body = await decoded(file);
    const query = new URLSearchParams({
      scene: $("scene").value,
      values: JSON.stringify(changed),
      name: file.name ?? "",
    });
    for (const end of ["from", "to"]) {
      const value = span[end] ?? $(end).value;
      if (value !== "") query.set(end, value);
    }
    const response = await fetch(`recordings?${query}`, { method: "POST", body, signal });
    if (response.status === 413) {
      state.textContent = await response.text();
      return;
    }
    if (!response.ok) {
      const status = await response.json();
      state.textContent = status.error;
      showFault(status.error, status.key);
      return;
    }
    let summary = null; // the one that is shown; the fit may change it
    for await (const status of linesOf(response)) {
      const doing = status.found ? `First results; next: ${progressText(status)}` : progressText(status);
      state.textContent = status.error ?? (status.done ? "" : doing);
      const result = status.result ?? status.found;
      if (!result || (!status.done && result.summary.join() === summary)) continue;
      await showRecording({ result, folder: status.folder, isFirst: summary === null }, file, span);
      summary = result.summary.join();
    }
  } catch {
    if (!signal.aborted) state.textContent = "The studio does not respond; is it still running?";
    else if (signal === analysis.signal) state.textContent = "The analysis was stopped.";
  } finally {
    if (signal === analysis.signal) $("recording-stop").hidden = true;
  }
}

/** Show results of a recording, the first ones or those after its fit, and play it as B. */
async function showRecording({ result, folder, isFirst }, file, span) {
  const parts = result.summary.map((line) => element("p", { textContent: line }));
  if (result.runs.length > 1) {
    const inOrder = [...result.runs].sort((one, other) => one.start - other.start);
    const choices = inOrder.map(({ end, high }, i) => {
      const from = i ? inOrder[i - 1].high : (span.from ?? 0); // all of the sound since the run before
      const button = element("button", { type: "button", textContent: `run that ends at ${end.toFixed(1)} s` });
      button.addEventListener("click", () => analyse(file, { from, to: high + 1 }));
      return button;
    });
    parts.push(element("p", { className: "actions" }, ...choices));
  }
  const [first, ...others] = ["spectrogram.png", ...result.pictures].filter(
    (name, i, all) => result.pictures.includes(name) && all.indexOf(name) === i,
  );
  if (first) parts.push(picture(folder, first));
  if (result.details.length) {
    const lines = result.details.map((line) => element("p", { textContent: line }));
    const gallery = others.map((name) => picture(folder, name));
    parts.push(element("details", {}, element("summary", { textContent: "Details" }), ...lines, ...gallery));
  }
  $("recording").replaceChildren(...parts);
  if (!result.runs.length) return;
  const answer = await fetch(`${folder}recording.json`);
  if (!answer.ok) return;
  const heard = await answer.json();
  if (!isFirst && recording?.source_end === heard.source_end) return;
  recording = heard;
  attempt(display({ a: shown.a ?? OPENING }));
}

/** Return a picture that a click enlarges. */
function picture(folder, name) {
  const words = name.replace(".png", "").replaceAll("_", " ");
  const button = element("button", { type: "button", className: "picture" }, element("img", { src: folder + name, alt: `Picture of the recording: ${words}` }));
  button.setAttribute("aria-expanded", "false");
  button.addEventListener("click", () => button.setAttribute("aria-expanded", String(button.classList.toggle("large"))));
  return button;
}

let recorder = null;

/** Show the level of a microphone [dB re full scale] until the stream ends. */
function showLevel(stream) {
  const context = new AudioContext();
  const meter = new AnalyserNode(context, { fftSize: 2048 });
  context.createMediaStreamSource(stream).connect(meter);
  const block = new Float32Array(meter.fftSize);
  $("level-box").hidden = false;
  const update = () => {
    if (!stream.active) {
      $("level-box").hidden = true;
      context.close();
      return;
    }
    meter.getFloatTimeDomainData(block);
    const peak = block.reduce((most, x) => Math.max(most, Math.abs(x)), 1e-6);
    $("level").value = 20 * Math.log10(peak);
    requestAnimationFrame(update);
  };
  update();
}

async function toggleRecording() {
  const button = $("record");
  if (recorder) {
    recorder.stop();
    return;
  }
  try {
    const quiet = { echoCancellation: false, noiseSuppression: false, autoGainControl: false };
    const stream = await navigator.mediaDevices.getUserMedia({ audio: quiet });
    const pieces = [];
    recorder = new MediaRecorder(stream);
    recorder.ondataavailable = (event) => pieces.push(event.data);
    recorder.onstop = () => {
      stream.getTracks().forEach((track) => track.stop());
      recorder = null;
      button.textContent = "Record";
      button.setAttribute("aria-pressed", "false");
      analyse(new Blob(pieces));
    };
    recorder.start();
    showLevel(stream);
    button.textContent = "Stop recording";
    button.setAttribute("aria-pressed", "true");
  } catch {
    $("recording-state").textContent = "The browser does not allow access to the microphone.";
  }
}

function addForm() {
  const before = stored();
  const known = [...$("scene").options].some(({ value }) => value === before.scene);
  if (known) $("scene").value = before.scene;
  showControls(known ? (before.changed ?? {}) : {});
  $("scene").addEventListener("change", () => showControls());
  $("reset").addEventListener("click", () => showControls());
  $("scene-form").addEventListener("submit", runScene);
  $("stop").addEventListener("click", () => abort?.abort());
  $("takes-form").addEventListener("submit", writeTakes);
  $("takes-stop").addEventListener("click", () => takesAbort?.abort());
  $("record").addEventListener("click", toggleRecording);
  $("recording-stop").addEventListener("click", () => analysis?.abort());
  $("file").addEventListener("change", () => $("file").files[0] && analyse($("file").files[0]));
  document.addEventListener("dragover", (event) => {
    event.preventDefault();
    $("drop").classList.add("over");
  });
  document.addEventListener("dragleave", () => $("drop").classList.remove("over"));
  document.addEventListener("drop", (event) => {
    event.preventDefault();
    $("drop").classList.remove("over");
    if (event.dataTransfer.files[0]) analyse(event.dataTransfer.files[0]);
  });
  $("bench").addEventListener(
    "click",
    (event) => {
      const live = $("live");
      if (!event.target.closest("#play") || !live.currentSrc || !live.hasAttribute("src") || live.ended) return;
      event.stopPropagation();
      if (live.paused) live.play();
      else live.pause();
    },
    true,
  );
  for (const kind of ["play", "pause"]) {
    $("live").addEventListener(kind, () => {
      const play = document.querySelector("#play");
      if (play && !view?.player.playing) play.textContent = $("live").paused ? "Play" : "Pause";
    });
  }
}

if (isEditable) addForm();
attempt(openFirst());
