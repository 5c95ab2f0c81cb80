"""All texts of each finding: claim, unit, source, and the sentences that report it.

A new finding needs a record here and its function.
"""

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from dynamics.compliant.stepping.time_loop import FLAT_INCLINATION
from dynamics.solver_settings import MIN_RELEVANT_SHARE
from sonify.claims.limits import (
    ALMOST_FLAT_INCLINATION,
    FINAL_ENERGY_SHARE,
    MODE_BAND_HALF_WIDTH,
)
from sonify.claims.phrases import (
    contact_in_words,
    film_switched_in_words,
    lift_off_in_words,
    nutation_in_words,
    open_contact_shares_in_words,
    restitutions_in_words,
    rises_in_words,
    shares_in_words,
)

SOUND_QUESTION = "what do you hear"
PITCH_QUESTION = "does the pitch rise"
LOSS_QUESTION = "is contact lost"
END_QUESTION = "what ends the motion"
NO_ANSWER_REASONS = {
    SOUND_QUESTION: "no sound was rendered",
    PITCH_QUESTION: "no sound was rendered",
    LOSS_QUESTION: "no motion was solved",
    END_QUESTION: "the motion does not end in this run",
}
"""Reason for a missing answer, by question."""


NO_WORDS: Mapping[str, str] = {}


class AnswerSentences(NamedTuple):
    """Answers for a claim that holds, fails or is undecided; {value} is its value, and
    {told} the phrase with its details or the reason why it is undecided.

    An empty answer leaves the question to the next finding."""

    yes: str
    no: str
    undecided: str


class HeadlineClauses(NamedTuple):
    """Clauses of the headline for a claim that holds and for one that fails."""

    yes: str
    no: str


class Quotation(NamedTuple):
    """A sentence of Kessler & O'Reilly (2002), and its place in the paper."""

    sentence: str
    place: str


@dataclass(frozen=True, kw_only=True)
class FindingText:
    """Texts of a finding; a {name} in them stands for a word or number of the run.

    Parameters
    ----------
    claim, unit, source : str
        As in `Finding`.
    variants : mapping of str to mapping
        Claim, unit or source that replace these in some runs, by the name of the
        variant.
    quotation : Quotation, optional
        Sentence of the paper to which the finding refers.
    details : str or callable
        Template of the phrase with the details, or a function that returns it.
    question : str
        Question that the finding answers, one of NO_ANSWER_REASONS.
    answers : AnswerSentences, optional
        Answers to the question.
    headline : HeadlineClauses, optional
        Clauses of the headline on the subject of the question.
    loudest : str
        Loudest part of the sound if the claim holds, in plain words.
    short : str
        The claim in the head of a table.
    omitted_effect : str
        Effect that becomes significant at the value of the finding, a time before the
        end.
    """

    claim: str
    unit: str
    source: str
    variants: Mapping[str, Mapping[str, str]] = field(default_factory=dict)
    quotation: Quotation | None = None
    details: str | Callable[[Mapping[str, float]], str] = ""
    question: str = ""
    answers: AnswerSentences | None = None
    headline: HeadlineClauses | None = None
    loudest: str = ""
    short: str = ""
    omitted_effect: str = ""

    def phrase(self, details: Mapping[str, float]) -> str:
        """Return the phrase with the details of a finding."""
        if isinstance(self.details, str):
            return self.details.format_map(details)
        return self.details(details)

    def of_run(
        self, variant: str = "", words: Mapping[str, str] = NO_WORDS
    ) -> dict[str, Any]:
        """Return claim, unit and source of a variant, with the words of a run."""
        texts: dict[str, Any] = {
            "claim": self.claim,
            "unit": self.unit,
            "source": self.source,
        }
        texts |= self.variants[variant] if variant else {}
        if not words:
            return texts
        return {name: text.format_map(words) for name, text in texts.items()}


PREDICTED_VIBRATION = {
    "unit": "times the weight (greatest rms of the predicted vibration of the normal force)",
    "source": "a Gaussian vibration breaks the contact from 0.3 of the weight on, in every motion from "
    "0.4 on",
}
"""Texts of a predicted vibration that may break the contact."""
REMAINING_AT_ONSET_CLAUSE = "that remained at the onset of two-way coupling"
ENERGY_SHARE_FORMAT = "{value:.0%}"
LEVEL_FORMAT = "{value:+.0f} dB(A)"
TIME_ADVANCE_FORMAT = (
    "1e-5 rad is reached {value:.2f} s earlier, 1e-4 rad "
    "{advance_at_100_urad:.2f} s earlier"
)
_PITCH_RISES = Quotation(
    "the acoustic frequencies emitted by the disk and surface exhibit a sharp increase at the end "
    "of the motion",
    "section 1",
)
_ABRUPT_HALT = Quotation(
    "the disk eventually comes to rest in an abrupt manner", "section 1"
)
_SOUND_SOURCE = Quotation(
    "To produce sound, the actual disk and the surface that it moves on vibrates.",
    "section 8",
)
_EXCITED_MODES = Quotation(
    "This forcing will excite modes of vibration of the disk and consequently produce sound.",
    "section 8",
)
_CONTACT_LOSS = Quotation(
    "we conjecture that the vibrations of the disk and surface will eventually result in it losing "
    "contact with the surface",
    "section 8",
)
_FINAL_IMPACT = Quotation(
    "the ensuing impact of the disk and surface constitutes the abrupt end of the disk's motion",
    "section 8",
)

