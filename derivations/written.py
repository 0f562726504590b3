"""Whether a symbol stands in a formula that is written in LaTeX."""

from __future__ import annotations

import re

_NO_SYMBOLS = re.compile(r"\\(?:text|mathrm|operatorname)\{(?!SR|kin|sta)[^{}]*\}|\\[dD]elta_\{[ijklp]+\}")
"""What looks like symbols and is none: words, operators, Kronecker's delta."""
_BRACED = re.compile(r"\^\{(\\[a-z]+|\w)\}")
_NOT_BEFORE = r"(?<![a-zA-Z\\])(?<!\\tilde )(?<!\\bar )(?<!\\bar)(?<!\\tilde)(?<!\\mathrm )"
_NOT_BEHIND = r"(?![a-zA-Z_']|\^\\circ|\^\{\(|\^r)"


def is_name(latex: str) -> bool:
    """Whether a symbol is more than one letter, so that nothing else can be meant by it."""
    return re.fullmatch(r"\\?[a-zA-Z]+", latex) is None


def stands_in(latex: str, formula: str) -> bool:
    """Whether a symbol stands in a formula by itself: not within a command, nor with another index, mark or accent."""
    return re.search(_pattern(latex), _bare(formula)) is not None


def is_defined(latex: str, formula: str) -> bool:
    """Whether a symbol stands alone on the left of an equality sign."""
    return re.search(rf"(?:^|[,;&]|quad|\n)\s*{_pattern(latex)}\s*&?=", _bare(formula)) is not None


def _pattern(latex: str) -> str:
    return _NOT_BEFORE + re.escape(_bare(latex)) + _NOT_BEHIND


def _bare(formula: str) -> str:
    return _BRACED.sub(r"^\1", _NO_SYMBOLS.sub(" ", formula))
