"""A world as a graph: states, the outcomes of an action, and their rewards."""

from __future__ import annotations

from collections import deque

import numpy as np

from laplace_core import World
from laplace_core.figures.theme import NEUTRAL, Figure, Trace, action_colour, axis, build, in_plotly
from laplace_core.worlds import END, Outcome

MAX_DRAWN = 26
_GRID_MAX = 700
_SNAKE = 6  # states in a row before a plain chain turns round
_FAINT = 0.6
_LONG = 3.0  # columns that an edge may span before its bend stops growing
_NAMED_COLUMNS = 6  # more columns than this leave no room for names beneath the states

Places = dict[int, tuple[float, float]]


def world_graph(world: World, state: int, action: int, policy: np.ndarray) -> Figure:
    """The states near ``state``, the outcomes of ``action`` highlighted, those of the policy elsewhere in grey."""
    positions = world.positions if world.n_states <= _GRID_MAX else None
    gridded = positions is not None
    drawn = list(range(world.n_states)) if gridded else _nearby(world, state)
    places = _layered_places(world, drawn) if positions is None else _grid_places(positions)
    edges = _grid_edges(world, places, drawn, policy) if gridded else []
    arrows: list[Trace] = []
    for s in drawn:
        for a in range(world.n_actions):
            lit = s == state and a == action
            if lit or (not gridded and (a == policy[s] or (s == state and world.n_actions <= 6))):
                colour = action_colour(a) if s == state else NEUTRAL
                _add_edges(
                    edges,
                    arrows,
                    world,
                    places,
                    s=s,
                    a=a,
                    colour=colour,
                    lit=lit,
                    labelled=_room_for_labels(world, s, a, lit=lit, drawn=len(drawn), gridded=gridded),
                )
    hidden = world.n_states - len(drawn)
    corners = [*places.values(), *_ends_of(edges)]
    (x_low, y_low), (x_high, y_high) = np.min(corners, axis=0), np.max(corners, axis=0)
    return build(
        "World" if not hidden else f"World ({hidden:,} distant states are not drawn)",
        [*edges, *_nodes(world, drawn, places, state, action=action, gridded=gridded)],
        margin={"l": 6, "r": 6, "t": 30, "b": 6},
        showlegend=False,
        annotations=arrows,
        xaxis=axis(visible=False, range=[x_low - 0.6, x_high + 0.6]),
        yaxis=axis(visible=False, range=[y_low - 0.8, y_high + 0.8]),
    )


def _ends_of(edges: list[Trace]) -> list[tuple[float, float]]:
    """The outermost points of curved edges: a long one bends beyond the states that it joins."""
    curves = [edge for edge in edges if isinstance(edge["x"], np.ndarray)]
    return [(float(pick(edge["x"])), float(pick(edge["y"]))) for edge in curves for pick in (np.min, np.max)]


def _room_for_labels(world: World, s: int, a: int, *, lit: bool, drawn: int, gridded: bool) -> bool:
    if gridded:  # neighbours are so close that two labels would cover each other
        return len({row.next_state for row in world.outcomes(s, a)}) == 1
    return lit or drawn <= 16


def _successors(world: World, state: int) -> list[int]:
    first, last = np.searchsorted(world.state, [state, state + 1])
    return [s for s in world.next_state[first:last].tolist() if s != END]


def _nearby(world: World, state: int) -> list[int]:
    """All states if they fit, else those nearest after ``state``."""
    if world.n_states <= MAX_DRAWN:
        return list(range(world.n_states))
    seen, queue = {state: None}, deque([state])
    while queue and len(seen) < MAX_DRAWN:
        for successor in _successors(world, queue.popleft()):
            if successor not in seen and len(seen) < MAX_DRAWN:
                seen[successor] = None
                queue.append(successor)
    return list(seen)


def _grid_places(positions: np.ndarray) -> Places:
    places = {s: (float(x), float(y)) for s, (x, y) in enumerate(positions)}
    places[END] = (float(positions[:, 0].max()) + 1.0, float(positions[:, 1].min()))
    return places


