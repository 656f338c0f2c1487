"""A plan is drawn by touch, taken back, saved, and driven in; and everything of it by keyboard and numbers."""

import io
import json
import re

import ezdxf
import pytest
import trimesh
from browser.driving import reaches_the_goal
from browser.sizes import fits, keep, window
from browser.tablets import send
from playwright.sync_api import expect

pytestmark = [pytest.mark.browser, pytest.mark.long]

DRAFT = "JSON.parse(localStorage.getItem('bodydrive-plan-draft'))"


@pytest.fixture(params=["768x1024", "1280x800"])
def tablet(request, browser, page_log, demo):
    """Yield a page of one tablet on the list of floor plans, a function that keeps a screenshot, and its log."""
    log = page_log(demo)
    page = log.watch(browser.new_page(in_3d=True, viewport=window(request.param), has_touch=True))
    page.goto(demo)
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    assert send(page, demo, "POST", "/auth/introduction").ok
    page.reload()  # without the sentences of a first time, which would move the drawing
    page.get_by_role("navigation", name="What else").get_by_role("link", name="Floor plans").click()
    expect(page.get_by_role("heading", name="Floor plans", exact=True)).to_be_visible()
    yield page, lambda picture: keep(page, f"{request.param}-plan-{picture}"), log
    log.assert_clean()


def document(page):
    return page.evaluate(f"() => {DRAFT}?.document")


class Sheet:
    """The drawing, touched at places in metres; an empty plan shows (4, 3) in its middle, 60 px to a metre."""

    def __init__(self, page):
        self.page = page
        self.box = page.locator(".sheet").bounding_box()

    def tap(self, *places):
        for x, y in places:
            middle_x, middle_y = self.box["x"] + self.box["width"] / 2, self.box["y"] + self.box["height"] / 2
            self.page.touchscreen.tap(middle_x + (x - 4) * 60, middle_y - (y - 3) * 60)


def new_sheet(page):
    page.get_by_role("button", name="New plan").tap()
    expect(page.locator(".sheet")).to_be_visible()
    return Sheet(page)


def tool(page, name):
    page.get_by_role("toolbar", name="Tools").get_by_role("button", name=name, exact=True).tap()


def draw_a_room(page, keep):
    sheet = new_sheet(page)
    expect(page.get_by_text("There is no path yet")).to_be_visible()

    tool(page, "Wall")
    sheet.tap((0, 1), (7, 1), (7, 5), (0, 5), (0, 1.02))
    assert document(page)["walls"] == [[[0, 1], [7, 1], [7, 5], [0, 5], [0, 1]]]
    tool(page, "Door")
    sheet.tap((7, 3))
    assert document(page)["doors"][0]["position"] == [7, 3]
    tool(page, "Box")
    sheet.tap((5, 4), (6, 4.6))
    tool(page, "Cone")
    sheet.tap((3, 4.4))
    tool(page, "Path")
    sheet.tap((1, 3), (3, 2.2), (6, 2.2))
    keep("drawing")
    page.get_by_role("button", name="Done").tap()
    expect(page.get_by_text("This plan can be driven in.")).to_be_visible()
    whole = document(page)
    assert whole["paths"][0]["points"] == [[1, 3], [3, 2.2], [6, 2.2]]
    assert whole["obstacles"][0]["size"] == [1, 0.6]
    return whole


