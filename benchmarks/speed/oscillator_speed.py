"""Measure processor time per mode and sample of the oscillator bank, scipy, Csound and
Faust for the same modes and force.

Run as `python -m benchmarks.speed.oscillator_speed`. The printed differences show that
all programs compute the same samples. scipy and Faust run the recursion of the bank.
Csound's `mode` opcode has its own difference scheme, which scipy reproduces; its
relative pitch error is (w/fs)^2/24, and modes near fs/pi (15 kHz at 48 kHz) and above
are distorted. Csound and Faust are skipped if they are not installed."""

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

SAMPLE_RATE = 48000
"""Sample rate [Hz]."""

MODE_COUNT = 64

DURATION = 10.0
"""Duration of the sound [s]."""

BLOCK_LENGTH = 1024
"""Samples per call of the bank."""

FREQUENCIES = np.geomspace(200.0, 12000.0, MODE_COUNT)
"""Frequencies of the modes [Hz]."""

DECAY_RATES = 6.908 / np.linspace(2.0, 0.2, MODE_COUNT)
"""Decay rates of the modes [1/s], for reverberation times of 2 s to 0.2 s."""


def smallest_time(work, repeats=5) -> float:
    """Return the smallest processor time [s] of several calls of `work`."""
    times = []
    for _ in range(repeats):
        began = processor_time()
        work()
        times.append(processor_time() - began)
    return min(times)


def processor_time() -> float:
    """Return the processor time [s] of this process and of its ended child
    processes."""
    children = getrusage(RUSAGE_CHILDREN)
    return process_time() + children.ru_utime + children.ru_stime


def biquads(bank) -> tuple[np.ndarray, np.ndarray]:
    """Return numerators and denominators (3, m) of the recursion of the bank, from
    force to acceleration."""
    through, first, trace, second, minus_det = bank.step
    b = np.array([through, first - trace * through, second - minus_det * through])
    return b, np.array([np.ones(MODE_COUNT), -trace, -minus_det])


def by_bank(force, weight):
    """Return the weighted sum of the responses of all modes to one force, as the
    program computes a pressure."""
    bank = OscillatorBank(FREQUENCIES, DECAY_RATES, SAMPLE_RATE)
    out = np.empty((BLOCK_LENGTH, MODE_COUNT))
    total = np.empty(len(force) - 1)
    for start in range(0, len(total), BLOCK_LENGTH):
        part = force[start : start + BLOCK_LENGTH + 1, None]
        np.matmul(
            bank.advance(part, out=out[: len(part) - 1]),
            weight,
            out=total[start : start + BLOCK_LENGTH],
        )
    return total


