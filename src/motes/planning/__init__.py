"""Which directions to measure, and when: `plan` and `plan_times`, from the derivatives that fits use."""

from motes.planning.design import Design
from motes.planning.offers import Offer
from motes.planning.planner import plan
from motes.planning.schedule import Schedule, plan_times

__all__ = ["Design", "Offer", "Schedule", "plan", "plan_times"]
