"""The command ``motes``: a thin shell over the library; each command is in `motes.cli`, exit statuses in `motes.cli.statuses`."""

from __future__ import annotations

import inspect
import io
import os
import sys
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING

from motes.cli.invocation import ARGUMENTS, read_by
from motes.cli.statuses import BROKEN_PIPE, DEFECT, DONE, INTERRUPTED, USAGE
from motes.files.writing import READ

if TYPE_CHECKING:
    from cyclopts import App

HELP = """Reflectance that changes with time: measured, fitted, rendered.

motes COMMAND --help shows the options of a command; motes demo is a good start."""


def make_app() -> App:
    """The commands and their options."""
    import cyclopts

    from motes.cli.age_command import age
    from motes.cli.certify_command import certify
    from motes.cli.demo_command import demo
    from motes.cli.dust_command import dust
    from motes.cli.export_command import export
    from motes.cli.fit_command import fit
    from motes.cli.info_command import info
    from motes.cli.material_command import material
    from motes.cli.plan_command import plan
    from motes.cli.render_command import render
    from motes.cli.report_command import report
    from motes.cli.simulate_command import simulate
    from motes.cli.stack_command import stack
    from motes.cli.view_command import view
    from motes.version import __version__

    app = cyclopts.App(
        name="motes",
        version=f"motes {__version__}",
        help=HELP,
        help_format="plaintext",  # Markdown would cost a third of the time of --help
        default_parameter=cyclopts.Parameter(show_default=_default),
        suppress_keyboard_interrupt=False,  # `main` answers it
    )
    for command in (fit, plan, stack, info, age, simulate, render, dust, view, export, material, certify, report, demo):
        app.command(command, help=_description(command))
    return app


def _default(value: object) -> str | None:
    """A default value as --help shows it; an option that is off by default says nothing."""
    return None if value is None or value is False or value == () else "on" if value is True else str(value)


def _description(command: Callable[..., int]) -> str:
    """What a docstring says before its parameters, a line a paragraph, which --help breaks to the terminal's width."""
    text = inspect.cleandoc(command.__doc__ or "").partition("\nParameters\n-")[0].strip()
    return "\n\n".join(" ".join(paragraph.split()) for paragraph in text.split("\n\n"))


def main(argv: Sequence[str] | None = None) -> int:
    """Run a command line; returns the exit status.

    Parameters
    ----------
    argv
        The arguments; those of the process by default.
    """
    arguments = list(sys.argv[1:] if argv is None else argv)
    ARGUMENTS.set(tuple(arguments))
    READ.set(read_by(arguments))
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, io.TextIOWrapper):
            stream.reconfigure(errors="replace")  # a terminal that cannot show sigma still gets its table
    debug = "--debug" in arguments or os.environ.get("MOTES_DEBUG", "") not in ("", "0")
    try:
        status = _run(arguments)
        if sys.stdout:  # None where the shell closed it
            sys.stdout.flush()
        return status
    except KeyboardInterrupt:
        print("interrupted", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        _abandon_output()
        return BROKEN_PIPE
    except Exception as error:
        _abandon_output()
        if debug:
            import traceback

            traceback.print_exc()
        return _explain(error)


def _run(arguments: list[str]) -> int:
    if arguments == ["--version"]:  # answered without loading the commands
        from motes.version import __version__

        print(f"motes {__version__}")
        return DONE
    status = make_app()(arguments, exit_on_error=False, print_error=False, result_action="return_value")
    return status if isinstance(status, int) else DONE


def _abandon_output() -> None:
    """Drop what standard output cannot take: a full disk or a closed pipe would fail again at the interpreter's end."""
    try:
        if sys.stdout:
            sys.stdout.flush()
    except OSError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _explain(error: Exception) -> int:
    """Say what went wrong in a sentence and what to do in another; returns the exit status."""
    import cyclopts

    from motes.cli.console import clean
    from motes.errors import MotesError

    status = USAGE
    if isinstance(error, MotesError):
        message, hint = error.message, error.hint
    elif isinstance(error, cyclopts.CycloptsError):
        error.verbose = False
        message = " ".join(str(error).split())
        command = " ".join(("motes", *(error.command_chain or ())))
        hint = f"{command} --help shows what it takes"
    elif isinstance(error, OSError) and error.strerror:
        message = f"{error.strerror}: {error.filename}" if error.filename else error.strerror
        hint = "Check the path, its permissions and the room on the disk"
    elif isinstance(error, MemoryError):
        message, hint = "the memory does not suffice", "Take less data, or close other programs"
    elif isinstance(error, RuntimeError) and "can't start new thread" in str(error):
        message, hint = "no thread can be started: memory or processes are limited", "Raise ulimit -v or ulimit -u"
    else:
        status = DEFECT
        message = f"motes failed in a way it should not: {type(error).__name__}: {error}"
        hint = "Run it again with --debug and report what it prints"
    print(f"error: {clean(message).rstrip('.')}", file=sys.stderr)
    if hint:
        print(f"hint: {clean(hint)}", file=sys.stderr)
    return status


if __name__ == "__main__":
    sys.exit(main())
