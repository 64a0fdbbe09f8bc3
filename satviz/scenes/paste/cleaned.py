"""A text without what stands around its shapes, of the same length: prompts, quotes, removed lines, numbers of lines.

Each rule writes spaces, or as many other letters, so that every place in the cleaned text is that of the pasted one.
"""

import re
from html import unescape

from .tokens import MAX_CHARS

_N = r"[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?"
# what a Python or IPython session writes before each line
_PROMPT = r"^[ \t]*(?:>>>|\.\.\.:?(?!\s*\n\s*[\[({\d-]|[ ](?:and )?\d+ more\b)|In ?\[\d+\]:=?|Out\[\d+\][:=])(?=\s)"
# what a log or a list writes before a shape: a date and a time, a level, a source, a number
_TIME = r"\d\d:\d\d:\d\d(?:[.,]\d+)?"
_STAMP = (
    rf"\d{{4}}[-/]\d\d[-/]\d\d(?:[T ](?:{_TIME}|\d\d:\d\d)(?:Z|[+-]\d\d:?\d\d)?)?"
    rf"|(?:\d\d-\d\d[ ]|[IWEF]\d{{4}}[ ])?{_TIME}(?:[ ][AP]M\b)?|\d{{10}}\.\d+(?=\])"
)
# the host and the process that syslog writes after the time, and the source line that glog writes
_SYSLOG = rf"(?:<\d+>\d?[ ]?)?(?:[A-Z][a-z]{{2}}[ ]+\d{{1,2}}[ ]{_TIME}|{_STAMP})[ ][\w.-]+[ ]"
# patterns that describe a whole shape: three keys with numbers (not x, y and z), or two keys with points
_KEYED = r"[A-Za-z_][\w-]*[ \t]?=[ \t]?"
_SCALAR, _POINT, _GAP = rf"{_KEYED}[-+]?[\d.]+", rf"{_KEYED}\([^()\n]*\)", r"[ \t,;]+"
_KEYS = rf"{_SCALAR}{_GAP}{_SCALAR}{_GAP}(?![zZ]\b){_SCALAR}|{_POINT}(?:{_GAP}{_POINT}|,[ ]?{_SCALAR})"
_PREFIX = rf"""(?x)^[ \t]*(?:{_SYSLOG}(?:[\w./-]+(?:\[\d+\])?:|[\w.-]+[ ][\w-]+[ ][\w-]+[ ]-)[ ]+
       |[IWEF]\d{{4}}[ ]{_TIME}[ ]+\d+[ ][\w./-]+:\d+\][ ]
       |[\[(<]?(?:{_STAMP})(?!\d)[\])>]?[ \t:|,-]*)?
    (?:(?:\[[A-Za-z][\w\ ./:\#-]*\](?!\s*=>)|\b(?:TRACE|DEBUG|INFO|WARN|WARNING|ERROR|FATAL)\b
       |[VDIWEF]/[\w.-]+(?:\([ \d]+\))?:|\d+[ ]+\d+[ ]+[VDIWEF][ ]+[\w.-]+[ ]*:
       |[a-z]\w*(?:\.\w+)+(?=[ ]-[ ][A-Za-z]))[ \t:|-]+)*
    (?:\(?\d{{1,3}}[.)][ \t]+(?=[A-Za-z(\[{{]))?
    (?:(?:\d+[ \t,|]+|\w+[ \t]*\|[ \t]*){{1,3}}(?=(?:[A-Za-z]\w*[ ]+)?(?:MULTI)?POLYGON\b))?
    (?:(?:[A-Za-z_][\w.\#-]*[ ]){{0,2}}[\w.\#-]+:[ \t]+(?={_KEYS}))?
    (?:(?:>[ ])?\d*[ \t]+\|(?=[ \t]+(?:[A-Za-z]|\^)))?"""
