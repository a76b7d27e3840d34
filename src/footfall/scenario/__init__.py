"""A cue sheet: what starts and stops when."""

from footfall.scenario.schedule_problem import describe_problem, solve_batch, solve_problem

__all__ = ["describe_problem", "solve_batch", "solve_problem"]
