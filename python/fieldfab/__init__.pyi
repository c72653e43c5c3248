from ._core import *
from ._core import Error as Error
from . import shapes as shapes
