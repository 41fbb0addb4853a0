from snapjump.tasks.names import cell_name, sweep_name


def test_a_cell_is_called_by_its_overrides():
    assert cell_name(["design.epsilon=0.1", "sim=jump"]) == "design.epsilon=0.1,sim=jump"
    assert cell_name([]) == "defaults"


def test_names_are_fit_for_folders_and_differ_where_the_overrides_do():
    first, second = cell_name(["robot.mount_height=a/b"]), cell_name(["robot.mount_height=a?b"])
    assert first != second
    assert "/" not in first and "?" not in second
    long = [f"design.epsilon={i / 1000}" for i in range(100)]
    assert len(cell_name(long)) < 120


def test_the_order_of_overrides_does_not_matter_to_a_sweep():
    assert sweep_name(["a=1,2", "b=3"]) == sweep_name(["b=3", "a=1,2"])
    assert sweep_name(["a=1,2"]) != sweep_name(["a=1,3"])


def test_where_a_sweep_is_recorded_does_not_matter():
    assert sweep_name(["a=1,2", "tracking=off"]) == sweep_name(["a=1,2"])
    assert sweep_name(["a=1,2", "tracking.path=x.db"]) == sweep_name(["a=1,2"])
