"""What a run models and what it leaves out, said before the numbers."""

from dataclasses import dataclass

HEARING_LIMIT = 20e3
"""Modes above this are not sought [Hz]."""


@dataclass(frozen=True, kw_only=True)
class Plan:
    """Sentences on what is modelled and what is not; `highest_mode` [Hz] bounds the modes that are sought."""

    modelled: list[str]
    left_out: list[str]
    highest_mode: float


def plan_of(scene, motion=None, silence=()) -> Plan:
    """Return the plan of a scene; with the motion it also says how that ended, and why a sound tells nothing."""
    heard = min(HEARING_LIMIT, scene.audio.sample_rate / 2)
    ending = [] if motion is None else [f"The motion ends at t = {motion.t[-1]:.6g} s: {motion.outcome.sentence}."]
    return Plan(
        modelled=["A rigid disk rolls and slides on a rigid plane.", CONTACT[scene.support.kind], *RADIATION, *ending],
        left_out=[*LEFT_OUT, f"The sound of modes above {heard:g} Hz.", *unsettled(motion), *silence],
        highest_mode=HEARING_LIMIT,
    )


def unsettled(motion) -> list[str]:
    """Return the warning that a sound breaks off, for a motion that did not reach its end."""
    if motion is None or motion.outcome.name == "SETTLED":
        return []
    return [f"The end of the motion and its sound: {motion.outcome.sentence}."]


CONTACT = {
    "patch": "The elastic modes are those of the disk held at a patch of its rim, which travels with the contact; the "
    "contact force drives them through the rigid acceleration that it causes.",
    "free": "The elastic modes are those of the free disk; the contact force drives them where the contact is.",
}
RADIATION = (
    "The upper face radiates into the half space above the table (Rayleigh's integral with the table as baffle): heave "
    "and tilt of the rigid disk, and the elastic modes at their own frequency.",
    "The listener hears the source one travel time of sound later, from a fixed place.",
)
LEFT_OUT = (
    "Sound of the table, of impacts and of roughness; the action of the elastic modes on the motion.",
    "Air that flows round the rim while the film below the disk is open: until late in the motion the true pressure of "
    "heave and tilt is lower.",
    "The resisting moments and the centrifugal loads as drivers of the modes.",
)
