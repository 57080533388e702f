#!/usr/bin/env python3
"""site.py [--taut PROGRAM] [OUT] -- writes the pages of docs/ as a site that works from the disk, without a network (OUT,
default out/site): mkdocs with its plain theme, a gallery, the C library name by name, a search of its own, the studio
where the program has it. Fails where a link of the result leads nowhere.

What it does: copies README.md and docs/ to build/site, turns links between files of the repository into links between
pages (what is no page of the site becomes text), runs mkdocs, writes the index that the search looks in, checks all links.
"""
import argparse
import html.parser
import json
import os
import re
import shutil
import subprocess
import sys

ROOT = os.path.abspath(os.path.join(os.path.dirname(__file__), ".."))
STAGE = os.path.join(ROOT, "build", "site")
TEXT_LINK = re.compile(r"(?<!!)\[([^\[\]]*)\]\(([^) ]+)\)")  # [words](goal)
GOAL = re.compile(r"\]\(([^) ]+)")  # also of a picture, and of a picture that is a link
COPIED = (".md", ".svg", ".png", ".json", ".bib", ".step", ".cff")

# Groups of the navigation: title, pages; the rest of docs/ comes under "More".
NAVIGATION = [
    ("Start", ["index.md", "tutorial/README.md", "tutorial/1-tent.md", "tutorial/2-film.md", "tutorial/3-roof.md",
               "tutorial/4-pipes.md", "tutorial/5-certificate.md", "tutorial/6-gridshell.md", "tutorial/7-sail.md", "gallery/README.md", "search.md"]),
    ("Constructions", ["dirichlet.md", "plateau.md", "film.md", "harmonic.md", "biharmonic.md", "asymptotic.md",
                       "bonnet.md", "pipe.md", "trace.md", "pattern.md"]),
    ("Reference", ["commands.md", "format.md", "formats.md", "errors.md", "limits.md", "figures.md", "view.md",
                   "studio.md", "reference/README.md"]),
    ("Trust", ["certificate.md", "least.md", "reproduction.md", "trust.md", "performance.md", "architecture.md",
               "compatibility.md"]),
]


