#!/usr/bin/python3
"""Opens every deck of slides in headless Chromium as a projector shows it, and says which slide overflows, lacks a picture or a formula, or has no notes;
and whether the speaker view and the printed notes come.

With --pictures each slide is written as a picture. Needs Debian's chromium-driver and python3-selenium.
"""
import argparse
import sys
from pathlib import Path

from browser_test import ROOT, WebDriverException, WebDriverWait, browser, open_page, screen

PROJECTOR = {"width": 1280, "height": 720, "deviceScaleFactor": 1, "mobile": False}
SMALLEST_PICTURE = 220  # px: a picture that has less height cannot be read from the last row
READY = "return window.Reveal?.isReady() && !document.querySelector('[data-live]:not([data-live=ready])') && [...document.images].every(image => image.complete)"
SET = "const done = arguments[arguments.length - 1]; window.MathJax ? MathJax.Hub.Queue(() => done()) : done();"
# What is wrong with the slide that is shown: a part beyond the slide (by more than the slant of a letter), parts that lie over each other, nothing to look at, nothing to say.
FAULTS = """const faults = [], slide = Reveal.getCurrentSlide(), scale = Reveal.getScale(), border = document.querySelector('.reveal .slides').getBoundingClientRect();
const box = slide.querySelector('.slide'), parts = [...box.children];
for (const part of box.querySelectorAll('*')) {
  const { left, right, top, bottom, width, height } = part.getBoundingClientRect();
  if (part.closest('.MathJax_Preview, .MJX_Assistive_MathML, script') || !width || !height) continue;
  const over = Math.max(border.left - left, right - border.right, border.top - top, bottom - border.bottom) / scale;
  if (over > 2) { faults.push(`${part.tagName.toLowerCase()} of ${part.closest('.slide > *').className || part.closest('.slide > *').tagName} (${Math.round(width / scale)} x ${Math.round(height / scale)} px) is ${Math.round(over)} px beyond the slide`); break; }
}
parts.slice(1).forEach((part, i) => { if (parts[i].getBoundingClientRect().bottom > part.getBoundingClientRect().top + 1) faults.push(`${part.tagName.toLowerCase()} ${i + 2} lies over the part above`); });
const formulas = box.querySelectorAll('.formula svg').length, pictures = [...box.querySelectorAll('img, canvas')].filter(picture => picture.getClientRects().length);
if (!formulas && !pictures.length) faults.push('neither a picture nor a formula');
for (const picture of pictures) if (picture.getBoundingClientRect().height / scale < arguments[0]) faults.push(`a picture is only ${Math.round(picture.getBoundingClientRect().height / scale)} px high`);
for (const image of box.querySelectorAll('img')) if (!image.naturalWidth) faults.push(`a picture is missing: ${image.getAttribute('src')}`);
if (box.querySelector('.MathJax_Error, merror, g[data-mml-node=merror]')) faults.push('a formula is wrong');
if (/\\\\[([]|[$]/.test(box.innerText)) faults.push(`left raw: ${box.innerText.match(/.{0,20}(\\\\[([]|[$]).{0,20}/)[0]}`);
if (!slide.querySelector('aside.notes')?.textContent.trim()) faults.push('no notes');
return [slide.querySelector('h1, h2').innerText, faults];"""
NOTES = """const shown = document.querySelector('.speaker-notes'); return getComputedStyle(shown).display !== 'none' && shown.innerText.trim().length > 20;"""


def deck_faults(driver, deck, pictures=None):
    """(number of slides, faults) of one deck. @param pictures  folder for a picture of each slide"""
    screen(driver, PROJECTOR)
    open_page(driver, deck)
    try:
        WebDriverWait(driver, 60).until(lambda d: d.execute_script(READY))
    except WebDriverException:
        return 0, [f"{deck.name}: does not start: {[entry['message'][:160] for entry in driver.get_log('browser')]}"]
    driver.execute_async_script(SET)
    faults, total = [], driver.execute_script("return Reveal.getTotalSlides()")
    for number in range(1, total + 1):
        title, found = driver.execute_script(FAULTS, SMALLEST_PICTURE)
        faults += [f"{deck.name}, slide {number} '{title}': {fault}" for fault in found]
        if pictures:
            (pictures / f"{deck.stem}_{number:02}.png").write_bytes(driver.get_screenshot_as_png())
        driver.execute_script("Reveal.next()")
    key(driver, "N")
    if not driver.execute_script(NOTES):
        faults.append(f"{deck.name}: the key N does not show the notes")
    faults += [f"{deck.name}: console: {entry['message'][:160]}" for entry in driver.get_log("browser") if entry["level"] == "SEVERE"]
    return total, faults


def key(driver, letter):
    driver.execute_script("document.dispatchEvent(new KeyboardEvent('keydown', { keyCode: arguments[0], bubbles: true }))", ord(letter))


def speaker_faults(deck):
    """Whether S opens a window with the notes of the present slide, and P lays out a page of notes behind each slide."""
    driver = browser(waits=False)
    try:
        screen(driver, PROJECTOR)
        open_page(driver, deck)
        WebDriverWait(driver, 60).until(lambda d: d.execute_script(READY))
        notes, total = driver.execute_script("Reveal.next(); return [Reveal.getCurrentSlide().querySelector('aside.notes').textContent.slice(0, 30), Reveal.getTotalSlides()]")
        slides = driver.current_window_handle
        key(driver, "S")
        try:
            WebDriverWait(driver, 20).until(lambda d: len(d.window_handles) == 2)
            driver.switch_to.window(next(window for window in driver.window_handles if window != slides))
            WebDriverWait(driver, 20).until(lambda d: notes in (d.execute_script("return document.querySelector('.speaker-controls-notes')?.innerText") or ""))
        except WebDriverException:
            yield f"{deck.name}: the key S opens no speaker view with the notes"
        driver.switch_to.window(slides)
        key(driver, "P")
        count = "return document.querySelectorAll('.speaker-notes-pdf').length"
        try:
            WebDriverWait(driver, 60).until(lambda d: d.execute_script(count) == total)
        except WebDriverException:
            yield f"{deck.name}: the key P lays out {driver.execute_script(count)} pages of notes for {total} slides"
    finally:
        driver.quit()


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("--slides", type=Path, default=ROOT / "build/book/slides", help="the folder of the decks")
    parser.add_argument("--pictures", type=Path, help="where a picture of each slide goes")
    options = parser.parse_args()
    decks = sorted(options.slides.resolve().glob("*.html"))
    if not decks:
        sys.exit(f"{options.slides} has no slides: ./course docs --slides makes them")
    if options.pictures:
        options.pictures.mkdir(parents=True, exist_ok=True)
    driver, total, faults = browser(), 0, []
    try:
        for deck in decks:
            count, found = deck_faults(driver, deck, options.pictures)
            total, faults = total + count, faults + found
    finally:
        driver.quit()
    faults += speaker_faults(decks[0])
    for fault in faults:
        print(fault)
    print(f"{total} slides in {len(decks)} decks: {len(faults)} faults")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
