#!/usr/bin/python3
"""Opens every page of the book in headless Chromium, as a reader with a phone would, and says what is wrong with it.

No console error, formulas typeset, pictures loaded, readable contrast in both themes, no sideways scroll at 390 px, live
figures that answer and turn, a search that finds, and a chapter that prints. Needs Debian's chromium-driver and python3-selenium.
"""
import argparse
import base64
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from os import cpu_count
from pathlib import Path

try:
    from selenium import webdriver
    from selenium.common.exceptions import WebDriverException
    from selenium.webdriver.common.action_chains import ActionChains
    from selenium.webdriver.chrome.service import Service
    from selenium.webdriver.common.by import By
    from selenium.webdriver.common.keys import Keys
    from selenium.webdriver.support.ui import WebDriverWait
except ImportError:
    sys.exit("The browser test needs Debian's python3-selenium   (or: ./course setup)")

ROOT = Path(__file__).resolve().parents[2]
PROBE = (ROOT / "docs/tools/browser_probe.js").read_text(encoding="utf-8")
PHONE = {"width": 390, "height": 844, "deviceScaleFactor": 1, "mobile": False}  # "mobile" would widen to what does not fit
LAPTOP = {"width": 1400, "height": 900, "deviceScaleFactor": 1, "mobile": False}
DESKTOP = {"width": 1280, "height": 900, "deviceScaleFactor": 1, "mobile": False}
BROKEN_LINES = """return [...document.querySelectorAll('div.textblock div.fragment .line')].filter(line =>
    line.innerText.trimEnd().length <= 110 && line.getBoundingClientRect().height > 1.5 * parseFloat(getComputedStyle(line).lineHeight))
    .map(line => line.innerText);"""
# A live figure's view, words and picture, once it has been drawn anew; and the first place on a canvas where a point can be dragged.
LOOK = """const [figure, done] = arguments; requestAnimationFrame(() => requestAnimationFrame(() => done(
    { view: figure.dataset.view, answer: figure.dataset.answer, picture: figure.querySelector('canvas').toDataURL() })));"""
FIND_POINT = """const canvas = arguments[0], box = canvas.getBoundingClientRect();
for (let y = 5; y < box.height; y += 10) for (let x = 5; x < box.width; x += 10) {
  canvas.dispatchEvent(new PointerEvent('pointermove', { clientX: box.left + x, clientY: box.top + y }));
  if (canvas.style.cursor === 'grab') return [x + 5, y + 10];
}
return null;"""
# Whether the switch of themes can be seen and hit, in the row of the search field.
BESIDE = """const row = box => (box.top + box.bottom) / 2, seen = arguments[0].getBoundingClientRect(), field = document.querySelector('#book-search input').getBoundingClientRect();
const hit = document.elementFromPoint((seen.left + seen.right) / 2, row(seen));
return arguments[0].contains(hit) && Math.abs(row(seen) - row(field)) < 8 && seen.left >= field.right;"""
PRINTED = {"chapter_03.html": ("Which way is out, and how deep?", "Further reading"), "chapter_05.html": ("One normal is not enough", "Further reading")}


def browser(waits=True):
    """Headless Chromium. @param waits  for pages to be loaded; a window that a script writes never is"""
    options = webdriver.ChromeOptions()
    options.page_load_strategy = "normal" if waits else "none"
    for word in ("--headless=new", "--no-sandbox", "--disable-gpu", "--allow-file-access-from-files", "--hide-scrollbars"):
        options.add_argument(word)
    options.set_capability("goog:loggingPrefs", {"browser": "ALL"})
    driver = webdriver.Chrome(service=Service(shutil.which("chromedriver") or "chromedriver"), options=options)
    driver.set_script_timeout(120)
    driver.set_page_load_timeout(120)
    return driver


def screen(driver, size):
    driver.execute_cdp_cmd("Emulation.setDeviceMetricsOverride", size)


def open_page(driver, page):
    """Opens a page and waits until it is there: on a busy machine the browser says so before it has read it."""
    driver.get(page.as_uri())
    there = "return location.href.startsWith(arguments[0]) && document.readyState === 'complete'"
    WebDriverWait(driver, 60).until(lambda d: d.execute_script(there, page.as_uri()))


