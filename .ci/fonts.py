"""The letters of pictures that are printed: ``python .ci/fonts.py FOLDER``, where FOLDER holds Source Sans 3.

It needs fonttools, which nothing else needs. From ``SourceSans3_400Regular.ttf`` and ``SourceSans3_600SemiBold.ttf``
(npm: @expo-google-fonts/source-sans-3 0.4.1) it takes the signs of :data:`SIGNS` and writes

* ``app/js/print/fonts/*.ttf``, which a PDF embeds. The licence reserves the name Source for the whole font, so the
  parts bear another one;
* ``app/js/print/glyphs.js``, the same letters as outlines, which an SVG draws.
"""

from __future__ import annotations

import json
import sys
from pathlib import Path

from fontTools import subset
from fontTools.pens.basePen import BasePen
from fontTools.ttLib import TTFont

PRINT = Path(__file__).resolve().parents[1] / "app" / "js" / "print"
WEIGHTS = {"regular": "SourceSans3_400Regular.ttf", "bold": "SourceSans3_600SemiBold.ttf"}
FAMILY = "Workbench"
SIGNS = [
    *range(0x20, 0x7F), *range(0xA0, 0x180),  # Latin
    *range(0x391, 0x3CA), 0x3D1, 0x3D5,  # Greek
    *range(0x410, 0x450), 0x401, 0x451,  # Cyrillic
    *range(0x2010, 0x2027), 0x2032, *range(0x2070, 0x208A), 0x20AC,  # dashes, quotes, powers, indices
    *range(0x2190, 0x2196),  # arrows
    0x2202, 0x2206, 0x2208, 0x220F, 0x2211, 0x2212, 0x221A, 0x221E, 0x222B, 0x2248, 0x2260, 0x2264, 0x2265,
]  # fmt: skip
HEAD = """// Written by .ci/fonts.py: outlines of the letters of printed pictures, in 1/1000 of the size, y downwards. A
// letter is its advance and its path, which begins relative to the letter's place on the baseline; '' stands for every
// sign that is not here. Their font is Source Sans 3 under the SIL Open Font License: fonts/OFL.txt.
"""


class RelativePen(BasePen):
    """A path of SVG with y downwards, every place relative to the one before: a third shorter than absolute ones."""

    def __init__(self, glyphs: object) -> None:
        super().__init__(glyphs)
        self.words: list[str] = []
        self.at = self.start = (0, 0)

    def _to(self, command: str, *points: tuple[int, int]) -> None:
        steps = [f"{x - self.at[0]:g} {self.at[1] - y:g}" for x, y in points]
        self.words.append(command + " ".join(steps).replace(" -", "-"))
        self.at = points[-1]

    def _moveTo(self, point: tuple[int, int]) -> None:
        self._to("m", point)
        self.start = point

    def _lineTo(self, point: tuple[int, int]) -> None:
        self._to("l", point)

    def _qCurveToOne(self, control: tuple[int, int], point: tuple[int, int]) -> None:
        self._to("q", control, point)

    def _closePath(self) -> None:
        self.words.append("z")
        self.at = self.start


def part_of(path: Path) -> TTFont:
    """The font with the signs of :data:`SIGNS` alone, under its own name."""
    options = subset.Options()
    options.layout_features, options.hinting, options.notdef_outline = [], False, True
    options.name_IDs, options.drop_tables = [0, 1, 2, 3, 4, 6, 13, 14], [*options.drop_tables, "DSIG", "STAT"]
    font = subset.load_font(str(path), options)
    subsetter = subset.Subsetter(options)
    subsetter.populate(unicodes=SIGNS)
    subsetter.subset(font)
    weight = path.stem.split("_")[1]
    for entry in font["name"].names:
        if entry.nameID in (1, 3, 4, 6):
            entry.string = f"{FAMILY}-{weight}" if entry.nameID in (3, 6) else f"{FAMILY} {weight}"
    return font


def outlines_of(font: TTFont) -> dict[str, list[int | str]]:
    """Advance and path of every sign."""
    glyphs, advances = font.getGlyphSet(), font["hmtx"]

    def outline(name: str) -> list[int | str]:
        pen = RelativePen(glyphs)
        glyphs[name].draw(pen)
        return [advances[name][0], "".join(pen.words)]

    names = {chr(code): name for code, name in font.getBestCmap().items()}
    return {"": outline(".notdef")} | {sign: outline(name) for sign, name in sorted(names.items())}


def main(folder: Path) -> None:
    found = {}
    for name, file in WEIGHTS.items():
        font = part_of(folder / file)
        assert font["head"].unitsPerEm == 1000
        font.save(PRINT / "fonts" / f"{name}.ttf", reorderTables=True)
        found[name] = outlines_of(font)
    entries = [f"export const {name} = {json.dumps(each, ensure_ascii=False)};\n" for name, each in found.items()]
    (PRINT / "glyphs.js").write_text(HEAD + "".join(entries), encoding="utf-8")
    print({name: len(each) for name, each in found.items()})


if __name__ == "__main__":
    main(Path(sys.argv[1]))
