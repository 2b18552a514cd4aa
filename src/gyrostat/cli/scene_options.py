"""The options that name a scene, and an equilibrium of it by a point."""
import argparse

THREE = "three numbers or expressions, with , between them"


def scene_file(verb: argparse.ArgumentParser) -> None:
    """A scene of a file, and the body of one."""
    verb.add_argument("--scene", metavar="FILE[#NAME]",
                      help="the table [scene.NAME] of a TOML file, as gyrostat verify reads it, with "
                      "numbers in values; options go before what stands in it")
    verb.add_argument("--inertia", metavar="I1,I2,I3",
                      help=f"the principal moments, {THREE}, or a tensor, its rows with ; between them; "
                      "left out: I1,I1,I3, or I1,I2,I3 with I2 set, k1 or k2 in U, or no field")
    verb.add_argument("--gyrostatic-momentum", metavar="L1,L2,L3",
                      help=f"of the rotor, {THREE}; left out: 0,0,l, or l1,l2,l3 where one of them is set")


def claimed_point(verb: argparse.ArgumentParser) -> None:
    """An equilibrium by its coordinates, and by which names a family is written."""
    verb.add_argument("--point", metavar="PI1,PI2,PI3,K1,K2,K3",
                      help="an equilibrium of any scene, in numbers or expressions, 0,0,I3*w,0,0,1; of a "
                      "free body PI1,PI2,PI3; that it is one is checked")
    verb.add_argument("--spin", choices=("pi3_0", "omega3_0"),
                      help="the name of the spin of E1 and E2; left out: that which is set, or pi3_0")
    verb.add_argument("--eliminate", metavar="NAME",
                      help="the name that the relation of E3 expresses by the others, k3, l or one of U; "
                      "left out: as the names that are set ask for it")
    verb.add_argument("--direction", metavar="K1,K2,K3",
                      help=f"of a permanent rotation, {THREE}, a unit vector; or stereographic: by two "
                      "coordinates u1, u2; left out: any, with the names k1, k2, k3")