def _layered_places(world: World, drawn: list[int]) -> Places:
    """Columns by distance from the first state; a plain chain winds; END comes last."""
    start = int(np.argmax(world.start))
    depth = {start if start in drawn else drawn[0]: 0}
    queue = deque(depth)
    while queue:
        s = queue.popleft()
        for successor in _successors(world, s):
            if successor in drawn and successor not in depth:
                depth[successor] = depth[s] + 1
                queue.append(successor)
    columns: dict[int, list[int]] = {}
    for s in sorted(drawn, key=lambda s: (depth.get(s, 0), s)):
        columns.setdefault(depth.get(s, 0), []).append(s)
    ordered = [columns[key] for key in sorted(columns)]
    if all(len(states) == 1 for states in ordered) and len(ordered) >= 2 * _SNAKE - 2:
        return {s: _winding(i) for i, s in enumerate([*(states[0] for states in ordered), END])}
    places = {
        s: (float(column), ((len(states) - 1) / 2.0 - i) * 1.2)
        for column, states in enumerate(ordered)
        for i, s in enumerate(states)
    }
    return {**places, END: (float(len(ordered)), 0.0)}


def _winding(i: int) -> tuple[float, float]:
    row, along = divmod(i, _SNAKE)
    return float(along if row % 2 == 0 else _SNAKE - 1 - along), -1.2 * row


def _grid_edges(world: World, places: Places, drawn: list[int], policy: np.ndarray) -> list[Trace]:
    """The policy as short strokes, all in one trace: a grid may have hundreds."""
    x: list[float | None] = []
    y: list[float | None] = []
    tips: list[tuple[float, float, float]] = []
    for s in drawn:
        outcomes = world.outcomes(s, int(policy[s]))
        goal = places.get(max(outcomes, key=lambda row: row.probability).next_state, places[s])
        (x0, y0), (x1, y1) = places[s], goal
        length = np.hypot(x1 - x0, y1 - y0)
        if length > 0:
            dx, dy = 0.5 * (x1 - x0) / length, 0.5 * (y1 - y0) / length
            x += [x0, x0 + dx, None]
            y += [y0, y0 + dy, None]
            tips.append((x0 + dx, y0 + dy, float(np.degrees(np.arctan2(dx, dy)))))
    strokes = {"type": "scatter", "x": x, "y": y, "mode": "lines", "line": {"color": NEUTRAL, "width": 1.2}}
    heads = {"symbol": "triangle-up", "size": 6, "color": NEUTRAL, "angle": [angle for *_, angle in tips]}
    points = {
        "type": "scatter",
        "x": [t[0] for t in tips],
        "y": [t[1] for t in tips],
        "mode": "markers",
        "marker": heads,
    }
    return [{**strokes, "hoverinfo": "skip"}, {**points, "hoverinfo": "skip"}]


