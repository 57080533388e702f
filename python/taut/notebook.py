"""What a notebook shows: a model as the page of `taut view` and a picture, a certificate as a table."""
from __future__ import annotations

import base64
import html
from typing import TYPE_CHECKING, Any, Container

from .errors import Error

if TYPE_CHECKING:
    from .model import Certificate, Model

_WORDS = {True: "holds", False: "<b>does not hold</b>", None: "undecided"}


def certificate_table(certificate: Certificate) -> str:
    """The claims as an HTML table."""
    rows = "".join(f"<tr><td>{html.escape(one.claim)}</td><td>{_WORDS[one.holds]}</td><td>{one.kind}</td><td>{one.residual:.2g}</td>"
                   f"<td>{one.limit:.2g}</td><td>{html.escape(one.where)}</td></tr>" for one in certificate.claims)
    return ("<table><thead><tr><th>claim</th><th></th><th>kind</th><th>residual</th><th>limit</th><th>where</th></tr></thead>"
            f"<tbody>{rows}</tbody></table>")


def _picture(model: Model) -> list[tuple[str, bytes]]:
    """A picture with its kind: PNG, or SVG where cairo is missing; none of a library that does not draw."""
    for kind, mime in (("png", "image/png"), ("svg", "image/svg+xml")):
        try:
            return [(mime, model.to_text(kind))]
        except Error:
            continue
    return []


def model_bundle(model: Model, include: Container[str] | None, exclude: Container[str] | None) -> dict[str, Any]:
    """By kind: what a front end takes the richest of that it can show. include and exclude are IPython's, kinds that are asked for."""
    def is_asked(mime: str) -> bool:
        return (not include or mime in include) and not (exclude and mime in exclude)
    bundle: dict[str, Any] = {"text/plain": repr(model)} if is_asked("text/plain") else {}
    if is_asked("text/html"):
        bundle["text/html"] = model_page(model)
    if is_asked("image/png") or is_asked("image/svg+xml"):
        for mime, picture in _picture(model):
            if is_asked(mime):
                bundle[mime] = base64.b64encode(picture).decode() if mime == "image/png" else picture.decode("utf-8", "replace")
    return bundle


def model_page(model: Model) -> str:
    """The page in an iframe, whose picture stands there where scripts are off; below it the certificate."""
    parts = []
    try:
        page = model.to_text("html").decode("utf-8", "replace")
        parts.append(f'<iframe srcdoc="{html.escape(page)}" width="100%" height="480" style="border:0" title="surface"></iframe>')
    except Error:
        pass  # a library without pages
    for mime, picture in _picture(model):
        image = f'<img alt="surface" style="max-width:100%" src="data:{mime};base64,{base64.b64encode(picture).decode()}">'
        parts.append(f"<noscript>{image}</noscript>" if parts else image)
    if model.certificate is not None:
        parts.append(certificate_table(model.certificate))
    return "\n".join(parts)
