"""Names of arguments that have changed."""

import functools
import warnings
from collections.abc import Callable
from typing import ParamSpec, TypeVar

_Parameters = ParamSpec("_Parameters")
_Result = TypeVar("_Result")


def renamed(**present: str) -> Callable[[Callable[_Parameters, _Result]], Callable[_Parameters, _Result]]:
    """Read arguments under their former names, the keys, for one version more, with a warning."""

    def decorate(function: Callable[_Parameters, _Result]) -> Callable[_Parameters, _Result]:
        @functools.wraps(function)
        def call(*arguments: _Parameters.args, **named: _Parameters.kwargs) -> _Result:
            for old, new in present.items():
                if old in named:
                    if new in named:
                        raise TypeError(f"`{old}` is the former name of `{new}`, which is given too")
                    message = f"`{old}` is now `{new}`: write the new name, the next version refuses the old one"
                    warnings.warn(message, DeprecationWarning, stacklevel=2)
                    named[new] = named.pop(old)
            return function(*arguments, **named)

        return call

    return decorate
