from ._core import *
from ._core import Error as Error
from ._core import __version__ as __version__
from . import cam as cam
from . import language as language
from . import stock as stock
from . import shapes as shapes
