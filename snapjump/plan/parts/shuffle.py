"""Shuffled numbers that can be computed one by one, so that no permutation is ever held.

A Feistel network of eight rounds permutes 0 to 4^k - 1 by a key; numbers that leave 0 to
count - 1 are permuted again until they come back (after at most four passes on average). It is
integer arithmetic throughout: the same on every machine.
"""

import numpy as np
from numpy.typing import NDArray

Integers = NDArray[np.uint64]
ROUNDS = 8
MIXERS = (np.uint64(0xBF58476D1CE4E5B9), np.uint64(0x94D049BB133111EB))
GOLDEN = np.uint64(0x9E3779B97F4A7C15)


def mixed(numbers: Integers) -> Integers:
    """Every 64-bit number turned into another that looks random (SplitMix64's finalizer)."""
    x = numbers + GOLDEN
    x = (x ^ (x >> np.uint64(30))) * MIXERS[0]
    x = (x ^ (x >> np.uint64(27))) * MIXERS[1]
    return x ^ (x >> np.uint64(31))


def keyed(key: int, stream: int, numbers: Integers) -> Integers:
    """Random bits for each number, others for every key and stream."""
    seeded = mixed(np.array([key], dtype=np.uint64))
    return mixed(mixed(seeded + np.uint64(stream)) ^ numbers)


def shuffled(numbers: Integers, count: int, key: int, stream: int) -> Integers:
    """Images of numbers under a permutation of 0 to count - 1."""
    half = max(1, ((count - 1).bit_length() + 1) // 2)
    result = numbers.copy()
    outside = np.arange(len(numbers))
    while len(outside):
        result[outside] = _feistel(result[outside], half, key, stream)
        outside = outside[result[outside] >= count]
    return result


def _feistel(numbers: Integers, half: int, key: int, stream: int) -> Integers:
    """One pass of the network over numbers of twice ``half`` bits."""
    bits, mask = np.uint64(half), np.uint64(2**half - 1)
    left, right = numbers >> bits, numbers & mask
    for turn in range(ROUNDS):
        left, right = right, left ^ (keyed(key, ROUNDS * stream + turn, right) & mask)
    return (left << bits) | right
