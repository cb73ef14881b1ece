"""Hints are executed: what an error tells a user to type is known to the command line, and does what it says."""

from __future__ import annotations

import ast
import json
import re
import shlex
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

import pytest

from motes import errors
from motes.cli.main import make_app
from motes.measurements import registry

ROOT = Path(__file__).parents[1]
ERRORS = {name for name, kind in vars(errors).items() if isinstance(kind, type) and issubclass(kind, errors.MotesError)}
Run = Callable[..., tuple[int, str, str]]


class Hint(NamedTuple):
    """A hint as it stands in the code, with {} for what is put in."""

    file: str
    line: int
    text: str


def literal(node: ast.expr) -> str | None:
    match node:
        case ast.Constant(value=str(text)):
            return text
        case ast.JoinedStr(values=parts):
            return "".join(str(p.value) if isinstance(p, ast.Constant) else "{}" for p in parts)
        case ast.BinOp(left=left, right=right):
            return (literal(left) or "{}") + (literal(right) or "{}")
        case ast.IfExp(body=body, orelse=orelse):
            return f"{literal(body) or ''} ; {literal(orelse) or ''}"
    return None


def hints() -> Iterator[Hint]:
    for path in sorted((ROOT / "src" / "motes").rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if not isinstance(node, ast.Call):
                continue
            name = getattr(node.func, "id", getattr(node.func, "attr", ""))
            place = 1 if name in ERRORS else 2 if name == "require" else None
            if place is not None and len(node.args) > place:
                text = literal(node.args[place])
                if text:
                    yield Hint(str(path.relative_to(ROOT / "src" / "motes")), node.lineno, text)


HINTS = list(hints())


def commands() -> dict[str, set[str]]:
    """The commands and their options."""
    app = make_app()
    return {
        name: {option for argument in app[name].assemble_argument_collection() for option in argument.names}
        for name in app
        if not name.startswith("-")
    }


COMMANDS = commands()


def named(hint: Hint) -> str:
    return f"{hint.file}:{hint.line}: {hint.text}"


def test_hints_are_found() -> None:
    assert len(HINTS) > 500
    assert len({h.file for h in HINTS}) > 60


def test_every_error_says_what_to_do() -> None:
    """An error is a sentence and a next step; those that say so in one place, such as a package that is missing, are classes of their own."""
    plain = {"MotesError", "ParameterError", "DataError", "FormatError"}
    without = [
        f"{path.relative_to(ROOT)}:{node.lineno}"
        for path in sorted((ROOT / "src" / "motes").rglob("*.py"))
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8")))
        if isinstance(node, ast.Call) and getattr(node.func, "id", "") in plain and not node.keywords
        if len(node.args) == 1 and not isinstance(node.args[0], ast.Starred)
    ]
    assert not without


def test_options_in_hints_exist() -> None:
    known = set().union(*COMMANDS.values())
    unknown = [
        named(h)
        for h in HINTS
        if "dask scheduler" not in h.text
        for option in re.findall(r"(?<![\w-])--[a-z][a-z-]*", h.text)
        if option not in known
    ]
    assert not unknown


def test_commands_in_hints_exist() -> None:
    """``motes fit DATA`` is a command; ``that motes reads`` is a sentence, and there is no such hint."""
    unknown = [
        named(h)
        for h in HINTS
        for command in re.findall(r"(?<![\w.])motes ([a-z]+)", h.text)
        if command not in COMMANDS
    ]
    assert not unknown


def test_options_of_readers_in_hints_exist() -> None:
    own = {"column", "format", "relative_uncertainty", "common_uncertainty"}
    known = own.union(*(reader.options for reader in registry.READERS.values()))
    unknown = [
        named(h) for h in HINTS for option in re.findall(r"--read '?([a-z_]+)[=:]", h.text) if option not in known
    ]
    assert not unknown


def test_extras_and_pages_in_hints_exist() -> None:
    extras = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["optional-dependencies"]
    for h in HINTS:
        for extra in re.findall(r"motes\[([a-z]+)\]", h.text):
            assert extra in extras, named(h)
        for page in re.findall(r"docs/[\w-]+\.md", h.text):
            assert (ROOT / page).is_file(), named(h)


# Files whose errors come up in Python only: the command line does not get there.
PYTHON_ONLY = (
    "models/",
    "kernels/",
    "fitting/",
    "parameters/",
    "exports/shaders.py",
    "exports/mitsuba.py",
    "rendering/surface_plugin.py",
    "measurements/openmaterial_writing.py",
)


def test_no_python_in_hints_at_the_shell() -> None:
    """``name=value`` belongs to an option; calls and methods do not run in a shell."""
    words = r"(?<![\w:'\[{])(?<!--read )(?<!--fix )(?<!--set )(?<!--trend )(?<!{} )[a-z_]+=(?=\S)"
    found = []
    for h in HINTS:
        if h.file.startswith(PYTHON_ONLY):
            continue
        text = re.sub(r"<[^>]*>", "", h.text)  # a scene's XML
        text = re.sub(r"--\w[\w-]* (?:'[^']*'|\S+)", "", text)
        text = re.sub(r"MOTES_\w+=\S+", "", text)
        if re.search(words, text) or re.search(r"\b\w+\.\w+\(", text):
            found.append(named(h))
    assert not found


# ---------------------------------------------------------------- what the hints of tables say, typed in

FULL = "theta_i_deg,theta_r_deg,phi_r_deg,"
ROW = "10,20,30,"
TABLES: dict[str, str] = {
    "an unknown column": f"{FULL}brdf,T\n{ROW}.1,21\n",
    "a nameless column": f"{FULL}brdf,,grey\n{ROW}.1,7.5,.2\n20,20,30,.1,7.1,.2\n",
    "two columns for an angle": f"aoi_deg,{FULL}brdf\n10,{ROW}.1\n",
    "two columns for a channel": f"{FULL}brdf,f_r\n{ROW}.1,.1\n",
    "two uncertainties": f"{FULL}brdf,brdf_unc,brdf_std\n{ROW}.1,.01,.01\n",
    "an uncertainty of one of three": f"{FULL}R,G,B,uncertainty\n{ROW}.1,.1,.1,.01\n",
    "an uncertainty of nothing": f"{FULL}R,G,sigma_B\n{ROW}.1,.1,.01\n",
    "an uncertainty of 0": f"{FULL}brdf,brdf_unc\n{ROW}.1,0\n",
    "a relative uncertainty in percent": f"{FULL}brdf,rel_unc\n{ROW}.1,5\n",
    "a row a wavelength and two values": f"{FULL}wavelength_nm,brdf,f_r\n{ROW}500,.1,.2\n",
    "a wavelength and a channel": f"{FULL}wavelength_nm,channel,brdf\n{ROW}500,R,.1\n",
    "no azimuth": "theta_i_deg,theta_r_deg,brdf\n10,20,.1\n",
    "no viewer": "theta_i_deg,brdf\n10,.1\n",
    "an angle without a unit": "theta_i,theta_r_deg,phi_r_deg,brdf\n1,20,30,.1\n",
    "degrees without a word": "theta_i,theta_r,phi_r,brdf\n10,20,30,.1\n",
    "wavelengths in micrometres": f"{FULL}0.45,0.55\n{ROW}.1,.2\n",
    "a BRDF in percent": f"{FULL}brdf (%)\n{ROW}10\n",
    "a unit that contradicts": "theta_i_deg,theta_r_deg,phi_r_deg,brdf\nrad,deg,deg,1/sr\n0.1,20,0,.1\n",
    "a unit of something else": "theta_i_nm,theta_r_deg,phi_r_deg,brdf\n10,20,30,.1\n",
    "theta_s alone": "theta_s_deg,phi_r_deg,brdf\n10,20,.1\n",
}
# What stands for ROLE in a hint that leaves it to the user.
ROLES = {
    "an unknown column": "ignore",
    "a nameless column": "ignore",
    "a unit that contradicts": "theta_i_rad",
    "a unit of something else": "theta_i_deg",
}
# Two steps: the first hint leads to another error, whose hint is typed in as well.
STEPS = 3


def options_of(hint: str, role: str) -> list[str]:
    """The ``--read`` arguments of a hint."""
    found = re.findall(r"--read ('[^']+'|\S+)", hint)
    return [shlex.split(f"{text.rstrip(',.')}")[0].replace("=ROLE", f"={role}") for text in found]


@pytest.mark.parametrize("name", TABLES)
def test_what_a_hint_says_works(name: str, motes: Run, tmp_path: Path) -> None:
    path = tmp_path / "table.csv"
    path.write_text(TABLES[name])
    status, _, error = motes("info", path)
    assert status == 2
    hint = error.splitlines()[1]
    choices = options_of(hint, ROLES.get(name, "ignore"))
    assert choices, hint
    together = ("no viewer",)
    for choice in [choices] if name in together else [[c] for c in choices]:
        arguments = list(choice)
        for _ in range(STEPS):
            status, out, error = motes("info", path, "--json", *(x for c in arguments for x in ("--read", c)))
            if status == 0:
                break
            more = options_of(error.splitlines()[1], "ignore")
            assert more, error
            arguments.append(more[0])
        assert status == 0, error
        assert json.loads(out)["n_usable"] > 0


def test_findings_that_name_an_option_name_one_that_exists() -> None:
    known = set().union(*COMMANDS.values())
    for file in ("measurements/doubts.py", "fitting/plausibility.py"):
        text = (ROOT / "src" / "motes" / file).read_text()
        options = re.findall(r"--[a-z][a-z-]*", text)
        assert options
        assert set(options) <= known