def test_a_room_is_drawn_by_touch_saved_and_driven_in(tablet):
    page, keep, _ = tablet
    keep("list")
    whole = draw_a_room(page, keep)

    for _ in range(4):
        page.get_by_role("button", name="Undo").tap()
    assert (document(page)["paths"], document(page)["cones"], document(page)["doors"]) == ([], [], [])
    for _ in range(4):
        page.get_by_role("button", name="Redo").tap()
    assert document(page) == whole

    page.reload()  # what is not saved is still there
    expect(page.get_by_text("not saved")).to_be_visible()
    assert document(page) == whole
    page.get_by_label("Title", exact=True).fill("My room")
    page.get_by_label("Title", exact=True).press("Tab")
    expect(page.get_by_role("heading", name="My room")).to_be_visible()
    fits(page, ".page")

    page.get_by_role("link", name="All plans").tap()
    expect(page.get_by_role("heading", name="This plan is not saved")).to_be_visible()
    keep("leave")
    page.get_by_role("button", name="Stay").tap()
    page.get_by_role("button", name="Save as new plan").tap()
    expect(page.get_by_text("saved, version 1")).to_be_visible()
    keep("saved")
    assert re.fullmatch("my-room(-2)?", page.evaluate(f"() => {DRAFT}.name"))  # one demonstration for both tablets

    page.get_by_role("link", name="Drive here").tap()
    expect(page.get_by_role("heading", name="Where to?")).to_be_visible()
    expect(page.locator(".task-card")).to_contain_text("My room")
    keep("chosen")
    page.get_by_role("button", name="Start trial").tap()
    expect(page.frame_locator("iframe").locator("canvas").first).to_be_visible()
    keep("driven")
    reaches_the_goal(page)


def test_what_is_wrong_is_shown_where_it_is(tablet):
    page, keep, _ = tablet
    sheet = new_sheet(page)
    tool(page, "Wall")
    sheet.tap((2, 1), (2, 5), (2, 5.01))
    tool(page, "Path")
    sheet.tap((0.5, 3), (5, 3), (5, 3))
    expect(page.locator(".verdict.bad")).to_contain_text(
        re.compile(r"comes within 0\.00 m of a wall near \(2\.00, 3\.00\)")
    )
    expect(page.locator(".sheet .at")).to_have_count(1)
    keep("wrong")
    tool(page, "Door")
    sheet.tap((2, 3))
    expect(page.locator(".verdict.good")).to_be_visible()

    # Everything also without touching the picture: the list, numbers and arrow keys.
    page.get_by_label("Chosen", exact=True).select_option("Path: Main path")
    page.get_by_label("Start heading (°)").fill("90")
    page.get_by_label("Start heading (°)").press("Tab")
    assert document(page)["paths"][0]["start_heading"] == pytest.approx(1.5708)
    page.get_by_role("button", name="Next point").tap()
    page.locator(".sheet").focus()
    page.keyboard.press("ArrowUp")
    page.keyboard.press("Shift+ArrowLeft")
    assert document(page)["paths"][0]["points"][0] == [-0.5, 3.1]
    page.keyboard.press("Control+z")
    page.keyboard.press("Control+z")
    assert document(page)["paths"][0]["points"][0] == [0.5, 3]
    tool(page, "Cone")
    page.locator(".sheet").focus()
    page.keyboard.press("ArrowRight")
    page.keyboard.press("Enter")
    assert len(document(page)["cones"]) == 1
    page.keyboard.press("Escape")
    page.evaluate("() => document.documentElement.dataset.theme = 'dark'")
    keep("dark")
    page.get_by_role("link", name="All plans").tap()
    page.get_by_role("button", name="Throw it away").tap()
    expect(page.get_by_role("heading", name="Floor plans", exact=True)).to_be_visible()
    assert page.evaluate(f"() => {DRAFT}") is None


