"""Panels with logarithmic axes beside each other, as SVG. The same numbers give the same file."""

import dataclasses
import math

COLOURS = ("#0072b2", "#d55e00", "#009e73", "#cc79a7", "#e69f00")
WIDTH, HEIGHT, LEGEND_LINE = 250, 290, 15
LEFT, RIGHT, TOP, BOTTOM = 62, 14, 56, 46
# Over how many points at the end the slope is taken.
END = 3


@dataclasses.dataclass
class Line:
    """Points (x, y) with a name."""

    name: str
    points: list[tuple[float, float]]

    def slope(self) -> tuple[float, float]:
        """Exponent and factor of `y = factor x^exponent`, least squares over the logarithms of the last points."""
        logs = [(math.log(x), math.log(y)) for x, y in self.points[-END:]]
        centre = [sum(values) / len(logs) for values in zip(*logs)]
        spread = sum((x - centre[0]) ** 2 for x, _ in logs)
        exponent = sum((x - centre[0]) * (y - centre[1]) for x, y in logs) / spread
        return exponent, math.exp(centre[1] - exponent * centre[0])


@dataclasses.dataclass
class Panel:
    """Lines over the same values; `notes` stand above the points of the first line, and `remark` says what they are."""

    title: str
    label: str
    lines: list[Line]
    notes: list[str] = dataclasses.field(default_factory=list)
    remark: str = ""


@dataclasses.dataclass
class Axis:
    """A logarithmic axis from `low` to `high`, drawn from `start` to `end`."""

    low: float
    high: float
    start: float
    end: float

    def at(self, value: float) -> float:
        """Where a value is drawn."""
        share = math.log(value / self.low) / math.log(self.high / self.low)
        return self.start + share * (self.end - self.start)


def draw(title: str, label: str, panels: list[Panel]) -> str:
    """The figure; `label` is that of all horizontal axes."""
    step = LEFT + WIDTH + RIGHT
    width, height = len(panels) * step, TOP + HEIGHT + BOTTOM
    lines = [
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{height}" viewBox="0 0 {width} {height}" '
        'font-family="sans-serif" font-size="12" fill="#202020">',
        '<rect width="100%" height="100%" fill="#ffffff"/>',
        text(width / 2, 20, title, 'font-size="15" font-weight="bold" text-anchor="middle"'),
    ]
    for index, panel in enumerate(panels):
        lines.append(f'<g transform="translate({index * step + LEFT} {TOP})">')
        lines += draw_panel(panel, label)
        lines.append("</g>")
    return "\n".join([*lines, "</svg>"]) + "\n"


def draw_panel(panel: Panel, label: str) -> list[str]:
    """One panel with its frame, in coordinates that begin at its upper left corner."""
    values = [x for x, _ in panel.lines[0].points]
    heights = [y for line in panel.lines for _, y in line.points]
    across = Axis(values[0] / 1.25, values[-1] * 1.25, 0, WIDTH)
    up = Axis(
        min(heights) / 1.3, max(heights) * 1.3, HEIGHT, 12 + LEGEND_LINE * (len(panel.lines) + bool(panel.remark))
    )
    drawn = [text(WIDTH / 2, -10, panel.title, 'font-size="13" text-anchor="middle"')]
    for value in values:
        drawn.append(stroke(across.at(value), 0, across.at(value), HEIGHT, "#e4e4e4"))
    for value in readable(values, across, 18):
        drawn.append(text(across.at(value), HEIGHT + 16, f"{value:g}", 'text-anchor="middle"'))
    for value in ticks(up):
        drawn.append(stroke(0, up.at(value), WIDTH, up.at(value), "#e4e4e4"))
        drawn.append(text(-6, up.at(value) + 4, f"{value:g}", 'text-anchor="end"'))
    drawn.append(f'<rect width="{WIDTH}" height="{HEIGHT}" fill="none" stroke="#707070"/>')
    drawn.append(text(WIDTH / 2, HEIGHT + 36, label, 'text-anchor="middle"'))
    drawn.append(text(0, 0, panel.label, f'text-anchor="middle" transform="translate(-46 {HEIGHT / 2}) rotate(-90)"'))
    for line, colour in zip(panel.lines, COLOURS):
        drawn += draw_line(line, colour, across, up)
    drawn += legend(panel)
    for (x, y), note in zip(panel.lines[0].points, panel.notes):
        drawn.append(text(across.at(x), up.at(y) - 7, note, 'font-size="10" fill="#606060" text-anchor="middle"'))
    return drawn


def draw_line(line: Line, colour: str, across: Axis, up: Axis) -> list[str]:
    """Points, joined."""
    places = [(across.at(x), up.at(y)) for x, y in line.points]
    joined = " ".join(f"{x:.1f},{y:.1f}" for x, y in places)
    drawn = [f'<polyline points="{joined}" fill="none" stroke="{colour}" stroke-width="1.6"/>']
    return drawn + [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.8" fill="{colour}"/>' for x, y in places]


def legend(panel: Panel) -> list[str]:
    """Names and slopes in the upper left corner."""
    drawn = []
    for index, (line, colour) in enumerate(zip(panel.lines, COLOURS)):
        y = 16 + LEGEND_LINE * index
        words = f"{line.name}: slope {line.slope()[0]:.1f}".removeprefix(": ")
        drawn.append(f'<circle cx="12" cy="{y - 4}" r="3.5" fill="{colour}"/>')
        drawn.append(text(21, y, words, 'font-size="11"'))
    if panel.remark:
        drawn.append(text(8, 18 + LEGEND_LINE * len(panel.lines), panel.remark, 'font-size="10" fill="#606060"'))
    return drawn


def ticks(axis: Axis) -> list[float]:
    """Powers of ten and, where these are few, some multiples of them."""
    decades = range(math.floor(math.log10(axis.low)), math.ceil(math.log10(axis.high)) + 1)
    span = axis.high / axis.low
    factors = (1, 2, 3, 5, 7) if span < 15 else (1, 2, 5) if span < 1000 else (1,)
    values = [factor * 10.0**decade for decade in decades for factor in factors]
    return [value for value in values if axis.low <= value <= axis.high]


def readable(values: list[float], axis: Axis, apart: float) -> list[float]:
    """The values, from the last on, whose labels do not overlap."""
    kept = []
    for value in reversed(values):
        if not kept or axis.at(kept[-1]) - axis.at(value) >= apart + 3 * len(f"{kept[-1]:g}"):
            kept.append(value)
    return kept


def stroke(x1: float, y1: float, x2: float, y2: float, colour: str) -> str:
    """A straight line."""
    return f'<line x1="{x1:.1f}" y1="{y1:.1f}" x2="{x2:.1f}" y2="{y2:.1f}" stroke="{colour}"/>'


def text(x: float, y: float, words: str, style: str) -> str:
    """Words at a place."""
    return f'<text x="{x:.1f}" y="{y:.1f}" {style}>{words}</text>'
