#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
"""SAM3D (facebookresearch/sam-3d-objects) as a shape estimator beside hydrabench; docs/sam3d.md has the format.

    python3 sam3d_sidecar.py PATH_OF_SAM_3D_OBJECTS [CONFIG]

Runs in the Python environment of SAM3D, with its weights in PATH/checkpoints/hf. CONFIG is its pipeline.yaml, if it is elsewhere.
All that is known of its frames, units and axes is turned here, so that nobody else has to.
"""
import array
import hashlib
import json
import math
import os
import struct
import sys
import time


# ---------------------------------------------------------------- frames

def points_for_sam3d(depth, width, camera_matrix):
    """Flat x, y, z of every pixel in PyTorch3D axes (x left, y up, z forward) [m]: SAM3D does not turn a point map it is given.

    NaN where nothing was measured: zeros would enter its medians.
    """
    fx, _, cx, _, fy, cy, *_ = camera_matrix
    points = array.array("f", bytes(12 * len(depth)))
    nan = math.nan
    for i, z in enumerate(depth):
        if z > 0 and z < math.inf:
            points[3 * i] = -((i % width) - cx) * z / fx
            points[3 * i + 1] = -((i // width) - cy) * z / fy
            points[3 * i + 2] = z
        else:
            points[3 * i] = points[3 * i + 1] = points[3 * i + 2] = nan
    return points


def matrix_of_quaternion(w, x, y, z):
    """Rows of the rotation of a quaternion, normalised first, as PyTorch3D's quaternion_to_matrix has it."""
    n = math.sqrt(w * w + x * x + y * y + z * z)
    w, x, y, z = w / n, x / n, y / n, z / n
    return [[1 - 2 * (y * y + z * z), 2 * (x * y - z * w), 2 * (x * z + y * w)],
            [2 * (x * y + z * w), 1 - 2 * (x * x + z * z), 2 * (y * z - x * w)],
            [2 * (x * z - y * w), 2 * (y * z + x * w), 1 - 2 * (x * x + y * y)]]


def opencv_pose(quaternion_wxyz, translation):
    """R (9 numbers, row by row) and t of v -> s R v + t in OpenCV axes.

    SAM3D's pose is PyTorch3D's: p = (s v) Q + t with row vectors, so Q transposed for columns; and its camera looks along z with
    x to the left and y up, so both change their sign. The determinant stays +1.
    """
    q = matrix_of_quaternion(*quaternion_wxyz)
    flip = (-1, -1, 1)
    rotation = [flip[row] * q[column][row] for row in range(3) for column in range(3)]
    return rotation, [f * t for f, t in zip(flip, translation)]


# ---------------------------------------------------------------- the format

def frame(header, blobs=()):
    header = dict(header, blobs=[dict(name=n, dtype=d, shape=s, bytes=len(b)) for n, d, s, b in blobs])
    text = json.dumps(header, allow_nan=False).encode()
    return b"S3D1" + struct.pack("<I", len(text)) + text + b"".join(b for _, _, _, b in blobs)


def read_frame(source):
    """Header and arrays by name; None at the end."""
    prefix = source.read(8)
    if len(prefix) < 8:
        return None
    magic, length = struct.unpack("<4sI", prefix)
    if magic != b"S3D1":
        raise ValueError("a message does not begin with S3D1")
    header = json.loads(source.read(length))
    return header, {b["name"]: source.read(b["bytes"]) for b in header["blobs"]}


def answer(estimator, header, blobs):
    """The frame that answers a question."""
    reply = {"id": header["id"]}
    if "rgb" not in blobs:
        return frame(dict(reply, status="rejected", message="no colour"))
    depth = array.array("f", blobs["depth"])
    if not any(m and z > 0 for m, z in zip(blobs["mask"], depth)):
        # SAM3D would silently take scale 1 and place 0.
        return frame(dict(reply, status="rejected", message="no depth on the mask"))
    points = points_for_sam3d(depth, header["width"], header["K"])
    shape = estimator.estimate(blobs["rgb"], blobs["mask"], points, header["width"], header["height"], header["seed"])
    rotation, translation = opencv_pose(shape["quaternion_wxyz"], shape["translation"])
    numbers = rotation + translation + [shape["scale"]]
    vertices, faces = shape["vertices"], shape["faces"]  # flat; of the local frame with z up, not of the GLB with y up
    if not all(math.isfinite(x) for x in numbers) or shape["scale"] <= 0 or not len(faces):
        return frame(dict(reply, status="error", message="the pose is not finite or the mesh is empty"))
    return frame(dict(reply, status="ok", R=rotation, t=translation, s=shape["scale"], timings_ms=shape["timings_ms"]),
                 [("vertices", "f4", [len(vertices) // 3, 3], array.array("f", vertices).tobytes()),
                  ("faces", "u4", [len(faces) // 3, 3], array.array("I", faces).tobytes())])


def example():
    """A question as the harness asks them, of its own making: a grey ball of 0.6 m, 1.5 m away, before a wall 3 m away."""
    width, height, focal, middle_z, radius = 320, 240, 260, 1.5, 0.3
    rgb, mask, depth = bytearray(), bytearray(), array.array("f")
    for i in range(width * height):
        x, y = (i % width - width / 2) / focal, (i // width - height / 2) / focal
        a = x * x + y * y + 1  # the ray z (x, y, 1) meets the ball where a z^2 - 2 middle_z z + middle_z^2 = radius^2
        under_root = middle_z * middle_z - a * (middle_z * middle_z - radius * radius)
        z = (middle_z - math.sqrt(under_root)) / a if under_root > 0 else 3
        rgb += bytes([round(255 * (2 - z)) if under_root > 0 else 240] * 3)
        mask.append(under_root > 0)
        depth.append(z)
    header = {"id": 0, "op": "estimate", "camera": "opencv", "width": width, "height": height,
              "K": [focal, 0, width / 2, 0, focal, height / 2, 0, 0, 1], "label": 0, "seed": 0}
    return header, {"rgb": bytes(rgb), "mask": bytes(mask), "depth": depth.tobytes()}


def warm_up(estimator):
    """Answers the example, so that what only the first call does (kernels are loaded, memory is taken) is done before a call is timed.

    Returns how long that took [s]. An example that finds no shape has still warmed; what is broken shows at the first question.
    """
    start = time.monotonic()
    try:
        answer(estimator, *example())
    except Exception as error:
        print(f"warm-up: {error!r}", file=sys.stderr)
        if "CUDA" in str(error):
            sys.exit(1)
    return time.monotonic() - start


def serve(make_estimator):
    """Loads, warms up, says hello and answers until the input ends. Standard input and output are ours alone: what libraries print goes
    to the log."""
    out = os.fdopen(os.dup(1), "wb")
    source = os.fdopen(os.dup(0), "rb")
    os.dup2(2, 1)
    os.dup2(os.open(os.devnull, os.O_RDONLY), 0)

    def say(data):
        out.write(data)
        out.flush()

    estimator = make_estimator()
    warm_up_s = warm_up(estimator)
    say(frame(dict(estimator.hello, op="hello", protocol=1, warm_up_s=warm_up_s)))
    while (question := read_frame(source)) is not None:
        header, blobs = question
        try:
            say(answer(estimator, header, blobs))
        except Exception as error:  # out of memory, an empty set of voxels: of this object, not of the next
            print(f"question {header['id']}: {error!r}", file=sys.stderr)
            say(frame({"id": header["id"], "status": "error", "message": str(error)[:300]}))
            if "CUDA" in str(error):  # nothing works after some of these: a new process does
                sys.exit(1)


# ---------------------------------------------------------------- SAM3D itself

class Sam3d:
    """Its pipeline, without the notebook's wrapper, which wants a conda environment and a display."""

    def __init__(self, root, config=None):
        sys.path.insert(0, root)
        os.environ.setdefault("LIDRA_SKIP_INIT", "true")  # its package asks for a module that is not public
        import numpy
        import torch
        from hydra.utils import instantiate
        from omegaconf import OmegaConf
        self.numpy, self.torch = numpy, torch
        config = config or os.path.join(root, "checkpoints", "hf", "pipeline.yaml")
        with open(config, "rb") as file:
            digest = hashlib.sha256(file.read()).hexdigest()
        settings = OmegaConf.load(config)
        settings.rendering_engine = "pytorch3d"
        settings.compile_model = False
        settings.workspace_dir = os.path.dirname(config)
        self.pipeline = instantiate(settings)
        self.hello = {"name": "SAM3D", "config_sha256": digest, "gpu": torch.cuda.get_device_name(),
                      "licence": "SAM License"}

    def estimate(self, rgb, mask, points, width, height, seed):
        numpy, torch = self.numpy, self.torch
        image = numpy.frombuffer(rgb, numpy.uint8).reshape(height, width, 3)
        alpha = numpy.frombuffer(mask, numpy.uint8).reshape(height, width) > 0
        pointmap = torch.from_numpy(numpy.frombuffer(points, numpy.float32).reshape(height, width, 3).copy())
        image = numpy.concatenate([image, (255 * alpha[..., None]).astype(numpy.uint8)], axis=-1)
        start = time.monotonic()
        # Both formats: with the mesh alone its last step looks for a Gaussian that is not there.
        result = self.pipeline.run(image, None, seed % 2**31, stage1_only=False, with_mesh_postprocess=False,
                                   with_texture_baking=False, with_layout_postprocess=False, use_vertex_color=True,
                                   pointmap=pointmap, decode_formats=["mesh", "gaussian"])
        mesh = result["mesh"][0]
        if not mesh.success:
            raise RuntimeError("the mesh decoder found no surface")
        return {"quaternion_wxyz": result["rotation"].reshape(4).tolist(),
                "translation": result["translation"].reshape(3).tolist(),
                "scale": float(result["scale"].reshape(-1)[0]),
                "vertices": mesh.vertices.float().cpu().reshape(-1).tolist(),
                "faces": mesh.faces.cpu().reshape(-1).tolist(),
                "timings_ms": {"total": 1000 * (time.monotonic() - start)}}


if __name__ == "__main__":
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    serve(lambda: Sam3d(*sys.argv[1:]))