def test_an_object_of_an_improbable_size_is_asked_about(tablet, request):
    page, keep, log = tablet
    sheet = new_sheet(page)
    tool(page, "Box")
    sheet.tap((5, 4), (6, 4.6))
    name = f"bed-{request.node.callspec.params['tablet']}"
    content = trimesh.creation.box((1000, 2000, 3000)).export(file_type="glb")  # mm: left, up and ahead
    file = {"name": f"{name}.glb", "mimeType": "model/gltf-binary", "buffer": content}
    objects = page.locator("input[type=file][accept^='.glb']")
    question = page.get_by_role("alertdialog").filter(has_text="3,000 x 1,000 x 2,000 m large as it says")
    objects.set_input_files(file)
    expect(question.get_by_role("button")).to_have_text(["3 × 1 × 2 m", "3000 × 1000 × 2000 m, as it says", "Cancel"])
    fits(page, ".page")
    keep("object-size")
    page.keyboard.press("Escape")
    expect(question).to_be_hidden()
    expect(page.get_by_label("Drawn as").locator("option", has_text=name)).to_have_count(0)
    objects.set_input_files(file)
    question.get_by_role("button", name="3 × 1 × 2 m", exact=True).tap()
    expect(page.get_by_text(f"{name}.glb was added")).to_be_visible()
    page.get_by_label("Drawn as").select_option(f"{name} (3.00 × 1.00 × 2.00 m)")
    page.get_by_role("button", name="As large as the object").tap()
    box = document(page)["obstacles"][0]
    assert (box["size"], box["height"]) == ([3, 1], 2)
    assert all("422" in error for error in log.errors)  # the browser's own words about the question
    log.errors.clear()
    page.get_by_role("link", name="All plans").tap()
    page.get_by_role("button", name="Throw it away").tap()


def drawing_file():
    drawn = ezdxf.new()
    drawn.header["$INSUNITS"] = 0
    space = drawn.modelspace()
    space.add_lwpolyline([(0, 0), (900, 0), (900, 600), (0, 600)], close=True, dxfattribs={"layer": "WALLS"})
    space.add_line((450, 0), (450, 400), dxfattribs={"layer": "WALLS"})
    space.add_line((0, -100), (900, -100), dxfattribs={"layer": "DIMENSIONS"})
    text = io.StringIO()
    drawn.write(text)
    return {"name": "Ground floor.dxf", "mimeType": "image/vnd.dxf", "buffer": text.getvalue().encode()}


def test_a_drawing_and_a_bundled_plan_are_opened_as_copies(tablet):
    page, keep, log = tablet
    page.locator(".import-form input[type=file]").first.set_input_files(drawing_file())
    page.get_by_role("button", name="Read the file").tap()
    expect(page.get_by_text("does not say in which unit")).to_be_visible()
    assert len(log.errors) == 1  # the browser's own words about the refusal
    log.errors.clear()
    page.get_by_label("Drawn in").select_option("centimetres")
    page.get_by_role("button", name="Read the file").tap()
    expect(page.get_by_text("Which layers are walls?")).to_be_visible()
    keep("import")
    assert not page.get_by_label("DIMENSIONS").is_checked()
    preview = page.get_by_role("region", name="Plan made from the file")
    expect(preview.get_by_text("m large, as given, in cm.")).to_be_visible()
    expect(preview.get_by_text("DIMENSIONS")).to_be_visible()
    page.get_by_label("DIMENSIONS").check()
    page.get_by_role("button", name="Read the file").tap()
    expect(preview.get_by_text("DIMENSIONS")).to_be_hidden()
    page.get_by_label("DIMENSIONS").uncheck()
    page.get_by_role("button", name="Read the file").tap()
    expect(preview.get_by_role("img", name="The walls and the path from above")).to_be_visible()
    page.get_by_role("button", name="Open this plan").tap()
    expect(page.get_by_text("This plan can be driven in.")).to_be_visible()
    keep("imported")
    assert document(page)["title"] == "Ground floor"

    page.get_by_role("link", name="All plans").tap()
    page.get_by_role("button", name="Leave it here").tap()
    expect(page.get_by_role("link", name="Go on with")).to_be_visible()
    page.get_by_text("Plans that come with the software").tap()
    page.get_by_role("button", name=re.compile("Open a copy of “.*clinic", re.IGNORECASE)).first.tap()
    page.get_by_role("button", name="Throw it away").tap()
    expect(page.get_by_text("This plan can be driven in.")).to_be_visible()
    keep("copy")
    assert json.dumps(document(page)).count("Copy of") == 1
    page.get_by_role("button", name="Nearer").tap()
    page.get_by_role("button", name="Look left").tap()
    page.get_by_role("button", name="All of the plan").tap()
