"""`python -m bench.prior`: maps from other people against those of the person alone, on people kept apart."""

from collections.abc import Callable, Iterable, Sequence
from dataclasses import replace
from typing import Annotated

import numpy as np
import typer
from numpy.typing import NDArray

from app.calibration.clean_recording import CleanRecording
from app.calibration.fit.profile_fit import fit_profile
from app.calibration.fit.repetitions import repetitions_of_prompts
from app.calibration.guided.guided_map import with_guided_maps
from app.calibration.linear_map import LARGEST_LOSS, Arrangement, Forecast
from app.calibration.prior import solving
from app.calibration.prior.documents import OwnPrior, PersonEntry
from app.calibration.prior.entry import person_entry
from app.calibration.prior.map_prior import MapPrior
from app.calibration.prior.prior_map import find_arrangements, with_prior_maps
from app.calibration.profile import CalibrationProfile
from bench.prior.knit import FOLDER, knit_people
from bench.prior.simulated import simulated_people
from bench.prior.step_cost import step_cost
from bench.prior.wearers import (
    OWN_PROMPTS,
    TABLE_HEAD,
    Figures,
    JointPart,
    Wearer,
    figures,
    prompted_stretches,
    summary,
)

Array = NDArray[np.float64]
DEAD_ZONE = solving.DEAD_ZONE_DEVIATIONS


def entries_of(wearers: Iterable[Wearer]) -> dict[str, PersonEntry]:
    """Return what each person adds to a prior, from all recordings of the person."""
    recordings: dict[str, list[CleanRecording]] = {}
    for one in wearers:
        prompted = [stretch for part in one.parts for stretch in prompted_stretches(one, part.prompts)]
        recorded = CleanRecording.of(one.layout, one.sample_rate, one.values[one.free], stretches=prompted)
        recordings.setdefault(one.code, []).append(recorded)
    return {code: person_entry(own) for code, own in recordings.items()}


def calibrated(wearer: Wearer, part: JointPart, prior: MapPrior, seconds: float) -> CalibrationProfile:
    """Return the profile after free movement and `seconds` of the joint's prompts, with every map that can be made."""
    until = float(wearer.t[part.rows.start]) + seconds
    rows = [prompt for prompt in part.prompts if prompt.end < until]
    free = wearer.values[wearer.free]
    repetitions = repetitions_of_prompts(wearer.t, wearer.values, rows, wearer.sample_rate)
    own = prompted_stretches(wearer, rows, until)
    clean = CleanRecording.of(wearer.layout, wearer.sample_rate, free, None, repetitions, own)
    fitted = with_prior_maps(with_guided_maps(fit_profile(clean), clean).profile, prior, clean)
    if part.joint in fitted.reasons:
        raise ValueError(f"{wearer.code}, {part.joint}: {fitted.reasons[part.joint]}")
    return fitted.profile


class Comparison:
    """Figures of all maps on all people, each with a prior of the people of other groups."""

    def __init__(self, wearers: Sequence[Wearer], entries: dict[str, PersonEntry]) -> None:
        self._groups = {one.code: one.group for one in wearers}
        self._layout, self._entries = wearers[0].layout, entries
        self._priors = {group: MapPrior.of(self.prior_without(group)) for group in set(self._groups.values())}
        self.figures: dict[tuple[float, str], list[Figures]] = {}
        self.forecasts: dict[float, list[tuple[Forecast, float]]] = {}
        self.offers: dict[float, list[tuple[Figures, Figures]]] = {}  # seconds -> what was offered, the standard map

    def prior_without(self, group: str) -> OwnPrior:
        """Return the prior of everybody outside of a group."""
        people = {code: entry for code, entry in self._entries.items() if self._groups[code] != group}
        return OwnPrior(layout=self._layout, people=people)

    def add(self, wearer: Wearer) -> None:
        """Calibrate and judge one recording."""
        prior = self._priors[wearer.group]
        for part in wearer.parts:
            for seconds in OWN_PROMPTS:
                profile = calibrated(wearer, part, prior, seconds)
                joint = next(one for one in profile.joints if one.name == part.joint)
                by_prior = figures(wearer, part, profile, "prior")
                self._note(seconds, "prior", by_prior)
                if joint.prior is not None and joint.prior.hits is not None:
                    self.forecasts.setdefault(seconds, []).append((joint.prior.hits, 100 * by_prior.hit))
                by_pca = figures(wearer, part, profile, "pca")  # of free movement alone where nothing was prompted
                self._note(seconds, "PCA", by_pca)
                if seconds:
                    by_cues = by_pca if joint.guided is None else figures(wearer, part, profile, "guided")
                    self._note(seconds, "guided (PCA where it cannot be made)", by_cues)
                    best = joint.best_map
                    by_best = {"prior": by_prior, "guided": by_cues, "pca": by_pca}[best]
                    self._note(seconds, "best", by_best)
                    if joint.prompted and best != "pca":
                        self.offers.setdefault(seconds, []).append((by_best, by_pca))

    def arrangements(self, wearer: Wearer, shift: int, *, mirrored: bool = False) -> Iterable[bool]:
        """Yield for each ring, turned by `shift` places or with its sensors in reverse order, whether that is found."""
        for ring, sensors in wearer.layout.rings.items():
            count = len(sensors)
            sits = Arrangement(shift=count - 1, mirrored=True) if mirrored else Arrangement(shift=shift % count)
            values = wearer.values.copy()
            values[:, sensors] = values[:, np.array(sensors)[::-1] if mirrored else np.roll(sensors, shift)]
            found = find_arrangements(self._priors[wearer.group], values[wearer.free], wearer.sample_rate)
            yield found[ring] == sits

    def _note(self, seconds: float, name: str, one: Figures) -> None:
        self.figures.setdefault((seconds, name), []).append(one)

    def table(self) -> str:
        """Return the table of the figures."""
        rows = [f"| {seconds:g} s | {name} | {summary(rows)} |" for (seconds, name), rows in self.figures.items()]
        return "\n".join([TABLE_HEAD, *sorted(rows, key=lambda row: int(row.split()[1]))])

    def offer_lines(self) -> list[str]:
        """Return how often another map was offered, and was then worse in phase than the standard map."""
        lines = []
        for seconds, offered in self.offers.items():
            losses = [standard.in_phase - other.in_phase for other, standard in offered]
            worse = sum(loss > 0.0 for loss in losses)
            clear = sum(loss > LARGEST_LOSS for loss in losses)
            lines.append(
                f"offered in place of the standard map with {seconds:g} s: {len(offered)}; less in phase than it: "
                f"{worse}, by more than {LARGEST_LOSS:g}: {clear}; worst loss {max(0.0, *losses):.3f}"
            )
        return lines

    def forecast_lines(self) -> list[str]:
        """Return how well hits are forecast: means, and the share of recordings within the stated deviations."""
        lines = []
        for seconds, pairs in self.forecasts.items():
            expected, came = np.array([(one.value, hit) for one, hit in pairs]).T
            deviations = np.abs(expected - came) / np.array([one.uncertainty for one, _ in pairs])
            within = ", ".join(f"{float((deviations < most).mean()):.0%} within {most}" for most in (1, 2))
            means = f"{expected.mean():.0f} of 100 expected, {came.mean():.0f} came"
            lines.append(f"forecast of hits with {seconds:g} s: {means}; {within} stated deviations")
        return lines


