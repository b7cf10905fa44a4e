#!/usr/bin/python3
"""What messages tell a user to write exists: keys of the study, sections, commands and their options. And some test takes each option.

  messages_test.py     with ISOPATCH_PROGRAM and ISOPATCH_SOURCE_DIR in the environment
"""

import os
import pathlib
import re
import subprocess
import unittest

PROGRAM = os.environ["ISOPATCH_PROGRAM"]
SOURCE = pathlib.Path(os.environ["ISOPATCH_SOURCE_DIR"])
ROOMS = ("app", "geometry", "iga", "segmentation", "solvers")
TOKEN = re.compile(r'//[^\n]*|/\*.*?\*/|R"\((?P<raw>.*?)\)"|"(?P<text>(?:[^"\\\n]|\\.)*)"|\'(?:[^\'\\\n]|\\.)+\'', re.S)
# Names that no study has, and where they are right.
NOT_KEYS = {
    "straight_pieces": "iga, a function for programs that link the library",
    "memory.max": "a file of control groups",
    "memory.high": "the same",
    "quadrature_points": "iga::ElasticityOptions, for programs that link the library; a study's key is checked before",
    "smoothing_range": "solvers::SolverOptions, the same",
    "max_depth": "geometry::CertificateOptions, the same",
    "is_collapsed": "the same, a function",
    "why_invalid": "segmentation, a function",
    "dihedral_limit": "segmentation::CostOptions, for programs that link the library",
    "exact_up_to": "the same",
    "most_failures": "segmentation::ReconstructionOptions, for programs that link the library",
    "plane_1": "the name of a face",
    "cylinder_1": "the same",
    "end_header": "a line of PLY files",
    "vertex_indices": "a property of PLY files",
    "von_mises": "a field of isopatch render",
    "closed_forms": "a suite of isopatch verify",
    "id_range": "G+Smo XML",
    "id_index": "G+Smo XML",
    "byte_order": "VTK XML",
    "header_type": "VTK XML",
}
NOT_OPTIONS = {"--bind-to": "of mpiexec", "--gtest": "of GoogleTest", "--mpi": "of Slurm", "--plot-": "of a page's style", "--isopatch": "the same"}
# Options that no test takes, and why.
NOT_TAKEN = {"--remove-blends": "needs triangles with rounds along freeform walls, which only models of others have"}
ENDINGS = ("cpp", "g2", "h5", "html", "json", "mesh", "png", "so", "svg", "toml", "txt", "vtm", "vtu", "xml", "step", "brep")


def literals(text):
    """(line, literal) of C++ text; neighbours that the compiler joins are one, includes are none."""
    text = re.sub(r"^\s*#\s*include.*$", "", text, flags=re.M)
    found, end = [], None
    for token in TOKEN.finditer(text):
        literal = token["raw"] if token["raw"] is not None else token["text"]
        if literal is None:
            continue
        if end is not None and not text[end:token.start()].strip():
            found[-1][1] += literal
        else:
            found.append([text.count("\n", 0, token.start()) + 1, literal])
        end = token.end()
    return found


def messages():
    """(place, text) of every literal of the program and its libraries."""
    for room in ROOMS:
        for path in sorted((SOURCE / room).rglob("*.?pp")):
            relative = path.relative_to(SOURCE)
            if "tests" in relative.parts or "opencascade" in relative.parts:
                continue
            for line, text in literals(path.read_text(encoding="utf-8")):
                yield f"{relative}:{line}", text


def sections(documentation):
    """{section: its keys}; keys of tables inside a section, as where, are sections too."""
    found, names = {}, []
    for line in documentation.splitlines():
        if line.startswith("## "):
            heading = line[3:]
            names = [name.split(".")[-1] for name in re.findall(r"\[\[?([a-z_.]+)\]\]?", heading)]
            names += re.findall(r"(where|edges|lame|plane|cylinder|sphere|box)\b", heading)
            if heading == "The file":
                names = [""]
        key = re.match(r"\| `([a-z_]+)` \|", line)
        for name in names if key else ():
            found.setdefault(name, set()).add(key[1])
    return found


