"""Processor time per mode and sample of the oscillator bank, beside scipy, Csound and Faust: same modes, same force.

Run as `python -m tests.benchmarks.sound_oscillators`. Each competitor is first shown to compute the same samples: scipy
and Faust run the very recursion of the bank; Csound's `mode` opcode has its own, a difference scheme whose samples
scipy reproduces; its pitch is off by (w/fs)^2/24, and it bends modes near fs/pi (15 kHz at 48 kHz) and above. Csound
and Faust are skipped where absent.
"""

import re
import shutil
import subprocess
import tempfile
from pathlib import Path
from resource import RUSAGE_CHILDREN, getrusage
from time import process_time

import numpy as np
import soundfile
from scipy.signal import lfilter

from sonify.sound.oscillators import OscillatorBank

RATE, MODES, SECONDS, BLOCK = 48000, 64, 10.0, 1024
FREQUENCY = np.geomspace(200.0, 12000.0, MODES)
DECAY = 6.908 / np.linspace(2.0, 0.2, MODES)
REPEATS = 5


def best(work) -> float:
    """Return the least processor time [s] of some runs."""
    times = []
    for _ in range(REPEATS):
        began = processor_time()
        work()
        times.append(processor_time() - began)
    return min(times)


def processor_time() -> float:
    """Return the processor time [s] of this process and of those that it has waited for."""
    children = getrusage(RUSAGE_CHILDREN)
    return process_time() + children.ru_utime + children.ru_stime


def biquads(bank) -> tuple[np.ndarray, np.ndarray]:
    """Return numerators and denominators (3, m) of the bank's recursion, force to acceleration."""
    through, first, trace, second, minus_det = bank.step
    b = np.array([through, first - trace * through, second - minus_det * through])
    return b, np.array([np.ones(MODES), -trace, -minus_det])


def by_bank(force, weight):
    """What a user needs: the response of all modes to one force, each with its gain, participation times radiation."""
    bank, out, total = OscillatorBank(FREQUENCY, DECAY, RATE), np.empty((BLOCK, MODES)), np.empty(len(force) - 1)
    for start in range(0, len(total), BLOCK):
        part = force[start : start + BLOCK + 1, None]
        np.matmul(bank.advance(part, out=out[: len(part) - 1]), weight, out=total[start : start + BLOCK])
    return total