_SHAPE = r"(?i:circle|ball|dis[ck]|rect(?:angle)?|box|polygon|triangle)"
# Circle #1 (0, 0, 2): a number of a shape before its own numbers
_NUMBERED = rf"\b({_SHAPE})[ ]+(?:#\d+:?|\d+:?(?=[ ]*\([ ]?{_N}[ ]?,[ ]?{_N}[ ]?,))(?=[ ]*\()"
_LETTER = r"(?:x|y|w|h|r|width|height|radius)"
_PLACED = r"(?:(?:top|bottom|upper|lower)[ -](?:left|right)|center|centre|pos|position|size|extents)"
# After the sign of a line that a change adds or removes stands no number, as in -4, and not one space, as in a list.
_REMOVED, _ADDED = r"[ \t]*-(?![ \t]*[-.\d]| \S).*\n", r"[ \t]*\+(?![ \t]*[.\d]| \S).*(?:\n|\Z)"
_PATCH = re.compile(r"^(?:--- \S.*\n\+\+\+ \S|@@ -\d+.*@@)", re.MULTILINE)
_CHANGE = re.compile(rf"^(?:{_REMOVED})++(?P<added>(?:{_ADDED})++)?", re.MULTILINE)


def blank(match: re.Match[str], part: str | int = 0) -> str:
    """Return a match with spaces in place of the text of a group that ends it; 0 is all of it.  Lines stay lines."""
    return match[0].removesuffix(match[part]) + re.sub(r"[^\n]", " ", match[part])


def keyed(match: re.Match[str]) -> str:
    """Return a match as keys: x=10 for x 10, and top_left=(0, 0) for top left (0, 0)."""
    return re.sub(r"(?<=[a-z])[ -](?=[a-z])", "_", re.sub(r"(?<=[a-z]) (?=[-+.\d(])", "=", match[0]))