_SOUND: dict[str, FindingText] = {
    "table_is_louder": FindingText(
        claim="The table is louder than the disk",
        unit="dB(A), table relative to disk, median over the seconds of the motion",
        source="section 1: vibrations of disk and surface",
        quotation=_SOUND_SOURCE,
        question=SOUND_QUESTION,
        answers=AnswerSentences(
            f"the table, {LEVEL_FORMAT} relative to the disk",
            f"the disk; the table has {LEVEL_FORMAT} relative to it",
            f"undecided: the table has {LEVEL_FORMAT} relative to the disk",
        ),
        headline=HeadlineClauses(
            "you hear the table more than the disk",
            "you hear the disk more than the table",
        ),
        loudest="the table vibrates under the moving contact and sounds like a drum skin",
    ),
    "table_moves_carrier": FindingText(
        claim="The table sets the noise band",
        unit="times the band on a rigid table, or its inverse, median along the motion",
        source="the linear filter of the rough contact with and without its table",
        details="{with_table:.0f} Hz with the table, {on_rigid_table:.0f} Hz without; the band of the "
        "sound is at {heard:.2f} of the prediction",
        question=SOUND_QUESTION,
        answers=AnswerSentences(
            "disk and table together on their contact, a factor of {value:.2f} from the frequency on a "
            "rigid table",
            "the disk on its contact, as on a rigid table",
            "undecided: disk and table together, or the contact alone",
        ),
        loudest="disk and table vibrate together on their springy contact, too fast to be seen",
    ),
    "carrier_is_contact": FindingText(
        claim="The noise band is the resonance of the disk on its elastic contact",
        unit="times the expected resonance of the contact, median along the motion",
        source="contact laws of Hertz, Mindlin and Kalker; noise band determined from the sound alone",
        details="{force_alone:.2f} for the force alone",
        question=SOUND_QUESTION,
        answers=AnswerSentences(
            "the contact resonance, at {value:.2f} times its predicted frequency",
            "a resonance at {value:.2f} times the frequency of the contact resonance",
            "undecided: the contact resonance, at {value:.2f} times its predicted frequency",
        ),
        headline=HeadlineClauses(
            "you hear the disk vibrate on its contact",
            "you hear a resonance other than that of the contact alone",
        ),
        loudest="the disk vibrates on its springy contact, too fast to be seen",
    ),
    "modes_carry_the_end": FindingText(
        claim="In the last second, the sound of the disk is the vibration of its modes",
        unit="dB(A), ringing modes relative to the rigid motion of the disk",
        source="section 8: the motion of the disk is not the primary sound source; the forcing excites modes",
        quotation=_EXCITED_MODES,
        question=SOUND_QUESTION,
        answers=AnswerSentences(
            f"the modes of the disk, {LEVEL_FORMAT} relative to its rigid motion",
            f"the rigid motion of the disk; its modes have {LEVEL_FORMAT} relative to it",
            f"undecided: the modes of the disk have {LEVEL_FORMAT} relative to its rigid motion",
        ),
        headline=HeadlineClauses(
            "you hear the disk ring",
            "you hear the disk move rather than ring",
        ),
        loudest="the disk rings like a bell under the moving contact",
    ),
    "free_modes_are_heard": FindingText(
        claim="The sound is that of the modes of the disk",
        unit=f"of the sound power above 100 Hz, within {MODE_BAND_HALF_WIDTH:.0%} of the frequencies of the "
        "modes",
        source="recorded coins: the spectral lines of a rolling coin are within 0.3 % of those of the free "
        "coin",
        question=SOUND_QUESTION,
        answers=AnswerSentences(
            "the modes of the disk, with {value:.0%} of the sound power",
            "more than the modes of the disk, which have {value:.0%} of the sound power",
            "undecided: the modes of the disk, with {value:.0%} of the sound power",
        ),
        headline=HeadlineClauses(
            "you hear the disk ring",
            "you hear more than the ringing of the disk",
        ),
        loudest="the disk rings like a bell at every knock",
    ),
    "heard_through_film": FindingText(
        claim="The motion of the rigid disk is audible through the open film",
        unit="dB above the threshold of hearing",
        source="ISO 226; air flows around the rim as the face moves",
        question=SOUND_QUESTION,
        answers=AnswerSentences(
            "the motion of the disk, {value:+.0f} dB relative to the threshold of hearing",
            "not the motion of the disk: {value:+.0f} dB relative to the threshold of hearing",
            "undecided: the motion of the disk, {value:+.0f} dB relative to the threshold of hearing",
        ),
        headline=HeadlineClauses(
            "you hear the disk move",
            "the motion of the disk is inaudible",
        ),
    ),
    "sound_is_audible": FindingText(
        claim="The sound exceeds the threshold of hearing",
        unit="dB above the threshold (greatest third-octave level in 200 ms)",
        source="ISO 389-7, equal to the thresholds of ISO 226",
        details="above the threshold for {audible_share:.0%} of the time",
    ),
}
"""Texts on what is heard."""
_PITCH: dict[str, FindingText] = {
    "pitch_rises": FindingText(
        claim="The tone, the beats or the noise band rises",
        unit="times, from the beginning to the end of the audible part",
        source="abstract and section 1: a sharp rise, here an octave for the tone and the beats and a "
        "minor third for the noise band; audible above the threshold of ISO 226, beats with the "
        "modulation depth of Viemeister (1979); determined from the sound alone",
        quotation=_PITCH_RISES,
        details=rises_in_words,
        question=PITCH_QUESTION,
        answers=AnswerSentences("yes: {told}", "no: {told}", "undecided: {told}"),
        headline=HeadlineClauses("the pitch rises", "the pitch does not rise"),
    ),
    "table_tone_rises": FindingText(
        claim="The tone of the table rises",
        unit="times from the start to the end of the tone in the stem of the table",
        source="section 8: the frequencies rise; the table is driven at n times the precession frequency",
        quotation=_PITCH_RISES,
    ),
    "carrier_rises": FindingText(
        claim="A noise band rises",
        unit="times, from the first tenth to the end of the audible band",
        source="abstract: the pitch rises; determined from the sound alone",
        quotation=_PITCH_RISES,
        details="from {from:.0f} Hz to {to:.0f} Hz",
    ),
    "tone_is_precession": FindingText(
        claim="In the last second the rising tone is the precession of the contact",
        unit="times the solved precession, median",
        source="section 8 does not state which frequency rises; here it is compared with the precession",
        quotation=Quotation(
            "Our model shows that the frequency of the motion increases as the disk declines. This "
            "however is not the primary sound source of the system.",
            "section 8",
        ),
    ),
    "tone_was_nutation": FindingText(
        claim="Until four seconds before the end the tone is the nutation, the frequency of the normal force",
        unit="times the solved nutation, median",
        source="section 8: the normal force is a measure of the forcing",
        quotation=Quotation(
            "the normal force behavior that we report can be considered as a measure of the forcing "
            "experienced by the actual disk and surface",
            "section 8",
        ),
    ),
    "tone_ends_with_the_motion": FindingText(
        claim="The rising tone lasts until the end of the motion",
        unit="s from the end of the motion to the fitted end of the tone",
        source="section 1: the abrupt halt",
        quotation=_ABRUPT_HALT,
    ),
    "tone_is_heard": FindingText(
        claim="The rising tone can be heard",
        unit="s of uninterrupted audibility before the end (threshold of ISO 226)",
        source="section 8: the frequencies are in the audible range",
    ),
    "table_carries_the_tone": FindingText(
        claim="The table emits the rising tone of the last second",
        unit="dB, table relative to disk in the third-octave band of the tone",
        source="abstract: the vibrations of disk and surface produce the sound",
        quotation=_SOUND_SOURCE,
    ),
    "deformation_makes_the_tone": FindingText(
        claim="Transverse deformation of the disk alone makes the rising tone",
        unit="dB(A), modes driven by the smooth force relative to all other sources",
        source="Villanueva & Epstein (2005)",
    ),
}
"""Texts on whether the pitch rises."""
_CONTACT: dict[str, FindingText] = {
    "table_breaks_contact": FindingText(
        claim="Vibration of the table breaks the contact",
        short="the table breaks the contact",
        unit=f"losses of contact above {ALMOST_FLAT_INCLINATION:g} rad; their occurrence is checked with "
        "half the time step and twice the contact stiffness",
        source="abstract: the vibrations will result in a loss of contact",
        variants={"predicted": PREDICTED_VIBRATION},
        quotation=_CONTACT_LOSS,
        question=LOSS_QUESTION,
        headline=HeadlineClauses(
            "vibrations break the contact",
            "vibrations do not break the contact",
        ),
    ),
    "disk_rattles": FindingText(
        claim="The disk rattles: it flies from crest to crest of the unevenness",
        unit="of the time without contact",
        source="contact with an uneven table is lost where the curvature of its heights exceeds that of the rim",
        details="{impacts_per_second:.0f} impacts per second; the curvature of the heights is "
        "{curvature_number:.2f} times that of the rim, and their rms is {rms_over_depth:.1f} times the "
        "indentation; restitution {effective_restitution:.2f} with the modes of the disk",
        question=LOSS_QUESTION,
        headline=HeadlineClauses(
            "the disk rattles on the table",
            "the disk hardly leaves the table",
        ),
    ),
    "contact_is_lost": FindingText(
        claim="Contact is lost, whatever breaks it",
        unit="of the time without contact",
        source="abstract: a loss of contact; the findings on its causes name what breaks it",
        details=contact_in_words,
        question=LOSS_QUESTION,
        answers=AnswerSentences(
            "yes, for {value:.1%} of the time",
            "no, it is open for {value:.1%} of the time",
            "undecided: it is open for {value:.1%} of the time",
        ),
        headline=HeadlineClauses(
            "the disk leaves the table",
            "the disk never leaves the table",
        ),
    ),
    "contact_kept": FindingText(
        claim="The normal force stays positive",
        unit="times the weight (least normal force)",
        source="section 7, figure 4 (a)",
        quotation=Quotation(
            "Another interesting feature of the normal force is that it is never zero.",
            "section 7",
        ),
        question=LOSS_QUESTION,
        answers=AnswerSentences(
            "no, the least normal force is {value:.1f} of the weight",
            "yes",
            "undecided: the least normal force is {value:.1f} of the weight",
        ),
        headline=HeadlineClauses(
            "the disk never leaves the table",
            "the disk leaves the table",
        ),
    ),
    "micro_flights": FindingText(
        claim="Contact is lost in micro-flights, too short to be seen",
        unit="s (the longest flight)",
        source="Borisov et al. (2015)",
        details="{number:.0f} in all; the highest reaches {height:.2g} m",
    ),
    "number_of_losses": FindingText(
        claim="The number of losses of contact is definite",
        unit=f"losses of contact above {ALMOST_FLAT_INCLINATION:g} rad",
        source="the same motion with half the time step and with twice the contact stiffness",
    ),
    "loss_at_resonance": FindingText(
        claim="Contact is first lost where the contact moves as fast as the waves of a mode",
        unit="n times the precession frequency, divided by the frequency of the nearest mode",
        source="section 8: the vibrations will result in a loss of contact",
        details="{before_end:.2g} s before the end, at {precession_frequency:.3g} turns per second; "
        "{number:.0f} losses in all",
    ),
    "waves_break_contact": FindingText(
        claim="Contact is first lost where the waves of the table outweigh the inclination",
        unit="times (n^2 - 1) amplitude/radius (inclination at the first loss of contact)",
        source="section 8: the vibrations will result in a loss of contact; here the table is wavy",
    ),
    "vibration_opens_contact": FindingText(
        claim="Vibration of the disk breaks the contact",
        short="the disk breaks the contact",
        unit="of the time without contact vanishes without the modes of the disk",
        source="section 8: vibrations excited by the contact force break the contact",
        variants={
            "predicted": PREDICTED_VIBRATION,
            "solved": {
                "unit": "of the time without contact where neither geometry nor table nor air breaks it"
            },
        },
        quotation=_CONTACT_LOSS,
        details=open_contact_shares_in_words,
    ),
    "unevenness_breaks_contact": FindingText(
        claim="Unevenness alone breaks the contact",
        short="unevenness breaks the contact",
        unit="times the curvature at which a rim without vibration leaves the heights (greatest)",
        source="contact with an uneven table is lost where the curvature of its heights exceeds that of "
        "the rim",
        details="waves {waves:.2g}, roughness {roughness:.2g}",
    ),
    "loss_begins_at": FindingText(
        claim="The roughness of an ordinary surface, 0.1 um, breaks the contact",
        unit="m (least rms of table and edge that breaks the contact)",
        source="abstract; N' is proportional to the rms of the heights",
    ),
}
"""Texts on whether contact is lost."""
_END: dict[str, FindingText] = {
    "impacts_end_it": FindingText(
        claim="Impacts bring the disk to rest",
        short="many impacts end the motion",
        unit="of the energy is lost in the dashpots of the contacts",
        source="the disk makes thousands of small impacts on the crests of an uneven table",
        question=END_QUESTION,
        answers=AnswerSentences(
            "impacts: {value:.0%} of the energy",
            "several causes, impacts with {value:.0%} of the energy",
            "undecided: impacts, {value:.0%} of the energy",
        ),
        headline=HeadlineClauses(
            "impacts dissipate most of its energy",
            "impacts dissipate less than half of its energy",
        ),
    ),
    "halt_comes_earlier": FindingText(
        claim="The table brings the halt forward",
        unit=f"s earlier at {FLAT_INCLINATION:g} rad than with one-way coupling",
        source="section 8: the vibrations will result in an abrupt halt",
        quotation=_ABRUPT_HALT,
        details="{advance_at_100_urad:.3g} s earlier at 1e-4 rad",
        question=END_QUESTION,
        answers=AnswerSentences(
            f"the table: {TIME_ADVANCE_FORMAT}",
            f"not the table: {TIME_ADVANCE_FORMAT}",
            f"undecided: the table, {TIME_ADVANCE_FORMAT}",
        ),
    ),
    "table_takes_little": FindingText(
        claim="The table holds too little energy to affect the motion",
        unit="s before the end when the modes of the table first hold as much energy as the disk",
        source="section 8: the vibrations will result in a loss of contact; here the coupling is one-way",
        question=END_QUESTION,
        answers=AnswerSentences(
            "",  # the table does not end the motion
            "the table, not solved: {value:.1f} s before the end it would hold as much energy as "
            "the disk",
            "undecided: the table, not solved: it would hold as much energy as the disk "
            "{value:.1f} s before the end",
        ),
    ),
    "what_ends": FindingText(
        claim="What ends the motion is {cause}",
        unit=f"of the last {FINAL_ENERGY_SHARE:.0%} of the energy",
        source="energy lost to each cause along the motion",
        details=shares_in_words,
        question=END_QUESTION,
        answers=AnswerSentences(
            f"{{cause}}: {ENERGY_SHARE_FORMAT}",
            f"several causes, mainly {{cause}}: {ENERGY_SHARE_FORMAT}",
            f"undecided: {{cause}}, {ENERGY_SHARE_FORMAT}",
        ),
    ),
    "carried_by_air": FindingText(
        claim="Air breaks the contact: the film lifts the disk",
        unit="times the vertical force (greatest lift of the film)",
        source="Reynolds' equation on the falling film",
        variants={
            "no film": {
                "claim": "With the air film included, the air would lift the disk"
            },
            "rattling": {
                "unit": "1 if the film finally lifts the rattling disk, otherwise 0"
            },
        },
        details=lift_off_in_words,
    ),
    "halt_is_abrupt": FindingText(
        claim="The motion stops abruptly once the disk has lost its rolling contact",
        unit="turns from the loss of contact until it precesses less than once per second",
        source="section 1: the abrupt halt; the motion of the falling disk",
        details="within {milliseconds:.3g} ms",
    ),
    "air_catches_disk": FindingText(
        claim="The air catches the disk: its rim does not touch the table again",
        unit="touches of the table after the lift-off",
        source="Reynolds' equation under the falling disk",
        details="the low point rises to {clearance:.3g} um after {milliseconds:.3g} ms; the disk finally "
        "lies level on a cushion of {gap:.3g} um",
    ),
    "one_impact_ends_it": FindingText(
        claim="A single impact ends the motion",
        short="one impact stops the disk",
        unit="of the energy at the first impact after the loss of contact (largest loss in one impact)",
        source="section 8: loss of contact and the following impact end the motion",
        quotation=_FINAL_IMPACT,
        variants={
            "kept": {"unit": "of the energy: the disk never loses contact"},
            "rattling": {
                "unit": f"of the last {FINAL_ENERGY_SHARE:.0%} of the energy (largest loss in the contact within 3 ms)"
            },
        },
        details=restitutions_in_words,
    ),
    "air_carries_earlier": FindingText(
        claim="The table brings forward the time at which the air lifts the disk",
        unit="s earlier than with one-way coupling",
        source="section 8: the vibrations will result in an abrupt halt; here in air",
        details="two-way coupling lasts for the final {acts_before_end:.3g} s",
    ),
    "waves_make_the_halt": FindingText(
        claim="The waves of the table dissipate the final energy",
        unit=f"of the last {FINAL_ENERGY_SHARE:.0%} of the energy {REMAINING_AT_ONSET_CLAUSE}",
        source="section 8: loss of contact and the following impact end the motion",
        quotation=_FINAL_IMPACT,
        details=shares_in_words,
    ),
    "table_rings_at_the_halt": FindingText(
        claim="The table finally holds more energy than the disk",
        unit="of the energy of both",
        source="abstract: the vibrations of disk and surface",
        details="{before_end:.3g} s before the end",
    ),
    "disk_rings_at_the_halt": FindingText(
        claim="The vibrations of the disk contribute to the halt",
        unit=f"of the last {FINAL_ENERGY_SHARE:.0%} of the energy {REMAINING_AT_ONSET_CLAUSE} (greatest energy of "
        "its elastic modes)",
        source="abstract: the vibrations of disk and surface",
    ),
    "roughness_ends_it": FindingText(
        claim="Roughness ends the motion",
        unit="of the energy lost, {where}",
        source="power of N' on the rising heights; roughness.loss = '{loss}'",
    ),
    "slip_is_the_loss": FindingText(
        claim="Slip dissipates most of the energy",
        unit="of the energy lost while the disk slides",
        variants={"solved": {"unit": "of the energy lost by sliding friction"}},
        source="Caps et al. (2004)",
    ),
    "impacts_are_not_the_loss": FindingText(
        claim="Causes other than impacts end the motion",
        unit="of the energy lost by compression of the contact",
        source="Baranyai & Varkonyi (2017)",
    ),
}
"""Texts on what ends the motion."""
_MOTION: dict[str, FindingText] = {
    "repeated_slips": FindingText(
        claim="The disk repeatedly changes from rolling to sliding",
        unit="transitions",
        source="section 1 of the paper",
        quotation=Quotation(
            "the disk transitions repeatedly between rolling and sliding",
            "section 1",
        ),
    ),
    "load_frequency_rises": FindingText(
        claim="The frequency of the normal force rises as the disk declines",
        unit="times the frequency of the first tenth of the peaks (last tenth)",
        source="section 7, figure 4 (b)",
        quotation=Quotation(
            "a frequency f associated with this force increases as the angle of inclination of the "
            "disk tends to zero",
            "section 7",
        ),
        details=nutation_in_words,
    ),
    "load_frequency_reached": FindingText(
        claim="The frequency of the normal force reaches f = 2.5 (36 Hz for the paper's disk)",
        unit="χ of (4.5) after the release (inf: never)",
        source="figure 4 (b), read in quadruple precision; footnote 3",
        quotation=Quotation(
            "For Tangent Toy's Euler's disk, a value of f = 2.5 corresponds to a frequency of 36 Hz.",
            "figure 4",
        ),
        details=nutation_in_words,
    ),
    "energy_falls": FindingText(
        claim="The energy falls monotonically",
        unit="times the initial energy (greatest increase between two instants)",
        source="sections 6.3 and 7, figure 3 (b)",
        quotation=Quotation(
            "Correspondingly, the total energy of the disk decreases.",
            "section 7",
        ),
    ),
    "sliding_costs_more": FindingText(
        claim="Sliding dissipates more than rolling",
        unit="times the greater of the powers before and after a slide, median",
        source="section 7, figure 3 (b)",
        quotation=Quotation(
            "during sliding the dissipation of energy is larger than it is during rolling",
            "section 7",
        ),
    ),
    "centre_comes_to_rest": FindingText(
        claim="The motion of the centre diminishes until it is almost negligible",
        unit="times the extent of the path in its first fifth (last fifth)",
        source="section 7, figure 5",
        quotation=Quotation(
            "the in-plane motion of the center of mass of the disk diminishes considerably until it is "
            "almost negligible",
            "section 7",
        ),
    ),
    "no_singularity": FindingText(
        claim="The precession rate stays finite",
        unit="exponent of the precession rate as a power of the remaining time (negative: it diverges)",
        source="section 7",
        quotation=Quotation(
            "the model we have developed for Euler's disk does not appear to possess a finite-time "
            "singularity",
            "section 7",
        ),
    ),
    "rate_follows_unevenness": FindingText(
        claim="The precession rate rises as the spectrum of the unevenness implies",
        unit="exponent n of the precession rate ~ (t_end - t)^-n",
        source="n = (2 - H)/(4 - H) for a power spectrum k^-(1 + 2H) of the heights",
    ),
    "rate_is_that_of_the_table": FindingText(
        claim="On this table the precession rate is the same function of time for disks of any size",
        unit="times the precession rate due to impacts alone, a function of the rms height and the "
        "restitution, median over the last second",
        source="d beta/dt = -k sqrt(g s)/R for impacts on unevenness without a preferred scale",
        details="impacts alone would give {rate_at_1s:.3g} turns per second one second before the "
        "end",
    ),
    "friction_exponent": FindingText(
        claim="With the friction of the scene, the precession rate grows as measured",
        unit="exponent of the precession rate as a power of the remaining time",
        source="recordings of disks on granite, 2026: 0.31(3)",
    ),
    "pivoting_within_contact": FindingText(
        claim="A Hertzian contact can cause the pivoting friction of the scene",
        unit="times the arm of a slipping contact at 0.1 rad",
        source="Hertzian pressure; the moment of full spin slip is mu N times the mean distance from the centre",
    ),
}
"""Texts on the motion."""
_OMITTED: dict[str, FindingText] = {
    "modes_take_little": FindingText(
        claim="The modes hold too little energy to affect the motion",
        unit="s before the end when the modes first hold as much energy as the disk",
        source="section 8: the vibrations will result in a loss of contact; here the coupling is one-way",
        omitted_effect="The modes of the disk affect its motion",
    ),
    "table_takes_a_hundredth": FindingText(
        claim="The table may be neglected in the motion until the last half second",
        unit="s before the end when the modes of the table first hold "
        f"{MIN_RELEVANT_SHARE:.0%} of the energy of the disk",
        source="energies of a motion on a rigid table and of the table modes driven by its force",
        omitted_effect="The table affects the motion",
    ),
    "disk_supplies_table": FindingText(
        claim="The disk loses enough power to supply the table",
        unit="of the power that the disk loses is taken by the table, as heat and sound, where this "
        "share is greatest",
        source="balance of power: with one-way coupling the disk does not lose what the table takes",
        details="heat {heat:.0%}, sound {radiated:.0%}, around {time:.4g} s after the release",
    ),
    "coupling_error_is_predicted": FindingText(
        claim="The plan predicted how much one-way coupling would change the level of the table",
        unit="dB(A), measured minus predicted error of one-way coupling, median over intervals",
        source="the linear filter of the rough contact with and without its table, in time and as a "
        "spectrum",
        details="measured {measured:+.1f} dB, predicted {predicted:+.1f} dB",
    ),
    "waves_become_heat": FindingText(
        claim="The table converts most of the energy of its waves to heat and little to sound",
        unit="of the energy lost by the modes of the table is radiated",
        source="energy balance of a table with two-way coupling",
    ),
    "air_negligible": FindingText(
        claim="The air film under the disk may be neglected",
        unit="of the duration, before the film first dissipates 1 % of the power",
        source="Reynolds' equation on the film; Moffatt (2000)",
    ),
}
"""Texts on effects that the motion may omit."""
_SPECTRUM: dict[str, FindingText] = {
    "audible_modes": FindingText(
        claim="At least four modes of vibration are in the audible range",
        unit="modes from 20 Hz to 20 kHz",
        source="section 8",
        quotation=Quotation(
            "it has at least four modes of vibration in the audible range of humans",
            "section 8",
        ),
    ),
    "carriers_are_steady": FindingText(
        claim="The strongest steady tone keeps its pitch",
        unit="cents, spread over the sound",
        source="modes are linear; determined from the sound alone",
    ),
    "carriers_are_modes": FindingText(
        claim="The strongest steady tone is a mode of the disk",
        unit="cents to the nearest mode",
        source="section 8",
        quotation=_EXCITED_MODES,
    ),
    "air_moves_carrier": FindingText(
        claim="The resonance of film and air sets the noise band",
        unit="times that of the force alone, median",
        source="contact force and radiation of a disk over its film; noise band determined from the "
        "sound alone",
        variants={
            "switched off": {
                "unit": "times the band without the film, or its inverse, median along the motion",
                "source": "the linear filter of the rough contact, radiated above the film and above a "
                "gap of 0.6 radii",
            }
        },
        details=film_switched_in_words,
    ),
    "stiffness_moves_carrier": FindingText(
        claim="The contact resonance sets the noise band",
        unit="exponent of the frequency of the band with that of the contact resonance alone",
        source="the linear filter of the rough contact with the moduli of the scene and with twice "
        "these moduli",
    ),
    "carrier_passes_recorded_peaks": FindingText(
        claim="The contact resonance passes the peaks recorded on granite, 1.84 to 2.28 kHz",
        unit="s between these peaks",
        source="recordings of the toy on granite, 2026",
        details="from {from:.3g} s to {to:.3g} s",
    ),
    "constant_peaks_are_the_contact": FindingText(
        claim="The constant peaks of recordings, 5.04 and 8.23 kHz, come from the contact",
        unit="of the motion, within 2 % of either",
        source="recordings of the toy on granite, 2026; peaks that remain constant as the disk falls come "
        "from the table or the air",
    ),
    "force_peaks_sound": FindingText(
        claim="The peaks of the normal force are the peaks of the sound",
        unit="correlation of level and normal force",
        source="Saje & Zupan (2006)",
    ),
    "mode_ratio": FindingText(
        claim="The highest recorded peaks, 10.945 and 17.438 kHz, are the first two modes of the free disk",
        unit="ratio of the first two free modes",
        source="recordings of the toy on granite, 2026",
    ),
}
"""Texts on modes, spectral lines and noise bands."""
VERDICT_TEXTS: dict[str, FindingText] = {
    "vibrations_make_sound": FindingText(
        claim="Vibrations make the sound of the last second",
        short="vibrations make the sound",
        unit="dB, the smaller of the level relative to the rigid motion and the level above the "
        "threshold of hearing",
        source="section 8: the motion of the disk is not the primary sound source; the forcing excites modes",
        details="{louder:.0f} dB(A) relative to the rigid motion of the disk; {audible:.0f} dB above the "
        "threshold of hearing",
        question=SOUND_QUESTION,
        answers=AnswerSentences(
            "vibrations, {louder:+.0f} dB(A) relative to the rigid motion",
            "not the vibrations, {louder:+.0f} dB(A) relative to the rigid motion",
            "undecided: vibrations, {louder:+.0f} dB(A) relative to the rigid motion",
        ),
    ),
    "contact_breaks_before_end": FindingText(
        claim="Vibration or unevenness breaks the contact before the motion ends",
        short="vibration or unevenness breaks the contact",
        unit="times the final inclination (inclination at which contact is lost)",
        source="abstract: the vibrations will result in a loss of contact",
        details=shares_in_words,
    ),
    "air_carries_disk": FindingText(
        claim="The air lifts the disk at the end",
        short="the air lifts the disk",
        unit="1 if it does",
        source="the air film under the disk, Reynolds' equation",
    ),
    "table_brings_end_forward": FindingText(
        claim="The vibration of the table brings the end forward by at least 0.05 s",
        short="the table ends the motion earlier",
        unit="s earlier than without its vibration",
        source="section 8: the vibrations will result in an abrupt halt",
    ),
    "precession_rises": FindingText(
        claim="The final precession rate is at least twice that halfway through the motion",
        short="the precession rate doubles",
        unit="times the mean precession rate halfway through the motion (in a later fiftieth)",
        source="abstract and section 1: the pitch rises sharply",
    ),
    "resonance_rises": FindingText(
        claim="The contact stiffens: the resonance of the disk on it, as on a rigid table, rises by at "
        "least a fifth",
        short="the contact resonance on a rigid table rises by a fifth",
        unit="times its frequency at the release (frequency at the end)",
        source="abstract: the pitch rises; contact laws of Hertz and Mindlin",
    ),
}
"""Texts of the claims that verdict sweeps judge, in the order of their sentences."""

