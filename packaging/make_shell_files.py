#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Writes the manual page and the completions for bash, zsh and fish from what the program says of itself.

    make_shell_files.py PROGRAM VERSION DATE OUTPUT_FOLDER
"""
import os
import re
import subprocess
import sys

COMMAND_LINE = re.compile(r"^  geomesh (\S+).*?  +(\S.*)$")
OPTION = re.compile(r"^  ((?:-[A-Za-z],?)?(?:--[a-z][a-z-]*)?)(?: (\S.*?))?(?:  +(\S.*))?$")


def said(program, *arguments):
    return subprocess.run([program, *arguments], stdout=subprocess.PIPE, text=True, check=True).stdout


def commands_of(overview):
    """(name, what it does) of each command in the overview; the project command is named PROJECT.yaml."""
    return [match.groups() for match in map(COMMAND_LINE.match, overview.splitlines()) if match]


def options_of(help_text):
    """(option, what it does) of each option in the help of a command."""
    found, last = [], None
    for line in help_text.splitlines():
        match = OPTION.match(line)
        if match and match.group(1):
            last = [match.group(1).split(",")[-1], match.group(3) or ""]
            found.append(last)
        elif last is not None and line.startswith("      ") and line.strip():
            last[1] = (last[1] + " " + line.strip()).strip()
        elif not line.strip():
            last = None
    return [tuple(option) for option in found]


def roff(text):
    return "\n".join(("\\&" + line if line[:1] in (".", "'") else line)
                     for line in text.replace("\\", "\\e").replace("-", "\\-").splitlines())


def manual(overview, helps, version, date):
    parts = ['.TH GEOMESH 1 "%s" "geomesh %s" "User Commands"' % (date, version), ".SH NAME",
             "geomesh \\- tetrahedral meshes of earth models, from surfaces that disagree", ".SH COMMANDS", ".nf", roff(overview), ".fi"]
    for name, text in helps.items():
        parts += [".SH %s" % ("GEOMESH " + name).upper().replace("-", "\\-"), ".nf", roff(text), ".fi"]
    parts += [".SH FILES", ".TP", "/usr/share/geomesh/samples", "Whole projects that run as they are.", ".TP",
              "/usr/share/geomesh/project.schema.json", "The JSON schema of the project file.", ".SH SEE ALSO",
              "The documents in /usr/share/doc/geomesh, of the package geomesh-doc."]
    return "\n".join(parts) + "\n"


def bash(helps):
    cases = "".join("    %s) words=\"%s\" ;;\n" % (name, " ".join(o for o, _ in options_of(text)))
                    for name, text in helps.items() if name != "PROJECT.yaml")
    project = " ".join(o for o, _ in options_of(helps["PROJECT.yaml"]))
    names = " ".join(name for name in helps if name != "PROJECT.yaml")
    return """# bash completion for geomesh
_geomesh() {
  local words here=${COMP_WORDS[COMP_CWORD]}
  COMPREPLY=()
  case ${COMP_WORDS[1]} in
%s    *) words="%s" ;;
  esac
  if [ "$COMP_CWORD" -eq 1 ]; then words="%s --help --version"; fi
  if [ "$COMP_CWORD" -eq 1 ] || [ "${here:0:1}" = - ]; then COMPREPLY=($(compgen -W "$words" -- "$here")); fi
  if [ "${here:0:1}" != - ]; then COMPREPLY+=($(compgen -f -- "$here")); fi
}
complete -o filenames -F _geomesh geomesh
""" % (cases, project, names)


def zsh_quoted(*parts):
    """One word in single quotes of what is given, joined: zsh reads ' as '\\''."""
    return "'" + "".join(parts).replace("'", "'\\''") + "'"


def zsh_plain(text):
    """Text in which brackets and colons mean nothing to _describe and _arguments."""
    return re.sub(r"([\[\]:\\])", r"\\\1", text)


def zsh(summaries, helps):
    lines = ["#compdef geomesh", "local -a geomesh_commands", "geomesh_commands=("]
    lines += ["  " + zsh_quoted(name, ":", zsh_plain(text)) for name, text in summaries if name != "PROJECT.yaml"]
    lines += [")", "if (( CURRENT == 2 )); then", "  _describe command geomesh_commands", "  _files", "  return", "fi", "case $words[2] in"]
    for name, text in helps.items():
        pattern = "*" if name == "PROJECT.yaml" else name
        options = " ".join(zsh_quoted(o, "[", zsh_plain(what), "]") for o, what in options_of(text))
        lines.append("  %s) _arguments %s '*:file:_files' ;;" % (pattern, options))
    order = [line for line in lines if not line.startswith("  *)")] + [line for line in lines if line.startswith("  *)")]
    return "\n".join(order + ["esac"]) + "\n"


def fish_quoted(text):
    return "'" + re.sub(r"([\\'])", r"\\\1", text) + "'"


def fish(summaries, helps):
    lines = ["# fish completion for geomesh"]
    names = " ".join(name for name in helps if name != "PROJECT.yaml")
    for name, text in summaries:
        if name != "PROJECT.yaml":
            lines.append("complete -c geomesh -n __fish_use_subcommand -a %s -d %s" % (name, fish_quoted(text)))
    for name, text in helps.items():
        when = "not __fish_seen_subcommand_from %s" % names if name == "PROJECT.yaml" else "__fish_seen_subcommand_from " + name
        for option, what in options_of(text):
            flag = "-l " + option[2:] if option.startswith("--") else "-s " + option[1:]
            lines.append("complete -c geomesh -n '%s' %s -d %s" % (when, flag, fish_quoted(what)))
    return "\n".join(lines) + "\n"


def main():
    program, version, date, folder = sys.argv[1:]
    overview = said(program, "--help")
    summaries = commands_of(overview)
    helps = {"PROJECT.yaml": said(program, "--help-project")}
    for name, _ in summaries:
        if name != "PROJECT.yaml":
            helps[name] = said(program, name, "--help")
    os.makedirs(folder, exist_ok=True)
    for file, text in (("geomesh.1", manual(overview, helps, version, date)), ("geomesh.bash", bash(helps)),
                       ("_geomesh", zsh(summaries, helps)), ("geomesh.fish", fish(summaries, helps))):
        with open(os.path.join(folder, file), "w", encoding="utf-8") as out:
            out.write(text)


if __name__ == "__main__":
    main()