# One row for each: where it stands, and what is written there.
_ROWS = [
    (re.compile(pattern, re.MULTILINE), write)
    for pattern, write in (
        (_PROMPT, blank),
        (r"^ *\[,1\] +\[,2\] *$|^ *\[\d+,\](?= )", blank),  # a matrix of R
        (rf"\b(?!h){_LETTER} {_N}(?:[ ,;]+{_LETTER} {_N}(?![\w.])){{2,}}", keyed),
        (rf"\b{_PLACED} \([^()\n]*\)[ ,;]+{_PLACED} \((?:[^()\n]*\)[ ,;]+(?:angle|rot(?:ation)?) [-.\d])?", keyed),
        (r"(?<=\d) ?(deg|rad|\u00b0)(?:rees|ians?)?(?!\w)", lambda m: m[1].ljust(len(m[0]))),
        (r"<br ?/?>|&(?:quot|#39|nbsp);", blank),
        (r"&(?:amp|lt|gt);", lambda m: unescape(m[0]).ljust(len(m[0]))),
        (rf"<([A-Za-z]\w*)>(\s*{_N}\s*)</\1>", lambda m: f" {m[1]}={m[2]};".ljust(len(m[0]))),
        (  # PHP writes [x] => 0, Clojure :x 0; a number is a place in a list
            r"(?:\[(\w+)\]|\b(\d+))\s*=>(?=\s*(?:[Aa]rray\b|[-\d\[]))|(?<=[{\s]):([a-z]\w*)\s(?=\s*[-.\d\[{])",
            lambda m: ("," if m[m.lastindex].isdigit() else f",{m[m.lastindex]}:").ljust(len(m[0])),
        ),
        (rf"^[ \t]*\w{{1,40}}\s*<<(?=\s*{_N}(?:\s*,\s*{_N}){{5,}}\s*;)", lambda m: m[0].replace("<<", "= ")),  # Eigen
        (r"(?<=\s)--?[a-z][\w-]*[ =](?=[\"'])", blank),  # an option of a command line
        (r"(?<=\w):(?=(?:moveTo|move|rotate|setPosition|setRotation|setAngle|translate)\()", lambda _: "."),  # Lua
        (r"^[ \t]*m_Paths:[ \t]*\n[ \t]*-(?= - \{)|^(?:--- !|%YAML|%TAG).*", blank),  # Unity
        (_PREFIX, blank),
        (r"(?<=@export)_\w+(?:\([^()\n]*\))?|(?<=\bexport)\([^()\n]*\)", blank),  # annotations of GDScript
        (r"(?<=\bat )(?:the )?origin\b|(?<=\bon )the origin\b", lambda m: "(0, 0)".rjust(len(m[0]))),
        (r"\.map\((?:(\w+)[ ]?=>[ ]?\[\1\.x,[ ]?\1\.y\]|\(\{[ ]?x,[ ]?y[ ]?\}\)[ ]?=>[ ]?\[x,[ ]?y\])\)", blank),
        (r"\b(\w+)\.begin\(\),[ ]*\1\.end\(\)", lambda m: m[1].ljust(len(m[0]))),
        (r"(?<=[A-Za-z])#\d+(?= [A-Za-z])", blank),  # entity#17 circle ...
        (r"^[ \t]*[.#][a-z][\w-]*(?=[ \t]*\{)", lambda m: m[0].replace("-", "_")),  # a rule of CSS: .box-a {
        (r"^[ \t]*(?:TEST(?:_F|_CASE)?|SECTION|BOOST_AUTO_TEST_CASE)\([^()\n]*\)(?=\s{0,9}\{)", blank),
        (r"(?<=[\d)\]])[.,](?= \w{1,40}: [a-z]\w{0,40} ?= ?[-.\d(\[])", lambda _: ";"),  # a: x=0 y=0, b: x=9 y=0
        (r"(?<=[\d)\]]) ?\|(?= ?[A-Za-z]\w{0,40}[:=])", lambda m: ",".rjust(len(m[0]))),  # x: 0 | y: 0 | w: 4 | h: 4
        (r"(?:(?<==)|(?<=: ))0x[0-9a-f]{8,16}\b", lambda m: "null".ljust(len(m[0]), "_")),
        (r"(?<=\w) ->(?= \([-+.\d])", lambda _: " : "),
        (r"(?<=\[)@?pixi[\w./-]*:", blank),
        (r"\bsrsDimension=\"2\"", lambda m: 'srsDimension=""'.rjust(len(m[0]))),  # GML
        (_NUMBERED, lambda m: m[1].ljust(len(m[0]))),
        (r"\(/(?=\s*[-+.\d])|(?<=[\s.\d])/\)", lambda m: {"(/": "[ ", "/)": " ]"}[m[0]]),  # Fortran
        (r"^[ \t]*(?:real|integer)\b[^:\n]*::|(?<=\w)\([\d, ]+\)(?=[ ]*=[ ]*(?:\[ |reshape))", blank),
    )
]

# Letters that look like others: spaces, quotes, brackets and commas of word processors and of Chinese.
_PLAIN = str.maketrans("\u00a0\u202f\ufeff\u200b\u201c\u201d\uff08\uff09\uff0c", '    ""(),')
# the fields of a type with plain values: those of every shape of its kind, unless another one says its own
_PLAIN_FIELD = r"(?:[^{}()\[\]\n;]|\([^(),{}\n]*(?:,[^(),{}\n]*)?\)|\{ ?get;[^{}]*\}|\{[-\d.f]*\})*+"
TYPE = re.compile(
    rf"\b(?:class|struct|record)\s+(\w+)(?:(?:\([\w., ]*\))?:[ \t]*\n(?P<lines>(?:[ \t]+[^\n(){{}}\[\]]+\n|[ \t]*\n)++)"
    rf"|[^{{}}()=;\n]*\s*[{{(](?P<fields>(?:{_PLAIN_FIELD}[;\n])*+(?:{_PLAIN_FIELD}(?=[)}}]))?+))"
    # GDScript, whose exported variables a scene sets anew
    r"|^[ \t]*class_name[ \t]+(?P<name>\w+).*\n(?P<exports>(?:[ \t]*(?:@|export\b|extends\b|$).*(?:\n|\Z))++)"
    r"|^(?P<exported>(?:[ \t]*(?:@export\b|export {2,}var\b).*(?:\n|\Z)\s*)++)",
    re.MULTILINE,
)
MAX_TYPES = 20  # types whose names are looked for in the text

