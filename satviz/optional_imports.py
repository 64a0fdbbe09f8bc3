"""Libraries that only some users need come as extras; an error line says how to install one."""


def extra_needed(what: str, extra: str) -> str:
    """Return the error line that says which extra something needs, and how to install it.

    From a checkout: satviz is not published yet, and the name "satviz" on PyPI is another project's.
    """
    return f"{what} needs the extra {extra!r}: in a checkout of satviz run python -m pip install '.[{extra}]'"
