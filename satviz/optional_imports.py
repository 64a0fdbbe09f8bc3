"""What only some users need comes as an extra, and there is one way to say how to get it."""


def extra_needed(what: str, extra: str) -> str:
    """The line that says which extra something needs, and how to install it.

    From a checkout: satviz is not published yet, and the name "satviz" on PyPI is another project's.
    """
    return f"{what} needs the extra {extra!r}: in a checkout of satviz run python -m pip install '.[{extra}]'"
