"""The examples in the docstrings of the package give what they say."""

from __future__ import annotations

import doctest
import importlib
import pkgutil

import pytest

import motes

MODULES = sorted(module.name for module in pkgutil.walk_packages(motes.__path__, "motes."))
WITH_EXAMPLES = {"motes.models.base", "motes.models.expressions"}


def test_the_modules_are_found() -> None:
    assert set(MODULES) >= WITH_EXAMPLES


@pytest.mark.parametrize("name", MODULES)
def test_examples(name: str) -> None:
    failed, attempted = doctest.testmod(importlib.import_module(name))
    assert failed == 0
    assert attempted or name not in WITH_EXAMPLES