def by_bank_alone(g, bank, out):
    for _ in range(int(SECONDS * RATE) // BLOCK):
        bank.advance(g, out=out)


def by_scipy(force, b, a):
    return sum(lfilter(b[:, m], a[:, m], force[:-1]) for m in range(MODES))


FAUST_MAIN = """
#include <cstdio>
#include <cstdlib>
#include <algorithm>
#include <ctime>
#include <vector>
struct Meta { void declare(const char*, const char*) {} };
struct UI {};
struct dsp { virtual ~dsp() {} };
#define FAUSTFLOAT double
%s
int main(int, char** args) {
  size_t n = atol(args[1]);
  std::vector<double> in(n), out(n);
  FILE* file = fopen(args[2], "rb"); if (fread(in.data(), 8, n, file) != n) return 1; fclose(file);
  double least = 1e9;
  for (int k = 0; k < 5; ++k) {
    auto* bank = new mydsp(); bank->init(48000);
    auto began = std::clock();
    for (size_t i = 0; i + 1024 <= n; i += 1024) {
      double* from = in.data() + i; double* to = out.data() + i;
      bank->compute(1024, &from, &to);
    }
    least = std::min(least, double(std::clock() - began) / CLOCKS_PER_SEC);
    delete bank;
  }
  file = fopen(args[3], "wb"); fwrite(out.data(), 8, n, file); fclose(file);
  printf("%%.9f\\n", least);
}
"""


def by_faust(force, b, a, folder, *options):
    """Return samples and seconds of a bank compiled by Faust with g++ -O3, in double precision."""
    sections = ", ".join(f"fi.tf2({','.join(f'{x:.17g}' for x in (*b[:, m], *a[1:, m]))})" for m in range(MODES))
    (folder / "bank.dsp").write_text(f'import("stdfaust.lib");\nprocess = _ <: ({sections}) :> _;\n')
    command = ["faust", "-double", *options, "-lang", "cpp", "bank.dsp"]
    code = subprocess.run(command, cwd=folder, capture_output=True, text=True, check=True).stdout
    code = re.sub(r"virtual void (metadata|buildUserInterface)\(.*?\n\t\}\n", "", code, flags=re.S)
    (folder / "bank.cpp").write_text(FAUST_MAIN % code)
    subprocess.run(
        ["g++", "-O3", "-march=native", "-ffp-contract=fast", "-o", "bank", "bank.cpp"], cwd=folder, check=True
    )
    n = (len(force) - 1) // 1024 * 1024
    force[:n].tofile(folder / "force.raw")
    asked = subprocess.run(
        ["./bank", str(n), "force.raw", "out.raw"], cwd=folder, capture_output=True, text=True, check=True
    )
    return np.fromfile(folder / "out.raw"), float(asked.stdout)


def csound_scheme():
    """Return b, a (3, m) of Csound's `mode`: (y+ - 2y + y-) fs^2 + w/Q (y+ - y-) fs/2 + w^2 y = w fs/2 x, one late."""
    alpha = RATE / (2 * np.pi * FREQUENCY)
    quality = np.pi * FREQUENCY / DECAY
    a0 = 1 / (alpha**2 + alpha / (2 * quality))
    ones = np.ones(MODES)
    return np.array([0 * ones, a0 * alpha / 2, 0 * ones]), np.array(
        [ones, a0 * (1 - 2 * alpha**2), a0 * (alpha**2 - alpha / (2 * quality))]
    )


def by_csound(force, folder):
    """Return samples and seconds of Csound's `mode` opcodes, less the time of the same score without them."""
    soundfile.write(folder / "force.wav", force[:-1], RATE, "DOUBLE")
    quality = np.pi * FREQUENCY / DECAY
    lines = [f"aout += mode(ain, {f:.17g}, {q:.17g})" for f, q in zip(FREQUENCY, quality, strict=True)]
    times = []
    for body in ("\n".join(lines), "aout += ain"):
        head = f"sr = {RATE}\nksmps = 1024\nnchnls = 1\n0dbfs = 1\ninstr 1\n"
        text = f'{head}ain soundin "force.wav"\naout = 0\n{body}\nout aout\nendin\n'
        (folder / "bank.orc").write_text(text)
        (folder / "bank.sco").write_text(f"i 1 0 {SECONDS}\n")
        command = ["csound", "-d", "-m0", "-W", "-f", "-o", "out.wav", "bank.orc", "bank.sco"]
        times.append(best(lambda c=command: subprocess.run(c, cwd=folder, capture_output=True, check=True)))
        if body.startswith("aout += mode"):
            samples = soundfile.read(folder / "out.wav")[0]
    return samples, times[0] - times[1]


def main():
    force = np.random.default_rng(0).normal(size=int(SECONDS * RATE) + 1)
    force[0] = 0
    count = MODES * int(SECONDS * RATE)
    bank = OscillatorBank(FREQUENCY, DECAY, RATE)
    b, a = biquads(bank)
    gain = np.ones(MODES)
    reference = by_bank(force, gain)
    scale = np.abs(reference).max()
    g = np.random.default_rng(1).normal(size=(BLOCK + 1, MODES))
    out = np.empty((BLOCK, MODES))
    rows = [("this bank, a force for each mode, no sum", best(lambda: by_bank_alone(g, bank, out)), 0.0)]
    rows.append(("this bank, one force, sum with gains", best(lambda: by_bank(force, gain)), 0.0))
    apart = np.abs(by_scipy(force, b, a) - reference).max() / scale
    rows.append(("scipy.signal.lfilter", best(lambda: by_scipy(force, b, a)), apart))
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        if shutil.which("faust") and shutil.which("g++"):
            for options in ((), ("-vec", "-lv", "1")):
                samples, seconds = by_faust(force, b, a, folder, *options)
                apart = np.abs(samples - reference[: len(samples)]).max() / scale
                rows.append((f"Faust {' '.join(options)}".strip(), seconds, apart))
        if shutil.which("csound"):
            samples, seconds = by_csound(force, folder)
            expected = by_scipy(force, *csound_scheme())
            samples = samples[: len(expected)]
            rows.append(
                ("Csound mode (its own scheme)", seconds, np.abs(samples - expected).max() / np.abs(expected).max())
            )
    print(f"{MODES} modes, {RATE} Hz, {SECONDS:g} s, one core\n")
    print("| bank | ns per mode and sample | times real time | largest difference / peak |\n|---|---|---|---|")
    for label, seconds, apart in rows:
        print(f"| {label} | {seconds / count * 1e9:.2f} | {SECONDS / seconds:.0f} | {apart:.1e} |")
    flat = 1200 * np.log2(1 - (2 * np.pi * 5000 / RATE) ** 2 / 24)
    print(f"\nPitch of Csound's scheme at 5 kHz: {flat:.0f} cents; of this bank: exact.")


if __name__ == "__main__":
    main()