def compare(title: str, wearers: Sequence[Wearer], entries: dict[str, PersonEntry]) -> Comparison:
    """Print the table of one set of recordings."""
    comparison = Comparison(wearers, entries)
    for one in wearers:
        comparison.add(one)
    typer.echo(f"\n{title}\n\n{comparison.table()}\n")
    for line in (*comparison.offer_lines(), *comparison.forecast_lines()):
        typer.echo(line)
    return comparison


def print_arrangements(comparison: Comparison, wearers: Sequence[Wearer]) -> None:
    """Print how many rings were left as they are, and how many turned ones were found."""
    kept = [found for one in wearers for found in comparison.arrangements(one, 0)]
    turned = [found for one in wearers for shift in (1, -1) for found in comparison.arrangements(one, shift)]
    typer.echo(f"rings that sit right and are kept: {sum(kept)} of {len(kept)}")
    typer.echo(f"rings turned by one place that are found: {sum(turned)} of {len(turned)}")
    mirrored = [found for one in wearers for found in comparison.arrangements(one, 0, mirrored=True)]
    typer.echo(f"rings in reverse order that are found: {sum(mirrored)} of {len(mirrored)}")


def with_ring(wearer: Wearer) -> Wearer:
    """Return a recording of the sleeve whose five sensors are a ring."""
    channels = tuple(channel.model_copy(update={"ring": "sleeve"}) for channel in wearer.layout.channels)
    return replace(wearer, layout=wearer.layout.model_copy(update={"channels": channels}))


def with_dead_channel(wearer: Wearer) -> Wearer:
    """Return the recording with one constant channel of each joint that is prompted."""
    rng = np.random.default_rng(int(wearer.code[1:]))
    values = wearer.values.copy()
    for part in wearer.parts:
        values[:, int(rng.choice(wearer.layout.channels_of_joint[part.joint]))] = 1.0
    return wearer.with_values(values)


def turned(wearer: Wearer) -> Wearer:
    """Return the recording with every ring turned by one place."""
    values = wearer.values.copy()
    for sensors in wearer.layout.rings.values():
        values[:, sensors] = np.roll(values[:, sensors], 1, axis=1)
    return wearer.with_values(values)


CHANGES: dict[str, Callable[[Wearer], Wearer]] = {
    "as they are": lambda one: one,
    "one dead channel in each joint": with_dead_channel,
    "rings of the elbows turned by one place": turned,
}


def main(
    people: Annotated[int, typer.Option(min=6, help="Simulated people.")] = 20,
    seed: Annotated[int, typer.Option(help="Of the cues' lead on the real knit.")] = 1,
    *,
    only_knit: Annotated[bool, typer.Option("--knit", help="Only the recordings of the real knit.")] = False,
    dead_zone: Annotated[
        float, typer.Option(help="Deviations below the mean rate of strokes where it lies.")
    ] = -DEAD_ZONE,
    rings: Annotated[
        bool, typer.Option("--rings", help="Only how simulated rings of sensors sit: half a minute.")
    ] = False,
) -> None:
    """Print the tables of docs/learning/prior-measured.md."""
    solving.DEAD_ZONE_DEVIATIONS = -dead_zone
    if rings:
        wearers = simulated_people(people)
        print_arrangements(Comparison(wearers, entries_of(wearers)), wearers)
        return
    if not only_knit:
        typer.echo("\n".join(step_cost()))
    if FOLDER.exists():
        knit = [with_ring(one) for one in knit_people(seed)]
        comparison = compare(f"Real knit: {len(knit)} recordings, one fitting kept apart", knit, entries_of(knit))
        print_arrangements(comparison, knit)
    else:
        typer.echo(f"The recordings of the real knit are not here ({FOLDER}): that table is left out.")
    if only_knit:
        return
    simulated = simulated_people(people)
    entries = entries_of(simulated)
    for title, change in CHANGES.items():
        changed = [change(one) for one in simulated]
        comparison = compare(f"Simulated shirt: {people} people, one kept apart, {title}", changed, entries)
    print_arrangements(comparison, simulated)


if __name__ == "__main__":
    typer.run(main)
