"""Choosing LLVM before Dr.Jit loads: in processes of their own, for a wrong one ends the interpreter."""

from __future__ import annotations

import os
import platform
import signal
import stat
import subprocess
import sys
from pathlib import Path

import pytest

from motes.errors import install_command
from motes.rendering import llvm

OLD = sorted(
    path
    for number in (14, 15, 16)
    for path in Path("/usr/lib").glob(f"*-linux-gnu/libLLVM-{number}.so.1")
    if platform.machine() in str(path)
)
WHEEL = sorted((Path(sys.prefix) / "lib").glob("libLLVM.so.*"))
needs_old = pytest.mark.skipif(not OLD, reason="no LLVM 14, 15 or 16 is installed (apt-get install libllvm15)")
needs_wheel = pytest.mark.skipif(not WHEEL, reason="the wheel karellen-llvm-core is not installed")
needs_mitsuba = pytest.mark.skipif(
    subprocess.run(
        [sys.executable, "-c", "import importlib.util as u; exit(u.find_spec('mitsuba') is None)"]
    ).returncode,
    reason="Mitsuba is not installed",
)
needs_linux = pytest.mark.skipif(sys.platform != "linux", reason="shared libraries are faked as on Linux")

RENDER = """
mi = load_mitsuba({variant!r})
import numpy as np
film = {{"type": "hdrfilm", "width": 4, "height": 4, "pixel_format": "rgb"}}
view = mi.ScalarTransform4f().look_at([0, 0, 5], [0, 0, 0], [0, 1, 0])
scene = load_scene({{"type": "scene", "integrator": {{"type": "path"}}, "light": {{"type": "constant"}},
    "sensor": {{"type": "perspective", "to_world": view, "fov": 20, "film": film}},
    "sphere": {{"type": "sphere", "bsdf": {{"type": "motes_dusty"}}}}}})
print(mi.variant(), np.isfinite(np.array(mi.render(scene, spp=2))).all())
"""
MOTES = "from motes.rendering import load_mitsuba, load_scene, slow_note\n"


def python(
    script: str, tmp_path: Path, library: str | Path | None = None, found: str | None = None
) -> subprocess.CompletedProcess[str]:
    """Run a script with a library named in the environment; `found` replaces what is installed by a list of paths.

    The kernel cache of Dr.Jit is left out: a kernel that is taken from there is not compiled.
    """
    environment = {k: v for k, v in os.environ.items() if k != llvm.VARIABLE} | {"HOME": str(tmp_path)}
    if library is not None:
        environment[llvm.VARIABLE] = str(library)
    if found is not None:
        script = f"import motes.rendering.llvm as L\nfrom pathlib import Path\nL._found = lambda: {found}\n{script}"
    return subprocess.run(
        [sys.executable, "-W", "error", "-c", script], env=environment, capture_output=True, text=True, timeout=300
    )


# ---------------------------------------------------------------- With the libraries that are here


@needs_mitsuba
@needs_old
def test_an_old_llvm_ends_the_interpreter_where_nobody_chooses(tmp_path: Path) -> None:
    """What this is all about: if it no longer happens, the version checked for can be lowered."""
    script = """
import mitsuba as mi
mi.set_variant("llvm_ad_rgb")
print(mi.render(mi.load_dict(mi.cornell_box()), spp=1))
"""
    for library in OLD:
        assert python(script, tmp_path, library).returncode != 0
    if "15" in OLD[-1].name:
        assert python(script, tmp_path, OLD[-1]).returncode == -signal.SIGABRT


@needs_mitsuba
@needs_old
@needs_wheel
@pytest.mark.parametrize("variant", [None, "llvm_ad_rgb"])
def test_an_old_llvm_first_in_line_is_passed_over(tmp_path: Path, variant: str | None) -> None:
    done = python(MOTES + RENDER.format(variant=variant), tmp_path, OLD[-1])
    assert (done.returncode, done.stdout) == (0, "llvm_ad_rgb True\n"), done.stderr
    assert f"LLVM not used: {OLD[-1]}: its version is" in done.stderr  # the user named it, so is told
    assert len(done.stderr.splitlines()) == 1


@needs_mitsuba
@needs_wheel
@needs_linux
def test_the_wheel_is_found_without_being_named(tmp_path: Path) -> None:
    """Before `load_mitsuba` too, for who imports Mitsuba himself, after motes.rendering."""
    done = python(MOTES + RENDER.format(variant=None), tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, "llvm_ad_rgb True\n", "")
    script = "from motes.rendering import register\nimport mitsuba as mi\nregister()\nmi.set_variant('llvm_ad_rgb')\n"
    script += "print('motes_dusty' in str(mi.load_dict({'type': 'motes_dusty'})))\n"
    script += "from pathlib import Path\nlines = Path('/proc/self/maps').read_text().splitlines()\n"
    script += "print(*{line.split()[-1] for line in lines if 'libLLVM' in line})"
    done = python(script, tmp_path)
    assert (done.returncode, done.stdout, done.stderr) == (0, f"True\n{WHEEL[-1].resolve()}\n", "")


