"""Every sample's exported MuJoCo model, checked by MuJoCo: at every key frame its loops are closed.

usage: check.py SYNTHETICA FOLDER   SYNTHETICA is the built command; the index of FOLDER names the documents
"""

import json
import subprocess
import sys

import mujoco
import numpy as np

# Largest violation of MuJoCo's own equality constraints: lengths, and for rotations the sine of half the angle.
RESIDUAL = 1e-6
# The workpiece in MuJoCo and in the planned motion: lengths, and parts of the quaternion.
POSE = 1e-9
# A joint moved by this much (rad or length) must open a loop by a good part of it.
MOVED = 0.1
OPENED = 1e-3


def equality(data):
    """MuJoCo's constraint residuals of the equalities, in the order of its rows."""
    kinds = np.asarray(data.efc_type[: data.nefc])
    return np.asarray(data.efc_pos[: data.nefc])[kinds == mujoco.mjtConstraint.mjCNSTR_EQUALITY]


def residual(model, data, qpos):
    data.qpos[:] = qpos
    data.qvel[:] = 0
    mujoco.mj_forward(model, data)
    return float(np.max(np.abs(equality(data)), initial=0.0))


def check(synthetica, document):
    run = lambda kind: subprocess.run([synthetica, "export", kind, document], check=True, capture_output=True, text=True).stdout
    motion = json.loads(run("json"))
    columns = {column["name"]: column["values"] for column in motion["columns"]}
    model = mujoco.MjModel.from_xml_string(run("mjcf"))
    data = mujoco.MjData(model)
    chains = motion["report"]["chains"]

    names = [model.joint(i).name for i in range(model.njnt)]
    wanted = [name for name in columns if name.startswith("chain")]
    assert names == wanted, f"joints {names}, not {wanted}"
    assert model.nq == model.nv == len(wanted), "a joint is not a hinge or a slide"
    assert model.nkey == motion["frames"], f"{model.nkey} key frames of {motion['frames']}"
    units = {column["name"]: column["unit"] for column in motion["columns"]}

    worst = worst_pose = 0.0
    for frame in range(model.nkey):
        qpos = model.key_qpos[frame]
        shown = [np.radians(columns[n][frame]) if units[n] == "deg" else columns[n][frame] for n in names]
        assert np.allclose(qpos, shown, rtol=1e-12, atol=1e-12), f"frame {frame + 1}: joint values differ"
        worst = max(worst, residual(model, data, qpos))
        rows = len(equality(data))
        assert rows == 6 * (len(chains) - 1), f"{rows} rows of equalities for {len(chains)} chains"
        body = data.body("workpiece")
        place = [columns[axis][frame] for axis in ("x", "y", "z")]
        turn = np.array([columns[part][frame] for part in ("qw", "qx", "qy", "qz")])
        apart = min(np.max(np.abs(body.xquat - turn)), np.max(np.abs(body.xquat + turn)))
        worst_pose = max(worst_pose, apart, np.max(np.abs(body.xpos - place)))
    assert worst < RESIDUAL, f"residual {worst:.1e}"
    assert worst_pose < POSE, f"the workpiece is {worst_pose:.1e} off"

    # That closed loops are no accident of the model: any joint that moves alone opens them.
    for joint in range(model.nq if len(chains) > 1 else 0):
        qpos = model.key_qpos[0].copy()
        qpos[joint] += MOVED
        opened = residual(model, data, qpos)
        assert opened > OPENED, f"{names[joint]} moved by {MOVED}, and the loops open by {opened:.1e} only"
    # The model opens as its first frame, and stays there.
    assert np.array_equal(model.qpos0, model.key_qpos[0]), "the reference position is not the first frame"
    mujoco.mj_resetData(model, data)
    mujoco.mj_step(model, data, 100)
    assert np.allclose(data.qpos, model.qpos0, atol=1e-5), "the linkage does not rest"
    return worst, worst_pose, model


def main(synthetica, folder):
    with open(f"{folder}/index.json", encoding="utf-8") as index:
        files = [entry["file"] for entry in json.load(index)]
    assert files, "no document to check"
    for file in files:
        worst, worst_pose, model = check(synthetica, f"{folder}/{file}")
        print(
            f"{file:16} residual {worst:.1e}, workpiece off by {worst_pose:.1e}; "
            f"{model.nkey} frames, {model.njnt} joints, {model.neq} welds"
        )


main(*sys.argv[1:])
