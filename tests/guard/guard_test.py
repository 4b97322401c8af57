"""Runs what action.yml and .pre-commit-hooks.yaml say in a folder of graphs, as a build server and pre-commit would: in a
good folder all steps pass, and each mistake fails the step that looks for it. Usage: guard_test.py PATINA SOURCE"""
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import tempfile
import unittest

try:
    import yaml
except ImportError:  # another Python than Debian's, for which scripts/setup installs it
    os.execv("/usr/bin/python3", ["/usr/bin/python3", "-B", *sys.argv])

PATINA = SOURCE = ""

GOOD = """{
  "patina": 1,
  "workflow": "unlit",
  "surface": { "color": 0.5 }
}
"""
SNAPSHOT = '{ "patina": 1, "size": 8, "via": "cpu" }\n'
MISTAKES = {  # the step that finds it -> what the graph becomes
    "patina check": GOOD.replace('"color"', '"colour"'),
    "patina fmt --check": GOOD.replace("0.5", " 0.5"),
    "patina snapshot": GOOD.replace("0.5", "0.9"),
}
# A graph with a mistake has no picture, so this step fails, too.
ALSO = {"patina check": {"patina fmt --check", "patina snapshot"}, "patina fmt --check": set(), "patina snapshot": set()}


def write(path, text):
    os.makedirs(os.path.dirname(path) or ".", exist_ok=True)
    with open(path, "w", encoding="utf-8") as file:
        file.write(text)


def read(path):
    with open(path, encoding="utf-8") as file:
        return file.read()


def load(name):
    return yaml.safe_load(read(os.path.join(SOURCE, name)))


class InAFolder(unittest.TestCase):
    def setUp(self):
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        os.chdir(folder.name)
        for name in ("art/rust", "art/a name/with spaces"):
            write(name + ".graph.json", GOOD)
            write(name + ".snapshot.json", SNAPSHOT)
        subprocess.run([PATINA, "snapshot", "art", "--update"], check=True, capture_output=True)

    def expect_failures(self, failed_steps):
        """`failed_steps`: runs all steps, and gives the names of those that fail."""
        self.assertEqual(failed_steps(), set())
        for step, graph in MISTAKES.items():
            shutil.rmtree("received", ignore_errors=True)
            write("art/a name/with spaces.graph.json", graph)
            failed = failed_steps()
            self.assertIn(step, failed)
            self.assertLessEqual(failed, {step} | ALSO[step], step)
            if "patina snapshot" in failed:
                self.assertIn("a name/with spaces", read("received/report.html"))
            write("art/a name/with spaces.graph.json", GOOD)
        self.assertEqual(failed_steps(), set())


class Action(InAFolder):
    def run_steps(self, given):
        """As GitHub runs a composite action: the results by step, and what `uses` was given."""
        action = load("action.yml")
        inputs = {name: each["default"] for name, each in action["inputs"].items()} | given
        failed, used = set(), {}
        write("env", "")
        for step in action["runs"]["steps"]:
            if failed and "!cancelled()" not in step.get("if", ""):
                continue
            known = lambda text: re.sub(r"\$\{\{ inputs\.(\w+) \}\}", lambda found: inputs[found[1]], text)
            if "uses" in step:
                used[step["uses"]] = {key: known(value) for key, value in step["with"].items()}
                continue
            env = dict(os.environ, GITHUB_ENV=os.path.abspath("env"), GITHUB_ACTION_PATH=SOURCE)
            env |= dict(line.split("=", 1) for line in read("env").splitlines())
            env |= {key: known(value) for key, value in step.get("env", {}).items()}
            self.assertNotIn("${{", step["run"], "an input that becomes a part of a script could be one")
            self.assertEqual(step["shell"], "bash")
            done = subprocess.run(["bash", "--noprofile", "--norc", "-e", "-o", "pipefail", "-c", step["run"]], env=env,
                                  capture_output=True, text=True, check=False)
            if done.returncode != 0:
                failed.add(step["name"])
        return failed, used

    def test_is_a_composite_action(self):
        action = load("action.yml")
        self.assertEqual(action["runs"]["using"], "composite")
        for key in ("name", "description"):
            self.assertIsInstance(action[key], str)
        for name, each in action["inputs"].items():
            self.assertEqual(set(each), {"description", "default"}, name)
            self.assertIsInstance(each["default"], str)

    def test_each_step_fails_where_it_should(self):
        self.expect_failures(lambda: self.run_steps({"patina": PATINA, "folder": "art"})[0])

    def test_the_report_is_the_artefact(self):
        write("art/rust.graph.json", MISTAKES["patina snapshot"])
        failed, used = self.run_steps({"patina": PATINA, "folder": "art", "artifact": "mine"})
        self.assertEqual(failed, {"patina snapshot"})
        (action, given), = used.items()
        self.assertRegex(action, r"^actions/upload-artifact@v\d+$")
        self.assertEqual(given["name"], "mine")
        for name in ("report.html", "results.xml", "rust.received.png"):
            self.assertTrue(os.path.getsize(os.path.join(given["path"], name)))

    def test_shards_share_the_work(self):
        write("art/rust.graph.json", MISTAKES["patina snapshot"])
        failed = [bool(self.run_steps({"patina": PATINA, "folder": "art", "shard": f"{i}/2"})[0]) for i in (1, 2)]
        self.assertEqual(sorted(failed), [False, True])

    def test_what_it_builds_with_is_there(self):
        build = load("action.yml")["runs"]["steps"][0]["run"]
        for path in re.findall(r"scripts/\w+", build):
            self.assertTrue(os.access(os.path.join(SOURCE, path), os.X_OK), path)
        self.assertIn("--programs", read(os.path.join(SOURCE, "scripts/setup")))


