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
                      help=f"the principal moments, {THREE}, or a tensor, its rows in brackets or with "
                      "semicolons between them; one unit may stand after all of it, '[[62.1, 1.3, -0.8], "
                      "[1.3, 58, 0.2], [-0.8, 0.2, 30]] kg m^2'; default: I1,I1,I3, or I1,I2,I3 if I2 is "
                      "set, if U contains k1 or k2, without a field, and in orbit")
    verb.add_argument("--products", metavar="SIGN",
                      help="the sign of the products of inertia in a tensor: negative for its entries, "
                      "−∫ xy dm, positive for the integrals ∫ xy dm, as many CAD programs print them; "
                      "default: negative")
    verb.add_argument("--gyrostatic-momentum", metavar="L1,L2,L3",
                      help=f"the momentum of the rotor, {THREE}; in orbit held: the one that holds a tensor "
                      "with products of inertia Earth-pointing, l along the axis of pitch; default: 0,0,l, "
                      "in orbit l along the axis of pitch, or l1,l2,l3 if one of them is set")
    verb.add_argument("--wheel", metavar="TEXT", action="append", dest="rotors",
                      help="instead of --gyrostatic-momentum: a wheel, 'axis=0,0,1 inertia=0.01 kg m^2 "
                      "speed=3000 rpm', its inertia about its axis; speed= of a motor, or momentum= of a "
                      "wheel that runs freely; may be repeated")
    verb.add_argument("--lumped", nargs="?", const=True, choices=(True, False), type=_truth, metavar="TRUTH",
                      help="whether the inertia includes the wheels, true or false; if not, each needs "
                      "transverse=, its inertia across its axis; default: true")


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


def _truth(text: str) -> bool:
    """Read true or false."""
    if text not in ("true", "false"):
        raise argparse.ArgumentTypeError(f"{text} is neither true nor false: give one of the two")
    return text == "true"


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
                      help="a circular orbit: 'height=500 km' above the equator of the Earth, 'height=100 km "
                      "body=moon' (or mars), 'period=95 min', 'mu=398600.4418 km^3/s^2 radius=6878 km', or "
                      "its rate, a name or a number, omega0 or '0.0011 rad/s'; U is then the potential of "
                      "the gravity gradient, and --potential is what acts beside it, in n1, n2, n3, the "
                      "normal, r1, r2, r3, the vertical, and t1, t2, t3, along the velocity: 'f*t1' of a "
                      "drag f whose centre of pressure is at 1 on axis 1")
    scene_file(verb)
    numbers(verb, meaning)


def a_motion(verb: argparse.ArgumentParser) -> None:
    """Declare the options of a body, its state and its times."""
    a_scene(verb, "I1, I3 or I1, I2, I3; l or l1, l2, l3; the names in U",
           "none for a free body")
    verb.add_argument("--state", metavar="PI1,PI2,PI3,K1,K2,K3",
                      help="the exact state at time 0: pi is the momentum with the rotor locked, k the "
                      "direction of the field in the body; for a free body PI1,PI2,PI3, in orbit "
                      "PI1,PI2,PI3,N1,N2,N3,R1,R2,R3")
    pointing(verb)
    verb.add_argument("--release", metavar="ROLL,PITCH,YAW",
                      help="instead of --state: start a satellite at rest in the frame of the orbit, turned "
                      "by these angles, first by yaw and last by roll; '5 deg,0,0', or in rad without a unit")
    verb.add_argument("--until", metavar="T", required=True,
                      help="the last time; if it is negative, the motion goes back from 0")
    among = verb.add_mutually_exclusive_group()
    among.add_argument("--count", type=int, metavar="N",
                       help="how many times from 0 to T; default: 201, for a curve 2001, for a film 150")
    among.add_argument("--step", metavar="DT", help="the time from one to the next, instead of --count")
    verb.add_argument("--tolerance", metavar="X",
                      help="the largest error of a motion that is integrated numerically; default: 1e-3")


def numbers(verb: argparse.ArgumentParser, meaning: str) -> None:
    """Declare numbers of names."""
    verb.add_argument("--set", action="extend", nargs="+", default=[], metavar="NAME=VALUE", dest="values",
                      help=f"exact numbers, I1=1.6 l=1/2 k3='sqrt(3)/2': {meaning}")
