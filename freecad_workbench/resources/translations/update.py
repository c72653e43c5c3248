#!/usr/bin/env python3
"""Collects the workbench's texts for users from its sources into every fieldfab_*.ts beside this file, which keep their
translations, and makes the .qm files that FreeCAD reads. A new language begins as an empty file: fieldfab_fr.ts.

    PYTHONPATH=build/release/python /usr/bin/python3 update.py     (the kernel is asked for its own texts)

The templates of the kernel's messages are found in its sources (messages.py) and listed in messages.txt.
"""

import ast
import pathlib
import shutil
import subprocess
import sys
import xml.etree.ElementTree as xml
from xml.sax.saxutils import escape

HERE = pathlib.Path(__file__).resolve().parent
sys.path.insert(0, str(HERE))
from messages import of_sources
PACKAGE = HERE.parents[1] / "fieldfab_workbench"
MESSAGES = HERE / "messages.txt"  # the templates that the workbench matches messages with
PREFERENCES = HERE.parent / "preferences.ui"
# The calls that give an object a property: of the texts among their arguments, which are its name and its description.
PROPERTY_CALLS = {"add": (1, 3), "addProperty": (1, 3), "add_choice": (0, 2), "_add_choice": (0, 2),
                  "described": (0, 1), "add_outside": (0, 2)}


def collected():
    """Texts of all sources as [(context, text)], each once, sorted by context. The contexts are those where FreeCAD and
    words.py look."""
    found = {}
    for path in sorted(PACKAGE.rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            found.update(dict.fromkeys(_of_call(node) if isinstance(node, ast.Call) else _of_commands(node)))
    context = xml.parse(PREFERENCES).getroot()
    found.update(dict.fromkeys((context.findtext("class"), text.text) for text in context.iter("string")))
    found.update(dict.fromkeys(_of_kernel()))
    found.update(dict.fromkeys(("Kernel: message", template) for template in of_sources(HERE.parents[2])))
    return sorted(found, key=lambda each: each[0])


def _of_kernel():
    """What the kernel says of its operations, settings and machines."""
    from fieldfab import cam

    machines = [cam.machine(identifier) for identifier in dict(cam.machines())]
    told = [*cam.stages(), {"name": "moves", "help": "how the paths are joined to moves",
                            "settings": cam.joining_settings()}]
    for each in (*told, *(setting for owner in (*told, *machines) for setting in owner["settings"])):
        yield "Kernel", each["name"]
        yield "Kernel", each["help"]
        yield from (("Kernel: choice", choice) for choice in each.get("choices") or ())
        if "kind" in each:  # a setting: a property, too, named and described as in workflow.py
            unit = {"1/min": "rpm"}.get(each["unit"], each["unit"])
            yield "App::Property", each["name"].replace("_", " ").title()
            yield "App::Property", each["help"][:1].upper() + each["help"][1:] + (f" ({unit})" if unit else "")
    for machine in machines:
        yield "Kernel", machine["name"]
        yield "Kernel", machine["description"]


def _of_call(call):
    name = getattr(call.func, "attr", getattr(call.func, "id", ""))
    texts = [each.value for each in call.args if isinstance(each, ast.Constant) and isinstance(each.value, str)]
    if name == "tr":
        return [("Fieldfab", text) for text in texts]
    if name == "marked":
        held = call.args[0]
        return [("Fieldfab", each.value)
                for each in (held.keys if isinstance(held, ast.Dict) else getattr(held, "elts", [held]))]
    if name in PROPERTY_CALLS and len(texts) > PROPERTY_CALLS[name][1]:
        label, words = (texts[place] for place in PROPERTY_CALLS[name])
        return [("App::Property", "".join(f" {c}" if c.isupper() else c for c in label).strip()),
                ("App::Property", words)]
    return []


def _of_commands(node):
    """The texts of a module's table of commands, and its toolbar's title."""
    name = getattr(node.targets[0], "id", "") if isinstance(node, ast.Assign) else ""
    if name == "TITLE":
        return [("Workbench", node.value.value)]
    if name != "COMMANDS":
        return []
    told = [(key.value, [each.value for each in command.args
                         if isinstance(each, ast.Constant) and isinstance(each.value, str)][-3:])
            for key, command in zip(node.value.keys, node.value.values) if isinstance(command, ast.Call)]
    return [(command, text) for command, texts in told for text in texts]


def translations(path):
    """{(context, text): its translation} of a .ts file; "" where there is none yet."""
    if not path.stat().st_size:
        return {}
    return {(context.findtext("name"), message.findtext("source")): message.findtext("translation") or ""
            for context in xml.parse(path).getroot().iter("context") for message in context.iter("message")}


def written(language, wanted, known):
    """The text of a .ts file."""
    lines = ['<?xml version="1.0" encoding="utf-8"?>', "<!DOCTYPE TS>",
             f'<TS version="2.1" language="{language}" sourcelanguage="en">']
    for context in dict.fromkeys(context for context, _ in wanted):
        lines += ["<context>", f"    <name>{escape(context)}</name>"]
        for text in (text for other, text in wanted if other == context):
            translation = known.get((context, text), "")
            kind = "" if translation else ' type="unfinished"'
            lines += ["    <message>", f"        <source>{escape(text)}</source>",
                      f"        <translation{kind}>{escape(translation)}</translation>", "    </message>"]
        lines.append("</context>")
    return "\n".join([*lines, "</TS>", ""])


def main():
    tool = shutil.which("lrelease") or "/usr/lib/qt5/bin/lrelease"
    wanted, missing = collected(), 0
    MESSAGES.write_text("".join(f"{text}\n" for context, text in wanted if context == "Kernel: message"),
                        encoding="utf-8")
    for path in sorted(HERE.glob("fieldfab_*.ts")):
        known = translations(path)
        path.write_text(written(path.stem.split("_", 1)[1], wanted, known), encoding="utf-8")
        subprocess.run([tool, "-silent", path, "-qm", path.with_suffix(".qm")], check=True)
        lacking = [each for each in wanted if not known.get(each)]
        missing += len(lacking)
        print(f"{path.name}: {len(wanted)} texts, {len(lacking)} not translated yet")
    return 1 if missing else 0


if __name__ == "__main__":
    sys.exit(main())
