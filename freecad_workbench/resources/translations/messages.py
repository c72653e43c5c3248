"""The kernel's messages, found in its C++ sources: errors, notes and names of phases, which it makes from templates
such as "{0}: there is nothing left to cut"."""

import pathlib
import re

SOURCES = ("kernel/src", "cam")
# Calls whose texts are messages, by the last part of their names.
CALLS = re.compile(r"\b(?:refuse|fail|wrong|Error|Refusal|TextError|Damaged|damaged|expect|unexpected|need(?:ed)?|want|"
                   r"no_compensation|sticky|told|report|event|require_memory|check_corner|note_?|phase|"
                   r"notes?_?(?:\.|->)(?:add|push_back)|left_out(?:\.|->)insert)\s*([({])")
# Returned suggestions, which follow other messages.
SUGGESTIONS = re.compile(r"\breturn [^;]*?\bformat\s*([({])(?=\s*\"; )")
# A file of nothing but messages: all its texts.
ALL_OF = ("certainty.cpp",)
LITERAL = re.compile(r'"((?:[^"\\\n]|\\.)*)"')
FIELD = re.compile(r"\{(\d*)(?::(?:[^{}]|\{\d*\})*)?\}")
OPEN, CLOSED = "([{", ")]}"


def of_sources(root):
    """Every template in the sources below `root`, each once. Values are numbered: "{0} of {1}"."""
    found = {}
    for path in sorted(each for folder in SOURCES for each in pathlib.Path(root, folder).rglob("*")
                       if each.suffix in (".cpp", ".h")):
        text = _without_comments(path.read_text(encoding="utf-8"))
        hidden = _hidden(text)
        told = [text[call.end(1):_end_of_bracket(hidden, call.end(1))]
                for call in (*CALLS.finditer(hidden), *SUGGESTIONS.finditer(text))]
        if path.name in ALL_OF:
            told += [literal[0] for literal in LITERAL.finditer(text)] + re.findall(r"(\?[^;?]*);", text)
        found.update(dict.fromkeys(each for expression in told for each in _templates(expression)
                                   if re.search("[a-z]{2}", each)))
    return sorted(found)


def _without_comments(text):
    """The source with literals over several lines joined, and without comments, includes and raw literals."""
    text = re.sub(r'R"(\w*)\(.*?\)\1"', '""', text, flags=re.DOTALL)
    text = re.sub(r'"(?:[^"\\\n]|\\.)*"|\'(?:[^\'\\\n]|\\.)\'|//[^\n]*|/\*.*?\*/|#include[^\n]*',
                  lambda each: each[0] if each[0][0] == '"' else "0" if each[0][0] == "'" else " ", text,
                  flags=re.DOTALL)
    return re.sub(r'(?<=[^\\])"\s*\n\s*"', "", text)


def _hidden(text):
    """The text with its literals' letters replaced, so that brackets and commas in them are not seen."""
    return LITERAL.sub(lambda each: '"' + "_" * (len(each[0]) - 2) + '"', text)


def _end_of_bracket(hidden, start):
    depth = 1
    for place in range(start, len(hidden)):
        depth += (hidden[place] in OPEN) - (hidden[place] in CLOSED)
        if not depth:
            return place
    return len(hidden)


def _templates(expression, chosen=False):
    """The templates in an expression. A single word is one only where it was `chosen` by a condition."""
    hidden = _hidden(expression)
    whole = LITERAL.fullmatch(expression.strip())
    if whole:
        if chosen or " " in whole[1].strip():
            yield _template(_unescaped(whole[1]))
        return
    for separator in (",", "?", ":", "+"):
        parts = _split(expression, hidden, separator)
        if len(parts) == 1:
            continue
        if separator == "+" and any(LITERAL.fullmatch(part.strip()) for part in parts):
            yield _sum(parts)
            parts = [part for part in parts if not LITERAL.fullmatch(part.strip())]
        for part in parts[1:] if separator == "?" else parts:
            yield from _templates(part, separator == "?" or chosen and separator == ":")
        return
    call = re.match(r"\s*(?:[\w:<>~]|\.|->)*\s*[({]", hidden)
    if call:
        yield from _templates(expression[call.end():_end_of_bracket(hidden, call.end())])


def _split(expression, hidden, separator):
    """The parts of an expression between separators that are in no bracket."""
    parts, depth, last = [], 0, 0
    for place, letter in enumerate(hidden):
        depth += (letter in OPEN) - (letter in CLOSED)
        if letter == separator and not depth and ":" not in (hidden[place - 1:place], hidden[place + 1:place + 2]):
            parts.append(expression[last:place])
            last = place + 1
    return [*parts, expression[last:]]


def _sum(parts):
    """The template of literals and values that are added: "cannot read {0}"."""
    text, count = "", 0
    for part in parts:
        literal = LITERAL.fullmatch(part.strip())
        text += _escaped(_unescaped(literal[1])) if literal else f"{{{count}}}"
        count += not literal
    return text


def _template(text):
    """A literal as a template: of one of fmt's the values are numbered and lose their formats."""
    if not FIELD.search(text):
        return _escaped(text)
    count = iter(range(100))
    return re.sub(r"\{\{|\}\}|" + FIELD.pattern,
                  lambda each: each[0] if each[0] in ("{{", "}}") else f"{{{each[1] or next(count)}}}", text)


def _escaped(text):
    return text.replace("{", "{{").replace("}", "}}")


def _unescaped(literal):
    return re.sub(r"\\(.)", lambda each: {"n": "\n", "t": "\t"}.get(each[1], each[1]), literal)
