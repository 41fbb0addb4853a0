"""The database is the file that was asked for, whatever its folder is called."""

import shutil

import pytest

from snapjump.tracking.base import Record
from snapjump.tracking.sqlite import Sqlite


@pytest.mark.parametrize("name", ["a%20b", "a%41b", "feature%2Ffoo", "é ü"])
def test_a_folder_of_any_name(tmp_path, tables, name):
    (tmp_path / "a b").mkdir()
    (tmp_path / name).mkdir()
    shutil.copy(tables, tmp_path / name / "mlruns.db")
    store = Sqlite(path=str(tmp_path / name / "mlruns.db"))
    store.check()
    run = store.open(Record("sweep", "FINISHED", 0, 0), None)
    assert store.client.get_run(run).info.status == "RUNNING"
    assert sorted(path.name for path in tmp_path.iterdir()) == sorted({"a b", name})
    assert list((tmp_path / "a b").iterdir()) == []
