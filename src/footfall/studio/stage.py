"""The live character: what was commanded, what has become of it, and the ghost beside it."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from footfall.motion import Clip
from footfall.scenario.cue_sheet import ActionEntry, Cue, Scenario
from footfall.scenario.goal_change import GoalChange
from footfall.scenario.ground_change import GroundChange
from footfall.scenario.motions import Motion
from footfall.scenario.moving_ground import MovingGround
from footfall.skeleton import Skeleton
from footfall.studio.card import Card, by_part
from footfall.studio.motion_list import LoadedMotion, MotionList
from footfall.studio.performer import Performer
from footfall.studio.stage_gaits import StageGaits
from footfall.studio.stage_goals import StageGoals
from footfall.studio.stage_ground import StageGround
from footfall.studio.take import Take

__all__ = ["Stage"]


class Stage(StageGaits, StageGoals, StageGround):
    """One character that is steered by hand, over and over from the beginning of a take."""

    def __init__(self, motions: MotionList) -> None:
        """Prepare a take with all motions of the list that mix."""
        self._list = motions
        self.asked = GroundChange()
        self.cards: list[Card] = []
        self.restart()

    def restart(self) -> None:
        """Begin a new take: the character stands where the first motion begins."""
        performed = self._list.performed
        self._entries = [one.entry for one, _ in performed]
        self._motions = [self._list.whole(one) for one, _ in performed]
        self._clips = [clip for _, clip in performed]
        known = {card.name: card for card in self.cards}
        self.cards = [self._card(one, known.get(one.name)) for one, _ in performed]
        self._entries = [
            replace(entry, fade_in=card.fades[0], fade_out=card.fades[1])
            for entry, card in zip(self._entries, self.cards, strict=True)
        ]
        self.take = Take(replace(self._list.sheet(), actions=tuple(self._entries)))
        self.begun = False
        self._asked_gaits: dict[str, tuple[float, float]] = {}
        self._asked_goals: list[GoalChange] = []
        self.performer: Performer | None = None
        self.ghost: Performer | None = None
        self.ground = MovingGround(0.0)
        if self._motions:
            self._prepare(0)
            self._keep_in_reach()
            self.ground.ask(self.asked, self.pair()[0].root)
            for one in self.pair():
                one.stand()

    def _card(self, loaded: LoadedMotion, old: Card | None) -> Card:
        entry = loaded.entry
        if old is not None:
            return replace(old, action=loaded.name, reason="")
        fades = (entry.fade_in, entry.fade_out)
        return Card(loaded.name, loaded.name, by_part(entry.priority), fades)

    def _begin(self, leading: int) -> None:
        """Begin the take: a ground that was raised before rises again, as a scenario can say it."""
        self._prepare(leading)
        self.begun = True
        if self.asked != GroundChange():
            self.ground.ask(self.asked, self.pair()[0].root)
            self.take = self.take.with_cue(Cue(0.0, "ground", ground=self.asked))
        self._tell_goals()

    def _prepare(self, leading: int) -> None:
        motions = tuple(self._motions)
        scenario = self.take.scenario
        body, clips = self._list.body, self._clips
        self.performer = Performer(scenario, motions, leading, body=body, clips=clips)
        self.ghost = Performer(
            scenario, motions, leading, body=body, clips=clips, synchronized=False
        )
        self.ground = MovingGround(self.performer.floor)

    def add(self, loaded: LoadedMotion) -> None:
        """Let one more motion be performed, while the take goes on."""
        clip = self._list.fit(loaded, self._clips[0])
        assert not isinstance(clip, str)
        self._append(loaded.entry, self._list.whole(loaded), clip)
        self.cards.append(self._card(loaded, None))

    def card(self, name: str) -> Card | None:
        """Return the card of a motion, or None."""
        return next((one for one in self.cards if one.name == name), None)

    def start(self, card: Card) -> None:
        """Start an action, or let it wait; the first start begins the take."""
        if not self.begun:
            self._begin(self._index(card.action))
        self._tell_gait(card)
        performer, ghost = self.pair()
        card.reason = performer.start(card.action)
        ghost.start(card.action)
        self._log("start", card)
        if card.priority != by_part(self._entry(card.action).priority):
            self._tell_priority(card)

    def stop(self, card: Card) -> None:
        """Let an action fade out, or cancel its wait."""
        if not self.begun:
            return
        performer, ghost = self.pair()
        performer.stop(card.action)
        ghost.stop(card.action)
        card.reason = ""
        self._log("stop", card)

    def toggle(self, card: Card) -> None:
        """Start an action that does not play, stop one that does."""
        states = {} if self.performer is None else self.activity()
        if states.get(card.name, "idle") in ("idle", "fading out"):
            self.start(card)
        else:
            self.stop(card)

    def set_priority(self, card: Card, priority: dict[str, float]) -> None:
        """Change the priority of an action, now and at every later start."""
        card.priority = priority
        if self.begun and self.pair()[0].is_active(card.action):
            self._tell_priority(card)

    def set_fades(self, card: Card, fade_in: float, fade_out: float) -> None:
        """Change how long a start and a stop take, from the next start on."""
        card.fades = (fade_in, fade_out)
        if not self.begun:
            self.restart()
            return
        # A scenario says fades once an action: another fade is another action of this motion.
        index = self._index(card.action)
        wanted = {"fade_in": fade_in, "fade_out": fade_out}
        alike = [one for one in self._entries if _source(one) == _source(self._entries[index])]
        for entry in alike:
            if (entry.fade_in, entry.fade_out) == card.fades:
                card.action = entry.name
                return
        count = len(alike)
        entry = replace(self._entries[index], name=f"{card.name} fade {count + 1}", **wanted)
        self._append(entry, self._motions[index], self._clips[index])
        card.action = entry.name

    def advance(self) -> None:
        """Let one frame pass, once the take has begun; the ground moves towards its height."""
        if self.performer is None:
            return
        moved = self.ground.advance(1.0 / self.take.scenario.fps, self.performer.root)
        for one in self.pair():
            if moved:
                one.exchange_ground(self.ground.ground, self.ground.rise)
            if self.begun:
                one.advance()
            elif moved:
                one.stand()

    def activity(self) -> dict[str, str]:
        """Return what each motion does, by name."""
        assert self.performer is not None
        states = self.performer.states()
        return {card.name: states[self._index(card.action)].activity for card in self.cards}

    def action_index(self, card: Card) -> int:
        """Return which action of the scenario a card now means."""
        return self._index(card.action)

    def motion_name(self, action: int) -> str:
        """Return the motion of an action of the scenario."""
        source = _source(self._entries[action])
        return next(one.name for one in self._list.family if _source(one.entry) == source)

    def scenario(self) -> Scenario:
        """Return the take so far as a scenario."""
        clock = 0.0 if self.performer is None else self.performer.clock
        return self.take.until(clock)

    def _append(self, entry: ActionEntry, motion: Motion, clip: Clip) -> None:
        self._entries.append(entry)
        self._motions.append(motion)
        self._clips.append(clip)
        for one in self.pair():
            one.add(entry, replace(motion, clip=clip))
        self.take = Take(replace(self.take.scenario, actions=tuple(self._entries)))

    def pair(self) -> tuple[Performer, Performer]:
        """Return the character and its ghost; there must be a motion."""
        assert self.performer is not None
        assert self.ghost is not None
        return self.performer, self.ghost

    def _index(self, action: str) -> int:
        return next(i for i, entry in enumerate(self._entries) if entry.name == action)

    def _entry(self, action: str) -> ActionEntry:
        return self._entries[self._index(action)]

    def _tell_priority(self, card: Card) -> None:
        for one in self.pair():
            one.set_priority(card.action, card.priority)
        at = self.pair()[0].clock
        self.take = self.take.with_cue(Cue(at, "priority", card.action, dict(card.priority)))

    def _log(self, kind: Literal["start", "stop"], card: Card) -> None:
        self.take = self.take.with_cue(Cue(self.pair()[0].clock, kind, card.action))

    @property
    def body(self) -> Skeleton | None:
        """Who performs; None: the body of the first motion."""
        return self._list.body

    @property
    def motions(self) -> tuple[Motion, ...]:
        """The motion of each action of the scenario."""
        return tuple(self._motions)


def _source(entry: ActionEntry) -> tuple[str, ...]:
    """Return what an action performs, by whatever name and with whatever fades."""
    return entry.motion, *entry.others
