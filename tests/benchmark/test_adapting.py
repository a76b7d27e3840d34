from __future__ import annotations

from footfall.benchmark import adapting


def test_adaptation_costs_at_most_as_much_as_the_rest_of_a_tick() -> None:
    shares = adapting.adaptation_shares()
    print({name: f"{100.0 * share:.0f} %" for name, share in shares.items()})
    assert set(shares) == set(adapting.GROUNDS)
    assert max(shares.values()) > 0.0
    assert all(share <= 1.0 for share in shares.values())
