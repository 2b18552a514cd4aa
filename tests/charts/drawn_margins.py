"""A margin written out in NumPy, and arrays to compute it on."""
import numpy as np
from hypothesis.extra import numpy as arrays

shapes = arrays.mutually_broadcastable_shapes(num_shapes=4, max_dims=5, min_side=0, max_side=4)


def vertical(I1, dU, l, pi3_0):
    """(π3 + l)² − 4 I1 U', with the same operations."""
    P = l + pi3_0
    return P * P - 4.0 * I1 * dU


def drawn(names, shapes, seed=0):
    source = np.random.default_rng(seed)
    return {name: source.uniform(0.2, 0.8, size=shape) for name, shape in zip(names, shapes)}
