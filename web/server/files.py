"""Export of models in every format for writing."""

import os

import fieldfab as ff

from .models import Mistakes

FORMULAS = {".frep": lambda model: ff.frep_text(model.parts), ".vm": lambda model: model.solid.vm(),
            ".math": lambda model: model.solid.math()}


def written_formats():
    """Returns {extension: kind} of the formats for a model."""
    kinds = {extension: each["kind"] for each in ff.formats() if each["writes"] for extension in each["extensions"]}
    return {extension: kind for extension, kind in kinds.items()
            if extension in FORMULAS or kind in ("mesh", "distances") or extension == ".vdb"}


def keeps_parts(extension):
    return any(extension in each["extensions"] and each["parts"] for each in ff.formats())


def plate(model, thickness):
    """Returns a flat model extruded to a plate; other models unchanged."""
    if not model.flat:
        return model.parts, None
    slab = ff.Solid(abs(ff.Z) - thickness / 2)
    return [(solid & slab, name, colour) for solid, name, colour in model.parts], thickness


def write(model, request, progress):
    """Writes the file `model` with the extension into the folder `request["into"]`. Returns the values of the
    answer."""
    extension, told = request["extension"], {}
    path = os.path.join(request["into"], "model" + extension)
    if extension in FORMULAS:
        ff.write_file(path, FORMULAS[extension](model))
        return {"bytes": os.path.getsize(path)}
    parts, told["thickness"] = plate(model, request["thickness"])
    united = parts[0][0]
    for solid, _, _ in parts[1:]:
        united = united | solid
    voxel = request["voxel"]
    if extension == ".asdf":
        ff.build(united, voxel=voxel, progress=progress).save(path)
    elif extension == ".vdb":
        ff.write_vdb(united, path, voxel=voxel, progress=progress)
    else:
        apart = keeps_parts(extension) and any(name for _, name, _ in parts)
        meshes = [(ff.mesh(solid, voxel=voxel, progress=progress), name, colour)
                  for solid, name, colour in (parts if apart else [(united, None, None)])]
        meshes = [each for each in meshes if len(each[0].triangles)]
        if not meshes:
            raise Mistakes("there is no surface: the solid is empty, or thinner than the cells")
        if apart:
            ff.save_parts(meshes, path)
        else:
            meshes[0][0].save(path)
        told.update(triangles=sum(len(each.triangles) for each, _, _ in meshes),
                    certain=all(each.certainty.certain for each, _, _ in meshes))
    return {"bytes": os.path.getsize(path), **told}
