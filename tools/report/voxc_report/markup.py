"""HTML as text: elements, and the templates of the folder page."""
import re
from pathlib import Path

PAGE = Path(__file__).parent / "page"
RESERVED = str.maketrans({"&": "&amp;", "<": "&lt;", ">": "&gt;", '"': "&quot;"})
PLACE = re.compile(r"\{\{(.*?)\}\}", re.DOTALL)


def escaped(text):
    return text.translate(RESERVED)


def tag(name, attributes, content):
    """<name attributes>content</name>, closed even if it is empty, as HTML wants it. The content is not escaped."""
    words = "".join(f' {key}="{escaped(str(value))}"' for key, value in attributes.items())
    return f"<{name}{words}>{content}</{name}>"


def text_tag(name, attributes, text):
    """The same around text, which is escaped."""
    return tag(name, attributes, escaped(text))


def read_page(path):
    return (PAGE / path).read_text(encoding="utf-8")


def fill(path, **values):
    """A template with every {{name}} replaced by its value, which is not looked into again."""
    return PLACE.sub(lambda place: values.get(place[1], ""), read_page(path))


def table_row(cells, **attributes):
    return tag("tr", attributes, "".join(cells)) + "\n"