# what a debugger writes beside values: places in a list, sizes, types
_WATCH = re.compile(
    r"^[ \t]*+(?:[-+][ \t]*+)?(?:\[\d+\][ \t]+(?=\{)|(?:\w+[ \t]+\{ ?size=\d+ ?\}|\[[A-Za-z][\w ]*\]\t).*)"
    r"|(?<=\})\t(?![^\n{}]*[ \t][-+.\d])[A-Za-z_][\w:<>, *&\[\]]*$|\bsize=\d+[ ](?=\{)|\b0x[0-9a-f]{8,16}[ ](?=\{)"
    r"|std::\w+ of length \d+, capacity \d+ = (?=\{)",
    re.MULTILINE,
)
_WITH_Z = re.compile(r"(?P<head>\b(?:MULTI)?POLYGON ?)(?P<z>ZM?|M)(?P<data> ?\([-+.\de,()\s]*)", re.IGNORECASE)  # WKT
_ROW_WITH_Z = re.compile(r"(?<![^\s(,])[-+.\de]++\s++[-+.\de]++((?:\s++[-+.\de]++){1,2})(?=\s*[,)])", re.IGNORECASE)
# the coordinate reference system, by its number, before WKT and behind an envelope
_SRID = re.compile(rf"\b(SRID=\d+;)|(?<=ST_MakeEnvelope\()(?:{_N}, ?){{3}}{_N}(, ?\d+)(?=\))")
_QUOTE = re.compile(r"^>+ .*(?:\n>+(?: .*|$))*", re.MULTILINE)  # or the prompts of R and MATLAB
_HEADS = re.compile(r"^(?:-.*|\+\+\+ .*|@@.*|diff --git.*|index [0-9a-f]{6,}\.\..*|\+)", re.MULTILINE)


def cleaned(text: str) -> tuple[str, list[str]]:
    """Return (the text with everything around its shapes blanked, remarks on lines that were left out).

    A text of more than MAX_CHARS is returned unchanged.
    """
    if len(text) > MAX_CHARS:
        return text, []
    text = text.translate(_PLAIN)
    text = _QUOTE.sub(lambda m: re.sub(r"(?m)^(?:> ?)+", blank, m[0]), text)
    if _PATCH.search(text):  # a diff with its heads
        kept = _WATCH.sub(blank, _HEADS.sub(blank, text))
    else:
        text = _WATCH.sub(blank, text)
        kept = _CHANGE.sub(lambda m: re.sub(r"(?m)^[ \t]*(?:-.*|\+)", blank, m[0]) if m["added"] else m[0], text)
    remarks = ["the lines that a change removes (-) were left out"] if kept != text else []
    if _WITH_Z.search(kept):
        kept = _WITH_Z.sub(
            lambda m: m["head"] + " " * len(m["z"]) + _ROW_WITH_Z.sub(lambda row: blank(row, 1), m["data"]), kept
        )
        remarks += ["the coordinates Z and M of WKT were left out, so the answer is about x and y alone"]
    systems = {re.sub(r"\D", "", m[m.lastindex or 0]) for m in _SRID.finditer(kept)}
    if len(systems) == 1:  # shapes in different systems cannot be compared
        kept = _SRID.sub(lambda m: blank(m, m.lastindex or 0), kept)
        remarks += [f"the SRID {systems.pop()} was left out: the coordinates are taken as x and y of one plane"]
    for pattern, write in _ROWS:
        kept = pattern.sub(write, kept)
    return TYPE.sub(lambda m: blank(m, m.lastgroup or 0) if _is_used(m, kept) else m[0], kept, MAX_TYPES), remarks


def _is_used(declared: re.Match[str], text: str) -> bool:
    """Return whether the name of a type stands in the text outside of its declaration."""
    name = declared[1] or declared["name"]
    return bool(name) and text.count(name) > declared[0].count(name)
