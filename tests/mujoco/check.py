"""Every sample's exported MuJoCo model, checked by MuJoCo: at every key frame its loops are closed, and its drives follow the motion.

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
# Simulated seconds in which the drives go through a motion.
SECONDS = 10.0
# How far the workpiece then is from the planned motion at any frame: shares of the linkage's size, and rad.
FOLLOWED = 1e-3
# The sample whose drives are given other controls too.
MUTATED = "3rps.json"


def equality(data):
    """MuJoCo's constraint residuals of the equalities, in the order of its rows."""
    kinds = np.asarray(data.efc_type[: data.nefc])
    return np.asarray(data.efc_pos[: data.nefc])[kinds == mujoco.mjtConstraint.mjCNSTR_EQUALITY]


def residual(model, data, qpos):
    data.qpos[:] = qpos
    data.qvel[:] = 0
    mujoco.mj_forward(model, data)
    return float(np.max(np.abs(equality(data)), initial=0.0))


def exported(synthetica, document, *asked):
    return subprocess.run([synthetica, "export", *asked, "--quiet", document], check=True, capture_output=True, text=True).stdout


def driven(xml, columns, units, size, follow=lambda controls: controls):
    """The largest gap of the workpiece, read from its sensors, while the drives follow the columns of the motion."""
    model = mujoco.MjModel.from_xml_string(xml)
    data = mujoco.MjData(model)
    joints = [model.joint(drive.trnid[0]).name for drive in map(model.actuator, range(model.nu))]
    own = np.array([np.radians(columns[j]) if units[j] == "deg" else columns[j] for j in joints]).T
    assert np.allclose(own, model.key_ctrl, rtol=1e-12, atol=1e-12), "the key frames have other controls than the joints' values"
    controls = follow(own)
    mujoco.mj_resetDataKeyframe(model, data, 0)
    steps = round(SECONDS / (len(controls) - 1) / model.opt.timestep)
    worst = 0.0
    for frame, control in enumerate(controls):
        before = controls[max(frame - 1, 0)]
        for step in range(steps if frame else 0):
            data.ctrl[:] = before + (step + 1) / steps * (control - before)
            mujoco.mj_step(model, data)
        mujoco.mj_forward(model, data)
        place = [columns[axis][frame] for axis in ("x", "y", "z")]
        turn = np.array([columns[part][frame] for part in ("qw", "qx", "qy", "qz")])
        found = data.sensor("workpiece_rotation").data
        angle = 4 * np.arcsin(min(np.linalg.norm(found - turn), np.linalg.norm(found + turn)) / 2)
        worst = max(worst, np.linalg.norm(data.sensor("workpiece_position").data - place) / size, angle)
    assert not any(warning.number for warning in data.warning), "MuJoCo warns"
    return worst


def check(synthetica, document):
    run = lambda *asked: exported(synthetica, document, *asked)
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
        assert np.allclose(qpos, shown, rtol=1e-12, atol=1e-12), f"frame {frame}: joint values differ"
        assert model.key(frame).name == f"frame{columns['frame'][frame]:.0f}" == f"frame{frame}", "frames do not count from 0"
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
    # The model opens as its first frame, and stays there with the controls of that key frame.
    assert np.array_equal(model.qpos0, model.key_qpos[0]), "the reference position is not the first frame"
    mujoco.mj_resetDataKeyframe(model, data, 0)
    mujoco.mj_step(model, data, 100)
    assert np.allclose(data.qpos, model.qpos0, atol=1e-5), "the linkage does not rest"

    assert model.nu == motion["report"]["mobility_rank"], f"{model.nu} drives"
    assert not model.opt.gravity.any(), "gravity, and nobody asked for it"
    # As src/exchange/mjcf.rs has it: the size of the linkage.
    size = model.stat.extent / 1.2
    follow = lambda *asked, **how: driven(run("mjcf", *asked), columns, units, size, **how)
    gaps = [follow(), follow("--gravity")]
    assert max(gaps) < FOLLOWED, f"the workpiece is {gaps[0]:.1e} off the motion, with gravity {gaps[1]:.1e}"
    # The drives are what moves it: left at the first frame, or going there and back, they do not follow the motion.
    if document.endswith(MUTATED):
        for name, other in {"still": lambda c: np.repeat(c[:1], len(c), 0), "back": lambda c: np.concatenate([c[::2], c[::-2]])[: len(c)]}.items():
            gap = follow(follow=other)
            assert gap > 10 * FOLLOWED, f"with controls that go {name} the workpiece is {gap:.1e} off only"
    return worst, worst_pose, gaps, model


def main(synthetica, folder):
    with open(f"{folder}/index.json", encoding="utf-8") as index:
        files = [entry["file"] for entry in json.load(index)]
    assert MUTATED in files, "no document to check"
    for file in files:
        worst, worst_pose, gaps, model = check(synthetica, f"{folder}/{file}")
        print(
            f"{file:16} residual {worst:.1e}, workpiece off by {worst_pose:.1e}; "
            f"{model.nkey} frames, {model.njnt} joints, {model.neq} welds, {model.nu} drives off by {gaps[0]:.1e}, with gravity {gaps[1]:.1e}"
        )


main(*sys.argv[1:])