class Hooks(InAFolder):
    def test_each_hook_fails_where_it_should(self):
        os.environ["PATH"] = os.path.dirname(PATINA) + os.pathsep + os.environ["PATH"]

        def failed_hooks():
            files = [os.path.join(folder, name)[2:] for folder, _, names in os.walk(".") for name in names]
            failed = set()
            for hook in load(".pre-commit-hooks.yaml"):
                chosen = [file for file in files if re.search(hook["files"], file)]
                self.assertTrue(chosen, hook["id"])
                command = shlex.split(hook["entry"]) + hook.get("args", [])
                if hook.get("pass_filenames", True):
                    command += chosen
                if subprocess.run(command, capture_output=True, check=False).returncode != 0:
                    failed.add(hook["name"])
            return failed
        self.expect_failures(failed_hooks)

    def test_have_what_pre_commit_needs(self):
        for hook in load(".pre-commit-hooks.yaml"):
            for key in ("id", "name", "entry", "language", "files"):
                self.assertIsInstance(hook[key], str)
            self.assertEqual(hook["language"], "system")


class Documentation(InAFolder):
    def blocks(self, language):
        page = read(os.path.join(SOURCE, "docs/snapshots.md"))
        return re.findall(rf"^```{language}\n(.*?)^```", page, flags=re.DOTALL | re.MULTILINE)

    def test_its_workflow_and_hooks_use_what_there_is(self):
        workflow, hooks = map(yaml.safe_load, self.blocks("yaml"))
        step = workflow["jobs"]["patina"]["steps"][-1]
        self.assertLessEqual(set(step["with"]), set(load("action.yml")["inputs"]))
        known = {each["id"] for each in load(".pre-commit-hooks.yaml")}
        self.assertEqual({each["id"] for each in hooks["repos"][0]["hooks"]}, known)

    def test_every_key_of_its_snapshot_is_known(self):
        snapshot, = self.blocks("jsonc")
        write("art/rust.snapshot.json", snapshot)
        done = subprocess.run([PATINA, "snapshot", "art", "--only", "rust"], capture_output=True, text=True, check=False)
        for code in ("bad-snapshot", "unknown-key", "bad-json"):
            self.assertNotIn(f"[{code}]", done.stderr)
        self.assertEqual(done.stdout.count("failed   rust._Metallic="), 3, done.stdout)  # GOOD has no such property

    def test_its_limits_are_the_defaults(self):
        done = subprocess.run([PATINA, "snapshot", "art", "--json"], capture_output=True, text=True, check=True)
        for name, gate in json.loads(done.stdout)["cases"][0]["gates"].items():
            page = read(os.path.join(SOURCE, "docs/snapshots.md"))
            row, = re.findall(rf"^\| `{name}` \|.*\| ([0-9.]+) \|$", page, flags=re.MULTILINE)
            self.assertEqual(float(row), gate["limit"], name)


if __name__ == "__main__":
    SOURCE = os.path.abspath(sys.argv.pop())
    PATINA = os.path.abspath(sys.argv.pop())
    unittest.main()