_PAPER: dict[str, FindingText] = {
    "unit_of_time": FindingText(
        claim="The unit of time is χ = 0.0691712 s", unit="s", source="(7.2)"
    ),
    "half_height": FindingText(
        claim="H/R = 1.28/7.51 (the paper prints the reciprocal)",
        unit="H/R",
        source="(7.2)",
    ),
    "density": FindingText(
        claim="The density is 7737.27", unit="kg/m³", source="footnote 4"
    ),
    "named_rate": FindingText(
        claim="f = 2.5 is 36 Hz", unit="Hz", source="figure 4, caption"
    ),
    "begins_at": FindingText(
        claim="α begins at 1.0", unit="rad", source="figure 3 (a), (7.4)"
    ),
    "ends_at": FindingText(claim="α tends to π/2", unit="rad", source="figure 3 (a)"),
    "rates_are_alike": FindingText(
        claim="The curve of dθ/dτ mostly resembles that of the frequency of the normal force",
        unit="half the 5-95 % range of their ratio, relative to its median",
        source="section 7, on figures 4 (b) and 6",
        details="{nutations_per_turn:.2f} nutations per turn",
    ),
    "precession_grows": FindingText(
        claim="dθ/dτ increases considerably",
        unit="times, from the release to 99 % of the time",
        source="figure 6",
        details="{release:.3g}/χ at the release, {half_way:.3g}/χ at half the time and "
        "{late:.3g}/χ at 99 %",
    ),
}
"""Texts on numbers of the paper."""

FINDING_TEXTS: dict[str, FindingText] = {
    **_SOUND,
    **_PITCH,
    **_CONTACT,
    **_END,
    **_MOTION,
    **_OMITTED,
    **_SPECTRUM,
    **VERDICT_TEXTS,
    **_PAPER,
}
"""Texts by the key of a finding; of several findings on a question, the first one that is
available answers it."""


def texts_with(name: str) -> dict[str, Any]:
    """Return the text `name` of each finding that has it, by key."""
    found = {key: getattr(text, name) for key, text in FINDING_TEXTS.items()}
    return {key: text for key, text in found.items() if text}


def texts_by_question(name: str) -> dict[str, dict[str, Any]]:
    """Return the text `name` of each finding that has it, by question and key."""
    found = texts_with(name)
    return {
        question: {
            key: text
            for key, text in found.items()
            if FINDING_TEXTS[key].question == question
        }
        for question in NO_ANSWER_REASONS
    }
