"""Pictures for print: panels of the lens as PDF, SVG and PNG at the width of a journal's column."""

from __future__ import annotations

import itertools
import re
import xml.etree.ElementTree as ET

import pytest
from PIL import Image

from tests.browser.support import module_of, open_at, settled

pytestmark = pytest.mark.usefixtures("chromium")
expect = pytest.importorskip("playwright.sync_api").expect

SVG = "{http://www.w3.org/2000/svg}"
DARK = {"#e6e9ed", "#14171b", "#1b2026", "#a9b1ba"}
"""Colours of text and paper of a dark page."""


def dialog_of(page):
    page.get_by_role("button", name="save for print").click()
    dialog = page.get_by_role("dialog", name="Save for print")
    expect(dialog.get_by_role("status")).to_contain_text("mm")
    return dialog


def saved(page, dialog, kind, width, path):
    dialog.get_by_label(f"{width} mm").check()
    dialog.get_by_label(kind, exact=True).check()
    with page.expect_download() as waiting:
        dialog.get_by_role("button", name="Save", exact=True).click()
    waiting.value.save_as(path)
    return path


def only(dialog, *names):
    for box in dialog.get_by_role("checkbox").all():
        box.set_checked(box.get_attribute("value") in names)


def labels(drawing) -> list[str]:
    return [node.get("aria-label") for node in drawing.iter(f"{SVG}path") if node.get("aria-label")]


def places(drawing) -> list[tuple[float, ...]]:
    """Left, top, right and bottom of what each panel is clipped to."""
    clips = {node.get("id"): node[0] for node in drawing.iter(f"{SVG}clipPath")}
    groups = [node for node in drawing if node.tag == f"{SVG}g"]
    found = [clips[re.search(r"#(\w+)", group.get("clip-path"))[1]] for group in groups]
    sides = [[float(box.get(name)) for name in ("x", "y", "width", "height")] for box in found]
    return [(x, y, x + w, y + h) for x, y, w, h in sides]


def test_one_panel_is_two_clicks_from_a_pdf_of_a_column(page, demo, tmp_path):
    open_at(page, demo)
    dialog = dialog_of(page)
    with page.expect_download() as waiting:
        dialog.get_by_role("button", name="Save", exact=True).click()
    assert waiting.value.suggested_filename == "lens_two_branch_tau-space_85mm.pdf"
    waiting.value.save_as(tmp_path / "one.pdf")
    data = (tmp_path / "one.pdf").read_bytes()
    width, _ = (float(number) for number in re.search(rb"/MediaBox \[0 0 ([\d.]+) ([\d.]+)\]", data).groups())
    assert width == pytest.approx(85 / 25.4 * 72, abs=0.02)
    fonts = set(re.findall(rb"/FontName /(\w+)", data))
    assert fonts == {b"Workbench"}
    assert data.count(b"/FontFile2 ") == 2
    assert len(re.findall(rb"/Type\s*/Page\b", data)) == 1


def test_a_set_in_a_dark_theme_is_light_and_every_letter_an_outline(page, demo, tmp_path):
    page.emulate_media(color_scheme="dark")
    open_at(page, demo)
    settled(page)
    background = page.evaluate("() => getComputedStyle(document.querySelector('.stApp')).backgroundColor")
    assert sum(map(int, re.findall(r"\d+", background)[:3])) < 200  # the page is dark
    dialog = dialog_of(page)
    only(dialog, "gamma-space", "tau-space", "values")
    text = saved(page, dialog, "SVG", 180, tmp_path / "set.svg").read_text()
    drawing = ET.fromstring(text)
    assert drawing.get("width") == "180mm"
    assert not list(drawing.iter(f"{SVG}text"))
    assert not any(colour in text for colour in DARK)
    paper = next(drawing.iter(f"{SVG}path"))
    assert paper.get("fill") == "#ffffff"
    right, bottom = (float(number) for number in drawing.get("viewBox").split()[2:])
    corners = [float(number) for number in re.findall(r"[\d.]+", paper.get("d"))]
    assert corners == pytest.approx([0, 0, right, 0, right, bottom, 0, bottom], abs=0.01)

    found = places(drawing)
    assert len(found) == 3
    for a, b in itertools.combinations(found, 2):
        assert a[2] <= b[0] or b[2] <= a[0] or a[3] <= b[1] or b[3] <= a[1]
    assert found[2][0] == pytest.approx(right - found[2][2], abs=0.01)  # the odd one stands in the middle

    words = labels(drawing)
    caption = " ".join(words)
    for setting in ("α = 0.2", "T = 3 steps", "solver Tikhonov", "slope 25 / reward", "Rows as decoded"):
        assert setting in caption
    assert {"Tau-space", "Gamma-space", "sensitivity θ (reward)", "value (reward)", "horizon T (steps)"} <= set(words)
    letters = module_of(page, "print/letters.js")
    assert letters.evaluate("({ missingFrom }, words) => missingFrom(words)", caption) == []

    # Heat maps are enlarged to 300 dots to the inch or more, so that no program smooths their cells.
    sizes = page.evaluate(
        """(addresses) => Promise.all(addresses.map(async (src) => {
             const image = Object.assign(new Image(), { src });
             await image.decode();
             return image.naturalWidth;
           }))""",
        [node.get("href") for node in drawing.iter(f"{SVG}image")],
    )
    drawn = [float(node.get("width")) for node in drawing.iter(f"{SVG}image")]
    assert all(dots * 96 / width >= 300 for dots, width in zip(sizes, drawn, strict=True))

    # What is on the page is as dark as before.
    dialog.get_by_role("button", name="Close").click()
    expect(page.get_by_role("dialog")).to_have_count(0)
    page.get_by_role("button", name="long", exact=True).click()
    settled(page)
    with page.expect_download() as waiting:
        page.get_by_role("button", name="save SVG").click()
    waiting.value.save_as(tmp_path / "lens.svg")
    assert 'fill="#ffffff"/>' not in (tmp_path / "lens.svg").read_text()[:400]


