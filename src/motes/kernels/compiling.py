"""The parts of a module, compiled by this process and by others beside it.

llvmlite holds a lock through each call, so that one process compiles one part at a time.  Another one is Python with `motes.kernels.object_code` and nothing
else; it is handed LLVM's text through a pipe and gives an object back, the same that this process would make.  Where it does not start, or ends, or is late,
its part is compiled here.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
import threading
from collections.abc import Sequence
from contextlib import suppress
from pathlib import Path
from typing import Self

from motes import workers
from motes.kernels import assembly, machine_code, object_code

#: Processes besides this one.
MOST_HELPERS = 3
# Letters and functions of a module's source from which on it is worth while to start others.
LONG, MANY = 40_000, 8
# Seconds that are waited for what another process has in work, when there is nothing else to do; a part takes a fortieth of that.
PATIENCE = 5.0

Helper = subprocess.Popen[bytes]


class Parts:
    """The parts of a module, which whoever is free compiles next.

    Other processes start when it is made of a long `source`: what is done before `compiled` goes on beside that.
    """

    def __init__(self, source: str) -> None:
        self._changed = threading.Condition()
        self._texts: Sequence[str] | None = None
        self._waiting: list[int] = []
        self._found: dict[int, bytes] = {}
        self._helpers: list[Helper] = []
        if assembly.IN_PARTS and len(source) >= LONG and source.count("\ndef ") >= MANY:
            with suppress(OSError, RuntimeError, ImportError):  # no more processes or threads can be had
                for _ in range(min(MOST_HELPERS, workers.threads() - 1)):
                    self._start()

    def _start(self) -> None:
        helper = _started()
        if helper is not None:
            self._helpers.append(helper)
            threading.Thread(target=self._help, args=(helper,), daemon=True).start()

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        with self._changed:
            self._texts, self._waiting = self._texts or (), []
            self._changed.notify_all()
        for helper in self._helpers:
            helper.kill()
            helper.wait()

    def compiled(self, texts: Sequence[str]) -> list[bytes]:
        """The objects of all parts."""
        with self._changed:
            self._texts, self._waiting = texts, list(range(len(texts)))
            self._changed.notify_all()
        while (k := self._next()) is not None:
            code = machine_code.compiled(texts[k])
            with self._changed:
                self._found[k] = code
        with self._changed:
            self._changed.wait_for(lambda: self._waiting or len(self._found) == len(texts), PATIENCE)
            found = dict(self._found)
        return [found[k] if k in found else machine_code.compiled(text) for k, text in enumerate(texts)]

    def _next(self) -> int | None:
        with self._changed:
            return self._waiting.pop(0) if self._waiting else None

    def _help(self, helper: Helper) -> None:
        """Hand parts to another process, one after the other; one that does not come back waits again."""
        asked, answers = helper.stdin, helper.stdout
        assert asked is not None
        assert answers is not None
        k: int | None = None
        try:
            with asked, answers:
                object_code.put(asked, json.dumps(machine_code.processor()).encode())
                with self._changed:
                    self._changed.wait_for(lambda: self._texts is not None)
                    texts = self._texts or ()
                while (k := self._next()) is not None:
                    object_code.put(asked, texts[k].encode())
                    code = object_code.take(answers)
                    with self._changed:
                        self._found[k] = code
                        self._changed.notify_all()
        except (OSError, EOFError, ValueError):
            with self._changed:
                if k is not None and k not in self._found:
                    self._waiting.append(k)
                self._changed.notify_all()


def _started() -> Helper | None:
    """Python that compiles; None where this program is not Python itself, or is not made of files."""
    import llvmlite

    script = Path(object_code.__file__)
    if not Path(sys.executable or "").name.lower().startswith("python") or not script.is_file():
        return None
    # Nothing of the environment, of the folder or of site packages: what runs is this file, the standard library and llvmlite.
    run = [sys.executable, "-I", "-S", os.fspath(script), os.fspath(Path(llvmlite.__file__).parent.parent)]
    return subprocess.Popen(run, stdin=subprocess.PIPE, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
