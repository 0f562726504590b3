"""What the gate lets pass on a screen, each with its reason."""

from __future__ import annotations

MAY_OVERLAP: dict[str, str] = {
    "#js-plotly-tester": "plotly measures its text there, far outside the screen",
}
"""Elements whose boxes are not compared, by selector."""

WORDS_MAY_MEET: dict[tuple[str, str], str] = {}
"""Pairs of words in a drawing whose boxes may meet."""

HARMLESS_MESSAGES: dict[str, str] = {
    "invalid theme mode": "the theme, on a first visit: no mode is stored yet",
    "unhandled promise rejection: NetworkError": "the theme looks for files that only a server has",
}
"""Messages on the console that do not concern a reader, by a part of them."""