def probe(driver, page):
    """What one page shows."""
    open_page(driver, page)
    report = driver.execute_async_script(PROBE)
    report["faults"] += [f"console: {entry['message'][:160]}" for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
    return report


def probe_all(pages):
    """The reports of some pages, in one browser. A browser that falls over is started again, once for each page."""
    driver, reports = None, {}
    for page in pages:
        for attempt in (1, 2):
            try:
                if driver is None:
                    driver = browser()
                    screen(driver, PHONE)
                reports[page.name] = probe(driver, page)
                break
            except WebDriverException as error:
                if driver is not None:
                    driver.quit()
                    driver = None
                reports[page.name] = {"faults": [f"the browser gave up: {str(error).splitlines()[0]}"]}
    if driver is not None:
        driver.quit()
    return reports


SEARCHED = {"rest offset": "chapter_", "capstan": "chapter_10.html", "continuous_impulse": "continuous_impulse"}  # words of the text, and a name of the code


def search_faults(driver, book):
    """The search finds words of the text and names of the code, and leads to their page."""
    for size in (DESKTOP, PHONE):
        screen(driver, size)
        open_page(driver, book / "index.html")
        field = WebDriverWait(driver, 20).until(lambda d: d.find_element(By.CSS_SELECTOR, "#book-search input"))
        for words, told in SEARCHED.items():
            field.clear()
            field.send_keys(words)
            found = "return [...document.querySelectorAll('#book-search .found a')].map(e => e.href + ' ' + e.innerText).join('\\n')"
            try:
                WebDriverWait(driver, 20).until(lambda d: words in d.execute_script(found).lower() and told in d.execute_script(found))
            except WebDriverException:
                yield f"index.html, {size['width']} px: the search does not find {words} ({driver.execute_script(found)[:60]!r})"


def switch_faults(driver, book):
    """The switch of themes is drawn beside the search field, answers to a click and to a key, and the next page keeps the choice."""
    dark = "return document.documentElement.classList.contains('dark-mode')"
    for size in (DESKTOP, PHONE):
        screen(driver, size)
        open_page(driver, book / "index.html")
        switch = WebDriverWait(driver, 20).until(lambda d: d.find_element(By.CSS_SELECTOR, "doxygen-awesome-dark-mode-toggle[role=button]"))
        name, first = f"index.html, {size['width']} px: the switch of themes", driver.execute_script(dark)
        if not driver.execute_script(BESIDE, switch):
            yield f"{name} is not drawn beside the search field"
            continue
        switch.click()
        open_page(driver, book / "chapter_01.html")
        if driver.execute_script(dark) == first:
            yield f"{name} changes nothing on the next page"
        driver.find_element(By.CSS_SELECTOR, "doxygen-awesome-dark-mode-toggle").send_keys(Keys.ENTER)
        if driver.execute_script(dark) != first:
            yield f"{name} does not answer to a key"


def sidebar_faults(driver, book):
    """The first thing that the sidebar offers is chapter 1."""
    screen(driver, DESKTOP)
    open_page(driver, book / "chapter_03.html")
    shown = "return [...document.querySelectorAll('#nav-tree .item .label a')].filter(a => a.innerText.trim() && a.offsetParent).map(a => a.innerText)"
    entries = WebDriverWait(driver, 20).until(lambda d: (found := d.execute_script(shown)) and len(found) > 5 and found)
    above = entries[:next((i for i, entry in enumerate(entries) if entry.startswith("Chapter 1")), None)]
    if set(above) != {"Enduring Contacts"}:
        yield f"chapter_03.html: the sidebar shows {', '.join(above)} above chapter 1"


def listing_faults(driver, book):
    """On a laptop's screen no line of a listing is broken that keeps to the sources' 110 columns."""
    screen(driver, LAPTOP)
    for page in sorted(book.glob("chapter_*.html")):
        open_page(driver, page)
        for line in driver.execute_script(BROKEN_LINES):
            yield f"{page.name}: broken at {LAPTOP['width']} px: {line.strip()[:60]}"


def drag(driver, canvas, place, by):
    """Presses the pointer at a place on a canvas, from its upper left corner, and moves it."""
    width, height = canvas.size["width"], canvas.size["height"]
    ActionChains(driver).move_to_element_with_offset(canvas, int(place[0] - width / 2), int(place[1] - height / 2)) \
        .click_and_hold().move_by_offset(*by).release().perform()


def turning_faults(driver, book, size):
    """A live figure in space turns when it is dragged beside its points, or by a key; it does not when a point is dragged; and it turns back."""
    screen(driver, size)
    for page in [page for page in sorted(book.glob("chapter_*.html")) if 'src="live/turning.js"' in page.read_text(encoding="utf-8")]:
        open_page(driver, page)
        WebDriverWait(driver, 60).until(lambda d: not d.execute_script("return document.querySelector('[data-live]:not([data-live=ready])')"))
        for figure in driver.find_elements(By.CSS_SELECTOR, ".live[data-view]"):
            canvas, back = figure.find_element(By.TAG_NAME, "canvas"), figure.find_element(By.XPATH, ".//button[text()='turn back']")
            name = f"{page.name}, {size['width']} px: {figure.get_attribute('data-figure')}"
            driver.execute_script("arguments[0].scrollIntoView({block: 'center'})", canvas)
            look = lambda: driver.execute_async_script(LOOK, figure)
            first, point = look(), driver.execute_script(FIND_POINT, canvas)
            for how, turn, undo in (("dragging", lambda: drag(driver, canvas, (60, 90), (50, 20)), back.click),
                                    ("the arrow keys", lambda: canvas.send_keys(Keys.ARROW_LEFT), lambda: canvas.send_keys(Keys.HOME))):
                turn()
                turned = look()
                if turned["view"] == first["view"] or turned["picture"] == first["picture"]:
                    yield f"{name} is not turned by {how}"
                    continue
                if turned["answer"] != first["answer"]:
                    yield f"{name}: {how} changes what it says"
                undo()
                if look() != first:
                    yield f"{name} does not turn back after {how}"
            if point:
                drag(driver, canvas, point, (15, -25))
                if look()["view"] != first["view"] or look()["answer"] == first["answer"]:
                    yield f"{name}: a dragged point does not move alone"


def print_faults(driver, book, out):
    """A chapter prints: its first and its last heading are there, on several pages, and the navigation is not."""
    screen(driver, DESKTOP)
    for name, (first, last) in PRINTED.items():
        open_page(driver, book / name)
        driver.execute_async_script("const go = arguments[0]; document.documentElement.classList.add('dark-mode'); MathJax.Hub.Queue(() => setTimeout(go, 300));")
        pdf = out / name.replace(".html", ".pdf")
        printed = driver.execute_cdp_cmd("Page.printToPDF", {"printBackground": True, "paperWidth": 8.27, "paperHeight": 11.69})
        pdf.write_bytes(base64.b64decode(printed["data"]))
        text = subprocess.run(["pdftotext", "-layout", pdf, "-"], capture_output=True, text=True, check=True).stdout
        words = " ".join(text.split())
        yield from (f"{name}: '{heading}' is missing in print" for heading in (first, last) if heading not in words)
        yield from (f"{name}: '{word}' of the navigation is printed" for word in ("Table of Contents", "Generated by", "Namespace Members") if word in words)
        if text.count("\f") < 5:
            yield f"{name}: prints on {text.count(chr(12))} pages"


def tell(reports, faults):
    total = {key: sum(report.get(key, 0) for report in reports.values()) for key in ("formulas", "pictures", "texts", "live", "inputs")}
    lowest = min(report.get("lowest", 21) for report in reports.values())
    widest = max(reports, key=lambda name: reports[name].get("width", 0))
    for fault in faults:
        print(fault)
    print(f"\n{len(reports)} pages, {total['formulas']} formulas, {total['pictures']} pictures and clips, {total['texts']} pieces of text in two themes "
          f"(lowest contrast {lowest:.2f}), {total['live']} live figures with {total['inputs']} inputs; widest {reports[widest].get('width', 0)} px ({widest}): "
          f"{len(faults)} faults")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--book", type=Path, default=ROOT / "build/book", help="the book")
    parser.add_argument("--pages", default="*.html", help="only those whose names match, as 'chapter_*.html'")
    parser.add_argument("--pdf", type=Path, help="where the printed chapters go")
    options = parser.parse_args()
    book = options.book.resolve()
    pages = sorted(book.glob(options.pages))
    if not pages:
        sys.exit(f"{book} has no pages: ./course docs builds them")
    try:
        browser().quit()
    except WebDriverException as error:
        sys.exit(f"The browser does not start: {str(error).splitlines()[0]}")
    workers = cpu_count()
    with ThreadPoolExecutor(workers) as pool:
        reports = {name: report for part in pool.map(probe_all, [pages[i::workers] for i in range(workers)]) for name, report in part.items()}
    faults = [f"{name}: {fault}" for name in sorted(reports) for fault in reports[name]["faults"]]
    if (book / "index.html").is_file():
        driver = browser()
        with tempfile.TemporaryDirectory() as scratch:
            faults += [*search_faults(driver, book), *switch_faults(driver, book), *sidebar_faults(driver, book), *listing_faults(driver, book), *turning_faults(driver, book, DESKTOP), *turning_faults(driver, book, PHONE),
                       *print_faults(driver, book, options.pdf or Path(scratch))]
        driver.quit()
    tell(reports, faults)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
