"""One self-contained page: sections, figures with captions, tables. Every text that comes in is escaped here."""
import base64
import html
import re
import urllib.parse

STYLE = """
:root { --ink: #222; --soft: #5c5c5c; --line: #d8d5ce; --paper: #fff; --accent: #0072b2; }
* { box-sizing: border-box; }
body { margin: 0 auto; padding: 2rem 1.5rem 4rem; max-width: 1100px; background: var(--paper); color: var(--ink);
       font: 16px/1.5 "Source Sans 3", "Helvetica Neue", Arial, sans-serif; }
header { border-bottom: 3px solid var(--ink); padding-bottom: .8rem; }
h1 { font-size: 1.9rem; line-height: 1.2; margin: 0 0 .3rem; overflow-wrap: anywhere; }
h2 { font-size: 1.3rem; margin: 2.6rem 0 .6rem; padding-top: .5rem; border-top: 1px solid var(--line); }
h3 { font-size: 1.05rem; margin: 1.6rem 0 .4rem; }
p { max-width: 46rem; margin: .5rem 0; overflow-wrap: anywhere; }
.outcome { display: inline-block; padding: .1rem .7rem; border-radius: 1rem; font-weight: 600; color: #fff; background: #5c5c5c; }
.outcome.good { background: #00734f; } .outcome.warn { background: #a85b00; } .outcome.bad { background: #a3200f; }
dl { display: grid; grid-template-columns: repeat(auto-fill, minmax(15rem, 1fr)); gap: .8rem 1.6rem; margin: 1.2rem 0; }
dl div { border-left: 3px solid var(--line); padding-left: .7rem; }
dt { color: var(--soft); font-size: .9rem; } dd { margin: 0; font-size: 1.2rem; font-weight: 600; overflow-wrap: anywhere; }
dd small { display: block; font-weight: 400; font-size: .85rem; color: var(--soft); }
figure { margin: 1rem 0 1.8rem; } figure img { max-width: 100%; height: auto; display: block; margin: 0 auto; }
figcaption { color: var(--soft); font-size: .95rem; max-width: 52rem; margin-top: .5rem; overflow-wrap: anywhere; }
.table { overflow-x: auto; margin: .6rem 0 1.2rem; }
table { border-collapse: collapse; font-size: .88rem; font-variant-numeric: tabular-nums; }
th, td { padding: .22rem .7rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap; }
th { vertical-align: bottom; font-weight: 600; white-space: normal; border-bottom: 2px solid var(--ink); }
/* Words break between words: "anywhere" would let a narrow table shrink them to a letter a line. A wide table scrolls. */
th.words, td.words { text-align: left; white-space: normal; overflow-wrap: break-word; min-width: 6rem; }
th.long, td.long { min-width: 14rem; }
nav ul { display: flex; flex-wrap: wrap; gap: .3rem 1.2rem; list-style: none; margin: 1rem 0; padding: 0; font-size: .95rem; }
nav a { color: var(--accent); }
.controls { display: flex; flex-wrap: wrap; gap: .4rem 1.1rem; align-items: center; font-size: .9rem; }
.controls button { font: inherit; padding: .1rem .7rem; min-width: 2.6rem; } .said { margin: .2rem 0; font-size: .9rem; min-height: 1.3em; }
#motion .frame { margin: .5rem 0; } #motion canvas { display: block; margin: 0 auto; max-width: 100%; } #motion [name=frame] { width: min(20rem, 60vw); }
#view-in-space .frame { border: 1px solid var(--line); margin: .5rem 0; touch-action: none; }
#view-in-space canvas { display: block; width: 100%; }
#view-in-space select { max-width: 12rem; }
.remarks { background: #fdf3d8; border-left: 4px solid #e69f00; padding: .6rem 1rem; margin: 1rem 0; }
.remarks ul { margin: .3rem 0; padding-left: 1.2rem; }
footer { margin-top: 3rem; border-top: 1px solid var(--line); color: var(--soft); font-size: .85rem; }
@media print { #view-in-space, .controls, nav { display: none; } @page { size: A4; margin: 15mm; } body { max-width: none; padding: 0; font-size: 10.5pt; }
  figure, tr, dl div, .remarks { break-inside: avoid; } h2, h3 { break-after: avoid; } .table { overflow: visible; }
  table { font-size: 7.5pt; } th, td { padding: .1rem .3rem; } * { print-color-adjust: exact; -webkit-print-color-adjust: exact; } }
"""


