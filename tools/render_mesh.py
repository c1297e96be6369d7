#!/usr/bin/env python3
# Copyright (c) 2026 The Shape_interrogation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a mesh with a curvature property as a PNG picture. Needs nothing but Python.

  render_mesh.py MESH.ply PICTURE.png [--property NAME] [--bound X] [--size WIDTHxHEIGHT]
                 [--view AZIMUTH,ELEVATION] [--add FILE.ply:COLOUR[:glass]]...
                 [--point X,Y,Z:COLOUR]...

MESH.ply is a file that write_ply() or the program interrogate has written, in either encoding, with
normals (nx, ny, nz). The property (default gaussian_curvature) is shown from blue (-X and less)
through white (0) to red (X and more); without --bound, X is the magnitude that nine tenths of the
vertices stay below. The azimuth and the elevation of the viewer are in degrees; z points upward. A
vertex on an edge between patches has the value of one of them: in triangles of the other it is left
out.

Other files are added in one colour, rrggbb: meshes, which one can see through as glass, and lines that
write_polylines() or the program has written. Points are drawn as dots. Lines and dots are in front
of surfaces that they lie on.
"""
import argparse
import math
import pathlib
import struct
import sys
import zlib

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
         "float": "f", "double": "d"}
LINE, DOT = 1.2, 4.5  # radii in pixels
SAMPLES = 2  # a pixel is the mean of SAMPLES x SAMPLES


def read_header(stream):
    """Returns the encoding and the elements, each as [name, count, properties]."""
    encoding, elements = None, []
    for line in iter(stream.readline, b""):
        words = line.decode("ascii").split()
        if words[0] == "format":
            encoding = words[1]
        elif words[0] == "element":
            elements.append([words[1], int(words[2]), []])
        elif words[0] == "property":
            elements[-1][2].append((words[-1], words[1:-1]))
        elif words[0] == "end_header":
            return encoding, elements
    raise ValueError("the header has no end")


def number_reader(stream, encoding):
    """Returns a function that reads the next number of a given type."""
    if encoding == "ascii":
        words = iter(stream.read().split())
        return lambda kind: float(next(words)) if kind in ("float", "double") else int(next(words))
    if encoding != "binary_little_endian":
        raise ValueError(f"the encoding {encoding} is not known")

    def read(kind):
        layout = "<" + TYPES[kind]
        return struct.unpack(layout, stream.read(struct.calcsize(layout)))[0]
    return read


def read_ply(path):
    """Returns the columns of vertices, faces and edges by name; corners are a column, too."""
    with open(path, "rb") as stream:
        if stream.readline().strip() != b"ply":
            raise ValueError("this is no PLY file")
        encoding, elements = read_header(stream)
        read = number_reader(stream, encoding)
        columns = {"vertex": {}, "face": {}}
        for element, count, properties in elements:
            for _ in range(count):
                for name, kind in properties:
                    if kind[0] == "list":
                        value = [read(kind[2]) for _ in range(read(kind[1]))]
                    else:
                        value = read(kind[0])
                    columns.setdefault(element, {}).setdefault(name, []).append(value)
    return columns["vertex"], columns["face"], columns.get("edge", {})


def frame(azimuth, elevation):
    """Returns the directions to the right, upward and to the viewer."""
    a, e = math.radians(azimuth), math.radians(elevation)
    viewer = (math.cos(e) * math.cos(a), math.cos(e) * math.sin(a), math.sin(e))
    right = (-math.sin(a), math.cos(a), 0.0)
    up = (-math.sin(e) * math.cos(a), -math.sin(e) * math.sin(a), math.cos(e))
    return right, up, viewer


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def color_of(x):
    """Returns the colour of x in [-1, 1]: blue, white, red, each end less bright."""
    ends = ((33, 102, 172), (178, 24, 43))
    t = min(1.0, abs(x))
    end = ends[x > 0]
    return tuple(245 + (end[k] - 245) * t for k in range(3))


def shade(color, normal, to_viewer, light):
    """Returns the colour under a light from the upper left; the normal may point away."""
    if dot(normal, to_viewer) < 0:
        normal = tuple(-x for x in normal)
    diffuse = max(0.0, dot(normal, light))
    half = tuple(l + v for l, v in zip(light, to_viewer))
    gloss = max(0.0, dot(normal, half) / math.sqrt(dot(half, half))) ** 60
    return tuple(min(255.0, c * (0.35 + 0.68 * diffuse) + 70 * gloss) for c in color)


class Canvas:
    """Colours and depths of all samples."""

    def __init__(self, width, height):
        self.width, self.height = width, height
        self.color = [(255.0, 255.0, 255.0)] * (width * height)
        self.depth = [-math.inf] * (width * height)

    def dot(self, x, y, depth, color, radius):
        """Draws a disc that faces the viewer."""
        for j in range(max(0, math.ceil(y - radius)), min(self.height - 1, int(y + radius)) + 1):
            for i in range(max(0, math.ceil(x - radius)), min(self.width - 1, int(x + radius)) + 1):
                place = j * self.width + i
                if (i - x) ** 2 + (j - y) ** 2 <= radius ** 2 and depth > self.depth[place]:
                    self.depth[place], self.color[place] = depth, color

    def line(self, start, end, color, radius):
        """Draws dots (x, y, depth) close to each other."""
        steps = math.ceil(math.hypot(end[0] - start[0], end[1] - start[1]) / radius) or 1
        for k in range(steps + 1):
            t = k / steps
            self.dot(*(a + t * (b - a) for a, b in zip(start, end)), color, radius)

    def draw(self, triangle, glass=False):
        """Draws three corners (x, y, depth, red, green, blue); of glass every other sample."""
        (ax, ay), (bx, by), (cx, cy) = (corner[:2] for corner in triangle)
        area = (bx - ax) * (cy - ay) - (cx - ax) * (by - ay)
        if area == 0:
            return
        x0, x1 = max(0, math.ceil(min(ax, bx, cx))), min(self.width - 1, int(max(ax, bx, cx)))
        y0, y1 = max(0, math.ceil(min(ay, by, cy))), min(self.height - 1, int(max(ay, by, cy)))
        for y in range(y0, y1 + 1):
            for x in range(x0, x1 + 1):
                b = ((x - ax) * (cy - ay) - (cx - ax) * (y - ay)) / area
                c = ((bx - ax) * (y - ay) - (x - ax) * (by - ay)) / area
                a = 1 - b - c
                if a < 0 or b < 0 or c < 0 or (glass and (x + y) % 2):
                    continue
                depth, *color = (a * p + b * q + c * r for p, q, r in
                                 zip(triangle[0][2:], triangle[1][2:], triangle[2][2:]))
                place = y * self.width + x
                if depth > self.depth[place]:
                    self.depth[place] = depth
                    self.color[place] = color

    def rows(self):
        """Yields the rows of the picture as bytes."""
        samples = range(SAMPLES)
        for y in range(self.height // SAMPLES):
            row = bytearray()
            for x in range(self.width // SAMPLES):
                block = [self.color[(SAMPLES * y + j) * self.width + SAMPLES * x + i]
                         for j in samples for i in samples]
                row += bytes(round(sum(c[k] for c in block) / len(block)) for k in range(3))
            yield bytes(row)


def filtered(row, above):
    """Returns the row with the PNG filter that is likely to compress best."""
    left = bytes(3) + row[:-3]
    corner = bytes(3) + above[:-3]

    def paeth(a, b, c):
        pa, pb, pc = abs(b - c), abs(a - c), abs(a + b - 2 * c)
        return a if pa <= pb and pa <= pc else b if pb <= pc else c
    candidates = [
        bytes([0]) + row,
        bytes([1]) + bytes((x - a) & 255 for x, a in zip(row, left)),
        bytes([2]) + bytes((x - b) & 255 for x, b in zip(row, above)),
        bytes([4]) + bytes((x - paeth(a, b, c)) & 255
                           for x, a, b, c in zip(row, left, above, corner))]
    return min(candidates, key=lambda line: sum(min(x, 256 - x) for x in line[1:]))


def write_png(path, width, height, rows):
    data, above = bytearray(), bytes(3 * width)
    for row in rows:
        data += filtered(row, above)
        above = row

    def chunk(name, content):
        crc = zlib.crc32(name + content)
        return struct.pack(">I", len(content)) + name + content + struct.pack(">I", crc)
    path.write_bytes(b"\x89PNG\r\n\x1a\n" +
                     chunk(b"IHDR", struct.pack(">IIBBBBB", width, height, 8, 2, 0, 0, 0)) +
                     chunk(b"IDAT", zlib.compress(bytes(data), 9)) + chunk(b"IEND", b""))


def values_in(face, patch, values, patches):
    """Returns the values of the corners; that of another patch becomes a mean of the others."""
    own = [values[v] for v in face if patches[v] == patch]
    if not own:
        return [values[v] for v in face]
    return [values[v] if patches[v] == patch else sum(own) / len(own) for v in face]


class View:
    """Where points of space are in the picture, fitted to all of them."""

    def __init__(self, points, options):
        self.width, self.height = (SAMPLES * int(n) for n in options.size.lower().split("x"))
        self.right, self.up, self.viewer = frame(*(float(x) for x in options.view.split(",")))
        xs, ys = [dot(p, self.right) for p in points], [dot(p, self.up) for p in points]
        self.extent = max(max(xs) - min(xs), max(ys) - min(ys))
        self.scale = 0.94 * min(self.width / (max(xs) - min(xs)), self.height / (max(ys) - min(ys)))
        self.middle = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
        light = [-0.45 * r + 0.6 * u + 0.66 * v
                 for r, u, v in zip(self.right, self.up, self.viewer)]
        self.light = tuple(x / math.sqrt(dot(light, light)) for x in light)

    def place(self, p, lift=0.0):
        """Returns the sample and the depth; lifted ones are nearer, by a part of the extent."""
        return (self.width / 2 + self.scale * (dot(p, self.right) - self.middle[0]),
                self.height / 2 - self.scale * (dot(p, self.up) - self.middle[1]),
                dot(p, self.viewer) + lift * self.extent)


def points_of(columns):
    return list(zip(columns["x"], columns["y"], columns["z"]))


def draw_mesh(canvas, view, columns, faces, color_at, glass=False):
    """Draws triangles with the colour that color_at(face, patch) has for each corner."""
    places = [view.place(p) for p in points_of(columns)]
    normals = list(zip(columns["nx"], columns["ny"], columns["nz"]))
    lists = faces["vertex_indices"]
    for face, patch in zip(lists, faces.get("patch", [0] * len(lists))):
        corners = [(*places[v], *shade(color, normals[v], view.viewer, view.light))
                   for v, color in zip(face, color_at(face, patch))]
        for i in range(1, len(face) - 1):
            canvas.draw([corners[0], corners[i], corners[i + 1]], glass)


def parsed_color(text):
    if len(text) != 6:
        raise ValueError(f"a colour has six digits rrggbb, and not {text}")
    return tuple(int(text[k:k + 2], 16) for k in (0, 2, 4))


def parsed_scene(options):
    """Returns the added parts [columns, faces, edges, colour, glass] and the dots."""
    parts, dots = [], []
    for text in options.add:
        name, color, *kind = text.split(":")
        parts.append([*read_ply(name), parsed_color(color), kind == ["glass"]])
    for text in options.point:
        point, color = text.split(":")
        dots.append((tuple(float(x) for x in point.split(",")), parsed_color(color)))
    return parts, dots


def render(columns, faces, options):
    """Returns the canvas with the mesh and what is added."""
    parts, dots = parsed_scene(options)
    points = points_of(columns) + [p for part in parts for p in points_of(part[0])]
    view = View(points + [p for p, _ in dots], options)
    values = columns[options.property]
    bound = options.bound or sorted(abs(v) for v in values)[9 * len(values) // 10] or 1.0
    patches = columns.get("patch", [0] * len(values))
    canvas = Canvas(view.width, view.height)
    draw_mesh(canvas, view, columns, faces, lambda face, patch: [
        color_of(x / bound) for x in values_in(face, patch, values, patches)])
    for added, triangles, edges, color, glass in parts:
        if triangles:
            draw_mesh(canvas, view, added, triangles,
                      lambda face, _, color=color: [color] * len(face), glass)
        places = [view.place(p, 0.01) for p in points_of(added)]
        for a, b in zip(edges.get("vertex1", []), edges.get("vertex2", [])):
            canvas.line(places[a], places[b], color, SAMPLES * LINE)
    for point, color in dots:
        canvas.dot(*view.place(point, 0.02), color, SAMPLES * DOT)
    return canvas


def main():
    parser = argparse.ArgumentParser(description="Draws a mesh with a curvature property.")
    parser.add_argument("mesh")
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--property", default="gaussian_curvature")
    parser.add_argument("--bound", type=float)
    parser.add_argument("--size", default="760x430")
    parser.add_argument("--view", default="-75,18")
    parser.add_argument("--add", action="append", default=[])
    parser.add_argument("--point", action="append", default=[])
    options = parser.parse_args()
    try:
        columns, faces, _ = read_ply(options.mesh)
        missing = {"x", "y", "z", "nx", "ny", "nz", options.property} - columns.keys()
        if missing:
            raise ValueError("the vertices have no property " + ", ".join(sorted(missing)))
        canvas = render(columns, faces, options)
    except (OSError, ValueError, KeyError, StopIteration, struct.error) as error:
        print(f"render_mesh.py: {options.mesh}: {error}", file=sys.stderr)
        return 1
    write_png(options.picture, canvas.width // SAMPLES, canvas.height // SAMPLES, canvas.rows())
    return 0


if __name__ == "__main__":
    sys.exit(main())
