"""The clickable map of the course: its chapters, each a step above the one before, and the base that all stand on."""
import html

BASE = ["base_step", "base_fem", "base_rigid", "scene_format"]


def map_block(chapters, by_label):
    """HTML of the map.
    @param chapters  the chapters' pages, in their order
    @param by_label  all pages"""
    steps = "".join(f'<a class="map-step" href="{page.label}.html"><b>{html.escape(page.number)}</b><strong>{html.escape(short(page.title))}</strong></a>'
                    for page in chapters)
    base = "".join(f'<a class="map-base" href="{label}.html">{html.escape(by_label[label].title)}</a>' for label in BASE if label in by_label)
    return (f"\\htmlonly[block]\n<nav class=\"course-map\" aria-label=\"map of the course\"><div class=\"map-steps\">{steps}</div>"
            f'<div class="map-ground"><small>all stand on</small>{base}</div></nav>\n\\endhtmlonly')


def short(title):
    """A title without its number."""
    return title.split(": ", 1)[-1]
