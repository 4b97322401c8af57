"""The list of terms: a decorator files a function under its own name, which is the name that the value file uses.

A term takes the inputs of a row as keyword arguments and gives a number, a list of numbers, or a dict of either.
"""

from typing import Callable, Dict, NamedTuple


class Term(NamedTuple):
    function: Callable
    relative: float  # how far a derived number may be from the file's
    absolute: float  # the same, added


TERMS: Dict[str, Term] = {}


def term_within(relative, absolute):
    def file(function):
        assert function.__name__ not in TERMS, function.__name__
        TERMS[function.__name__] = Term(function, relative, absolute)
        return function

    return file


term = term_within(relative=1e-12, absolute=0.0)  # a closed form
