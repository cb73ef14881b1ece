"""Whether a JPEG is progressive (ITU-T T.81): its decoder then keeps the coefficients of the whole picture, and not of some lines."""

from __future__ import annotations

from pathlib import Path

# The markers of frames, SOF; C4, C8 and CC are others.
FRAMES = frozenset({*range(0xC0, 0xD0)} - {0xC4, 0xC8, 0xCC})
PROGRESSIVE = frozenset({0xC2, 0xC6, 0xCA, 0xCE})
SCAN, PREFIX = 0xDA, 0xFF
#: Segments before the frame that are looked at; profiles and thumbnails take some hundred at most.
MOST_SEGMENTS = 10_000


def progressive(path: Path) -> bool:
    """Whether the first frame is progressive; what cannot be followed so far is taken for it, which asks for more memory.

    Raises
    ------
    OSError
        When the file cannot be read.
    """
    with path.open("rb") as file:
        file.seek(2)  # its beginning
        for _ in range(MOST_SEGMENTS):
            byte = file.read(1)
            while byte and byte[0] != PREFIX:  # decoders go over what is no marker
                byte = file.read(1)
            while byte and byte[0] == PREFIX:  # as many as one likes may stand before a marker
                byte = file.read(1)
            if not byte or byte[0] == SCAN:
                return True
            if byte[0] in FRAMES:
                return byte[0] in PROGRESSIVE
            if 0xD0 <= byte[0] <= 0xD9 or byte[0] in (0, 1):  # without a length
                continue
            length = int.from_bytes(file.read(2), "big")
            file.seek(max(length - 2, 0), 1)
    return True
