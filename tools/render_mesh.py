#!/usr/bin/env python3
# Copyright (c) 2026 The Shape_interrogation authors.
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws a mesh with a curvature property as a PNG picture. Needs nothing but Python.

  render_mesh.py MESH.ply PICTURE.png [--property NAME] [--bound X] [--size WIDTHxHEIGHT]
                 [--view AZIMUTH,ELEVATION]

MESH.ply is a file that write_ply() or the program interrogate has written, in either encoding, with
normals (nx, ny, nz). The property (default gaussian_curvature) is shown from blue (-X and less)
through white (0) to red (X and more); without --bound, X is the magnitude that nine tenths of the
vertices stay below. The azimuth and the elevation of the viewer are in degrees; z points upward. A
vertex on an edge between patches has the value of one of them: in triangles of the other it is left
out.
"""
import argparse
import math
import pathlib
import struct
import sys
import zlib

TYPES = {"char": "b", "uchar": "B", "short": "h", "ushort": "H", "int": "i", "uint": "I",
         "float": "f", "double": "d"}
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
    """Returns the columns of the vertices and of the faces by name; corners are a column, too."""
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
    return columns["vertex"], columns["face"]


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

    def draw(self, triangle):
        """Draws three corners (x, y, depth, red, green, blue)."""
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
                if a < 0 or b < 0 or c < 0:
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


def render(columns, faces, options):
    """Returns the canvas with the mesh."""
    width, height = (SAMPLES * int(n) for n in options.size.lower().split("x"))
    right, up, viewer = frame(*(float(x) for x in options.view.split(",")))
    points = list(zip(columns["x"], columns["y"], columns["z"]))
    normals = list(zip(columns["nx"], columns["ny"], columns["nz"]))
    values = columns[options.property]
    bound = options.bound or sorted(abs(v) for v in values)[9 * len(values) // 10] or 1.0
    light = tuple(-0.45 * r + 0.6 * u + 0.66 * v for r, u, v in zip(right, up, viewer))
    light = tuple(x / math.sqrt(dot(light, light)) for x in light)

    xs, ys = [dot(p, right) for p in points], [dot(p, up) for p in points]
    scale = 0.94 * min(width / (max(xs) - min(xs)), height / (max(ys) - min(ys)))
    middle_x, middle_y = (max(xs) + min(xs)) / 2, (max(ys) + min(ys)) / 2
    places = [(width / 2 + scale * (x - middle_x), height / 2 - scale * (y - middle_y),
               dot(p, viewer)) for x, y, p in zip(xs, ys, points)]
    lists = faces["vertex_indices"]
    patches = columns.get("patch", [0] * len(points))
    canvas = Canvas(width, height)
    for face, patch in zip(lists, faces.get("patch", [0] * len(lists))):
        corners = [(*places[v], *shade(color_of(value / bound), normals[v], viewer, light))
                   for v, value in zip(face, values_in(face, patch, values, patches))]
        for i in range(1, len(face) - 1):
            canvas.draw([corners[0], corners[i], corners[i + 1]])
    return canvas


def main():
    parser = argparse.ArgumentParser(description="Draws a mesh with a curvature property.")
    parser.add_argument("mesh")
    parser.add_argument("picture", type=pathlib.Path)
    parser.add_argument("--property", default="gaussian_curvature")
    parser.add_argument("--bound", type=float)
    parser.add_argument("--size", default="760x430")
    parser.add_argument("--view", default="-75,18")
    options = parser.parse_args()
    try:
        columns, faces = read_ply(options.mesh)
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
