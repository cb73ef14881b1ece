"""A function in GLSL as a specimen: run by OpenGL without a window, a pixel a pair of directions, in float32."""

from __future__ import annotations

import re
import sys
from collections.abc import Callable, Mapping
from functools import cache
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from motes.certification.function_specimen import divided
from motes.certification.signature import SHAPES, Signature, declared, functions, numbers_for, without_comments
from motes.certification.specimen import Drawn, Floats, Numbers, Specimen, digest_of
from motes.errors import DataError, FormatError, MissingExtraError, MotesError

_VERSION = re.compile(r"^\s*#\s*version\s+([^\n]+)\n", re.MULTILINE)
NEWEST = "430"


@cache
def open_gl() -> Any:
    """An OpenGL context without a window, one for the process.

    Raises
    ------
    MissingExtraError
        Without moderngl.
    MotesError
        Where there is no OpenGL 4.3.
    """
    try:
        import moderngl
    except ImportError:
        raise MissingExtraError("moderngl", "glsl", "running GLSL") from None
    backend: dict[str, Any] = {"backend": "egl"} if sys.platform == "linux" else {}
    try:
        return moderngl.create_standalone_context(require=430, **backend)
    except Exception as error:  # each backend has its own
        raise MotesError(
            f"there is no OpenGL 4.3 without a window here: {error}",
            "On Debian apt-get install libegl1 libgl1-mesa-dri helps",
        ) from error


def pixels(
    context: Any, source: str, version: str, result: str, uniforms: Mapping[str, Any], a: Numbers, b: Numbers
) -> NDArray[np.float32]:
    """What a shader answers for pairs of vectors.

    Parameters
    ----------
    context
        From `open_gl`.
    source
        Functions and uniforms, without ``#version`` and ``main``.
    version
        ``"300 es"``, ``"450"``.
    result
        A statement that gives ``vec4 pixel`` its value from ``motes_a`` and ``motes_b``, vec3.
    uniforms
        Values by name; those that the shader does not use are passed over.
    a, b
        Vectors (N, 2) or (N, 3).

    Returns
    -------
    array (N, 4)
    """
    side = max(1, int(np.ceil(np.sqrt(len(a)))))
    head = f"#version {version}\n" + ("precision highp float;\nprecision highp sampler2D;\n" if "es" in version else "")
    main = f"""
        uniform sampler2D motes_first;
        uniform sampler2D motes_second;
        out vec4 pixel;
        void main() {{
            ivec2 at = ivec2(gl_FragCoord.xy);
            vec3 motes_a = texelFetch(motes_first, at, 0).xyz, motes_b = texelFetch(motes_second, at, 0).xyz;
            {result}
        }}"""
    vertex = f"{head}in vec2 corner; void main() {{ gl_Position = vec4(corner, 0.0, 1.0); }}"
    with context:  # current, whatever else draws in this process
        return _drawn(context, vertex, head + source + main, uniforms, a, b, side)


def _drawn(
    context: Any, vertex: str, fragment: str, uniforms: Mapping[str, Any], a: Numbers, b: Numbers, side: int
) -> NDArray[np.float32]:
    """Two lists of vectors as textures, one picture of answers."""
    program = context.program(vertex_shader=vertex, fragment_shader=fragment)
    for name, value in uniforms.items():
        if name in program:
            program[name] = value
    textures = []
    for unit, (name, w) in enumerate((("motes_first", a), ("motes_second", b))):
        padded = np.zeros((side * side, 4), "f4")
        padded[: len(w), : w.shape[1]] = w
        texture = context.texture((side, side), 4, padded.tobytes(), dtype="f4")
        texture.use(unit)
        if name in program:
            program[name] = unit
        textures.append(texture)
    corners = context.buffer(np.array([-1, -1, 3, -1, -1, 3], "f4"))
    array = context.vertex_array(program, [(corners, "2f", "corner")])
    canvas = context.texture((side, side), 4, dtype="f4")
    target = context.framebuffer([canvas])
    target.use()
    array.render(context.TRIANGLES)
    picture = np.frombuffer(target.read(components=4, dtype="f4"), "f4").reshape(-1, 4)[: len(a)].copy()
    for resource in (program, *textures, corners, array, target, canvas):
        resource.release()
    return picture


