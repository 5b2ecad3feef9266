# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
"""Stands in for SAM3D behind scripts/sam3d_sidecar.py: knows a pose in OpenCV axes and gives it out as SAM3D does, with the steps
undone one by one instead of by formula.

sam3d_stub.py FOLDER_OF_SIDECAR JSON    JSON: {"R": 9 numbers, "t": 3, "s": 1, "warm_up": "fails", if it shall}

Its hello has under "seen" what it was shown before it said so.
"""
import json
import math
import sys

sys.dont_write_bytecode = True
sys.path.insert(0, sys.argv[1])
import sam3d_sidecar

truth = json.loads(sys.argv[2])


def quaternion(m):
    """w, x, y, z of a rotation that acts on columns, by its largest component."""
    squares = [1 + m[0][0] + m[1][1] + m[2][2], 1 + m[0][0] - m[1][1] - m[2][2],
               1 - m[0][0] + m[1][1] - m[2][2], 1 - m[0][0] - m[1][1] + m[2][2]]
    k = max(range(4), key=lambda i: squares[i])
    r = math.sqrt(squares[k])
    rest = [[None, m[2][1] - m[1][2], m[0][2] - m[2][0], m[1][0] - m[0][1]],
            [m[2][1] - m[1][2], None, m[0][1] + m[1][0], m[0][2] + m[2][0]],
            [m[0][2] - m[2][0], m[0][1] + m[1][0], None, m[1][2] + m[2][1]],
            [m[1][0] - m[0][1], m[0][2] + m[2][0], m[1][2] + m[2][1], None]][k]
    return [r / 2 if v is None else v / (2 * r) for v in rest]


class Stub:
    def __init__(self):
        self.hello = {"name": "stub", "seen": []}

    def warm_up(self, rgb, mask, points, width, height):
        on = [points[3 * i:3 * i + 3] for i in range(width * height) if mask[i]]
        self.hello["seen"].append({"pixels": width * height, "bytes": len(rgb), "on": len(on), "nearest": min(p[2] for p in on),
                                   "left": max(p[0] for p in on), "top": max(p[1] for p in on)})
        if truth.get("warm_up") == "fails":
            raise RuntimeError("no voxels")

    def estimate(self, rgb, mask, points, width, height, seed):
        print("a library that prints to standard output")
        if not self.hello["seen"]:
            self.warm_up(rgb, mask, points, width, height)
            return self.shape()
        # The point of pixel (10, 5) at 2 m, and one that was not measured.
        at = 3 * (5 * width + 10)
        assert abs(points[at] - -(10 - 32) * 2 / 60) < 1e-6 and abs(points[at + 1] - -(5 - 24) * 2 / 60) < 1e-6
        assert points[at + 2] == 2 and all(math.isnan(p) for p in points[:3])
        assert len(rgb) == 3 * width * height and len(mask) == width * height
        return self.shape()

    def shape(self):
        # What a camera that looks along z with x to the left and y up sees of the axes of the object.
        columns = [[-truth["R"][c], -truth["R"][3 + c], truth["R"][6 + c]] for c in range(3)]
        rows_for_row_vectors = columns  # v Q is the sum of v[i] times row i of Q
        # quaternion() is of a matrix for columns; PyTorch3D applies the same matrix to rows.
        return {"quaternion_wxyz": [2 * q for q in quaternion(rows_for_row_vectors)],
                "translation": [-truth["t"][0], -truth["t"][1], truth["t"][2]], "scale": truth["s"],
                "vertices": [0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0, 3], "faces": [0, 2, 1, 0, 1, 3, 0, 3, 2, 1, 2, 3],
                "timings_ms": {"total": 1.0}}


sam3d_sidecar.serve(Stub)
