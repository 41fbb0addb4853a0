"""The table of outputs says what is declared; ``pytest --write-golden`` writes it anew."""

from pathlib import Path

from snapjump.run.tasks.publish import replaced
from snapjump.show.terminal.output_table import output_table

PAGE = Path(__file__).resolve().parents[2] / "docs" / "outputs.md"


def test_the_table_of_outputs_is_that_of_the_declarations(pytestconfig):
    written = PAGE.read_text(encoding="utf-8")
    text = replaced(written, "outputs", output_table())
    if pytestconfig.getoption("--write-golden"):
        PAGE.write_text(text, encoding="utf-8")
    else:
        assert written == text
