# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
"""Stands in for a shape estimator beside the program: answers, or fails, as its first argument says.

fake_sidecar.py MODE [FILE]    FILE keeps the number of starts, for modes that fail at the first only

Most modes answer with a tetrahedron that tests know by heart, wherever the object is; `box` with the box of what was seen of it, and
`box_dies_every_third` with that, too, but of every start the third answer breaks off.
"""
import array
import json
import os
import struct
import sys
import time

mode = sys.argv[1]
starts = 1
if len(sys.argv) > 2:
    with open(sys.argv[2], "a+") as file:
        file.write("x")
        file.seek(0)
        starts = len(file.read())
out = sys.stdout.buffer
source = sys.stdin.buffer


def frame(header, blobs=()):
    header = dict(header, blobs=[dict(name=n, dtype=t, shape=s, bytes=len(b)) for n, t, s, b in blobs])
    text = json.dumps(header).encode()
    return b"S3D1" + struct.pack("<I", len(text)) + text + b"".join(b for _, _, _, b in blobs)


def say(data, pieces=False):
    for i in range(0, len(data), 7 if pieces else max(len(data), 1)):
        out.write(data[i:i + (7 if pieces else len(data))])
        out.flush()


def read():
    prefix = source.read(8)
    if len(prefix) < 8:
        sys.exit(0)
    assert prefix[:4] == b"S3D1"
    header = json.loads(source.read(struct.unpack("<I", prefix[4:])[0]))
    return header, {b["name"]: source.read(b["bytes"]) for b in header["blobs"]}


def seen_box(header, depth, mask):
    """Middle, corners about it and faces of the box of the measured points of a mask but for a tenth at each end, in the axes of
    the camera: at the rim of a mask there is background."""
    width, (fx, _, cx, _, fy, cy, *_) = header["width"], header["K"]
    points = [((i % width - cx) * z / fx, (i // width - cy) * z / fy, z)
              for i, (z, m) in enumerate(zip(depth, mask)) if m and z == z]
    axes = [sorted(axis) for axis in zip(*points)]
    low, high = [axis[len(axis) // 10] for axis in axes], [axis[-1 - len(axis) // 10] for axis in axes]
    middle = [(a + b) / 2 for a, b in zip(low, high)]
    corners = [(low, high)[i >> k & 1][k] - middle[k] for i in range(8) for k in range(3)]
    return middle, corners, [0, 2, 1, 1, 2, 3, 4, 5, 6, 5, 7, 6, 0, 1, 4, 1, 5, 4,
                             2, 6, 3, 3, 6, 7, 0, 4, 2, 2, 4, 6, 1, 3, 5, 3, 7, 5]


if mode == "no_hello":
    time.sleep(1000)
if mode == "dies_at_start":
    sys.exit(3)
say(frame({"op": "hello", "protocol": 1, "name": "fake", "version": "1"}), mode == "pieces")
if mode == "deaf":
    time.sleep(1000)
questions = 0
while True:
    header, blobs = read()
    questions += 1
    depth = array.array("f", blobs["depth"])
    seen = sorted(z for z, m in zip(depth, blobs["mask"]) if m and z == z)
    # A tetrahedron of unequal edges, turned by a quarter about z, at the middle depth of the mask.
    vertices = array.array("f", [0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3])
    faces = array.array("I", [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3])
    reply = {"id": header["id"], "status": "ok", "R": [0, -1, 0, 1, 0, 0, 0, 0, 1],
             "t": [0.25, -0.5, seen[len(seen) // 2] if seen else 0], "s": 0.5,
             "timings_ms": {"stage1": 3.5, "decode": 1.25}}
    if mode.startswith("box"):
        middle, corners, box_faces = seen_box(header, depth, blobs["mask"])
        vertices, faces = array.array("f", corners), array.array("I", box_faces)
        reply.update(R=[1, 0, 0, 0, 1, 0, 0, 0, 1], t=middle, s=1)
    if mode == "late" or (mode == "late_once" and starts == 1):
        time.sleep(1000)
    if mode == "closes_output":
        os.close(1)
        time.sleep(1000)
    if mode == "garbage" or (mode == "garbage_once" and starts == 1):
        say(b"this is no message\n" * 100)
        time.sleep(1000)
    if mode == "nan":
        vertices[4] = float("nan")
    if mode == "nan_pose":
        reply["t"][0] = float("nan")
    if mode == "mirrored":
        reply["R"] = [1, 0, 0, 0, 1, 0, 0, 0, -1]
    if mode == "negative":
        reply["s"] = -1
    if mode == "bad_face":
        faces[0] = 4
    if mode == "no_shape":
        del reply["R"]
    if mode == "rejected":
        reply = {"id": header["id"], "status": "rejected", "message": "too small"}
    if mode == "error":
        reply = {"id": header["id"], "status": "error", "message": "out of memory"}
    if mode == "other_id":
        reply["id"] += 1
    if mode == "noisy":
        print("a library that prints to stderr", file=sys.stderr)
    blobs_out = [("vertices", "f4", [len(vertices) // 3, 3], vertices.tobytes()),
                 ("faces", "u4", [len(faces) // 3, 3], faces.tobytes())]
    if "R" not in reply and mode != "no_shape":
        blobs_out = []
    data = frame(reply, blobs_out)
    if mode == "wrong_length":
        data = data.replace(b'"bytes": 48', b'"bytes": 47')
    if mode == "dies" or (mode == "dies_once" and starts == 1) or (
            mode == "box_dies_every_third" and questions == 3):
        say(data[:len(data) // 2])
        os._exit(9)
    say(data, mode == "pieces")
