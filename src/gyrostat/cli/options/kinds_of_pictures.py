"""Declares the pictures of gyrostat plot, each with its options."""
from ..did_you_mean import Parser
from ..help import KINDS, Formatter
from ..output import picture_options
from .scene_options import a_motion, a_scene, an_equilibrium, claimed_point, numbers, pointing, scene_file


def kinds_of_pictures(plot: Parser) -> list[Parser]:
    """Declare the pictures, each with its options."""
    kinds = plot.add_subparsers(dest="kind", required=True, metavar="KIND")
    (sphere, nutation, effective, branches, rotors, staude, plane, amended, diagram, eigenvalues, well, cones,
     attitudes, librations, smelt) = (
        kinds.add_parser(name, help=line, description=sentences, formatter_class=Formatter)
        for name, (line, sentences) in KINDS.items())
    scene_file(sphere)
    numbers(sphere, "I1, I2, I3; l or l1, l2, l3")
    sphere.add_argument("--momentum", metavar="M", required=True, help="the radius of the sphere, |M|")
    sphere.add_argument("--energy", metavar="H", action="append",
                        help="draw the polhode of this energy; may be repeated; default: some of each kind")
    for kind in nutation, librations:
        a_motion(kind)
        kind.set_defaults(precision=None)
    a_scene(effective, "I1, I3, l, the names in U, p_phi and p_psi", "required")
    effective.add_argument("--energy", metavar="H", help="draw the motion at this energy, too")
    a_scene(branches, "I1, I3, l, omega and the names in U, or I1, I2, I3, l1, l2, l3 and M, except the name "
           "of the axis", "none for a free gyrostat; required")
    branches.add_argument("--x", metavar="NAME=LOW:HIGH", required=True,
                          help="the parameter, omega or another name, and its range")
    scene_file(rotors)
    numbers(rotors, "I1, I2, I3 and one of l1, l2, l3; the others are the axes")
    rotors.add_argument("--momentum", metavar="M", required=True, help="|M|")
    for kind in staude, plane:
        a_scene(kind, "I1, I2, I3, l or l1, l2, l3, and the names in U",
               "of degree 1 in k1, k2, k3; required")
    plane.add_argument("--x", metavar="omega=LOW:HIGH",
                       help="the range of the rates; default: all at which there are rotations")
    a_scene(amended, "I1, I2, I3, l or l1, l2, l3, the names in U, and C1",
           "of degree 1 or 2 in k1, k2, k3; required")
    a_scene(diagram, "I1, I3, l, the names in U, and p_psi", "required")
    a_scene(eigenvalues, "those of all names in the spectrum except the axis")
    an_equilibrium(eigenvalues, "default for a free body: axis 3")
    claimed_point(eigenvalues)
    eigenvalues.add_argument("--x", metavar="NAME=LOW:HIGH[:COUNT]", required=True,
                             help="the parameter, its range in either direction, and how many values; "
                             "default: 200")
    a_scene(well, "as for decide: those of all names, and C1, omega, M, … of the motion")
    well.add_argument("--number", type=int, metavar="N",
                      help="which equilibrium, by its number in the table of decide; default: the first that "
                      "has a well")
    numbers(cones, "I1 and I3")
    cones.add_argument("--transverse", metavar="W", required=True,
                       help="the angular velocity across the axis")
    cones.add_argument("--axial", metavar="W3", required=True, help="the angular velocity along the axis")
    for kind in attitudes, smelt:
        a_scene(kind, "I1, I2, I3, l or l1, l2, l3, and the names in --orbit and in U")
        pointing(kind)
    for kind in kinds.choices.values():
        picture_options(kind)
    return list(kinds.choices.values())
