"""Check words against a British dictionary and the words of this project.

The dictionary is en_GB-ise of SCOWL as the npm package dictionary-en-gb 3.0.0 ships it; its licence lies beside it.
"""

from __future__ import annotations

import ast
import re
import warnings
from collections.abc import Iterable, Iterator
from functools import cache
from pathlib import Path
from typing import Any

HERE = Path(__file__).parent
OWN_WORDS = HERE / "words.txt"
NO_WORDS = re.compile(
    r"```.*?```|``[^`]*``|`[^`]*`"  # code
    r"|\$\$.*?\$\$|\$[^$]*\$"  # formulas
    r"|\{[a-z:]+\}`[^`]*`|\]\([^)]*\)|<[^>]*>|https?://\S+"  # references, addresses, markup
    r"|^ *(?:>>>|\.\.\.) .*$|^ *:[a-z-]+:.*$"  # examples and options
    r"|^ *\w+(?:, \w+)* : |\{[a-z-]+\}"  # names of arguments and directives
    r"|\"[^\"\n]{1,80}\""  # quotations
    r"|--[\w-]+|\\[A-Za-z]+|\S*[_/@=\\]\S*"  # options of commands, macros, names in code and of files
    r"|\S*\w\.\w\S*|\.\w+\(\)|\b\w*\d\w*\b",  # members, numbers with their units
    flags=re.DOTALL | re.MULTILINE)
WORD = re.compile(r"[^\W\d_]+(?:['’][^\W\d_]+)*")
"""Letters of any alphabet, with apostrophes inside."""
DIVIDED = re.compile(r"(?<=[a-z])-\n(?=[a-z])")
"""A label of a figure may divide a word."""
NAME_IN_CODE = re.compile(r"[a-z][A-Z]|^[A-Z]+s?$")
"""Names of classes and units have capitals inside; abbreviations are capitals throughout."""
SCRIPT = re.compile(r"=>|;\n|; [a-z-]+:|\{ [a-z-]+:|rgba\(|, \.[a-z]")
"""Style sheets and scripts of pages are no prose."""
SHORTEST = 3
"""Letters of a word that is checked: one or two are symbols, units and abbreviations."""
FEWEST_WORDS = 4
"""Shorter strings of a program are keys and names."""


@cache
def _dictionary() -> Any:
    from spylls.hunspell import Dictionary

    with warnings.catch_warnings():
        warnings.simplefilter("ignore", ResourceWarning)  # it leaves the closing of its files to the interpreter
        return Dictionary.from_files(str(HERE / "british" / "en_GB"))


@cache
def own_words() -> frozenset[str]:
    """Words of this project: names, and terms of the field that no general dictionary has."""
    return frozenset(OWN_WORDS.read_text(encoding="utf-8").split())


@cache
def is_word(word: str) -> bool:
    """Whether a word is British English or one of this project's; shorter ones are symbols."""
    plain = word.replace("’", "'")
    stem = plain.removesuffix("'s")
    if len(stem) < SHORTEST or not {stem, stem.lower()}.isdisjoint(own_words()):
        return True
    return bool(_dictionary().lookup(plain))


def words(text: str) -> Iterator[str]:
    """Every word of a text that is neither code nor formula."""
    for found in WORD.finditer(NO_WORDS.sub(" ", DIVIDED.sub("", text))):
        if not NAME_IN_CODE.search(found[0]):
            yield found[0]


def misspelt(texts: Iterable[str]) -> list[str]:
    """Words of some texts that are in neither dictionary, each once."""
    return sorted({word for text in texts for word in words(text) if not is_word(word)})


@cache
def said_in_code(path: Path) -> tuple[str, ...]:
    """Docstrings, messages, help and captions of a Python file: strings that hold a sentence or a phrase."""
    return tuple(text for text in _strings(path) if len(text.split()) >= FEWEST_WORDS and not SCRIPT.search(text))


def _strings(path: Path) -> Iterator[str]:
    tree = ast.parse(path.read_text(encoding="utf-8"))
    parts = {id(value) for node in ast.walk(tree) if isinstance(node, ast.JoinedStr) for value in node.values}
    for node in ast.walk(tree):
        if isinstance(node, ast.JoinedStr):
            yield "".join(value.value if isinstance(value, ast.Constant) else " {} " for value in node.values)
        elif isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in parts:
            yield node.value
