"""Previews of references, and links to the numbers behind figures, as the extensions of the book make them."""

from __future__ import annotations

from docutils import nodes
from numbers_below import below_the_figure
from previews import ROWS, previews_of

PAGE = """
<section id="top"><h1>Title<a class="headerlink" href="#top">#</a></h1>
<div class="cell"><div class="result admonition" id="box"><p>The result.</p></div></div>
<p>Not this.</p>
<section id="sub"><span id="sec-label"></span><h2>Sub</h2><p>See <a href="x.html">there</a>.</p>
<div class="math" id="equation-eq-a"><span class="eqno">(1)<a class="headerlink">#</a></span>\\[a < b\\]</div>
<figure id="fig-a"><img src="_images/a.svg" alt="A" tabindex="0"/><figcaption>Caption</figcaption></figure>
<figure id="fig-b"><img src="data:image/svg+xml;base64,AAAA" alt="B"/><figcaption>Other</figcaption></figure>
<table id="tab-a"><tbody>ROWS</tbody></table>
</section></section>
"""


def test_each_kind_of_target_has_its_preview() -> None:
    """Breaks if a kind is left out, the page itself shows its first words instead of its result, or links stay in."""
    found = previews_of(PAGE.replace("ROWS", "<tr><td>1</td></tr>" * (ROWS + 2)))
    assert set(found) == {"", "top", "sub", "sec-label", "equation-eq-a", "fig-a", "fig-b", "tab-a"}
    assert "The result." in found[""] and "Not this." not in found[""]
    assert found["sub"] == found["sec-label"] == "<h2>Sub</h2><p>See there.</p>"
    assert "\\[a &lt; b\\]" in found["equation-eq-a"]
    assert "and 2 more rows" in found["tab-a"] and found["tab-a"].count("<tr>") == ROWS


def test_previews_repeat_no_id_and_carry_no_heavy_data() -> None:
    """Breaks if a page would hold an id twice while a preview is shown, or pictures inside pages are doubled."""
    for shown in previews_of(PAGE).values():
        assert "id=" not in shown
        assert "href=" not in shown
        assert "tabindex" not in shown
        assert "base64" not in shown


def cell(*parts: nodes.Node) -> nodes.container:
    return nodes.container("", nodes.container("", *parts, nb_element="cell_code_output"), nb_element="cell_code")


def figure(name: str) -> nodes.figure:
    words = "<p>the numbers behind the figure as NAME.csv</p>"
    link = nodes.raw("", words, format="html", numbers=True)
    return nodes.figure("", nodes.image(uri="a.svg"), link, nodes.caption("", "words"), ids=[name])


def test_numbers_come_below_their_figure_under_its_name() -> None:
    """Breaks if the link stays between picture and caption, or is not named like the figure."""
    page = nodes.section("", cell(figure("fig-a")), nodes.paragraph("", "words"))
    below_the_figure(None, page, "page")
    shown, link = page[0][0].children
    assert [type(part) for part in shown] == [nodes.image, nodes.caption]
    assert "fig-a.csv" in link.astext()


def test_a_page_that_offers_them_itself_keeps_its_own() -> None:
    """Breaks if a figure gets two links."""
    own = nodes.raw("", "<p>the numbers behind the figure as own.csv</p>", format="html")
    page = nodes.section("", cell(figure("fig-a")), cell(own))
    below_the_figure(None, page, "page")
    assert [raw.astext() for raw in page.findall(nodes.raw)] == [own.astext()]
