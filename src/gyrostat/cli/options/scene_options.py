"""Declares the options for a scene, its numbers, and its equilibria, by their names or by a point."""
import argparse
from difflib import get_close_matches

from ...mechanics.families.named_families import called, in_words, known_families, named

THREE = "three numbers or expressions, separated by commas"


def scene_file(verb: argparse.ArgumentParser) -> None:
    """Declare --scene, and the options for a body."""
    verb.add_argument("--scene", metavar="FILE[#NAME]",
                      help="read the table [scene.NAME] of a TOML file, as gyrostat verify does, with "
                      "numbers in values; options override the file")
    verb.add_argument("--inertia", metavar="I1,I2,I3",
                      help=f"the principal moments, {THREE}, or a tensor, its rows separated by semicolons; "
                      "default: I1,I1,I3, or I1,I2,I3 if I2 is set, if U contains k1 or k2, without a field, "
                      "and in orbit")
    verb.add_argument("--gyrostatic-momentum", metavar="L1,L2,L3",
                      help=f"the momentum of the rotor, {THREE}; default: 0,0,l, in orbit l along the axis "
                      "of pitch, or l1,l2,l3 if one of them is set")


def integral(verb: argparse.ArgumentParser) -> None:
    """Declare integrals of the scene, which are not found without it."""
    verb.add_argument("--integral", metavar="EXPR", action="append", dest="integrals",
                      help="an integral of the scene, in pi1, pi2, pi3 (or M1, M2, M3, where M = π + l), "
                      "k1, k2, k3 and the names of the scene; its bracket with the energy is proved to be 0; "
                      "may be repeated")


def claimed_point(verb: argparse.ArgumentParser) -> None:
    """Declare an equilibrium by its coordinates, and the names in which a family is written."""
    verb.add_argument("--point", metavar="PI1,PI2,PI3,K1,K2,K3",
                      help="an equilibrium of any scene by its coordinates, numbers or expressions: "
                      "0,0,I3*w,0,0,1; for a free body PI1,PI2,PI3, in orbit "
                      "PI1,PI2,PI3,N1,N2,N3,R1,R2,R3; the equations of motion are checked there")
    verb.add_argument("--spin", choices=("pi3_0", "omega3_0"),
                      help="the name of the spin of E1 and E2; default: the one that is set, otherwise pi3_0")
    verb.add_argument("--eliminate", metavar="NAME",
                      help="the name that the relation of E3 expresses by the others: k3, l or a name in U; "
                      "default: l, or another name if l is set")
    verb.add_argument("--direction", metavar="K1,K2,K3",
                      help=f"the unit vector along a permanent rotation, {THREE}; or stereographic: by two "
                      "coordinates u1, u2; default: any direction, with the names k1, k2, k3")
    pointing(verb)


def pointing(verb: argparse.ArgumentParser) -> None:
    """Declare the attitude of a satellite."""
    verb.add_argument("--pointing", metavar="ROLL,PITCH,YAW",
                      help="in orbit: the body axes along the velocity, the normal of the orbit and the "
                      "vertical, away from the Earth: 1, 2, 3 in some order, with a minus if the axis points "
                      "the other way, as in 1,-2,-3; default: 1,2,3")


def an_equilibrium(verb: argparse.ArgumentParser, left_out: str, action: str = "store") -> None:
    """Declare equilibria, by their labels or by the words of the field."""
    families = known_families()
    verb.add_argument("--equilibrium", action=action, type=_label, choices=tuple(named(families)),
                      metavar="NAME", help=f"{in_words(families)}; {left_out}")


def _label(text: str) -> str:
    """Read the name of an equilibrium."""
    families = known_families()
    if (family := called(text, families)) is None:
        near = get_close_matches(text.lower(), list(named(families)), 1)
        raise argparse.ArgumentTypeError(f"{text} is no equilibrium: "
                                         f"{f'did you mean {near[0]}? ' if near else ''}"
                                         f"give {in_words(families)}")
    return family.asked_for


def a_scene(verb: argparse.ArgumentParser, meaning: str,
           potential: str = "none for a free body; default: U unspecified") -> None:
    """Declare a field, a body and numbers."""
    verb.add_argument("--potential", metavar="EXPR",
                      help="U in k3, or in k1, k2, k3, and parameters: names, numbers, + - * / ^, "
                      f"parentheses, sqrt, exp, log, sin, …; {potential}")
    verb.add_argument("--orbit", metavar="RATE",
                      help="the rate of a circular orbit: a name or a number, omega0 or '0.0011 rad/s', or "
                      "'mu=398600.4418 km^3/s^2,radius=6778 km' (the radius is that of the Earth plus the "
                      "height); U is then the potential of the gravity gradient, and --potential is what "
                      "acts besides it, in n1, n2, n3, the normal, and r1, r2, r3, the vertical")
    scene_file(verb)
    numbers(verb, meaning)


def numbers(verb: argparse.ArgumentParser, meaning: str) -> None:
    """Declare numbers of names."""
    verb.add_argument("--set", action="extend", nargs="+", default=[], metavar="NAME=VALUE", dest="values",
                      help=f"exact numbers, I1=1.6 l=1/2 k3='sqrt(3)/2': {meaning}")
