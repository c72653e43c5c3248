"""Names of Python 2 at run time, for python2.py: builtins, attributes, modules, and functions used by rewritten
code.
"""

from __future__ import annotations

import builtins
import collections.abc
import decimal
import functools
import importlib
import io
import itertools
import math
import numbers
import operator
import random
import string
import sys
import types

PRINT, EXEC, ERROR, DIVIDE = "_print_", "_exec_", "_error_", "_divide_"
DIVIDE_ATTRIBUTE, DIVIDE_ITEM, ATTRIBUTE, COMPARE = "_divide_attribute_", "_divide_item_", "_attribute_", "_compare_"
ORDERS = {"Lt": operator.lt, "LtE": operator.le, "Gt": operator.gt, "GtE": operator.ge}
METHODS = {"next": "__next__", "__nonzero__": "__bool__", "__div__": "__truediv__", "__rdiv__": "__rtruediv__",
           "__idiv__": "__itruediv__"}


def divide(a, b):
    """Divides; the quotient of integers is an integer, rounded down."""
    return a // b if isinstance(a, numbers.Integral) and isinstance(b, numbers.Integral) else a / b


def divide_attribute(owner, name, value):
    setattr(owner, name, divide(getattr(owner, name), value))


def divide_item(owner, key, value):
    owner[key] = divide(owner[key], value)


def print_(file, comma, *values):
    print(*values, file=file, end=" " if comma else "\n")


def error_(kind, value=None, trace=None):
    """Returns the exception of `raise kind, value, trace`."""
    if not isinstance(kind, type) or isinstance(value, kind):
        error = value if isinstance(kind, type) else kind
    else:
        error = kind() if value is None else kind(*value) if isinstance(value, tuple) else kind(value)
    return error.with_traceback(trace)


def _rank(value):
    """Returns the rank of a value among values of other types: None, numbers, then others by the name of the type."""
    return (0, "") if value is None else (1, "") if isinstance(value, numbers.Number) else (2, type(value).__name__)


def compare(a, operation, b):
    try:
        return ORDERS[operation](a, b)
    except TypeError:
        for value, other, sign in ((a, b, 1), (b, a, -1)):
            if hasattr(value, "__cmp__") and (order := value.__cmp__(other)) is not NotImplemented:
                return ORDERS[operation](sign * order, 0)
        return ORDERS[operation](_rank(a), _rank(b))


def cmp(a, b):
    return compare(a, "Gt", b) - compare(a, "Lt", b)


_order = cmp


def _key(cmp_function, key):
    if cmp_function is None:
        return key
    order = functools.cmp_to_key(cmp_function)
    return order if key is None else lambda value: order(key(value))


def sorted_(values, cmp=None, key=None, reverse=False):
    values = list(values)
    try:
        return builtins.sorted(values, key=_key(cmp, key), reverse=reverse)
    except TypeError:
        return builtins.sorted(values, key=_key(cmp or _order, key), reverse=reverse)


def map_(function, *lists):
    """Returns a list; shorter arguments are padded with None."""
    rows = itertools.zip_longest(*lists) if len(lists) > 1 else None
    if function is None:
        return list(lists[0]) if rows is None else list(rows)
    return [function(each) for each in lists[0]] if rows is None else [function(*row) for row in rows]


def filter_(function, values):
    """Returns a list, or the type of `values` if that is a tuple or a text."""
    kept = [each for each in values if (each if function is None else function(each))]
    return "".join(kept) if isinstance(values, str) else tuple(kept) if isinstance(values, tuple) else kept


def round_(value, digits=0):
    """Returns a float; halves are rounded away from zero."""
    if not abs(value) < 1e22:  # an integer, infinite or NaN
        return float(value)
    return float(decimal.Decimal(value).quantize(decimal.Decimal(1).scaleb(-digits), decimal.ROUND_HALF_UP))


def _refused(name):
    def refuse(*_):
        raise RuntimeError(f"{name}(): a design script cannot ask for input")
    return refuse


class Random(random.Random):
    """Python 2's sequence of random numbers, also for a text as seed."""

    def seed(self, a=None, version=1):
        super().seed(a, version=1)

    def _randbelow(self, n):
        return int(self.random() * n)


# Attributes with another meaning in Python 3: of dictionaries, lists, texts, functions, iterators and modules.

DICTIONARY = {
    "has_key": lambda d: d.__contains__, "keys": lambda d: lambda: list(d.keys()),
    "values": lambda d: lambda: list(d.values()), "items": lambda d: lambda: list(d.items()),
    "iterkeys": lambda d: lambda: iter(d.keys()), "itervalues": lambda d: lambda: iter(d.values()),
    "iteritems": lambda d: lambda: iter(d.items())}
