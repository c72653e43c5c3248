"""make_man.py COMMAND FILE: writes the manual page of the command from its --help."""

import re
import subprocess
import sys


def help_of(command, *verb):
    return subprocess.run([command, *verb, "--help"], capture_output=True, text=True, check=True).stdout.rstrip()


def escaped(text):
    text = text.replace("\\", r"\e").replace("-", r"\-")
    return "\n".join(r"\&" + line if line[:1] in ".'" else line for line in text.split("\n"))


def verbatim(text):
    return f".nf\n{escaped(text)}\n.fi\n"


def page(command):
    version = subprocess.run([command, "--version"], capture_output=True, text=True, check=True).stdout.strip()
    text = help_of(command)
    # CLI11's newer versions write the headings in capitals, and no "Usage:".
    summary, options, verbs = re.fullmatch(r"(.*?)\n\s*(?:Usage: )?fieldfab \[OPTIONS\] SUBCOMMAND\s*"
                                           r"Options:\n(.*)\nSubcommands:\n(.*)", text, re.S | re.I).groups()
    out = [f'.TH FIELDFAB 1 "" "fieldfab {version}" "User Commands"\n',
           ".SH NAME\nfieldfab \\- solids from formulas, CT scans and meshes, and machine programs of them\n",
           ".SH SYNOPSIS\n.B fieldfab\n[\\fIOPTIONS\\fR] \\fIVERB\\fR ...\n",
           f".SH DESCRIPTION\n{escaped(summary)}\n.SH OPTIONS\n{verbatim(options.rstrip())}.SH VERBS\n"]
    for verb in re.findall(r"^  ([a-z]+) ", verbs, re.M):
        out.append(f".SS {verb}\n{verbatim(help_of(command, verb))}")
    out.append(".SH EXIT STATUS\n0: done. 1: a check or comparison failed. 2: bad usage or bad input. "
               "3: an internal error. 130: cancelled.\n")
    return "".join(out)


if __name__ == "__main__":
    with open(sys.argv[2], "w") as file:
        file.write(page(sys.argv[1]))
