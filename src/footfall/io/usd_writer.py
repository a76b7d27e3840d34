"""USD files out: a skeleton, its animation, and a mannequin that shows it in any viewer."""

from __future__ import annotations

import re
import tempfile
from pathlib import Path
from typing import Any

import numpy as np

from footfall.arrays import Floats, Positions
from footfall.extras import extra_module
from footfall.geometry import continuous
from footfall.io.atomic import write_atomically
from footfall.io.clip_mannequin import COLORS, clip_mannequin
from footfall.io.mannequin import Tone
from footfall.motion import Clip
from footfall.skeleton import Skeleton
from footfall.skeleton.landmarks import rest_positions

__all__ = ["save_usd"]


def save_usd(clip: Clip, path: Path) -> None:
    """Write a .usda (text), .usdc or .usd (binary) file.

    One time code is one frame. Joint names that USD does not allow are kept in ``jointNames``.

    Args:
        clip: The motion.
        path: The file; replaced if it exists.

    Raises:
        FileFormatError: If the file cannot be written.
        MissingExtraError: If usd-core is not installed.
    """
    pxr: Any = {
        name: extra_module(f"pxr.{name}", f"writing {path.name}", extra="usd", library="usd-core")
        for name in ("Gf", "Sdf", "Usd", "UsdGeom", "UsdShade", "UsdSkel", "Vt")
    }
    suffix = path.suffix.lower()
    with tempfile.TemporaryDirectory() as folder:
        # The library writes files only; the name that is asked for must not see half of one.
        scratch = Path(folder) / f"clip{suffix}"
        stage = pxr["Usd"].Stage.CreateNew(str(scratch))
        _write_stage(stage, clip, pxr)
        stage.GetRootLayer().Save()
        data = scratch.read_bytes()
    write_atomically(path, data)


def _write_stage(stage: Any, clip: Clip, pxr: Any) -> None:
    geometry, skel = pxr["UsdGeom"], pxr["UsdSkel"]
    geometry.SetStageUpAxis(stage, geometry.Tokens.y)
    geometry.SetStageMetersPerUnit(stage, 1.0)
    stage.SetTimeCodesPerSecond(clip.fps)
    stage.SetFramesPerSecond(clip.fps)
    stage.SetStartTimeCode(0)
    stage.SetEndTimeCode(clip.frames - 1)
    stage.GetRootLayer().documentation = f"{clip.name}, written by footfall"
    root = skel.Root.Define(stage, "/Body")
    stage.SetDefaultPrim(root.GetPrim())
    skeleton = _skeleton(stage, clip.skeleton, pxr)
    animation = _animation(stage, clip, pxr)
    binding = skel.BindingAPI.Apply(skeleton.GetPrim())
    binding.CreateAnimationSourceRel().SetTargets([animation.GetPath()])
    _mannequin(stage, clip, skeleton, pxr)


def _paths(skeleton: Skeleton) -> list[str]:
    """Return the joints' paths, of names that USD allows and that differ among brothers."""
    paths: list[str] = []
    for joint, name in enumerate(skeleton.names):
        allowed = re.sub(r"\W", "_", name, flags=re.ASCII) or "_"
        if allowed[0].isdigit():
            allowed = f"_{allowed}"
        parent = int(skeleton.parents[joint])
        prefix = f"{paths[parent]}/" if parent >= 0 else ""
        while f"{prefix}{allowed}" in paths:
            allowed += "_"
        paths.append(f"{prefix}{allowed}")
    return paths


def _moves(places: Positions, pxr: Any) -> Any:
    return pxr["Vt"].Matrix4dArray(
        [pxr["Gf"].Matrix4d().SetTranslate(pxr["Gf"].Vec3d(*place)) for place in places.tolist()]
    )


def _skeleton(stage: Any, skeleton: Skeleton, pxr: Any) -> Any:
    """Define the skeleton; at rest no joint is turned."""
    prim = pxr["UsdSkel"].Skeleton.Define(stage, "/Body/Skeleton")
    prim.CreateJointsAttr(_paths(skeleton))
    prim.CreateJointNamesAttr(list(skeleton.names))
    prim.CreateBindTransformsAttr(_moves(rest_positions(skeleton), pxr))
    prim.CreateRestTransformsAttr(_moves(skeleton.rest_offsets, pxr))
    return prim


