"""The book for GitHub: what Doxygen reads becomes what GitHub reads, and what cannot is told."""
import sys
import tempfile
import unittest
from pathlib import Path

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "tools"))
import github  # noqa: E402

FIGURE = r"""<div class="figure">
\anchor fig_drop
\htmlonly<a href="figures/a/drop.svg"><img src="figures/a/drop.svg" alt="A [drop]" loading="lazy"></a>\endhtmlonly
<div class="caption"><b>Figure 1.1.</b> It falls \f$h\f$.</div>
</div>"""


class ForGitHub(unittest.TestCase):
    def setUp(self):
        held = tempfile.TemporaryDirectory()
        self.addCleanup(held.cleanup)
        self.root = Path(held.name)
        self.write("docs/address.toml", 'repository = ""\nbook = ""\n')
        self.write("figures/a/drop.svg", "<svg/>")
        self.write("fall.hpp", "// [fall]\n    int fall();\n// [fall]\n")
        self.write("pages/mainpage.md", "# The course {#mainpage}\n\n- \\subpage chapter_01\n")

    def write(self, name, text):
        path = self.root / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text(text, encoding="utf-8")

    def made(self, text):
        self.write("pages/chapter_01.md", "# Chapter 1: The drop {#chapter_01}\n\n[TOC]\n\n" + text)
        faults = github.write(sorted((self.root / "pages").glob("*.md")), self.root / "figures", self.root / "out", self.root)
        return faults or (self.root / "out/chapter_01.md").read_text(encoding="utf-8")

    def test_links_lead_to_pages_headings_and_figures(self):
        text = self.made('## Why? {#why}\nSee \\ref why, \\ref fig_drop "Figure 1.1" and \\ref index "the start".\n\n' + FIGURE)
        self.assertIn("See [Why?](chapter_01.md#why), [Figure 1.1](chapter_01.md#fig_drop) and [the start](README.md).", text)
        self.assertIn('<a id="why"></a>\n\n## Why?', text)
        self.assertIn("[Chapter 1: The drop](chapter_01.md)", (self.root / "out/README.md").read_text(encoding="utf-8"))

    def test_a_figure_is_a_picture_with_its_caption(self):
        text = self.made(FIGURE)
        self.assertIn('![A (drop)](figures/a/drop.svg)\n\n**Figure 1.1.** It falls $`h`$.', text)
        self.assertTrue((self.root / "out/figures/a/drop.svg").is_file())

    def test_formulas_and_listings(self):
        text = self.made('So \\f$a\\,b\\f$, and\n\\f[\nx = y\n\\f]\n\n<div class="listing">fall.hpp</div>\n\\snippet fall.hpp fall\n')
        self.assertIn("So $`a\\,b`$, and\n```math\nx = y\n```", text)
        self.assertIn("`fall.hpp`:\n\n```cpp\nint fall();\n```", text)

    def test_the_name_behind_a_tick_is_its_title(self):
        tick = '<span class="test" tabindex="0">✓<code class="test">drop: \\|v\\| &lt; "1"</code></span>'
        self.assertIn('It falls (<span title="drop: |v| &lt; &quot;1&quot;">✓</span>).', self.made(f"It falls ({tick})."))

    def test_code_is_left_as_it_is(self):
        self.assertIn("`\\ref x`\n\n```\n\\ref y\n```", self.made("`\\ref x`\n\n```\n\\ref y\n```\n"))

    def test_what_is_missing_or_left_over_is_told_and_nothing_is_written(self):
        self.assertEqual(self.made("\\ref nowhere and \\anchor"),
                         ["chapter_01.md: leads to nowhere, which is not there", "chapter_01.md: left in the text: '\\\\anchor'"])
        self.assertEqual(self.made(FIGURE.replace("drop.svg", "gone.svg")), ["chapter_01.md: the picture figures/a/gone.svg is missing"])
        self.assertFalse((self.root / "out").exists())


if __name__ == "__main__":
    unittest.main()