def test_a_png_has_600_dots_to_the_inch_and_a_sheet_of_all_panels_no_hole(page, demo, tmp_path):
    open_at(page, demo)
    dialog = dialog_of(page)
    with Image.open(saved(page, dialog, "PNG", 85, tmp_path / "one.png")) as one:
        assert one.width == round(85 / 25.4 * 600)
        assert one.info["dpi"] == pytest.approx((600, 600), abs=0.1)
        assert one.convert("RGB").getpixel((0, 0)) == (255, 255, 255)
    dialog.get_by_role("button", name="All panels").click()
    drawing = ET.parse(saved(page, dialog, "SVG", 180, tmp_path / "all.svg")).getroot()
    found = places(drawing)
    assert len(found) == dialog.get_by_role("checkbox").count() == 7
    assert len({left for left, *_ in found}) == 3  # two columns, and the odd one in the middle
    only(dialog)
    expect(dialog.get_by_role("status")).to_have_text("Tick at least one panel.")
    expect(dialog.get_by_role("button", name="Save", exact=True)).to_be_disabled()


@pytest.mark.long
def test_the_graph_of_a_world_is_printed_with_the_rest(page, address, tmp_path):
    page.emulate_media(color_scheme="dark")
    open_at(page, address)
    dialog = dialog_of(page)
    only(dialog, "world", "values")
    drawing = ET.parse(saved(page, dialog, "SVG", 180, tmp_path / "set.svg")).getroot()
    assert len(places(drawing)) == 2
    (graph,) = drawing.iter(f"{SVG}image")
    darkest, lightest = page.evaluate(
        """async (src) => {
             const image = Object.assign(new Image(), { src });
             await image.decode();
             const canvas = new OffscreenCanvas(image.naturalWidth, image.naturalHeight), pen = canvas.getContext('2d');
             pen.drawImage(image, 0, 0);
             const { data } = pen.getImageData(0, 0, canvas.width, Math.round(canvas.height / 8)); // its title
             const of = (i) => data[4 * i] + data[4 * i + 1] + data[4 * i + 2];
             const sums = Array.from({ length: data.length / 4 }, (_, i) => of(i));
             return [sums.reduce((a, b) => Math.min(a, b)), sums[0]];
           }""",
        graph.get("href"),
    )
    assert lightest == 3 * 255
    assert darkest < 3 * 64


def test_a_saved_lens_prints_without_a_network_and_says_where_a_pdf_is_made(page, demo, chromium, tmp_path):
    open_at(page, demo)
    with page.expect_download() as waiting:
        page.get_by_role("button", name="save HTML").click()
    waiting.value.save_as(tmp_path / "lens.html")
    context = chromium.new_context(offline=True, accept_downloads=True)
    alone, problems = context.new_page(), []
    alone.on("pageerror", lambda error: problems.append(str(error)))
    alone.goto((tmp_path / "lens.html").as_uri())
    dialog = dialog_of(alone)
    expect(dialog.get_by_label("PDF")).to_be_disabled()
    expect(dialog).to_contain_text("A PDF is saved in the workbench")
    drawing = ET.parse(saved(alone, dialog, "SVG", 85, tmp_path / "one.svg")).getroot()
    assert drawing.get("width") == "85mm"
    assert "Tau-space" in labels(drawing)
    assert problems == []
    context.close()
