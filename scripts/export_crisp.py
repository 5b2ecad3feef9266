#!/usr/bin/env python3
# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
"""Turns a checkpoint of CRISP (torch.save of {"model": state dict, ...}) or DINOv2's state dict into files hydrabench reads.

    /usr/bin/python3 scripts/export_crisp.py epoch_50.pth models/crisp_ycbv --cube-half-side 0.35 --source "..." --licence MIT
    /usr/bin/python3 scripts/export_crisp.py dinov2_vits14_pretrain.pth models/dinov2   # weights only: no network to describe

Writes weights.safetensors, manifest.yaml and, with --reference FILE.py, golden.safetensors: a random input, what
forward(state, image, points, heads, taps) of that file answers (tap<i>, cls<i>, nocs, z, sdf) and the 1000 points asked for.
Point it at upstream's own model to check against upstream, or at tests/core/shape/crisp/reference_crisp.py. See docs/crisp.md.
Needs torch (1.13 or newer) and numpy. A checkpoint is a pickle, which can run code when opened: export only files you trust.
"""
import argparse, importlib.util, json, pathlib, struct, sys

import torch

sys.dont_write_bytecode = True  # --reference is read where it stands


def write_safetensors(path, tensors, metadata):
    """u64 length of the JSON header, header, then the numbers, little-endian and without gaps."""
    header, blobs, offset = {"__metadata__": metadata}, [], 0
    for name in sorted(tensors):
        tensor = tensors[name].detach().cpu()
        tensor = tensor.float() if tensor.is_floating_point() else tensor.long()
        blob = tensor.contiguous().numpy().tobytes()
        header[name] = {"dtype": "F32" if tensor.is_floating_point() else "I64", "shape": list(tensor.shape),
                        "data_offsets": [offset, offset + len(blob)]}
        offset += len(blob)
        blobs.append(blob)
    text = json.dumps(header).encode()
    text += b" " * (-len(text) % 8)
    path.write_bytes(struct.pack("<Q", len(text)) + text + b"".join(blobs))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("checkpoint", type=pathlib.Path)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--mode", choices=["metric", "normalised"], default="metric", help="published checkpoints are metric")
    parser.add_argument("--input-normalisation", choices=["imagenet", "none"], default="imagenet", help="none: NOCS dataset")
    parser.add_argument("--cube-half-side", type=float, default=1.0, help="[m], or 1 if normalised; from the training's config.yaml")
    parser.add_argument("--reference", type=pathlib.Path, help="Python file with forward(...), for golden tensors")
    parser.add_argument("--side", type=int, default=420, help="of the golden input [px]")
    parser.add_argument("--heads", type=int, default=6, help="of the attention")
    parser.add_argument("--taps", type=int, nargs="*", default=[2, 5, 8, 11])
    for text in ["source", "licence", "git-hash"]:
        parser.add_argument("--" + text, default="")
    args = parser.parse_args()

    checkpoint = torch.load(args.checkpoint, map_location="cpu")
    state = checkpoint.get("model", checkpoint)  # DINOv2's file is the state dict itself
    args.folder.mkdir(parents=True, exist_ok=True)
    origin = {"source": args.source or args.checkpoint.name, "licence": args.licence, "git_hash": args.git_hash}
    write_safetensors(args.folder / "weights.safetensors", state, origin)
    sine = [name for name in state if name.startswith("recons_net.filmed_sdf.") and name.endswith("weight")]
    if sine:
        manifest = {"preset": "full", "mode": args.mode, "input_normalisation": args.input_normalisation, "crop": "tight_stretch",
                    "cube_half_side": args.cube_half_side, "sdf_layers": len(sine), "sdf_width": len(state[sine[0]]),
                    "weights": "weights.safetensors", **origin}
        lines = [f"{key}: {json.dumps(value)}\n" for key, value in manifest.items()]  # JSON is YAML
        (args.folder / "manifest.yaml").write_text("".join(lines))
    if args.reference:
        spec = importlib.util.spec_from_file_location("reference", args.reference)
        reference = importlib.util.module_from_spec(spec)
        spec.loader.exec_module(reference)
        torch.manual_seed(0)
        image, points = torch.randn(1, 3, args.side, args.side), torch.rand(1, 1000, 3) * 2 - 1
        with torch.no_grad():
            answer = reference.forward(state, image, points * args.cube_half_side, args.heads, args.taps)
        golden = {"input": image, "points": points * args.cube_half_side, **answer}
        write_safetensors(args.folder / "golden.safetensors", golden, origin)


if __name__ == "__main__":
    main()