def options_of(command):
    text = subprocess.run([PROGRAM, command, "--help"], capture_output=True, text=True, check=True).stdout
    return set(re.findall(r"(?<![\w-])--[a-z][a-z-]*[a-z]", text.split("\nExamples:")[0]))


class Messages(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.documentation = subprocess.run([PROGRAM, "keys"], capture_output=True, text=True, check=True).stdout
        cls.sections = sections(cls.documentation)
        cls.keys = set().union(*cls.sections.values())
        help_text = subprocess.run([PROGRAM, "--help"], capture_output=True, text=True, check=True).stdout
        cls.commands = re.findall(r"^  ([a-z]+)  ", help_text.split("Subcommands:")[-1], re.M)
        cls.options = {command: options_of(command) for command in cls.commands}
        cls.messages = list(messages())

    def no(self, wrong):
        self.assertEqual([], wrong, "\n" + "\n".join(wrong))

    def test_there_is_much_to_check(self):
        self.assertGreater(len(self.messages), 2000)
        self.assertGreater(len(self.keys), 80)
        self.assertGreater(len(self.commands), 8)
        self.assertGreater(sum(map(len, self.options.values())), 60)

    def test_options_exist(self):
        every = set().union(*self.options.values(), {"--help", "--version"}, NOT_OPTIONS)
        self.no([f"{place}: there is no option {option}" for place, text in self.messages
                 for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", text) if option not in every])

    def test_some_test_takes_each_option(self):
        tests = "".join(path.read_text(encoding="utf-8") for folder in ("app", "verification", "scripts")
                        for path in sorted((SOURCE / folder).rglob("tests/*.?p*")) if path.name != "messages_test.py")
        taken = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*[a-z]", tests))
        every = set().union(*self.options.values()) - {"--help"}
        self.no([f"no test takes {option}" for option in sorted(every - taken - NOT_TAKEN.keys())])
        self.no([f"some test takes {option}" for option in sorted(NOT_TAKEN.keys() & taken)])

    def test_commands_exist_and_have_the_options_named_with_them(self):
        wrong = []
        for place, text in self.messages:
            for command, rest in re.findall(r"`isopatch ([a-z]+)([^`]*)`", text):
                if command not in self.commands:
                    wrong.append(f"{place}: there is no command {command}")
                    continue
                wrong += [f"{place}: isopatch {command} has no option {option}"
                          for option in re.findall(r"(?<![\w-])--[a-z][a-z-]+", rest)
                          if option not in self.options[command]]
        self.no(wrong)

    def test_keys_named_with_their_section_exist(self):
        wrong = []
        for place, text in self.messages:
            for word in re.findall(r"(?<![\w./\\])[a-z_]+(?:\.[a-z0-9_]+)+(?![\w(])", text):
                names = [name for name in word.split(".") if not name.isdigit()]
                if word in NOT_KEYS or names[-1] in ENDINGS or (names[0] not in self.sections and names[-1] not in self.keys):
                    continue
                path = ["", *names]
                if not all(key in self.sections.get(section, ()) for section, key in zip(path, path[1:])
                           if section or key not in ("where", "edges")):
                    wrong.append(f"{place}: there is no key {word}")
        self.no(wrong)

    def test_names_in_sentences_are_keys(self):
        known = set(re.findall(r"[a-z]+(?:_[a-z0-9]+)+", self.documentation)) | NOT_KEYS.keys()
        known |= {option[2:].replace("-", "_") for options in self.options.values() for option in options}
        self.no([f"{place}: '{name}' is no key" for place, text in self.messages if " " in text.strip()
                 for name in re.findall(r"(?<![\w/.-])[a-z]+(?:_[a-z0-9]+)+(?![\w(./])", text) if name not in known])

    def test_sections_exist(self):
        wrong = []
        for place, text in self.messages:
            for name in re.findall(r"(?<![\w\[\\])\[\[?([a-z_.]{3,})\]\]?", text) if " " in text.strip() else ():
                if name.split(".")[0] not in self.sections:
                    wrong.append(f"{place}: there is no section [{name}]")
        self.no(wrong)


if __name__ == "__main__":
    unittest.main()
