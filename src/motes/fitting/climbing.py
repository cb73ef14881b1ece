"""``model="auto"``: the ladder of candidates, climbed for one scan; `motes.fitting.judgement` says where to stop."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np
from numpy.typing import NDArray

from motes.errors import DataError
from motes.fitting.channels_among_many import even_channels
from motes.fitting.choice import LADDER, check_names, parsed
from motes.fitting.direction_blocks import Labels, blocks_of
from motes.fitting.judgement import FEWEST_BLOCKS, FOLLOWS, Contender, clearly_better
from motes.fitting.ladder import Rung, rung_of, under_robust
from motes.fitting.losses import LOSSES
from motes.fitting.nested import simplest_first
from motes.fitting.setup import Wishes, prepare, sample_weights
from motes.measurements import Measurement
from motes.models import describe
from motes.models.composition import layer_of
from motes.parameters import Role

# Candidates are compared on so many samples, and on so many directions at least; data of three times as many are thinned evenly.
COMPARED_SAMPLES, COMPARED_DIRECTIONS = 12_000, 1_000
# A layer with all orders of scattering is slow: it is tried where one that scatters once, over the same base, leaves less than this share of
# the least that a clean candidate leaves, of what it was fitted to or of what was left out, and ...
WORTH_TRYING = 0.9
# ... is so close to what was left out that the slow one could follow the data: within so many times `FOLLOWS`.
WITHIN_REACH = 1.5

Say = Callable[[str], None]


def climb(
    data: Measurement,
    wishes: Wishes,
    say: Say = lambda what: None,
    also: Sequence[Rung] = (),
    models: Sequence[str] = (),
) -> tuple[Rung, ...]:
    """Fit the candidates to one scan; in the order of the ladder.

    Parameters
    ----------
    say
        Called with each candidate before it is fitted.
    also
        What was fitted to another scan of a series: slow candidates among it are fitted even if they do not look worth it, from where they ended
        there.
    models
        What is fitted in place of the candidates, in this order, as it is written.

    Raises
    ------
    DataError
        Of the first candidate, when the data suffice for none.
    """
    if not models:
        check_names((*wishes.fixed, *wishes.per_channel))
    rows = _compared(data)
    if rows is not None:
        if not isinstance(wishes.weights, str):
            # Complains of a wrong shape before rows are taken.
            sample_weights(data, wishes.weights, LOSSES[wishes.loss])
            wishes = replace(wishes, weights=np.asarray(wishes.weights, float)[rows])
        data = data.select(rows)
    channels = even_channels(data.mask)
    ladder = _Ladder(data, wishes, channels, say)
    if wishes.robust != "none":
        plain = _Ladder(data, wishes, channels, say)
        plain.named(models) if models else plain.clean()
        ladder.plain = plain.rungs
    if models:
        ladder.named(models)
    else:
        ladder.clean()
        ladder.highlights_per_channel()
        ladder.layers(also)
    if not ladder.rungs:
        raise ladder.too_few or DataError("no candidate of auto has a parameter that is free", "Hold fewer parameters")
    return tuple(ladder.rungs)


def _compared(data: Measurement) -> NDArray[np.intp] | None:
    """The directions that candidates are compared on; None for all."""
    count = max(COMPARED_DIRECTIONS, COMPARED_SAMPLES // data.n_channels)
    return even_rows(data.n_directions, count) if data.n_directions > 3 * count else None


def even_rows(n: int, count: int) -> NDArray[np.intp]:
    """`count` of `n` rows, drawn evenly; the same each time."""
    return np.sort(np.random.default_rng(19940724).choice(n, min(n, count), replace=False))


class _Ladder:
    """The candidates that were fitted so far."""

    def __init__(self, data: Measurement, wishes: Wishes, channels: NDArray[np.intp] | None, say: Say) -> None:
        self.data, self.wishes, self.channels, self.say = data, wishes, channels, say
        self.rungs: list[Rung] = []
        self.plain: Sequence[Rung] = ()  # fits without the robust function, which tell its scale
        self.too_few: DataError | None = None
        self._blocks: Labels | None = None

    def named(self, models: Sequence[str]) -> None:
        """Those that were asked for, in this order; fitted the simplest first, which richer ones start from."""
        for text in simplest_first(models):
            self._try(text)
        self.rungs.sort(key=lambda rung: models.index(rung.text))

    def clean(self) -> None:
        """Those without a layer."""
        for candidate in LADDER:
            if layer_of(parsed(candidate.text).model) is None:
                self._try(candidate.text)

    def highlights_per_channel(self) -> None:
        """Those with a highlight once more, its strength for each channel, where that mends the best of them."""
        shared = [(rung, _strengths(rung)) for rung in self.rungs]
        coloured = [(rung, names) for rung, names in shared if names]
        if self.data.n_channels < 2 or not coloured:
            return
        best, names = min(coloured, key=lambda found: float(found[0].left_out.sum()))
        tried = self._try(best.text, names)
        if tried is None or not clearly_better(Contender.of([tried]), Contender.of([best])):
            self.rungs = [rung for rung in self.rungs if rung is not tried]
            return
        self.rungs.remove(tried)
        for rung, own in coloured:
            self._try(rung.text, own)

    def layers(self, also: Sequence[Rung]) -> None:
        """Those with a layer; with the strengths of highlights as the best clean one has them."""
        if not self.rungs:
            return
        best = min(self.rungs, key=lambda rung: float(rung.left_out.sum()))
        least = min(rung.objective for rung in self.rungs), float(best.left_out.sum())

        def worthwhile(rung: Rung) -> bool:
            left = float(rung.left_out.sum())
            near = 2 * left <= (WITHIN_REACH * FOLLOWS) ** 2 * float(rung.problem.brightness().sum())
            return near and (rung.objective < WORTH_TRYING * least[0] or left < WORTH_TRYING * least[1])

        for candidate in LADDER:
            model = parsed(candidate.text).model
            layer = layer_of(model)
            if layer is None:
                continue
            near = next((rung for rung in also if candidate.slow and rung.text == candidate.text), None)
            if candidate.slow and near is None:
                once = [rung for rung in self.rungs if _base(rung) == describe(layer.base)]
                if not any(worthwhile(rung) for rung in once):
                    continue
            names = tuple(slot.name for slot in model.slots(Role.HIGHLIGHT_STRENGTH)) if best.per_channel else ()
            self._try(candidate.text, names, near, candidate.slow)

    def _try(
        self, text: str, per_channel: tuple[str, ...] = (), near: Rung | None = None, slow: bool = False
    ) -> Rung | None:
        """A candidate as a new rung; None where it has too many parameters for the data, or none that is free."""
        wishes = self.wishes
        read = parsed(text)
        if not set(read.model.parameters) - set(wishes.fixed) - read.fixed:
            return None
        self.say(text)
        own = replace(wishes, per_channel=(*wishes.per_channel, *per_channel))
        try:
            brdf, _, problem, _ = prepare(self.data, read, own, lenient=True)
            if self.channels is not None:
                problem = problem.some_channels(self.channels)
            if self._blocks is None:
                self._blocks = blocks_of(problem.wi, problem.wo)
                if self._blocks.max() + 1 < FEWEST_BLOCKS:
                    self._blocks = np.zeros_like(self._blocks)
            problem = under_robust(problem, wishes.robust, self.plain) if self.plain else problem
            found = rung_of(text, brdf, problem, self.rungs, self._blocks, per_channel, near, slow)
        except DataError as error:
            self.too_few = self.too_few or error
            return None
        self.rungs.append(found)
        return found


def _strengths(rung: Rung) -> tuple[str, ...]:
    """The strengths of highlights that all channels share, and could have for themselves."""
    return tuple(
        q.name
        for q in rung.problem.quantities
        if q.parameter.role is Role.HIGHLIGHT_STRENGTH and q.parameter.per_channel and not q.per_channel
    )


def _base(rung: Rung) -> str:
    """What lies below the layer of a candidate; empty where it has none."""
    layer = layer_of(rung.brdf)
    return "" if layer is None else describe(layer.base)
