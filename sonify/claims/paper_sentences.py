"""Sentences of Kessler & O'Reilly (2002) to which the findings refer."""

_PITCH_RISES = (
    "the acoustic frequencies emitted by the disk and surface exhibit a sharp increase at the end "
    "of the motion",
    "section 1",
)
_ABRUPT_HALT = ("the disk eventually comes to rest in an abrupt manner", "section 1")
_SOUND_SOURCE = (
    "To produce sound, the actual disk and the surface that it moves on vibrates.",
    "section 8",
)
_EXCITED_MODES = (
    "This forcing will excite modes of vibration of the disk and consequently produce sound.",
    "section 8",
)
_CONTACT_LOSS = (
    "we conjecture that the vibrations of the disk and surface will eventually result in it losing "
    "contact with the surface",
    "section 8",
)
_FINAL_IMPACT = (
    "the ensuing impact of the disk and surface constitutes the abrupt end of the disk's motion",
    "section 8",
)
PAPER_SENTENCES: dict[str, tuple[str, str]] = {
    "repeated_slips": (
        "the disk transitions repeatedly between rolling and sliding",
        "section 1",
    ),
    "contact_kept": (
        "Another interesting feature of the normal force is that it is never zero.",
        "section 7",
    ),
    "load_frequency_rises": (
        "a frequency f associated with this force increases as the angle of inclination of the "
        "disk tends to zero",
        "section 7",
    ),
    "load_frequency_reached": (
        "For Tangent Toy's Euler's disk, a value of f = 2.5 corresponds to a frequency of 36 Hz.",
        "figure 4",
    ),
    "energy_falls": (
        "Correspondingly, the total energy of the disk decreases.",
        "section 7",
    ),
    "sliding_costs_more": (
        "during sliding the dissipation of energy is larger than it is during rolling",
        "section 7",
    ),
    "centre_comes_to_rest": (
        "the in-plane motion of the center of mass of the disk diminishes considerably until it is "
        "almost negligible",
        "section 7",
    ),
    "no_singularity": (
        "the model we have developed for Euler's disk does not appear to possess a finite-time "
        "singularity",
        "section 7",
    ),
    "audible_modes": (
        "it has at least four modes of vibration in the audible range of humans",
        "section 8",
    ),
    "pitch_rises": _PITCH_RISES,
    "carrier_rises": _PITCH_RISES,
    "table_tone_rises": _PITCH_RISES,
    "tone_is_precession": (
        "Our model shows that the frequency of the motion increases as the disk declines. This "
        "however is not the primary sound source of the system.",
        "section 8",
    ),
    "tone_was_nutation": (
        "the normal force behavior that we report can be considered as a measure of the forcing "
        "experienced by the actual disk and surface",
        "section 8",
    ),
    "tone_ends_with_the_motion": _ABRUPT_HALT,
    "halt_comes_earlier": _ABRUPT_HALT,
    "modes_carry_the_end": _EXCITED_MODES,
    "carriers_are_modes": _EXCITED_MODES,
    "table_is_louder": _SOUND_SOURCE,
    "table_carries_the_tone": _SOUND_SOURCE,
    "contact_is_lost": _CONTACT_LOSS,
    "table_breaks_contact": _CONTACT_LOSS,
    "vibration_opens_contact": _CONTACT_LOSS,
    "waves_make_the_halt": _FINAL_IMPACT,
}
"""Quoted sentence and its place in the paper, by the key of a finding."""
