# SPDX-FileCopyrightText: 2026 The hydrabench authors
# SPDX-License-Identifier: MIT
"""CRISP's forward pass, written a second time and without torch.nn: sums, products and gathers only, from the description of
the layers. Sizes come from the weights. Checks core/shape/crisp; slow, on purpose plain.

As a program: writes a checkpoint of random weights in CRISP's layout.
    reference_crisp.py OUT.pth full|tiny|backbone
"""
import math
import sys
from collections import OrderedDict

import torch


# Layers -------------------------------------------------------------------------------------------------------------------

def linear(x, state, name):
    y = torch.einsum("...i,oi->...o", x, state[name + ".weight"])
    return y + state[name + ".bias"] if name + ".bias" in state else y


def layer_norm(x, state, name, eps):
    centred = x - x.mean(-1, keepdim=True)
    scaled = centred / torch.sqrt((centred ** 2).mean(-1, keepdim=True) + eps)
    return scaled * state[name + ".weight"] + state[name + ".bias"]


def group_norm(x, state, name, groups=4, eps=1e-5):
    b, c, h, w = x.shape
    y = x.reshape(b, groups, -1)
    y = y - y.mean(-1, keepdim=True)
    y = (y / torch.sqrt((y ** 2).mean(-1, keepdim=True) + eps)).reshape(b, c, h, w)
    return y * state[name + ".weight"].view(1, c, 1, 1) + state[name + ".bias"].view(1, c, 1, 1)


def gelu(x):
    return x * 0.5 * (1 + torch.erf(x / math.sqrt(2)))


def conv(x, state, name, stride=1, padding=0):
    """A sum over the taps of the kernel, each a matrix product."""
    weight = state[name + ".weight"]
    b, c, h, w = x.shape
    k = weight.shape[2]
    padded = x.new_zeros(b, c, h + 2 * padding, w + 2 * padding)
    padded[:, :, padding:padding + h, padding:padding + w] = x
    oh, ow = (h + 2 * padding - k) // stride + 1, (w + 2 * padding - k) // stride + 1
    y = x.new_zeros(b, weight.shape[0], oh, ow)
    for i in range(k):
        for j in range(k):
            part = padded[:, :, i:i + (oh - 1) * stride + 1:stride, j:j + (ow - 1) * stride + 1:stride]
            y += torch.einsum("bchw,oc->bohw", part, weight[:, :, i, j])
    return y + state[name + ".bias"].view(1, -1, 1, 1) if name + ".bias" in state else y


def conv_transposed(x, state, name, stride):
    """Kernel and stride are equal: every input pixel paints a square of its own."""
    weight = state[name + ".weight"]  # in x out x k x k
    b, c, h, w = x.shape
    y = torch.einsum("bchw,coij->bohiwj", x, weight).reshape(b, weight.shape[1], h * stride, w * stride)
    return y + state[name + ".bias"].view(1, -1, 1, 1)


def resample(x, axis, positions, kernel):
    """Reads axis at fractional positions; outside, the border goes on. kernel(t): weights of the taps around floor(position)."""
    low = torch.floor(positions)
    size = x.shape[axis]
    shape = [1] * x.dim()
    shape[axis] = -1
    total = 0
    for offset, weight in kernel(positions - low):
        index = (low.long() + offset).clamp(0, size - 1)
        total = total + x.index_select(axis, index) * weight.float().view(shape)
    return total


def linear_kernel(t):
    return [(0, 1 - t), (1, t)]


def cubic_kernel(t, a=-0.75):
    def near(d):
        return ((a + 2) * d - (a + 3)) * d * d + 1

    def far(d):
        return ((a * d - 5 * a) * d + 8 * a) * d - 4 * a
    return [(-1, far(t + 1)), (0, near(t)), (1, near(1 - t)), (2, far(2 - t))]


def bilinear(x, height, width, aligned):
    for axis, size in ((2, height), (3, width)):
        out = torch.arange(size, dtype=torch.float64)
        old = x.shape[axis]
        if aligned:
            positions = out * ((old - 1) / (size - 1) if size > 1 else 0.0)
        else:
            positions = ((out + 0.5) * old / size - 0.5).clamp(min=0)
        x = resample(x, axis, positions, linear_kernel)
    return x


# Backbone -----------------------------------------------------------------------------------------------------------------

def position_embedding(stored, rows, columns):
    grid = math.isqrt(stored.shape[1] - 1)
    if (rows, columns) == (grid, grid):
        return stored
    patches = stored[:, 1:].reshape(1, grid, grid, -1)
    for axis, count in ((1, rows), (2, columns)):
        factor = (count + 0.1) / grid
        positions = (torch.arange(count, dtype=torch.float64) + 0.5) / factor - 0.5
        patches = resample(patches, axis, positions, cubic_kernel)
    return torch.cat([stored[:, :1], patches.reshape(1, rows * columns, -1)], 1)