LIST = {"sort": lambda items: lambda *how, **named: items.__setitem__(slice(None), sorted_(items, *how, **named))}
TEXT = {"decode": lambda text: lambda *_: text}
ERROR_OBJECT = {"message": lambda error: error.args[0] if len(error.args) == 1 else ""}
FUNCTION = {"func_name": "__name__", "func_code": "__code__", "func_defaults": "__defaults__",
            "func_globals": "__globals__", "func_doc": "__doc__", "im_func": "__func__", "im_self": "__self__"}


def _of_text(name):
    return lambda text, *arguments: getattr(text, name)(*arguments)


STRING = {name: _of_text(name) for name in """capitalize center count expandtabs find index ljust lower lstrip replace
          rfind rindex rjust rstrip split strip swapcase upper zfill""".split()}
STRING.update({
    "letters": string.ascii_letters, "lowercase": string.ascii_lowercase, "uppercase": string.ascii_uppercase,
    "join": lambda words, between=" ": between.join(words),
    "atoi": lambda text, base=10: int(text, base), "atol": lambda text, base=10: int(text, base), "atof": float})
MODULES = {
    "string": STRING,
    "itertools": {"imap": builtins.map, "ifilter": builtins.filter, "izip": builtins.zip,
                  "izip_longest": itertools.zip_longest, "ifilterfalse": itertools.filterfalse},
    "operator": {"div": divide, "isCallable": callable, "sequenceIncludes": operator.contains, "isSequenceType":
                 lambda value: isinstance(value, collections.abc.Sequence)},
    "sys": {"maxint": sys.maxsize},
}
MATH = {name: lambda value, of=getattr(math, name): float(of(value)) for name in ("floor", "ceil")}
ATTRIBUTES = {"next"}.union(DICTIONARY, LIST, TEXT, ERROR_OBJECT, FUNCTION, *MODULES.values())


def attribute(value, name):
    """Returns an attribute under its Python 2 name."""
    for kind, known in ((collections.abc.Mapping, DICTIONARY), (list, LIST), (str, TEXT),
                        (BaseException, ERROR_OBJECT)):
        if isinstance(value, kind) and name in known and not (kind is BaseException and hasattr(value, name)):
            return known[name](value)
    if name == "next" and not hasattr(value, "next") and hasattr(value, "__next__"):
        return value.__next__
    if isinstance(value, (types.FunctionType, types.MethodType)) and name in FUNCTION:
        return getattr(value, FUNCTION[name])
    if isinstance(value, types.ModuleType) and not hasattr(value, name):
        return MODULES.get(value.__name__, {}).get(name) or getattr(value, name)
    return getattr(value, name)


def modules():
    """Returns modules under their Python 2 names, with Python 2's random numbers."""
    renamed = {"Queue": "queue", "cPickle": "pickle", "__builtin__": "builtins"}
    made = {old: importlib.import_module(new) for old, new in renamed.items()}
    made["StringIO"] = made["cStringIO"] = io
    numbers_ = Random()
    for name in ("random", "string", "itertools", "operator", "math"):  # copies, also for `from string import letters`
        made[name] = types.ModuleType(name)
        vars(made[name]).update({**MODULES.get(name, {}), **vars(importlib.import_module(name))})
    vars(made["math"]).update(MATH)
    public = [name for name in dir(numbers_) if not name.startswith("_")]
    vars(made["random"]).update({name: getattr(numbers_, name) for name in public}, Random=Random)
    return made


def builtins_of_python2(execute):
    """Returns `__builtins__` for scripts; `execute` runs the text of an exec statement with globals and locals."""
    known = dict(vars(builtins))

    def reduce(function, values, *start):
        return functools.reduce(function, values, *start)

    def execfile(path, *where):
        with open(path, encoding="utf-8") as file:
            execute(file.read(), *where)

    known.update({
        "map": map_, "filter": filter_, "zip": lambda *lists: list(builtins.zip(*lists)),
        "range": lambda *limits: list(builtins.range(*limits)), "xrange": builtins.range, "reduce": reduce,
        "sorted": sorted_, "cmp": cmp, "round": round_, "long": int, "unicode": str, "basestring": str, "unichr": chr,
        "apply": lambda function, arguments=(), named={}: function(*arguments, **named), "intern": sys.intern,
        "file": open, "execfile": execfile, "raw_input": _refused("raw_input"), "input": _refused("input"),
        "reload": importlib.reload, "StandardError": Exception,
        PRINT: print_, EXEC: execute, ERROR: error_, ATTRIBUTE: attribute, COMPARE: compare,
        DIVIDE: divide, DIVIDE_ATTRIBUTE: divide_attribute, DIVIDE_ITEM: divide_item,
    })
    return known
