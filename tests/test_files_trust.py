"""Folders that code is run from: refused where somebody else could have put it there."""

from __future__ import annotations

import logging
import os
import sys
from collections.abc import Callable
from pathlib import Path
from types import SimpleNamespace

import numpy as np
import pytest

pytest.importorskip("llvmlite")

from motes.files.trust import distrusted
from motes.kernels import engine, machine_code, module_cache
from motes.kernels.lowering import lowered
from motes.models import Lambert

pytestmark = pytest.mark.skipif(os.name != "posix", reason="owners and modes are those of POSIX")

UP = np.array([[0.0, 0.0, 1.0]])
SOMEBODY = 54321


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    """One that is the user's alone, inside another."""
    made = tmp_path / "outer" / "kernels"
    made.mkdir(parents=True)
    for path in (made.parent, made):
        path.chmod(0o755)
    assert distrusted(made) is None
    return made


def test_a_folder_or_any_above_it_that_others_may_write(folder: Path) -> None:
    for path in (folder, folder.parent):
        for mode in (0o777, 0o757, 0o733):
            path.chmod(mode)
            assert distrusted(folder) == f"others may write {path}"
        path.chmod(0o755)
    folder.parent.chmod(0o1777)  # as /tmp: what is the user's stays where it is
    assert distrusted(folder) is None
    folder.chmod(0o1777)  # but anybody puts files here
    assert distrusted(folder) == f"others may write {folder}"


def test_groups(folder: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    import grp
    import pwd

    me = os.geteuid()
    folder.chmod(0o775)
    real = os.lstat

    def in_group(path: object) -> object:
        status = real(path)  # type: ignore[call-overload]
        return SimpleNamespace(st_mode=status.st_mode, st_uid=status.st_uid, st_gid=500)

    monkeypatch.setattr(os, "lstat", in_group)
    account = SimpleNamespace(pw_gid=500, pw_name="ada")
    monkeypatch.setattr(pwd, "getpwuid", {me: account}.__getitem__)
    for name, members, trusted in (
        ("ada", [], True),
        ("ada", ["ada"], True),
        ("ada", ["bob"], False),
        ("all", [], False),
    ):
        monkeypatch.setattr(grp, "getgrgid", {500: SimpleNamespace(gr_name=name, gr_mem=members)}.__getitem__)
        assert (distrusted(folder) is None) is trusted
    account.pw_gid = 100
    assert distrusted(folder) == f"others may write {folder}"
    monkeypatch.setattr(pwd, "getpwuid", {}.__getitem__)  # no account with this number
    assert distrusted(folder) == f"others may write {folder}"


@pytest.fixture
def give_away(monkeypatch: pytest.MonkeyPatch) -> Callable[[Path], int]:
    """Make a path another user's; returns that user's number."""

    def given(path: Path) -> int:
        real = os.lstat

        def foreign(looked: object) -> object:
            status = real(looked)  # type: ignore[call-overload]
            uid = SOMEBODY if Path(str(looked)) == path else status.st_uid
            return SimpleNamespace(st_mode=status.st_mode, st_uid=uid, st_gid=status.st_gid)

        if os.geteuid() == 0:
            os.chown(path, SOMEBODY, -1, follow_symlinks=False)
        else:
            monkeypatch.setattr(os, "lstat", foreign)
        return SOMEBODY

    return given


@pytest.mark.parametrize("which", ["kernels", "outer", "file", "link"])
def test_what_belongs_to_another_user(folder: Path, give_away: Callable[[Path], int], which: str) -> None:
    file, link = folder / "file", folder.parent / "link"
    file.write_text("")
    link.symlink_to(folder)
    assert distrusted(link, [file]) is None
    path = {"kernels": folder, "outer": folder.parent, "file": file, "link": link}[which]
    user = give_away(path)
    assert distrusted(link, [file]) == f"{path} belongs to another user (number {user})"


def test_links_are_followed_one_by_one(folder: Path, tmp_path: Path) -> None:
    """A link inside a folder that others write leads wherever they like, though both of its ends are sound."""
    (tmp_path / "open").mkdir()
    (tmp_path / "open" / "link").symlink_to(folder)
    (tmp_path / "first").symlink_to(Path("open") / ".." / "open" / "link")
    assert distrusted(tmp_path / "first") is None
    (tmp_path / "open").chmod(0o777)
    assert distrusted(tmp_path / "first") == f"others may write {tmp_path / 'open'}"
    (tmp_path / "circle").symlink_to("circle")
    with pytest.raises(OSError, match="40 links"):
        distrusted(tmp_path / "circle")


def test_files(folder: Path) -> None:
    file = folder / "file"
    file.write_text("")
    file.chmod(0o666)
    assert distrusted(folder, [file]) == f"others may write {file}"
    folder.chmod(0o700)  # nobody gets to it
    assert distrusted(folder, [file]) is None
    link = folder / "link"
    link.symlink_to(file)
    assert distrusted(folder, [link]) == f"{link} is a link"


#: A kernel with the arguments of the one that it stands in for: all that it does is to write 7.
PLANTED = """
@kernel
def evaluate(wi, wi_step, wi_stride, wo, wo_step, wo_stride, constants, varying, row, out, out_step, out_stride, room, first, last):
    store(float64, out, 0, float64(7.0), "out", 0, 1)
"""


def test_what_was_planted_in_a_cache_is_not_run(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    cache = tmp_path / "kernels"
    monkeypatch.setenv("MOTES_CACHE", str(cache))
    sentences: list[str] = []
    monkeypatch.setattr(engine, "on_compile", sentences.append)

    def evaluated() -> float:
        monkeypatch.setattr(engine, "_kernels", {})  # as in another process
        return float(engine.evaluate(Lambert(0.5), UP, UP).item())

    evaluated()
    (kept,) = cache.iterdir()
    planted = lowered(PLANTED)
    module_cache.keep(cache, kept.name, [machine_code.compiled(planted.text)], planted.kernels)
    before = {path: path.read_bytes() for path in cache.rglob("*") if path.is_file()}
    cache.chmod(0o777)
    with caplog.at_level(logging.WARNING, logger="motes.kernels"):
        assert evaluated() == pytest.approx(0.5 / np.pi, rel=1e-15)
    assert f"the cache folder {cache} is not used, for code is run from it and others may write {cache}" in caplog.text
    assert sentences[1:] == [
        f"compiling the evaluation of Lambert in float64 once (not kept: others may write {cache})"
    ]
    assert {path: path.read_bytes() for path in cache.rglob("*") if path.is_file()} == before
    cache.chmod(0o700)  # the attack is a real one: the same files, trusted, are run
    assert evaluated() == 7.0


@pytest.mark.skipif(sys.platform == "win32", reason="Windows has no passwd")
def test_a_user_without_a_home(monkeypatch: pytest.MonkeyPatch) -> None:
    import pwd

    for name in ("MOTES_CACHE", "XDG_CACHE_HOME", "HOME"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setattr(pwd, "getpwuid", {}.__getitem__)
    monkeypatch.setattr(engine, "_kernels", {})
    sentences: list[str] = []
    monkeypatch.setattr(engine, "on_compile", sentences.append)
    assert float(engine.evaluate(Lambert(0.5), UP, UP).item()) == pytest.approx(0.5 / np.pi, rel=1e-15)
    assert sentences == [
        "compiling the evaluation of Lambert in float64 once (not kept: this user has no home folder to keep kernels in)"
    ]
