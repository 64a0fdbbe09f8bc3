"""Hooks: what values of the engine need from higher modules, loaded by name at the first call.

The engine imports nothing upward.  `satviz/__init__.py`, which knows all layers, names the providers.
"""

from importlib import import_module
from typing import Any

_PROVIDERS: dict[str, str] = {}


def provide(**providers: str) -> None:
    """Register, for each hook, the function that it calls, as "module:function", imported at the first call."""
    _PROVIDERS.update(providers)


def call(hook: str, *arguments: Any) -> Any:
    """Import the function that provides a hook, and return what it returns for these arguments."""
    module, _, function = _PROVIDERS[hook].partition(":")
    return getattr(import_module(module), function)(*arguments)


def mime_bundle(value: object) -> dict[str, str]:
    """Return what a notebook shows of a shape, a scene, a trace or a picture: its text and its picture by MIME type."""
    bundle: dict[str, str] = call("mime_bundle", value)
    return bundle