NARROW_SCREEN = 640  # [px] up to which pictures are those drawn for it
LONG = 20  # letters; what is longer gets a column of 14 rem, so that it takes two or three lines and not one a word


def escape(value):
    return html.escape(str(value), quote=True)


class Page:
    def __init__(self, title):
        self.title = title
        self.parts = []
        self.sections = []       # rows (anchor, title)
        self.contents_at = None  # number of the part that is to hold their list

    def head(self, outcome, kind):
        """Title and outcome; kind is good, warn, bad or empty and only chooses the colour."""
        self.parts.append(f'<header><h1>{escape(self.title)}</h1>'
                          f'<span class="outcome {escape(kind)}">{escape(outcome)}</span></header>')

    def remarks(self, remarks):
        if remarks:
            items = "".join(f"<li>{escape(remark)}</li>" for remark in remarks)
            self.parts.append(f'<div class="remarks">What this report lacks:<ul>{items}</ul></div>')

    def warnings(self, warnings):
        """warnings: rows (kind, where, when, text) of what the result leaves open, in a box of their own."""
        if not warnings:
            return
        items = "".join(f"<li>{escape(where)}{escape(', ' + when if when else '')}: {escape(text)}. <small>{escape(kind)}</small></li>"
                        for kind, where, when, text in warnings)
        self.parts.append(f'<div class="remarks">What this result leaves open:<ul>{items}</ul></div>')

    def figures_asked_first(self, facts):
        """facts: rows (name, value, further words)."""
        cells = "".join(f"<div><dt>{escape(name)}</dt><dd>{escape(value)}"
                        + (f"<small>{escape(more)}</small>" if more else "") + "</dd></div>" for name, value, more in facts)
        self.parts.append(f"<dl>{cells}</dl>")

    def section(self, title):
        """Begins a section, which the list of contents leads to."""
        name = re.sub(r"[^a-z0-9]+", "-", title.lower()).strip("-") or "section"
        while name in (known for known, _ in self.sections):
            name += "-"
        self.sections.append((name, title))
        self.parts.append(f'<h2 id="{name}">{escape(title)}</h2>')

    def contents(self):
        """Where the list of all sections stands."""
        self.contents_at = len(self.parts)
        self.parts.append("")

    def part(self, title):
        self.parts.append(f"<h3>{escape(title)}</h3>")

    def words(self, words):
        self.parts.append(f"<p>{escape(words)}</p>")

    def picture(self, path, caption):
        """A PNG as data URI, and the one that was drawn for a narrow screen. Drawn at 160 dots per inch, shown at 110 pixels."""
        content = path.read_bytes()
        width = round(int.from_bytes(content[16:20], "big") * 110 / 160)
        uri = lambda content: f"data:image/png;base64,{base64.b64encode(content).decode('ascii')}"
        narrow = path.with_name(f"{path.stem}-narrow.png")
        source = f'<source media="(max-width: {NARROW_SCREEN}px)" srcset="{uri(narrow.read_bytes())}">' if narrow.exists() else ""
        self.parts.append(f'<figure><picture>{source}<img width="{width}" alt="{escape(caption)}" src="{uri(content)}"></picture>'
                          f"<figcaption>{escape(caption)}</figcaption></figure>")

    def drawing(self, path, caption):
        """An SVG as data URI, as wide as the page lets it be, and the one that was drawn for a narrow screen."""
        uri = lambda file: f"data:image/svg+xml;base64,{base64.b64encode(file.read_bytes()).decode('ascii')}"
        narrow = path.with_name(f"{path.stem}-narrow.svg")
        source = f'<source media="(max-width: {NARROW_SCREEN}px)" srcset="{uri(narrow)}">' if narrow.exists() else ""
        self.parts.append(f'<figure><picture>{source}<img alt="{escape(caption)}" src="{uri(path)}"></picture>'
                          f"<figcaption>{escape(caption)}</figcaption></figure>")

    def motion(self, data, script, frames, caption):
        """A motion to be played, stopped and stepped through: data as JSON, the script that draws it."""
        self.parts.append(
            '<figure id="motion"><div class="controls"><button type="button" name="back" aria-label="one step back">◀</button>'
            '<button type="button" name="play">Play</button><button type="button" name="on" aria-label="one step on">▶</button>'
            f'<label>Step <input type="range" name="frame" min="0" max="{frames - 1}" value="{frames - 1}"></label>'
            '<label>Magnified <input type="range" name="scale" min="0" max="100" value="50"></label></div>'
            f'<div class="frame"><canvas role="img" aria-label="{escape(caption)}"></canvas></div>'
            f'<p class="said"><output aria-live="polite"></output></p><figcaption>{escape(caption)}</figcaption></figure>')
        self.add_script("motion-data", data, [script])

    def add_script(self, name, data, scripts):
        """Numbers as JSON under a name, then the scripts that read them."""
        body = data.replace("<", "\\u003c")  # names in it must not end the element
        self.parts.append(f'<script type="application/json" id="{name}">{body}</script>')
        for script in scripts:
            if "</script" in script.lower():
                raise ValueError("a script that would end its own element")
            self.parts.append(f"<script>{script}</script>")

    def view_in_space(self, data, scripts, stages, ways, caption):
        """A structure to be turned: data as JSON, scripts that draw it, what the reader chooses from."""
        options = lambda words: "".join(f'<option value="{k}">{escape(word)}</option>' for k, word in enumerate(words))
        boxes = "".join(f'<label><input type="checkbox" name="{name}"{" checked" if on else ""}> {words}</label>' for name, words, on in (
            ("points", "points that open or slip", True), ("closed", "and those that stick", False), ("forces", "resultants", False),
            ("through", "see through", False), ("built", "as built", False)))
        self.parts.append(
            '<figure id="view-in-space"><div class="controls">'
            f'<label>Stage <select name="stage">{options(stages)}</select></label>'
            f'<label>Colours <select name="set">{options(ways)}</select></label>'
            '<label>Magnified <input type="range" name="scale" min="0" max="100" value="60"></label>'
            f'{boxes}<button type="button" name="play">Move</button><button type="button" name="home">From the front</button></div>'
            '<div class="frame"></div><p class="said"><output name="stage-words"></output>; <output name="scale-words"></output></p>'
            f'<p class="said stone" aria-live="polite"></p><figcaption>{escape(caption)}</figcaption></figure>')
        self.add_script("view-in-space-data", data, scripts)

    def table(self, columns, rows, words=(), links=None):
        """columns: headings; words: numbers of the columns that hold text and are set flush left; links: of every row the
        page its first cell leads to, or None."""
        long = [k for k in words if any(len(str(row[k])) > LONG for row in rows)]

        def cell(tag, k, value):
            if k not in words:
                return f"<{tag}>{escape(value)}</{tag}>"
            kind = '"words long"' if k in long else "words"
            return f"<{tag} class={kind}>{escape(value).replace('_', '_<wbr>')}</{tag}>"  # names without blanks break too

        head = "".join(cell("th", k, name) for k, name in enumerate(columns))
        cells = [[cell("td", k, value) for k, value in enumerate(row)] for row in rows]
        for row, link in zip(cells, links or ()):
            if link:
                row[0] = row[0].replace(">", f'><a href="{escape(urllib.parse.quote(link, safe="/=+,"))}">', 1).replace("</td>", "</a></td>")
        body = "".join("<tr>" + "".join(row) + "</tr>" for row in cells)
        self.parts.append(f'<div class="table"><table><thead><tr>{head}</tr></thead><tbody>{body}</tbody></table></div>')

    def write(self, path):
        if self.contents_at is not None and len(self.sections) > 1:
            items = "".join(f'<li><a href="#{name}">{escape(title)}</a></li>' for name, title in self.sections)
            self.parts[self.contents_at] = f'<nav aria-label="Contents"><ul>{items}</ul></nav>'
        body = "\n".join(self.parts)
        path.write_text(f'<!DOCTYPE html>\n<html lang="en"><head><meta charset="utf-8">'
                        f'<meta name="viewport" content="width=device-width, initial-scale=1"><title>{escape(self.title)}</title>'
                        f"<style>{STYLE}</style></head>\n<body>\n{body}\n<footer><p>Voussoir. SI units; gap and opening &gt; 0 open, "
                        "joint force &gt; 0 compression.</p></footer>\n</body></html>\n", encoding="utf-8")