def attention(x, state, name, heads):
    b, n, dim = x.shape
    width = dim // heads
    qkv = linear(x, state, name + ".qkv")
    out = []
    for head in range(heads):
        q, k, v = (qkv[..., part * dim + head * width:part * dim + (head + 1) * width] for part in range(3))
        score = torch.einsum("bik,bjk->bij", q, k) / math.sqrt(width)
        weight = torch.exp(score - score.max(-1, keepdim=True).values)
        out.append(torch.einsum("bij,bjk->bik", weight / weight.sum(-1, keepdim=True), v))
    return linear(torch.cat(out, -1), state, name + ".proj")


def block(x, state, name, heads):
    x = x + state[name + ".ls1.gamma"] * attention(layer_norm(x, state, name + ".norm1", 1e-6), state, name + ".attn", heads)
    hidden = gelu(linear(layer_norm(x, state, name + ".norm2", 1e-6), state, name + ".mlp.fc1"))
    return x + state[name + ".ls2.gamma"] * linear(hidden, state, name + ".mlp.fc2")


def backbone(state, image, heads, taps, prefix="backbone."):
    patch = state[prefix + "patch_embed.proj.weight"].shape[-1]
    maps = conv(image, state, prefix + "patch_embed.proj", stride=patch)
    b, dim, rows, columns = maps.shape
    tokens = torch.cat([state[prefix + "cls_token"].repeat(b, 1, 1), maps.reshape(b, dim, -1).transpose(1, 2)], 1)
    tokens = tokens + position_embedding(state[prefix + "pos_embed"], rows, columns)
    shown = []
    for i in range(max(taps) + 1):
        tokens = block(tokens, state, f"{prefix}blocks.{i}", heads)
        if i in taps:
            shown.append((tokens[:, 1:].transpose(1, 2).reshape(b, dim, rows, columns), tokens[:, 0]))
    return shown


# Heads --------------------------------------------------------------------------------------------------------------------

def residual_unit(x, state, name):
    y = group_norm(conv(x.clamp(min=0), state, name + ".conv1", padding=1), state, name + ".bn1")
    return x + group_norm(conv(y.clamp(min=0), state, name + ".conv2", padding=1), state, name + ".bn2")


def nocs_head(state, taps, side, p="nocs_net."):
    maps = []
    for i, (patches, cls) in enumerate(taps):
        b, dim, rows, columns = patches.shape
        tokens = patches.permute(0, 2, 3, 1)
        both = torch.cat([tokens, cls.view(b, 1, 1, dim).expand(tokens.shape)], -1)
        read = gelu(linear(both, state, f"{p}reassemble_blocks.readout_projects.{i}.0")).permute(0, 3, 1, 2)
        maps.append(conv(read, state, f"{p}reassemble_blocks.projects.{i}"))
    resize = p + "reassemble_blocks.resize_layers."
    maps[0] = conv_transposed(maps[0], state, resize + "0", 4)
    maps[1] = conv_transposed(maps[1], state, resize + "1", 2)
    maps[3] = conv(maps[3], state, resize + "3", stride=2, padding=1)
    maps = [conv(m, state, f"{p}convs.{i}", padding=1) for i, m in enumerate(maps)]
    x = None
    for i, skip in enumerate(reversed(maps)):
        name = f"{p}fusion_blocks.{i}"
        if x is None:
            x = skip
        else:
            if skip.shape[2:] != x.shape[2:]:
                skip = bilinear(skip, x.shape[2], x.shape[3], False)
            x = x + residual_unit(skip, state, name + ".res_conv_unit1")
        x = residual_unit(x, state, name + ".res_conv_unit2")
        x = conv(bilinear(x, 2 * x.shape[2], 2 * x.shape[3], True), state, name + ".project")
    head = p + "conv_nocs.head."
    x = conv(conv(x, state, p + "project", padding=1), state, head + "0", padding=1)
    x = group_norm(bilinear(x, side, side, True), state, head + "2")
    return conv(conv(x, state, head + "3", padding=1).clamp(min=0), state, head + "5")


def shape_code(state, taps, p="recons_backbone_adaptor.net."):
    x = torch.cat([cls for _, cls in taps] + [taps[-1][0].mean((2, 3))], -1)
    for i in (0, 3, 6):
        x = layer_norm(linear(x, state, f"{p}{i}"), state, f"{p}{i + 1}", 1e-5).clamp(min=0)
    return linear(x, state, p + "9")


def sdf(state, points, z, p="recons_net."):
    x = points
    layers = sum(name.startswith(p + "filmed_sdf") and name.endswith("weight") for name in state)
    for i in range(layers):
        y = linear(x, state, f"{p}filmed_sdf.{i}.0.layer")
        width = y.shape[-1]
        gain, shift = z[:, 2 * i * width:(2 * i + 1) * width], z[:, (2 * i + 1) * width:(2 * i + 2) * width]
        x = torch.sin(gain[:, None] * y + shift[:, None])
    return linear(x, state, p + "final_layer")[..., 0]


