"""The study of work and precision on few, coarse compositions, one refused and one that fails."""

import csv
import json
from pathlib import Path
from typing import Any

import pytest
from cells import GIVEN, run_study
from families import FAMILIES

from experiments.compositions import changed, described
from experiments.tradeoff import study as module
from experiments.tradeoff import tiers
from experiments.tradeoff.curves import Curve, adaptive, curves, estimate_order, fixed, tolerance
from experiments.tradeoff.modelling import DEFAULT, models
from experiments.tradeoff.study import Tradeoff
from snapjump.checks import ParameterError
from snapjump.composition import with_tier
from snapjump.declare.members import member_names
from snapjump.tiers import TIERS

COARSE = (16, 24)
CONFIG: dict[str, Any] = {
    **described(with_tier("draft")),
    "task": {"name": "tradeoff", "designs": 2, "tier_designs": 2},
    **GIVEN,
}


def few_curves(base: Any, full: bool) -> list[Curve]:
    broken = changed(base, {"contact": {"distance_m": 1e-9}})
    refused = changed(base, {"frame": {"name": "fixed"}})
    return [
        Curve(
            "generalized_alpha adaptive",
            "generalized_alpha",
            adaptive(base, "generalized_alpha", COARSE),
        ),
        Curve(
            "generalized_alpha fixed", "generalized_alpha", fixed(base, "generalized_alpha", COARSE)
        ),
        Curve("broken", "generalized_alpha", adaptive(broken, "generalized_alpha", COARSE[:1])),
        Curve("refused", "generalized_alpha", adaptive(refused, "generalized_alpha", COARSE[:1])),
    ]


@pytest.fixture
def few_compositions(tmp_path, monkeypatch) -> Path:
    """A folder, with one tier, few curves and few models beside a limit that is none."""
    monkeypatch.chdir(tmp_path)
    draft = {name: TIERS[name] for name in ("draft", "standard")}
    for place in (module, tiers):
        monkeypatch.setattr(place, "TIERS", draft)
    monkeypatch.setattr(tiers, "PROMISES", {"draft": (3.0, 0.03)})
    loose = {"name": "adaptive", "tolerance": 1e-6, "contact_steps": 1.0}
    limit = {"discretization": {"elements": 48}, "stepping": loose}
    monkeypatch.setattr(tiers, "FINEST", limit)
    monkeypatch.setattr(module, "curves", few_curves)
    monkeypatch.setattr(module, "tier_block", lambda points, designs: "table")

    def two_models(base: Any) -> Any:
        return dict(list(models(base).items())[:2])

    def coarse_tier(base: Any, name: str) -> Any:
        return changed(tiers.tier_groups(base, name), {"discretization": {"elements": 32}})

    monkeypatch.setattr(module, "models", two_models)
    monkeypatch.setattr(module, "tier_groups", coarse_tier)
    return tmp_path / "run"


def test_tables_and_figures_of_few_compositions(few_compositions):
    outcome, folder = run_study(Tradeoff(), CONFIG, few_compositions)
    assert outcome.status == "ok", outcome.message
    assert outcome.summary["cells_refused"] == 1 and outcome.summary["compositions"] == 4
    for name in ("precision_p95", "precision_median", "modelling"):
        assert (folder.path / f"{name}.png").stat().st_size > 20_000
    levels = list(csv.DictReader((folder.path / "levels.csv").read_text().splitlines()))
    twice = ["generalized_alpha adaptive"] * 2 + ["generalized_alpha fixed"] * 2
    assert [row["curve"] for row in levels] == [*twice, "broken", "refused"]
    assert float(levels[0]["ms"]) > 0.0 and float(levels[0]["x_median_percent"]) > 0.0
    failures = (folder.path / "failures.csv").read_text()
    assert "step_underflow" in failures and "frame = 'fixed' is not allowed" in failures
    beyond = (folder.path / "beyond.csv").read_text().splitlines()
    assert all(line.startswith(("tier,", "draft,")) for line in beyond)
    front = list(csv.DictReader((folder.path / "front.csv").read_text().splitlines()))
    assert front and all(float(row["x_p95_percent"]) > 0.0 for row in front)
    report = (folder.path / "report.md").read_text()
    assert "To have x and y right" in report and "confirms the limit" in report
    records = json.loads((folder.path / "children.json").read_text())["children"]
    (record,) = [r for r in records if r["name"].startswith("generalized_alpha adaptive, 16")]
    assert record["metrics"]["x_median_percent"] == float(levels[0]["x_median_percent"])


def test_every_integrator_and_discretization_is_in_it_by_name():
    base = described(with_tier("standard"))
    found = curves(base, full=False)
    assert len(found) >= 24
    assert len({curve.name for curve in found}) == len(found)
    for name in member_names("integrator"):
        assert {f"{name} adaptive", f"{name} fixed"} <= {curve.name for curve in found}
    for name in set(FAMILIES["discretization"]) - {"der"}:
        assert f"generalized_alpha, {name}" in {curve.name for curve in found}


def test_tolerances_follow_the_mesh_and_the_order_of_the_estimate():
    assert tolerance(120) == pytest.approx(1e-6)
    assert tolerance(240) == pytest.approx(1e-6 / 2**3)
    assert estimate_order("implicit_euler") == 2.0
    # As many steps: h^2 and h^3 of the same h.
    assert tolerance(120, 2.0) ** (1 / 2) == pytest.approx(tolerance(120) ** (1 / 3))


def test_models_differ_in_one_number():
    base = described(with_tier("standard"))
    found = models(base)
    assert found.pop(DEFAULT) == base
    assert "eta = 1e-05 s" not in found and {"eta = 0 s", "d_hat x 0.5", "K x 10"} <= set(found)
    for groups in found.values():
        different = [
            (group, key) for group in base for key in base[group] if base[group] != groups[group]
            and base[group][key] != groups[group][key]
        ]  # fmt: skip
        assert len(different) == 1


def test_a_tier_leaves_the_physical_model_alone():
    model = {"friction": {"velocity_threshold_m_s": 1e-3}, "contact": {"distance_m": 1e-3}}
    base = changed(described(with_tier("draft")), model)
    groups = tiers.tier_groups(base, "reference")
    assert groups["friction"]["velocity_threshold_m_s"] == groups["contact"]["distance_m"] == 1e-3
    tier = described(with_tier("reference"))
    assert all(groups[family] == tier[family] for family in ("discretization", "stepping"))
    assert tiers.tier_groups(base, "paper")["friction"]["name"] == "lagged"


def test_bad_numbers_of_designs():
    for key, value in (("designs", 1), ("tier_designs", "many"), ("designs", 2000)):
        with pytest.raises(ParameterError, match=f"task.{key} = "):
            Tradeoff().prepare({**CONFIG, "task": {**CONFIG["task"], key: value}})
