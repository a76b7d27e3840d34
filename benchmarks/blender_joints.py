"""Run by a Python that has bpy: where Blender has the joints of a file, as JSON, y up.

python blender_joints.py FILE OUT.json
"""

from __future__ import annotations

import json
import sys
from typing import Any

import bpy  # type: ignore[import-not-found]  # pyright: ignore

blender: Any = bpy
path, out = sys.argv[-2:]
blender.ops.wm.read_factory_settings(use_empty=True)
if path.endswith(".bvh"):
    blender.ops.import_anim.bvh(
        filepath=path, rotate_mode="QUATERNION", axis_forward="-Z", axis_up="Y",
        update_scene_fps=True,
    )  # fmt: skip
else:
    blender.context.scene.render.fps = 30
    blender.ops.import_scene.gltf(filepath=path)
armature = next(one for one in blender.data.objects if one.type == "ARMATURE")
first, last = map(int, armature.animation_data.action.frame_range)
frames: dict[int, dict[str, list[float]]] = {}
for frame in (first, (first + last) // 2, last):
    blender.context.scene.frame_set(frame)
    heads = {
        bone.name: (armature.matrix_world @ bone.matrix).to_translation()
        for bone in armature.pose.bones
    }
    frames[frame - first] = {name: [v.x, v.z, -v.y] for name, v in heads.items()}
with open(out, "w") as file:
    json.dump(frames, file)
