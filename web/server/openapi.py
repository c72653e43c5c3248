"""OpenAPI 3 description of the requests, generated from the tables that check them."""

from typing import Any

from . import protocol
from .limits import LIMITS

KINDS: dict[str, dict[str, Any]] = {
    "text": {"type": "string", "maxLength": LIMITS.text},
    "values": {"type": "object", "additionalProperties": {"type": "number"}},
    "section": {"type": "object", "nullable": True, "properties": {
        "axis": {"enum": ["x", "y", "z"]}, "at": {"type": "number"}, "keep": {"enum": ["below", "above"]}}},
    "mode": {"enum": list(protocol.MODES)},
    "language": {"enum": [*protocol.FORMULAS, *protocol.SCRIPTS]},
    "window": {"type": "array", "nullable": True, "items": {"type": "number"}, "minItems": 4, "maxItems": 4},
    "points": {"type": "array", "items": {"type": "array", "items": {"type": "number"}}, "maxItems": LIMITS.points},
    "at": {"type": "array", "items": {"type": "number"}, "minItems": 2, "maxItems": 2},
    **{name: {"type": "string"} for name in ("extension", "name")},
    **{name: {"type": "array", "nullable": True, "items": {"type": "number"}, "minItems": 6, "maxItems": 6}
       for name in ("bounds", "near")},
    **{name: {"type": "integer", "minimum": 8, "maximum": LIMITS.side} for name in ("width", "height")},
    **{name: {"type": "boolean"} for name in ("coarse", "smooth", "simulate")},
    "job": {"type": "object",
            "description": "machine, material, setting, zero, stock, tools, operations, as docs/cam.md has them; "
                           "adjust_feeds"},
}


def body_of(do):
    fields = protocol.REQUESTS[do]
    properties = {name: {**KINDS.get(name, {"type": "number"}), **(
        {} if default in (protocol.MUST, None) else {"default": default})} for name, (_, default) in fields.items()}
    required = [name for name, (_, default) in fields.items() if default is protocol.MUST]
    schema = {"type": "object", "properties": properties, "required": required, "additionalProperties": False}
    return {"required": True, "content": {"application/json": {"schema": schema}}}


def said(summary, code="200", kind="application/json"):
    error = {"description": "refused",
             "content": {"application/json": {"schema": {"$ref": "#/components/schemas/Refusal"}}}}
    return {"summary": summary, "responses": {code: {"description": summary, "content": {kind: {}}}, "default": error}}


def in_path(name):
    return {"parameters": [{"name": name, "in": "path", "required": True, "schema": {"type": "string"}}]}


def description():
    posts = {"look": "bounds, parts and size of a model", "values": "values of a model at places",
             "pick": "what a place of a picture shows",
             "parameters": "parameters of a text and their ranges", "words": "names that fit at a place of a text",
             "scan": "size, histogram and thresholds of a scan"}
    paths: dict[str, dict[str, Any]] = {
        f"/api/{do}": {"post": {**said(summary), "requestBody": body_of(do)}} for do, summary in posts.items()}
    paths["/api/picture"] = {"post": {**said("a picture", kind="image/png"), "requestBody": body_of("picture")}}
    paths["/api/files"] = {"post": {**said("a job that writes a file", "202"), "requestBody": body_of("file")}}
    paths["/api/machining"] = {"get": said("the tables of machines, operations and their settings")}
    paths["/api/machine"] = {"post": {**said("a job that plans a program, and simulates it where that is wanted",
                                             "202"), "requestBody": body_of("machine")}}
    paths["/api/jobs/{job}"] = {**in_path("job"), "get": said("state, progress, result or error of a job"),
                                "delete": said("cancels a job")}
    paths["/api/jobs/{job}/files/{name}"] = {"parameters": [*in_path("job")["parameters"],
                                                            *in_path("name")["parameters"]],
                                             "get": said("another file that it made", kind="application/octet-stream")}
    paths["/api/jobs/{job}/file"] = {**in_path("job"),
                                     "get": said("the file that a job wrote", kind="application/octet-stream")}
    paths["/api/documents"] = {"get": said("the documents")}
    paths["/api/documents/{name}"] = {**in_path("name"), "get": said("a document", kind="text/plain"),
                                      "put": said("writes a document; If-Match: its version, * or none"),
                                      "delete": said("removes a document; If-Match: its version, * or none")}
    paths["/api/scans/{name}"] = {**in_path("name"), "put": said("writes a scan", "201"),
                                  "delete": said("removes a scan")}
    paths["/api/examples"] = {"get": said("names of the examples")}
    paths["/api/examples/{name}"] = {**in_path("name"), "get": said("an example", kind="text/plain")}
    paths["/api/library"] = {"get": said("the functions of the shape library")}
    refusal = {"type": "object", "properties": {"error": {"type": "object", "properties": {
        "kind": {"type": "string"}, "message": {"type": "string"}, "mistakes": {"type": "array"}}}}}
    return {"openapi": "3.0.3", "info": {"title": "fabserver", "version": "1"}, "paths": paths,
            "components": {"schemas": {"Refusal": refusal}}}
