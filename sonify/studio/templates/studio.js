"use strict";
const $ = (id) => document.getElementById(id);
const sliderSteps = 1000;
let controls = [];
let changed = {};
let abort = null;
let chosen = null;

const rounded = (value) => Number(value.toPrecision(4));

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

function element(tag, properties = {}, ...children) {
  const made = Object.assign(document.createElement(tag), properties);
  made.append(...children);
  return made;
}

function nameOf(control) {
  const words = control.key.replace("_deg", "").split(".");
  const name = words.length > 1 ? `${words[0]}: ${words[1]}` : words[0];
  return control.unit ? `${name} [${control.unit}]` : name;
}

function numberField(control) {
  const id = `control-${control.key}`;
  const label = element("label", { htmlFor: id, textContent: nameOf(control), title: control.meaning });
  const number = element("input", { type: "number", id, step: "any" });
  number.value = control.value === null ? "" : rounded(control.value);
  if (control.optional) number.placeholder = "none";
  const slider = element("input", { type: "range", min: 0, max: sliderSteps, step: 1 });
  slider.setAttribute("aria-label", `${nameOf(control)}, slider`);
  const updateSliderText = () => slider.setAttribute("aria-valuetext", number.value || "none");
  slider.value = toSlider(control, control.value);
  updateSliderText();
  slider.addEventListener("input", () => {
    number.value = fromSlider(control, Number(slider.value));
    changed[control.key] = Number(number.value);
    updateSliderText();
    showFault("", control.key);
  });
  number.addEventListener("input", () => {
    changed[control.key] = number.value === "" ? null : Number(number.value);
    if (number.value !== "") slider.value = toSlider(control, Number(number.value));
    updateSliderText();
    showFault("", control.key);
  });
  return [label, number, slider];
}

function choiceText(control, choice) {
  if (choice === "") return "as in the scene";
  return control.key === "surface" ? `as in ${choice}` : choice;
}

function choiceField(control) {
  const id = `control-${control.key}`;
  const label = element("label", { htmlFor: id, textContent: nameOf(control).replace(": name", ""), title: control.meaning });
  const list = element("select", { id });
  for (const choice of control.choices) {
    list.append(element("option", { value: choice, textContent: choiceText(control, choice) }));
  }
  list.value = control.value;
  list.addEventListener("change", () => {
    changed[control.key] = list.value;
    showFault("", control.key);
  });
  return [label, list];
}

async function showControls() {
  const option = $("scene").selectedOptions[0];
  $("summary").textContent = option.dataset.summary;
  const answer = await fetch(`controls/${encodeURIComponent(option.value)}`);
  controls = await answer.json();
  changed = {};
  showFault("");
  showNotices([]);
  $("controls").replaceChildren(
    ...controls.map((control) => {
      const parts = control.choices.length ? choiceField(control) : numberField(control);
      const fault = element("span", { id: `fault-${control.key}`, className: "fault" });
      parts[1].setAttribute("aria-describedby", fault.id);
      return element("div", { className: "field" }, ...parts, fault);
    }),
  );
}

function showFault(sentence, key = "") {
  const field = key && $(`control-${key}`);
  if (!field) {
    $("fault").textContent = sentence;
    return;
  }
  $(`fault-${key}`).textContent = sentence;
  field.setAttribute("aria-invalid", sentence ? "true" : "false");
  if (sentence) field.focus();
}

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

function showNotices(lines) {
  $("notice").textContent = lines.join(" ");
}

function progressText(status) {
  if (status.before) return `waiting for ${status.before} earlier ${status.before > 1 ? "jobs" : "job"}`;
  return status.line || "starting";
}

function chooseRun(run) {
  const player = $("player");
  const position = player.currentTime;
  const plays = !player.paused;
  const first = chosen === null;
  chosen = run;
  player.src = run.sound;
  player.addEventListener("loadedmetadata", () => {
    player.currentTime = Math.min(position, player.duration);
    if (plays || first || run.fresh) player.play().catch(() => {});
    run.fresh = false;
  }, { once: true });
  showPage(run);
}

function showPage(run) {
  if (chosen !== run) return;
  $("page").hidden = !run.done;
  if (run.done && $("page").getAttribute("src") !== run.page) $("page").src = run.page;
}

function addRun(run) {
  const id = `run-${document.querySelectorAll("#runs li").length + 1}`;
  const radio = element("input", { type: "radio", name: "chosen", id, checked: true });
  radio.addEventListener("change", () => chooseRun(run));
  run.label = element("label", { htmlFor: id, textContent: ` ${run.name}` });
  $("runs").append(element("li", {}, radio, run.label));
  $("runs-box").hidden = false;
  $("empty").hidden = true;
  $("player").currentTime = 0;
  run.label.scrollIntoView({ block: "nearest" });
  chooseRun(run);
}

