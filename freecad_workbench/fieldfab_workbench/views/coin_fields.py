"""Fast copies of whole arrays into Coin fields."""

import ctypes

import numpy as np


def fill(field, array):
    """Copies the rows of an array into a multiple-value field. Their data types must be equal (float32, int32,
    uint32)."""
    array = np.ascontiguousarray(array)
    field.setNum(len(array))
    if len(array):
        values = field.startEditing()
        ctypes.memmove(int(getattr(values, "this", values)), array.ctypes.data, array.nbytes)
        field.finishEditing()


def packed(rgb):
    """Returns (n, 3) bytes of red, green and blue as Coin's packed colours, opaque."""
    wide = np.asarray(rgb, np.uint32)
    return (wide[:, 0] << 24) | (wide[:, 1] << 16) | (wide[:, 2] << 8) | np.uint32(255)