def site_path(path):
    """Where a file of the repository is in the site, None where it is not; both relative to their roots."""
    if path == "README.md":
        return "index.md"
    if path in ("CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "CITATION.cff"):
        return path.lower() if path.endswith(".md") else path
    if path.startswith("docs/"):
        return path[len("docs/"):]
    if path.startswith("build/reference/"):
        return path[len("build/"):]
    header = re.match(r"include/taut/(\w+)\.h$", path)
    return "reference/%s.md" % header.group(1) if header and header.group(1) != "taut" else None


def sources():
    """Files of the repository that are in the site."""
    found = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md", "LICENSE", "CITATION.cff"]
    for top in ("docs", "build/reference"):
        for folder, _, names in os.walk(os.path.join(ROOT, top)):
            relative = os.path.relpath(folder, ROOT)
            found += [os.path.join(relative, name) for name in names if name.endswith(COPIED)]
    return [path for path in found if os.path.exists(os.path.join(ROOT, path))]


def anchor(heading):
    """The place of a heading, as tools/check_docs.sh has it."""
    words = re.sub(r"<[^>]*>", "", heading).lower()
    return re.sub(r"[^a-z0-9_ -]", "", words).replace(" ", "-")


def translate(text, path, known):
    """A page of the repository as a page of the site."""
    here = os.path.dirname(site_path(path))

    def goal_of(target):
        """The same goal in the site; None where it is not there."""
        address, mark, place = target.partition("#")
        if re.match(r"(https?|mailto):", target) or not address:
            return target
        goal = os.path.normpath(os.path.join(os.path.dirname(path), address))
        goal = known.get(goal) or known.get(goal + "/README.md") or site_path(goal)
        return os.path.relpath(goal, here or ".") + mark + place if goal in known.values() else None

    out = []
    fenced = False
    before = ""
    for line in text.split("\n"):
        fenced ^= line.startswith("```")
        if not fenced and not line.startswith("    "):
            line = TEXT_LINK.sub(lambda m: m.group(0) if goal_of(m.group(2)) else m.group(1), line)
            line = GOAL.sub(lambda m: "](" + (goal_of(m.group(1)) or m.group(1)), line)
            heading = re.match(r"(#+) +(.*?) *$", line)
            if heading:
                line = "%s %s {: #%s }" % (heading.group(1), heading.group(2), anchor(heading.group(2)))
            begins = re.match(r"([-*]|\d+\.) ", line)
            if begins and before.strip() and not re.match(r" *([-*]|\d+\.) |  ", before):
                out.append("")  # a list begins after an empty line
        out.append(line)
        before = line
    return "\n".join(out)


def title_of(text, path):
    heading = re.search(r"^# +(.*?)(?: *\{:.*)?$", text, flags=re.M)
    return re.sub(r"[`*]", "", heading.group(1)) if heading else os.path.basename(path)


def stage(studio):
    shutil.rmtree(STAGE, ignore_errors=True)
    known = {path: site_path(path) for path in sources()}
    pages = {}
    for path, goal in known.items():
        target = os.path.join(STAGE, "docs", goal)
        os.makedirs(os.path.dirname(target), exist_ok=True)
        if path.endswith(".md"):
            with open(os.path.join(ROOT, path), encoding="utf-8") as file:
                text = translate(file.read(), path, known)
            pages[goal] = title_of(text, goal)
            with open(target, "w", encoding="utf-8") as file:
                file.write(text)
        else:
            shutil.copyfile(os.path.join(ROOT, path), target)
    for name in ("search.js", "site.css"):
        shutil.copyfile(os.path.join(ROOT, "tools", "site", name), os.path.join(STAGE, "docs", name))
    pages["search.md"] = "Search"
    with open(os.path.join(STAGE, "docs", "search.md"), "w", encoding="utf-8") as file:
        file.write('# Search\n\nA word of an error, a name of the library, or what you look for. All is searched in this page; nothing is '
                   'sent.\n\n<input id="words" type="search" aria-label="Words to search for" placeholder="cable force">\n'
                   '<p id="count"></p>\n<ul id="found"></ul>\n<script src="search-index.js"></script>\n'
                   '<script src="search.js"></script>\n')
    if studio:
        shutil.copyfile(studio, os.path.join(STAGE, "docs", "studio-page.html"))
        page = os.path.join(STAGE, "docs", "studio.md")
        with open(page, encoding="utf-8") as file:
            head, rest = file.read().split("\n", 1)
        with open(page, "w", encoding="utf-8") as file:
            file.write(head + "\n\n**[Open the studio](studio-page.html)**\n" + rest)
    return pages


def navigation(pages):
    listed = set()
    rows = []
    for title, names in NAVIGATION:
        rows.append((title, [name for name in names if name in pages]))
        listed.update(names)
    rows.append(("More", sorted(name for name in pages if name not in listed and "/" not in name)))
    for folder in ("papers", "plugins", "decisions", "reference", "bench", "tutorial", "gallery"):
        rest = sorted(name for name in pages if name.startswith(folder + "/") and name not in listed)
        if rest:
            rows[-1][1].extend(rest if folder in ("papers", "plugins") else [])
    return rows


def configure(pages, out):
    lines = ["site_name: Taut", "docs_dir: docs", "site_dir: " + json.dumps(out), "use_directory_urls: false", "plugins: []",
             "theme:", "  name: mkdocs", "  highlightjs: false", "  nav_style: light", "extra_css: [site.css]",
             "markdown_extensions: [attr_list, tables, fenced_code, md_in_html, toc]", "nav:"]
    for title, names in navigation(pages):
        lines.append("  - %s:" % title)
        lines += ["      - %s: %s" % (json.dumps(pages[name]), name) for name in names]
    path = os.path.join(STAGE, "mkdocs.yml")
    with open(path, "w", encoding="utf-8") as file:
        file.write("\n".join(lines) + "\n")
    return path


class Page(html.parser.HTMLParser):
    """Links, places and words of a page."""

    def __init__(self):
        super().__init__()
        self.links, self.places, self.words, self.main, self.skip = [], set(), [], 0, 0

    def handle_starttag(self, tag, attributes):
        given = dict(attributes)
        self.places.update(value for key, value in attributes if key in ("id", "name") and value)
        for key in ("href", "src"):
            if given.get(key):
                self.links.append((tag, given[key]))
        if given.get("role") == "main":
            self.main = 1
        self.skip += tag in ("script", "style")

    def handle_endtag(self, tag):
        self.skip -= tag in ("script", "style")
        if tag == "body":
            self.main = 0

    def handle_data(self, data):
        if self.main and not self.skip:
            self.words.append(data)


def read_pages(out):
    found = {}
    for folder, _, names in os.walk(out):
        for name in names:
            if name.endswith(".html") and name not in ("404.html", "studio-page.html"):
                page = Page()
                with open(os.path.join(folder, name), encoding="utf-8") as file:
                    page.feed(file.read())
                found[os.path.relpath(os.path.join(folder, name), out)] = page
    return found


def lost_links(out, found):
    wrong = []
    for path, page in sorted(found.items()):
        for tag, link in page.links:
            address, _, place = link.partition("#")
            if re.match(r"(https?|mailto|data):", link):
                if tag != "a":
                    wrong.append("%s: fetches %s" % (path, link))
                continue
            goal = os.path.normpath(os.path.join(os.path.dirname(path), address)) if address else path
            if not os.path.exists(os.path.join(out, goal)):
                wrong.append("%s: leads to %s, which is not there" % (path, link))
            elif place and goal in found and place not in found[goal].places:
                wrong.append("%s: leads to %s, where there is no such place" % (path, link))
    return wrong


def write_index(out, found, pages):
    """What the search looks in: a script, because a page from the disk may fetch no file."""
    rows = []
    for path, page in sorted(found.items()):
        if path == "search.html":
            continue
        name = os.path.splitext(path)[0] + ".md"
        name = name if name in pages else name.replace("index.md", "README.md")
        rows.append([path, pages.get(name, path), re.sub(r"\s+", " ", " ".join(page.words)).strip()])
    with open(os.path.join(out, "search-index.js"), "w", encoding="utf-8") as file:
        file.write("const pages = " + json.dumps(rows, ensure_ascii=False) + ";\n")


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--taut", help="the program, for the studio page")
    parser.add_argument("out", nargs="?", default=os.path.join(ROOT, "out", "site"))
    given = parser.parse_args()
    out = os.path.abspath(given.out)
    subprocess.run([os.path.join(ROOT, "tools", "reference.sh")], check=True)
    studio = None
    if given.taut:
        os.makedirs(os.path.join(ROOT, "build"), exist_ok=True)
        studio = os.path.join(ROOT, "build", "site-studio.html")
        if subprocess.run([given.taut, "studio", "-o", studio], stderr=subprocess.DEVNULL, check=False).returncode != 0:
            studio = None
    pages = stage(studio)
    shutil.rmtree(out, ignore_errors=True)
    done = subprocess.run(["mkdocs", "build", "--quiet", "--strict", "--config-file", configure(pages, out)], check=False)
    if done.returncode != 0:
        return 1
    found = read_pages(out)
    write_index(out, found, pages)
    wrong = lost_links(out, found)
    for line in wrong:
        print(line)
    if not wrong:
        print("%d pages in %s%s" % (len(found), os.path.relpath(out), ", with the studio" if studio else "; without the studio: make studio first"))
    return 1 if wrong else 0


if __name__ == "__main__":
    sys.exit(main())