@needs_mitsuba
@needs_old
@needs_wheel
def test_mitsuba_that_was_imported_first_with_an_old_llvm_is_told_apart(tmp_path: Path) -> None:
    """Dr.Jit has taken the library then; Motes does not walk into it."""
    first = "import mitsuba\n" + MOTES
    done = python(first + RENDER.format(variant=None), tmp_path, OLD[-1])
    assert (done.returncode, done.stdout) == (0, "scalar_rgb True\n"), done.stderr
    assert "Import motes.rendering before mitsuba" in done.stderr
    done = python(first + "load_mitsuba('llvm_ad_rgb')", tmp_path, OLD[-1])
    assert done.returncode == 1
    assert "the variant llvm_ad_rgb cannot run" in done.stderr.splitlines()[-1]


@needs_mitsuba
def test_without_any_llvm_the_preview_is_slow_and_says_so(tmp_path: Path) -> None:
    nowhere = tmp_path / "libLLVM.so"
    done = python(MOTES + RENDER.format(variant=None), tmp_path, nowhere, found="[]")
    assert (done.returncode, done.stdout) == (0, "scalar_rgb True\n"), done.stderr
    (note,) = [line for line in done.stderr.splitlines() if not line.startswith("jit")]  # Dr.Jit has its say
    assert "a thousand times slower" in note
    assert f"no LLVM 17 or later was found ({nowhere}: " in note
    if sys.platform == "linux" and platform.machine() == "x86_64":
        assert f"Run {install_command('render')}" in note
    done = python(MOTES + "load_mitsuba('llvm_ad_rgb')", tmp_path, nowhere, found="[]")
    assert done.returncode == 1
    assert "motes.errors.MotesError: the variant llvm_ad_rgb cannot run" in done.stderr.splitlines()[-1]


# ---------------------------------------------------------------- With libraries that are not what they seem


@needs_linux
def test_versions(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """A stand-in for the process that asks: the version it prints decides."""
    cases = {"17.0.6": "", "23.1.4": "", "16.0.6": "16.0.6", "15.0.7": "15.0.7", "old": "older than 16", "": ""}
    for version, known in cases.items():
        asker = tmp_path / "python"
        asker.write_text(f"#!/bin/sh\necho {version}\n")
        asker.chmod(asker.stat().st_mode | stat.S_IXUSR)
        monkeypatch.setattr(sys, "executable", str(asker))
        found, why = llvm.refusal(Path("libLLVM.so"))
        assert found == version
        usable = version in ("17.0.6", "23.1.4")
        assert bool(why) is not usable
        assert known in why


@needs_linux
def test_what_is_not_llvm_is_refused(tmp_path: Path) -> None:
    text = tmp_path / "libLLVM.so.99"
    text.write_text("not a library")
    libc = next(Path("/usr/lib").glob("*-linux-gnu/libc.so.6"), Path("/lib64/libc.so.6"))
    missing, broken, other = tmp_path / "nothing.so", text, libc
    choice = llvm.choose([missing, broken, other, tmp_path / "a\nb"])
    assert choice.path is None
    assert len(choice.refused) == 4
    assert "No such file" in choice.refused[0]
    assert "invalid ELF header" in choice.refused[1] or "too short" in choice.refused[1]
    assert "it is not LLVM" in choice.refused[2]
    message, hint = llvm.missing(choice)
    assert message.startswith("no LLVM 17 or later was found")
    assert llvm.VARIABLE in hint


@needs_linux
def test_a_library_that_crashes_when_it_loads_is_refused(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    asker = tmp_path / "python"
    asker.write_text("#!/bin/sh\nkill -ABRT $$\n")
    asker.chmod(0o755)
    monkeypatch.setattr(sys, "executable", str(asker))
    assert llvm.refusal(Path("libLLVM.so")) == ("", "loading it ended the process with code -6")
    monkeypatch.setattr(sys, "executable", str(tmp_path / "none"))
    assert "it could not be tried" in llvm.refusal(Path("libLLVM.so"))[1]


@pytest.mark.parametrize(
    ("path", "version"),
    [
        ("/usr/lib/x86_64-linux-gnu/libLLVM-15.so.1", 15),
        ("/usr/lib/x86_64-linux-gnu/libLLVM.so.19.1", 19),
        ("/usr/lib/llvm-20/lib/libLLVM.so.1", 20),
        ("/usr/lib64/libLLVM.so", 0),
        ("/opt/homebrew/opt/llvm@18/lib/libLLVM.dylib", 18),
    ],
)
def test_versions_in_names(path: str, version: int) -> None:
    """Only to try the newest first, and to leave old ones out; the library itself is asked."""
    assert llvm._named_version(Path(path)) == version


@needs_linux
def test_order_of_candidates(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    """The environment's, the wheel's, the system's from the newest; each file once."""
    (tmp_path / "lib").mkdir()
    files = {
        name: tmp_path / name for name in ("named.so", "libLLVM-19.so.1", "libLLVM.so.21.1", "lib/libLLVM.so.22.1")
    }
    for file in files.values():
        file.touch()
    (tmp_path / "link-19.so").symlink_to(files["libLLVM-19.so.1"])
    monkeypatch.setattr(sys, "prefix", str(tmp_path))
    monkeypatch.setattr(
        llvm, "_system", lambda: [files["libLLVM-19.so.1"], files["libLLVM.so.21.1"], tmp_path / "link-19.so"]
    )
    monkeypatch.setenv(llvm.VARIABLE, str(files["named.so"]))
    assert [path.name for path in llvm.candidates()] == [
        "named.so",
        "libLLVM.so.22.1",
        "libLLVM.so.21.1",
        "libLLVM-19.so.1",
    ]