def of_glsl(path: Path, source: str, function: str, parameters: Mapping[str, Any], cosine: bool) -> Specimen:
    """A function out of a file of GLSL; ``vec3 FUNCTION_sample(vec3 wi, vec2 u)`` and ``float FUNCTION_pdf(vec3 wi, vec3 wo)`` are run, too.

    Raises
    ------
    FormatError
        When there is no such function, its declaration is not understood, or it does not compile.
    MotesError
        Where it cannot be run.
    """
    stated = _VERSION.search(source)
    version, body = (stated[1].strip(), _VERSION.sub("", source)) if stated else (NEWEST, source)
    if re.search(r"\bvoid\s+main\s*\(", without_comments(source)):
        raise FormatError(f"{path} has a main of its own", "Give the functions and uniforms alone")
    found = {part: declared(source, function + part) for part in ("", "_sample", "_pdf")}
    main = found[""]
    if main is None:
        raise FormatError(
            f"{path} defines no function {function!r}", f"It has {', '.join(functions(source)) or 'none'}"
        )
    used = {a.name for s in found.values() if s is not None for a in s.arguments[2:]}
    uniforms = {name: _value(value) for name, value in parameters.items() if name not in used}
    absent = [
        name for name in uniforms if not re.search(rf"\buniform\b[^;]*\b{re.escape(name)}\b", without_comments(source))
    ]
    if absent:
        raise DataError(f"{function} has neither an argument nor a uniform {absent[0]}", "Leave it out")
    context = open_gl()

    def run(signature: Signature, kinds: tuple[str, str]) -> Callable[[Floats, Floats], Floats]:
        statement, count = _statement(signature, kinds, parameters)

        def answer(a: Floats, b: Floats) -> Floats:
            try:
                values = pixels(
                    context, body, version, statement, uniforms, np.broadcast_to(a, (len(b), a.shape[-1])), b
                )
            except Exception as error:  # moderngl's own, with the compiler's words
                lines = [line.strip() for line in str(error).splitlines() if re.search(r"error|:\d", line)]
                raise FormatError(
                    f"{path} does not compile: {(lines or [str(error).strip()])[0][:300]}",
                    "Try it in its own program first",
                ) from error
            return values[:, :count].astype(np.float64)

        return answer

    evaluate = run(main, ("vec3", "vec3"))
    sampler = None if found["_sample"] is None else run(found["_sample"], ("vec3", "vec2"))
    density = None if found["_pdf"] is None else run(found["_pdf"], ("vec3", "vec3"))

    def value(wi: Floats, wo: Floats) -> Floats:
        return divided(evaluate(wi, wo), wo) if cosine else evaluate(wi, wo)

    return Specimen(
        name=function,
        kind="function in GLSL",
        eval=value,
        digest=digest_of(source, repr(sorted(parameters.items()))),
        sample=None if sampler is None else lambda wi, u: Drawn(sampler(wi, u), np.full(len(u), np.nan), None),
        pdf=None if density is None else lambda wi, wo: density(wi, wo)[:, 0],
        single=True,
        strict=False,
        facts={
            "called as": f"{function}({', '.join(a.name for a in main.arguments)})",
            "version": version,
            "answers": "f times the cosine of wo, divided here" if cosine else "f in 1/sr, without a cosine",
            **{name: str(given) for name, given in parameters.items()},
        },
        versions={"OpenGL": f"{context.info['GL_VERSION']}, {context.info['GL_RENDERER']}"},
    )


def _value(value: Any) -> Any:
    return tuple(float(v) for v in value) if isinstance(value, (list, tuple)) else float(value)


def _statement(signature: Signature, kinds: tuple[str, str], parameters: Mapping[str, Any]) -> tuple[str, int]:
    """What calls it, and how many numbers come of it."""
    first = tuple(a.kind for a in signature.arguments[:2])
    counts = {"float": 1, "vec2": 2, "vec3": 3}
    if first != kinds or signature.returns not in counts:
        raise FormatError(
            f"the declaration of {signature.name} is not one of those that are known", f"Known are {SHAPES}"
        )
    further = signature.arguments[2:]
    numbers = [_value(v) for v in numbers_for(signature, further, parameters)]
    written = [
        f"{a.kind}({', '.join(map(repr, v if isinstance(v, tuple) else (v,)))})"
        for a, v in zip(further, numbers, strict=True)
    ]
    passed = ", ".join(["motes_a", "motes_b.xy" if kinds[1] == "vec2" else "motes_b", *written])
    count = counts[signature.returns]
    zeros = "".join(", 0.0" for _ in range(4 - count))
    return f"pixel = vec4({signature.name}({passed}){zeros});", count
