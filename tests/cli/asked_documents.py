"""A table of what the verbs are asked: each kind of scene, each verb, each of its forms.

`python tests/cli/asked_documents.py` prints all answers, as text, LaTeX and JSON.
"""
import tempfile
from pathlib import Path
from shlex import split

from gyrostat.cli.parser import main

SCENES = """
[scene.station]
inertia = [3, 3, 5]
values = { omega3_0 = "1/3" }
lumped = true
rotors = [{ axis = [0, 0, 1], axial = "1/2", transverse = "1/3", momentum = 1 }]
"""
NEWTONIAN = "--potential 'e*(I1*k1^2 + I2*k2^2 + I3*k3^2)/2' --gyrostatic-momentum 0,0,0"
HEAVY = "--potential m0*k3 --inertia 5,4,3 --equilibrium E2"
TILTED = "--equilibrium permanent-rotation --direction"
# by the schema of the answer: the verb and its options
QUESTIONS = {
    "report": [f"report {options}" for options in (
        "",
        "--potential m0*k3 --set I1=1 I3=1.6 l=0 m0=1 omega3_0=1.3",
        "--potential exp(a*k3) --equilibrium E3",
        "--potential 'sqrt(Omega)*k3 + mu^(1/3)*k3^2' --equilibrium E3",
        "--potential m0*k3 --equilibrium E1 --spin omega3_0",
        "--potential 'k1*k2 + k3' --point 0,0,I3*w,0,0,1",
        "--potential U(k1,k2,k3) --equilibrium permanent-rotation",
        "--potential none",
        "--orbit omega0",
        "--orbit omega0 --set I1=60 I2=70 I3=35 l=0 omega0=1",
        f"{NEWTONIAN} --integral 'M1^2 + M2^2 + M3^2 - e*(I2*I3*k1^2 + I3*I1*k2^2 + I1*I2*k3^2)'",
    )],
    "conditions": [f"conditions {options}" for options in (
        "",
        "--potential exp(k3)",
        "--potential 'a*log(1 + b*k3) + c*sqrt(2 - k3) + d*exp(e*k3)'",
        "--potential '(a*b*c + p*q)*k3/(r - s*k3)' --equilibrium E1",
        "--potential 'alpha*beta*k3 + gamma*delta*k3^2' --equilibrium E3 --eliminate k3",
        "--potential m*g*z*k3 --inertia A+B,A+B,C*D --gyrostatic-momentum 0,0,r*s*t1",
        "--potential 'a*b*k3 + (c*k1^2 + d*k2^2)/2' --inertia I1,I2,I3 --equilibrium E1",
        f"--potential 'c1*k1 + c3*k3' {TILTED} sin(a),0,cos(a)",
        f"--potential 'p*q*k1 + r*k2 + s*k3' {TILTED} stereographic",
        f"{HEAVY} --windows",
        "--potential m0*k3 --gyrostatic-momentum 0,0,0 --well",
        "--orbit omega0 --gyrostatic-momentum 0,l,0 --well",
        "--potential none",
        "--potential none --inertia I1,I2,I3 --gyrostatic-momentum 0,l,0",
        "--scene {scenes}#station --platform-damping c_p --rotor-damping c_r",
        "--orbit omega0 --pointing 1,-2,-3",
        "--orbit omega0 --inertia A,B,C --gyrostatic-momentum 0,0,0",
        "--orbit omega0 --inertia I1,I1,I3 --gyrostatic-momentum 0,0,l",
    )],
    "solution": [f"conditions {options}" for options in (
        "--potential m0*k3 --equilibrium E1 --solve-for l",
        "--potential 'a*b*k3 + c*d*k3^2/2' --solve-for omega",
        "--potential 'm0*k3 + a*k3^2/2' --equilibrium E2 --solve-for a --set I1=1 m0=1 l=1 I3=2",
        "--potential 'k1*k2 + k3' --inertia 1,2,3 --point 0,0,3*w,0,0,1 --solve-for w --set l=1/2",
        "--potential none --solve-for l",
        "--orbit omega0 --solve-for l --set I1=1 I2=7/10 I3=4/5 omega0=1",
        "--orbit 1 --inertia 3,4,2 --wheel 'axis=0,1,0 inertia=1 speed=s' --solve-for s",
    )],
    "decide": [f"decide {options}" for options in (
        "--potential k1 --inertia 1,2,3 --gyrostatic-momentum 0,0,1/2 --set C1=1/3 --well",
        "--orbit 1 --inertia 60,70,35 --gyrostatic-momentum 0,500,0 --well",
        "--potential 'k3**4 - k3**2/2' --set I1=2 I3=1 l=0 omega=1/2",
        "--potential m0*k3 --equilibrium E1 --set I1=1 I3=1.6 l=0 m0=1 omega3_0=1.25",
        "--potential m0*k3 --equilibrium E3 --set I1=1 I3=1.6 l=1/3 m0=1 omega=3/2",
        "--potential m0*k3 --set I1=2 I3=1 l=1 m0=1 pi3_0=1/2 C1=1/3",
        "--potential 1/(k3-1) --set I1=1 I3=2 l=0 omega=1",
        "--equilibrium E3 --set I1=1 I3=1/2 l=1/3 omega=1 k3=1/2 d2U=2",
        "--potential 'k1*k2 + k3' --point 0,0,I3*w,0,0,1 --set I1=1 I2=2 I3=3 l=1/2 w=5/2",
        "--potential k1 --inertia 3,2,2 --gyrostatic-momentum 0,0,0 --set omega=2",
        "--potential 'k1 + 2*k2' --set I1=1 I2=2 I3=3 l=1 omega=1",
        "--potential 'k1 + k2^2 + k3' --set I1=1 I2=2 I3=3 l=1 omega=1",
        "--potential 'k1 + 2*k2' --set I1=1 I2=2 I3=3 l=1 C1=5",
        "--potential 'k1 + k3' --set I1=1 I2=2 I3=3 l=0",
        "--potential 'k1 + k2 + k3' --set I1=1 I2=2 I3=3 l1=0 l2=1/2 l3=1",
        f"{HEAVY} --normal-form 4 --set m0=1 l=0 pi3_0=11/2",
        f"{HEAVY} --normal-form 6 --set m0=1 l=0 pi3_0=11/2",
        f"{HEAVY} --normal-form 4",
        "--potential none --set I1=1 I2=2 I3=3 l=1 --momentum 2",
        "--potential none --set I1=1 I2=1 I3=3 l=1 --momentum 2",
        "--potential none --inertia 3,1,0;1,3,0;0,0,5 --gyrostatic-momentum 0,0,1 --momentum 2",
        "--potential none --equilibrium 'axis 1' --set I1=1 I2=2 I3=3 l=0 omega1_0=1",
        "--scene {scenes}#station",
        "--orbit omega0 --equilibrium earth-pointing --pointing 1,3,2 --set I1=60 I2=35 I3=70 l=0 omega0=1",
        "--orbit 1 --inertia 1,5/4,8/5 --gyrostatic-momentum 3/10,0,0",
        "--orbit omega0 --equilibrium conical --inertia I1,I1,I3 --gyrostatic-momentum 0,0,l "
        "--set I1=1 I3=8/5 l=-6/5 n3=1/2 omega0=1",
    )],
    "verify": ["verify AR"],
}


def words_of(question, folder):
    """The words of a question; the file of scenes is put into the folder."""
    scenes = Path(folder) / "scenes.toml"
    scenes.write_text(SCENES, encoding="utf-8")
    return [word.replace("{scenes}", str(scenes)) for word in split(question)]


if __name__ == "__main__":
    with tempfile.TemporaryDirectory() as folder:
        for question in (question for questions in QUESTIONS.values() for question in questions):
            verb, *options = words_of(question, folder)
            for form in ("text", "json") if verb == "decide" else ("text", "latex", "json"):
                print(question, form, flush=True)
                assert main([verb, *options, "--format", form]) == 0, question