function nameOfRun() {
  const words = Object.entries(changed).map(([key, value]) => `${key} = ${value ?? "none"}`);
  return [$("scene").value, ...words].join(", ");
}

async function runScene(event) {
  event.preventDefault();
  if (abort) return;
  const scene = $("scene").value;
  const values = { ...changed };
  const run = { name: nameOfRun(), fresh: true, added: false, done: false };
  for (const control of controls) showFault("", control.key);
  showFault("");
  showNotices([]);
  abort = new AbortController();
  busy(true);
  try {
    const response = await fetch("runs", {
      method: "POST",
      body: JSON.stringify({ scene, values }),
      signal: abort.signal,
    });
    if (!response.ok) {
      const status = await response.json();
      showFault(status.error, status.key);
      return;
    }
    for await (const status of linesOf(response)) {
      if (status.error) showFault(status.error, status.key);
      const notices = status.notices ?? status.result?.notices;
      if (notices) showNotices(notices);
      if ((status.streams || status.heard) && !run.added) {
        const sound = status.heard ? status.sound : status.stream;
        Object.assign(run, { sound, page: status.page, added: true });
        addRun(run);
      }
      if (status.heard && run.sound !== status.sound) {
        run.sound = status.sound;
        if (chosen === run) chooseRun(run);
      }
      if (status.done) {
        run.done = true;
        run.label.textContent = ` ${run.name}: ${status.result.outcome}`;
        showPage(run);
      } else showProgress(status);
    }
  } catch (error) {
    showFault(error.name === "AbortError" ? "The run was cancelled." : "The studio does not respond; is it still running?");
  } finally {
    abort = null;
    busy(false);
  }
}

function busy(on) {
  $("run").disabled = on;
  $("stop").hidden = !on;
  $("progress-box").hidden = !on;
  if (on) showProgress({ line: "", share: null });
}

function showProgress(status) {
  $("doing").textContent = progressText(status);
  if (status.share === null || status.share === undefined) $("progress").removeAttribute("value");
  else $("progress").value = status.share;
}

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

async function analyse(file) {
  const state = $("recording-state");
  $("recording").replaceChildren();
  state.textContent = "reading the recording";
  try {
    const context = new AudioContext({ sampleRate: 48000 });
    let body = file; // the studio reads what the browser cannot decode, or says why not
    try {
      body = wavOf(await context.decodeAudioData(await file.arrayBuffer()));
    } catch {
      // the file itself is sent
    } finally {
      context.close();
    }
    const query = new URLSearchParams({
      scene: $("scene").value,
      values: JSON.stringify(changed),
      name: file.name ?? "",
    });
    for (const end of ["from", "to"]) if ($(end).value !== "") query.set(end, $(end).value);
    const response = await fetch(`recordings?${query}`, { method: "POST", body });
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
    const compare = () => chosen?.name === nameOfRun() || $("scene-form").requestSubmit(); // run the simulation
    if (body !== file) compare();
    for await (const status of linesOf(response)) {
      state.textContent = status.error ?? (status.done ? "" : progressText(status));
      if (!status.done) continue;
      showRecording(status);
      if (body === file && status.result.fit.length) compare();
    }
  } catch {
    state.textContent = "The studio does not respond; is it still running?";
  }
}

function showRecording(status) {
  const list = (title, lines) => [
    element("h3", { textContent: title }),
    ...lines.map((line) => element("p", { textContent: line })),
  ];
  const pictures = status.result.pictures.map((name) =>
    element("img", { src: status.folder + name, alt: `Picture of the recording: ${name.replace(".png", "")}` }),
  );
  const verdict = status.result.fit.length ? list(`Compared with ${$("scene").value}`, status.result.fit) : [];
  const gallery = element("div", { className: "pictures" }, ...pictures);
  $("recording").replaceChildren(...verdict, ...list("Analysis of the recording", status.result.heard), gallery);
}

let recorder = null;

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
    button.textContent = "Stop recording";
    button.setAttribute("aria-pressed", "true");
  } catch {
    $("recording-state").textContent = "The browser does not allow access to the microphone.";
  }
}

$("scene").addEventListener("change", showControls);
$("scene-form").addEventListener("submit", runScene);
$("stop").addEventListener("click", () => abort?.abort());
$("record").addEventListener("click", toggleRecording);
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
showControls();