def _animation(stage: Any, clip: Clip, pxr: Any) -> Any:
    vt, gf = pxr["Vt"], pxr["Gf"]
    prim = pxr["UsdSkel"].Animation.Define(stage, "/Body/Skeleton/Animation")
    prim.CreateJointsAttr(_paths(clip.skeleton))
    prim.CreateScalesAttr(vt.Vec3hArray([gf.Vec3h(1, 1, 1)] * clip.skeleton.count))
    places, turns = prim.CreateTranslationsAttr(), prim.CreateRotationsAttr()
    offsets = clip.skeleton.rest_offsets.astype(np.float32)
    rotations = continuous(clip.local_rotations).tolist()
    for frame in range(clip.frames):
        offsets[0] = clip.pelvis_positions[frame]
        places.Set(vt.Vec3fArray.FromNumpy(offsets), frame)
        turns.Set(vt.QuatfArray([gf.Quatf(*turn) for turn in rotations[frame]]), frame)
    return prim


def _mannequin(stage: Any, clip: Clip, skeleton: Any, pxr: Any) -> None:
    """Define the mesh of the mannequin, each vertex bound to two joints."""
    surface = clip_mannequin(clip)
    places = surface.positions + rest_positions(clip.skeleton)[surface.joints]
    mesh = pxr["UsdGeom"].Mesh.Define(stage, "/Body/Mannequin")
    mesh.CreateSubdivisionSchemeAttr("none")
    mesh.CreatePointsAttr(_vectors(places, pxr))
    mesh.CreateNormalsAttr(_vectors(surface.normals, pxr))
    mesh.SetNormalsInterpolation(pxr["UsdGeom"].Tokens.vertex)
    mesh.CreateFaceVertexCountsAttr([3] * len(surface.triangles))
    mesh.CreateFaceVertexIndicesAttr(surface.triangles.reshape(-1).tolist())
    mesh.CreateExtentAttr(_vectors(np.stack([places.min(axis=0), places.max(axis=0)]), pxr))
    binding = pxr["UsdSkel"].BindingAPI.Apply(mesh.GetPrim())
    binding.CreateSkeletonRel().SetTargets([skeleton.GetPath()])
    joints = np.stack([surface.joints, surface.others], axis=-1)
    weights = np.stack([1.0 - surface.shares, surface.shares], axis=-1)
    binding.CreateJointIndicesPrimvar(False, 2).Set(joints.reshape(-1).tolist())
    binding.CreateJointWeightsPrimvar(False, 2).Set(weights.reshape(-1).tolist())
    binding.CreateGeomBindTransformAttr(pxr["Gf"].Matrix4d(1.0))
    for tone in np.unique(surface.tones).tolist():
        faces = np.flatnonzero(surface.tones == tone).tolist()
        _painted(stage, mesh, Tone(tone), faces, pxr)


def _vectors(array: Floats, pxr: Any) -> Any:
    return pxr["Vt"].Vec3fArray.FromNumpy(np.ascontiguousarray(array, dtype=np.float32))


def _painted(stage: Any, mesh: Any, tone: Tone, faces: list[int], pxr: Any) -> None:
    """Give some faces of the mesh their color."""
    shade, sdf = pxr["UsdShade"], pxr["Sdf"]
    name = tone.name.title().replace("_", "")
    material = shade.Material.Define(stage, f"/Body/Materials/{name}")
    shader = shade.Shader.Define(stage, f"/Body/Materials/{name}/Surface")
    shader.CreateIdAttr("UsdPreviewSurface")
    color = shader.CreateInput("diffuseColor", sdf.ValueTypeNames.Color3f)
    color.Set(pxr["Gf"].Vec3f(*COLORS[tone]))
    shader.CreateInput("roughness", sdf.ValueTypeNames.Float).Set(0.75)
    material.CreateSurfaceOutput().ConnectToSource(shader.ConnectableAPI(), "surface")
    family = pxr["UsdShade"].MaterialBindingAPI.Apply(mesh.GetPrim())
    subset = family.CreateMaterialBindSubset(name, faces)
    shade.MaterialBindingAPI.Apply(subset.GetPrim()).Bind(material)
