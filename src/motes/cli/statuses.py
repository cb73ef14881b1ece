"""Exit statuses of the command line."""

from __future__ import annotations

DONE = 0
NOT_CONVERGED = 1  # the results are written, and marked so
FAULT_FOUND = 1  # by motes certify; the page is written
USAGE = 2  # bad input, or options that do not go together
DEFECT = 3  # of motes
INTERRUPTED = 130
BROKEN_PIPE = 141  # the reader of the output went away
