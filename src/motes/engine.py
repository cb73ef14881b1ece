"""The compiled engine: evaluation and gradients of models at many directions, on all cores.

A model is traced (`motes.tracing`), printed as a Numba module (`motes.codegen.numba`) and compiled once; the module and its machine
code are kept in the user's cache folder, so that the next process loads them in a fraction of a second.  Values of parameters are
inputs: a model of the same structure with other values uses the same kernel.

Work is cut into chunks of fixed size that threads of this process take in turn.  The kernels release the interpreter's lock and use no
threads of their own, so forking and calling from several threads at once are safe, and results do not depend on the number of
threads.  ``NUMBA_NUM_THREADS`` limits it.

The cache folder is ``$MOTES_CACHE``, or ``motes`` in the platform's place for caches.  It holds code that is executed: it is made
readable by its owner only.
"""

from __future__ import annotations

import hashlib
import importlib.util
import itertools
import os
import platform
import sys
import tempfile
import threading
from collections.abc import Callable, Mapping
from concurrent.futures import ThreadPoolExecutor
from dataclasses import dataclass
from pathlib import Path
from types import ModuleType
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

from motes import tracing
from motes._version import __version__
from motes.codegen import numpy as numpy_code
from motes.codegen.printer import statements
from motes.errors import DataError, ParameterError
from motes.parameters import Parametrised

if True:  # TYPE_CHECKING
    pass

#: Below this number of directions NumPy is about as fast, and there is nothing to compile.
THRESHOLD = 100_000
#: Called with a sentence before a kernel is compiled, which takes some seconds and is done once; None: nobody is told.
on_compile: Callable[[str], None] | None = None

CHUNK = 32_768  # directions a thread takes at a time; a multiple of the kernels' tile
