"""Pictures of motions and schedules, and the demo page."""

from footfall.view.foot_traces import foot_traces_svg
from footfall.view.lanes import ActionLane, CueMark, LanePhase, Timeline
from footfall.view.page import DemoPage, demo_page_html, write_demo_page
from footfall.view.performed_lanes import performance_timeline
from footfall.view.strip import strip_svg
from footfall.view.timeline import timeline_svg

__all__ = [
    "ActionLane",
    "CueMark",
    "DemoPage",
    "LanePhase",
    "Timeline",
    "demo_page_html",
    "foot_traces_svg",
    "performance_timeline",
    "strip_svg",
    "timeline_svg",
    "write_demo_page",
]
