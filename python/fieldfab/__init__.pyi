from ._core import *
from ._core import Error as Error
from . import cam as cam
from . import language as language
from . import stock as stock
from . import shapes as shapes