def forward(state, image, points, heads, taps):
    prefix = "backbone." if "backbone.cls_token" in state else ""
    shown = backbone(state, image, heads, taps, prefix)
    answer = {}
    for i, (patches, cls) in enumerate(shown):
        answer[f"tap{i}"], answer[f"cls{i}"] = patches, cls
    if prefix:
        answer["nocs"] = nocs_head(state, shown, image.shape[-1])
        answer["z"] = shape_code(state, shown)
        answer["sdf"] = sdf(state, points, answer["z"])
    return answer


# Random weights -----------------------------------------------------------------------------------------------------------

def random_state(dim, depth, grid, maps, channels, head, last, code, layers, width, seed=1):
    """Weights that keep numbers near 1, under the names of CRISP's checkpoints."""
    torch.manual_seed(seed)
    s = OrderedDict()

    def put(name, *shape, bias=True, fan_in=None):
        s[name + ".weight"] = torch.randn(*shape) / math.sqrt(fan_in or max(1, math.prod(shape[1:])))
        if bias:
            s[name + ".bias"] = 0.1 * torch.randn(shape[0])

    def norm(name, size):
        s[name + ".weight"] = 1 + 0.2 * torch.randn(size)
        s[name + ".bias"] = 0.2 * torch.randn(size)

    s["backbone.cls_token"] = torch.randn(1, 1, dim)
    s["backbone.pos_embed"] = torch.randn(1, 1 + grid * grid, dim)
    s["backbone.mask_token"] = torch.randn(1, dim)
    put("backbone.patch_embed.proj", dim, 3, 14, 14)
    for i in range(depth):
        b = f"backbone.blocks.{i}."
        norm(b + "norm1", dim)
        put(b + "attn.qkv", 3 * dim, dim)
        put(b + "attn.proj", dim, dim)
        s[b + "ls1.gamma"] = torch.rand(dim)
        norm(b + "norm2", dim)
        put(b + "mlp.fc1", 4 * dim, dim)
        put(b + "mlp.fc2", dim, 4 * dim)
        s[b + "ls2.gamma"] = torch.rand(dim)
    norm("backbone.norm", dim)
    if not maps:
        return OrderedDict((name[len("backbone."):], value) for name, value in s.items())
    r = "nocs_net.reassemble_blocks."
    for i, c in enumerate(maps):
        put(f"{r}projects.{i}", c, dim, 1, 1, bias=False)
        put(f"{r}readout_projects.{i}.0", dim, 2 * dim)
        put(f"nocs_net.convs.{i}", channels, c, 3, 3, bias=False)
    for i, k in ((0, 4), (1, 2)):
        put(f"{r}resize_layers.{i}", maps[i], maps[i], k, k, fan_in=maps[i])
    put(f"{r}resize_layers.3", maps[3], maps[3], 3, 3)
    for i in range(4):
        f = f"nocs_net.fusion_blocks.{i}."
        put(f + "project", channels, channels, 1, 1)
        for unit in ("1", "2") if i else ("2",):
            for j in ("1", "2"):
                put(f"{f}res_conv_unit{unit}.conv{j}", channels, channels, 3, 3, bias=False)
                norm(f"{f}res_conv_unit{unit}.bn{j}", channels)
    put("nocs_net.project", channels, channels, 3, 3)
    put("nocs_net.conv_nocs.head.0", head, channels, 3, 3)
    norm("nocs_net.conv_nocs.head.2", head)
    put("nocs_net.conv_nocs.head.3", last, head, 3, 3)
    put("nocs_net.conv_nocs.head.5", 3, last, 1, 1)
    a = "recons_backbone_adaptor.net."
    for i, size in ((0, 5 * dim), (3, code), (6, code)):
        put(f"{a}{i}", code, size)
        norm(f"{a}{i + 1}", code)
    put(a + "9", 2 * layers * width, code)
    for i in range(layers):
        put(f"recons_net.filmed_sdf.{i}.0.layer", width, width if i else 3)
    put("recons_net.final_layer", 1, width)
    return s


SIZES = {
    "full": dict(dim=384, depth=12, grid=37, maps=[48, 96, 192, 384], channels=256, head=128, last=32, code=512, layers=5, width=256),
    "tiny": dict(dim=24, depth=4, grid=7, maps=[4, 8, 12, 16], channels=8, head=12, last=6, code=20, layers=3, width=16),
    "backbone": dict(dim=384, depth=1, grid=37, maps=[], channels=0, head=0, last=0, code=0, layers=0, width=0),
}

if __name__ == "__main__":
    state = random_state(**SIZES[sys.argv[2]])
    if sys.argv[2] == "backbone":
        torch.save(state, sys.argv[1])
    else:
        torch.save({"model": state, "optimizer": {}, "epoch": 1, "hparams": {}}, sys.argv[1])
