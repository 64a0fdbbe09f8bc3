"""Texts in notations of many libraries: each is read rightly, asked about, or named as unread."""

import re

import pytest
from pastes import PASTES

import satviz as sv


def bounds(read):
    """The bounding box of a shape as it was read."""
    reach = read.radius or 0
    xs, ys = zip(*read.points, strict=True)
    return tuple(float(v) for v in (min(xs) - reach, min(ys) - reach, max(xs) + reach, max(ys) + reach))


def right(paste, pasted):
    """Whether the shapes are those of the text, and what it cannot say is named."""
    found = [bounds(each.read) for each in pasted.readings]
    said = " ".join(map(str, pasted.findings))
    return len(found) == len(paste.bounds) and found == [pytest.approx(b) for b in paste.bounds] and paste.says in said


@pytest.mark.parametrize("paste", PASTES, ids=lambda paste: re.sub(r"\W+", "-", paste.name))
def test_a_text_is_never_read_wrongly_without_a_word(paste):
    try:
        pasted = sv.paste(paste.text, paste.as_)
    except sv.InvalidScene:
        return
    named = any(finding.kind in ("not-read", "not-applied") for finding in pasted.findings)
    assert right(paste, pasted) or named or pasted.open or not pasted.traces
