"""Hooks: what values of the engine need from higher layers, loaded by name at the first call.

The engine imports nothing upward.  `satviz/__init__.py`, which knows all layers, names the providers.
"""

from collections.abc import Callable
from importlib import import_module
from typing import Any

_PROVIDERS: dict[str, str] = {}


def provide(**providers: str) -> None:
    """Register, for each hook, the function that it calls, as "module:function", imported at the first call."""
    _PROVIDERS.update(providers)


def _provider(hook: str) -> Callable[..., Any]:
    """Import and return the function that provides a hook."""
    module, _, function = _PROVIDERS[hook].partition(":")
    provided: Callable[..., Any] = getattr(import_module(module), function)
    return provided


def mime_bundle(value: object) -> dict[str, str]:
    """Return what a notebook shows of a shape, a scene, a trace or a picture: its text and its picture by MIME type."""
    bundle: dict[str, str] = _provider("mime_bundle")(value)
    return bundle


def trace_to_json(trace: object, indent: int | None) -> str:
    """Return a trace as the text of a trace file."""
    text: str = _provider("trace_to_json")(trace, indent)
    return text


def trace_from_json(text: str) -> Any:
    """Return the Trace in the text of a trace file; InvalidScene if the text does not hold one."""
    return _provider("trace_from_json")(text)
