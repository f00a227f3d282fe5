"""The plugin in MuJoCo's process, and a folder of baked parts to work in.

NEARFIELD_PLUGIN names the compiled plugin, NEARFIELD the program that bakes: `run` sets both."""

import os
import pathlib
import subprocess

import igl
import mujoco
import pytest

import screw

HERE = pathlib.Path(__file__).parent
SPOT = HERE / "../../tests/meshes/spot.ply"


def bake(mesh, field, *options):
    command = [os.environ["NEARFIELD"], "bake", mesh, "-o", field, *options]
    subprocess.run(command, check=True, capture_output=True)


@pytest.fixture(scope="session")
def parts(tmp_path_factory):
    """A folder with mesh and field of the cow, the bolt and the nut."""
    folder = tmp_path_factory.mktemp("parts")
    meshes = {"spot": igl.read_triangle_mesh(str(SPOT)), "bolt": screw.bolt(), "nut": screw.nut()}
    for name, (vertices, triangles) in meshes.items():
        igl.write_triangle_mesh(str(folder / f"{name}.obj"), vertices, triangles)
        bake(folder / f"{name}.obj", folder / f"{name}.nfd")
    return folder


@pytest.fixture(scope="session")
def plugin():
    mujoco.mj_loadPluginLibrary(os.environ["NEARFIELD_PLUGIN"])


@pytest.fixture
def scene(plugin, parts, monkeypatch):
    """Compiles a scene of this folder, with the text of it changed as told, among the parts."""
    monkeypatch.chdir(parts)

    def compiled(name, changes=()):
        text = (HERE / name).read_text()
        for old, new in changes:
            assert old in text, f"{name} has no {old}"
            text = text.replace(old, new)
        spec = mujoco.MjSpec.from_string(text)
        for mesh in spec.meshes:
            # MuJoCo makes an octree for every geom of type sdf that has a mesh. Nothing asks it where there is a plugin.
            mesh.octree_maxdepth = 1
        return spec.compile()

    return compiled
