"""Libraries that only some users need come as extras; an error line says how to install one."""


def extra_needed(what: str, extra: str) -> str:
    """Return the error line that says which extra something needs, and how to install it.

    The command installs from a checkout, because satviz is not published yet: the name "satviz" on PyPI belongs to
    another project.
    """
    return f"{what} needs the extra {extra!r}: in a checkout of satviz run python -m pip install '.[{extra}]'"