def by_bank_alone(g, bank, out):
    """Advance the bank with one force per mode, without the sum."""
    for _ in range(int(DURATION * SAMPLE_RATE) // BLOCK_LENGTH):
        bank.advance(g, out=out)


def by_scipy(force, b, a):
    """Return the sum of the responses of the recursions b, a (3, m) by scipy."""
    return sum(lfilter(b[:, m], a[:, m], force[:-1]) for m in range(MODE_COUNT))


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
    """Return samples and processor time [s] of a double-precision bank compiled by
    Faust and g++ -O3."""
    sections = ", ".join(
        f"fi.tf2({','.join(f'{x:.17g}' for x in (*b[:, m], *a[1:, m]))})"
        for m in range(MODE_COUNT)
    )
    (folder / "bank.dsp").write_text(
        f'import("stdfaust.lib");\nprocess = _ <: ({sections}) :> _;\n'
    )
    command = ["faust", "-double", *options, "-lang", "cpp", "bank.dsp"]
    code = subprocess.run(
        command, cwd=folder, capture_output=True, text=True, check=True
    ).stdout
    code = re.sub(
        r"virtual void (metadata|buildUserInterface)\(.*?\n\t\}\n", "", code, flags=re.S
    )
    (folder / "bank.cpp").write_text(FAUST_MAIN % code)
    subprocess.run(
        ["g++", "-O3", "-march=native", "-ffp-contract=fast", "-o", "bank", "bank.cpp"],
        cwd=folder,
        check=True,
    )
    n = (len(force) - 1) // 1024 * 1024
    force[:n].tofile(folder / "force.raw")
    done = subprocess.run(
        ["./bank", str(n), "force.raw", "out.raw"],
        cwd=folder,
        capture_output=True,
        text=True,
        check=True,
    )
    return np.fromfile(folder / "out.raw"), float(done.stdout)


def csound_scheme():
    """Return b, a (3, m) of Csound's `mode`, with a delay of one sample.

    The scheme is (y+ - 2y + y-) fs^2 + w/Q (y+ - y-) fs/2 + w^2 y = w fs/2 x.
    """
    alpha = SAMPLE_RATE / (2 * np.pi * FREQUENCIES)
    quality = np.pi * FREQUENCIES / DECAY_RATES
    a0 = 1 / (alpha**2 + alpha / (2 * quality))
    ones = np.ones(MODE_COUNT)
    return np.array([0 * ones, a0 * alpha / 2, 0 * ones]), np.array(
        [ones, a0 * (1 - 2 * alpha**2), a0 * (alpha**2 - alpha / (2 * quality))]
    )


def by_csound(force, folder):
    """Return samples and seconds of Csound's `mode` opcodes, minus the time of the same
    score without them."""
    soundfile.write(folder / "force.wav", force[:-1], SAMPLE_RATE, "DOUBLE")
    quality = np.pi * FREQUENCIES / DECAY_RATES
    lines = [
        f"aout += mode(ain, {f:.17g}, {q:.17g})"
        for f, q in zip(FREQUENCIES, quality, strict=True)
    ]
    times = []
    for body in ("\n".join(lines), "aout += ain"):
        head = f"sr = {SAMPLE_RATE}\nksmps = 1024\nnchnls = 1\n0dbfs = 1\ninstr 1\n"
        text = f'{head}ain soundin "force.wav"\naout = 0\n{body}\nout aout\nendin\n'
        (folder / "bank.orc").write_text(text)
        (folder / "bank.sco").write_text(f"i 1 0 {DURATION}\n")
        command = [
            "csound",
            "-d",
            "-m0",
            "-W",
            "-f",
            "-o",
            "out.wav",
            "bank.orc",
            "bank.sco",
        ]
        times.append(
            smallest_time(
                lambda c=command: subprocess.run(
                    c, cwd=folder, capture_output=True, check=True
                )
            )
        )
        if body.startswith("aout += mode"):
            samples = soundfile.read(folder / "out.wav")[0]
    return samples, times[0] - times[1]


def main():
    """Print time per mode and sample, real-time factor, and largest difference of each
    program."""
    force = np.random.default_rng(0).normal(size=int(DURATION * SAMPLE_RATE) + 1)
    force[0] = 0
    count = MODE_COUNT * int(DURATION * SAMPLE_RATE)
    bank = OscillatorBank(FREQUENCIES, DECAY_RATES, SAMPLE_RATE)
    b, a = biquads(bank)
    gain = np.ones(MODE_COUNT)
    reference = by_bank(force, gain)
    scale = np.abs(reference).max()
    g = np.random.default_rng(1).normal(size=(BLOCK_LENGTH + 1, MODE_COUNT))
    out = np.empty((BLOCK_LENGTH, MODE_COUNT))
    rows = [
        (
            "this bank, a force for each mode, no sum",
            smallest_time(lambda: by_bank_alone(g, bank, out)),
            0.0,
        )
    ]
    rows.append(
        (
            "this bank, one force, sum with gains",
            smallest_time(lambda: by_bank(force, gain)),
            0.0,
        )
    )
    apart = np.abs(by_scipy(force, b, a) - reference).max() / scale
    rows.append(
        ("scipy.signal.lfilter", smallest_time(lambda: by_scipy(force, b, a)), apart)
    )
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
                (
                    "Csound mode (its own scheme)",
                    seconds,
                    np.abs(samples - expected).max() / np.abs(expected).max(),
                )
            )
    print(f"{MODE_COUNT} modes, {SAMPLE_RATE} Hz, {DURATION:g} s, one core\n")
    print(
        "| bank | ns per mode and sample | times real time | largest difference / peak "
        "|\n|---|---|---|---|"
    )
    for label, seconds, apart in rows:
        print(
            f"| {label} | {seconds / count * 1e9:.2f} | {DURATION / seconds:.0f} | {apart:.1e} |"
        )
    flat = 1200 * np.log2(1 - (2 * np.pi * 5000 / SAMPLE_RATE) ** 2 / 24)
    print(
        f"\nPitch of Csound's scheme at 5 kHz: {flat:.0f} cents; of this bank: exact."
    )


if __name__ == "__main__":
    main()
