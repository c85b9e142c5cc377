"""Pictures of an episode: small JPEG files, and an animation of them.

Needs pillow, and for most environments pygame: both come with the application, neither with the library.
"""

from __future__ import annotations

import io
import os
from collections.abc import Sequence
from typing import Any

import gymnasium
import numpy as np

from laplace_core.errors import InputError

HEIGHT = 180
"""Pixels; the width follows."""
QUALITY = 75
_COLOURS = 64  # of an animation
_GAP, _CAPTION = 8, 22  # pixels between two pictures, and above them


def encoded(picture: np.ndarray, height: int = HEIGHT) -> bytes:
    """A picture ``(Y, X, 3)``, uint8, scaled to a height and packed as JPEG."""
    image_of = _pillow()
    image = image_of.fromarray(picture)
    width = max(1, round(image.width * height / image.height))
    file = io.BytesIO()
    image.resize((width, height), image_of.Resampling.BILINEAR).save(file, "JPEG", quality=QUALITY)
    return file.getvalue()


def picture_of(env: gymnasium.Env) -> bytes | None:
    """The present picture of an environment; None if it draws none.

    Raises:
        InputError: what it draws with is not installed.
    """
    if env.render_mode != "rgb_array":
        return None
    os.environ.setdefault("SDL_VIDEODRIVER", "dummy")  # no window is ever opened
    try:
        return encoded(np.asarray(env.render()))
    except gymnasium.error.DependencyNotInstalled:
        raise InputError("pictures need pygame, which is not installed: roll out without pictures.") from None


def animation(pictures: Sequence[bytes], seconds: float, most: int = 500) -> bytes:
    """An animated GIF of pictures, each shown for ``seconds``; of more than ``most`` every second or third is left out.

    Raises:
        InputError: no picture.
    """
    if not pictures:
        raise InputError("this episode has no pictures to animate.")
    stride = -(-len(pictures) // most)
    image_of = _pillow()
    opened = [image_of.open(io.BytesIO(each)).convert("RGB") for each in pictures[::stride]]
    # One palette for all of them: with one of its own a still background would flicker.
    palette = opened[len(opened) // 2].quantize(_COLOURS)
    first, *others = [each.quantize(palette=palette, dither=image_of.Dither.NONE) for each in opened]
    file = io.BytesIO()
    # A GIF counts hundredths of a second, and viewers slow down what is faster than two of them.
    duration = max(20, round(100 * seconds * stride) * 10)
    first.save(file, "GIF", save_all=True, append_images=others, duration=duration, loop=0)
    return file.getvalue()


def side_by_side(left: bytes, right: bytes, captions: tuple[str, str]) -> bytes:
    """Two pictures as one, each under a line of words."""
    image_of = _pillow()
    from PIL import ImageDraw

    pair = [image_of.open(io.BytesIO(each)).convert("RGB") for each in (left, right)]
    width, height = pair[0].width + _GAP + pair[1].width, max(each.height for each in pair)
    sheet = image_of.new("RGB", (width, _CAPTION + height), "white")
    draw = ImageDraw.Draw(sheet)
    for x, picture, words in zip((0, pair[0].width + _GAP), pair, captions, strict=True):
        draw.text((x + 4, 5), words, fill="black")
        sheet.paste(picture, (x, _CAPTION))
    file = io.BytesIO()
    sheet.save(file, "JPEG", quality=QUALITY)
    return file.getvalue()


def _pillow() -> Any:
    try:
        from PIL import Image
    except ImportError:
        raise InputError("pictures need pillow, which is not installed: pip install pillow.") from None
    return Image
