"""The surfaces that other programs compute, with parameters named as there: what `motes export --to openpbr` and its like fit to a material.

Texts and fits know them (``motes fit DATA --model openpbr``); lists of models do not offer them.
"""
