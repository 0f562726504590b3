"""Reading a small file whole: every way in which that can fail gets its own sentence."""

from __future__ import annotations

from pathlib import Path

from granular.errors import FileTooLarge, FileUnreadable

LARGEST = 1 << 20
"""Largest file [byte]; a scene or a gradation curve is some hundred bytes long, so anything larger is neither."""


def bytes_of(path: Path, name: str, *, kind: str = "a scene file") -> bytes:
    """Read a small file whole.

    Parameters
    ----------
    path : Path
        The file.
    name : str
        Its name for messages.
    kind : str
        What belongs there, with its article.

    Returns
    -------
    bytes
        At most 1 MiB.

    Raises
    ------
    FileUnreadable, FileTooLarge
        The file is missing, a folder, forbidden, or too large.

    Notes
    -----
    Source: a policy of this package.
    """
    try:
        with path.open("rb") as file:
            content = file.read(LARGEST + 1)
    except FileNotFoundError:
        raise FileUnreadable(f"{name} does not exist", allowed=f"{kind} is needed",
                             remedy="Check the path.") from None
    except IsADirectoryError:
        raise FileUnreadable(f"{name} is a folder", allowed=f"{kind} is needed",
                             remedy="Name a file in it.") from None
    except PermissionError:
        readable = kind.replace("a ", "a readable ", 1)
        raise FileUnreadable(f"{name} may not be read", allowed=f"{readable} is needed",
                             remedy="Change its permissions.") from None
    except (OSError, ValueError) as error:
        reason = error.strerror if isinstance(error, OSError) and error.strerror else str(error)
        raise FileUnreadable(f"{name} cannot be read ({reason.lower()})", allowed=f"{kind} is needed",
                             remedy="Check the path.") from None
    if len(content) > LARGEST:
        raise FileTooLarge(f"{name} is larger than {LARGEST} bytes",
                           allowed=f"allowed up to {LARGEST} bytes (1 MiB)",
                           remedy=f"Name {kind}; keep other data in files of their own.")
    return content