def _add_edges(
    edges: list[Trace], arrows: list[Trace], world: World, places: Places, *, s: int, a: int, colour: str, lit: bool,
    labelled: bool,
) -> None:  # fmt: skip
    """The outcomes of one state and action: a curve, an arrowhead, and what they pay and how often."""
    merged: dict[int, list[Outcome]] = {}
    for row in world.outcomes(s, a):
        merged.setdefault(row.next_state, []).append(row)
    strong = {"opacity": 1.0 if lit else _FAINT}
    for successor, rows in merged.items():
        if successor not in places:
            continue
        p = sum(row.probability for row in rows)
        x, y = _curve(places[s], places[successor], _bend(world, a))
        line = {"color": colour, "width": 3.5 if lit else 1.2, "dash": "solid" if p > 0.999 else "dot"}
        edges.append({"type": "scatter", "x": x, "y": y, "mode": "lines", "line": line, "hoverinfo": "skip", **strong})
        end = int(0.8 * len(x))
        arrows.append(
            {"x": x[end], "y": y[end], "ax": x[end - 2], "ay": y[end - 2], "axref": "x", "ayref": "y", "xref": "x",
             "yref": "y", "text": "", "showarrow": True, "arrowhead": 2, "arrowsize": 1.1, "arrowcolor": colour,
             "arrowwidth": 3.0 if lit else 1.2, **strong}
        )  # fmt: skip
        if labelled and (lit or p < 0.999 or any(row.reward for row in rows)):
            text = _rewards(rows) if p > 0.999 else f"{p:.2g}: {_rewards(rows)}"
            font = {"size": 13 if lit else 11}
            place = {"x": x[2 * len(x) // 5], "y": y[2 * len(y) // 5], "yshift": 10}
            # The page puts its own colour under a label, so that an edge that passes there does not hide it.
            place |= {"bgcolor": "#ffffff", "borderpad": 0}
            arrows.append({**place, "text": text, "showarrow": False, "font": font})


def _rewards(rows: list[Outcome]) -> str:
    """``5``; ``-2 or 2``; the mean of more than two."""
    values = sorted({row.reward for row in rows})
    if len(values) <= 2:
        return " or ".join(f"{value:.3g}" for value in values)
    return f"mean {sum(row.probability * row.reward for row in rows) / sum(row.probability for row in rows):.3g}"


def _bend(world: World, action: int) -> float:
    return 0.0 if world.n_actions == 1 else 0.28 * (1.0 - 2.0 * action / (world.n_actions - 1))


def _curve(
    start: tuple[float, float], end: tuple[float, float], bend: float, points: int = 25
) -> tuple[np.ndarray, np.ndarray]:
    """A quadratic curve from start to end; a loop where they are the same place."""
    t = np.linspace(0.0, 1.0, points)
    (x0, y0), (x1, y1) = start, end
    if start == end:
        angle = 2.0 * np.pi * t
        return x0 + 0.22 * np.sin(angle), y0 + 0.25 * (1.0 - np.cos(angle))
    bend *= min(1.0, _LONG / max(abs(x1 - x0), abs(y1 - y0)))  # a long edge is flatter
    middle_x, middle_y = (x0 + x1) / 2.0 - bend * (y1 - y0), (y0 + y1) / 2.0 + bend * (x1 - x0)
    first, second, third = (1 - t) ** 2, 2 * t * (1 - t), t**2
    return first * x0 + second * middle_x + third * x1, first * y0 + second * middle_y + third * y1


def _nodes(world: World, drawn: list[int], places: Places, state: int, *, action: int, gridded: bool) -> list[Trace]:
    names = [world.states[s] for s in drawn]
    columns = {x for x, _ in places.values()}
    crowded = gridded or len(drawn) > 10 or len(columns) > _NAMED_COLUMNS + 1
    size = max(6, min(22, int(190 / np.sqrt(len(drawn))))) if gridded else 24 if len(drawn) <= 12 else 17
    outline = {"color": "#5b616b", "width": 1.2}
    font = {"textposition": "bottom center", "textfont": {"size": 11}}
    states = {
        "type": "scatter",
        "x": [places[s][0] for s in drawn],
        "y": [places[s][1] for s in drawn],
        "mode": "markers" if crowded else "markers+text",
        "text": [in_plotly(name if len(name) <= 14 else name[:13] + "…") for name in names],
        "customdata": [[s, in_plotly(name)] for s, name in zip(drawn, names, strict=True)],
        "hovertemplate": "%{customdata[1]}<br>click to see its timeline<extra></extra>",
        "marker": {
            "size": size,
            "color": [action_colour(action) if s == state else "#c9ced6" for s in drawn],
            "symbol": "square" if gridded else "circle",
            "opacity": 1.0,
            "line": outline,
        },
        # A click selects a point; the page answers it, the picture should not fade.
        "selected": {"marker": {"opacity": 1.0}},
        "unselected": {"marker": {"opacity": 1.0}},
        **font,
    }
    end = {
        "type": "scatter",
        "x": [places[END][0]],
        "y": [places[END][1]],
        "mode": "markers+text",
        "text": ["END"],
        "hovertemplate": "the episode is over<extra></extra>",
        "marker": {"size": size, "color": "#3a3f47", "symbol": "square", "line": outline},
        **font,
    }
    return [states, end]
