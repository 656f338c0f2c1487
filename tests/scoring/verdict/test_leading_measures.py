"""The measures that lead in a task."""

from app.scoring.verdict.leading_measures import leading_measures, leading_of_task


def test_the_measures_of_a_task_are_chosen_by_what_it_has():
    trial = {"e_diff": 1, "dist": 2, "time": 3, "sparc": -4, "collisions": 0}
    assert leading_measures(trial) == ("e_diff", "dist", "time")
    turn = {"heading_error_deg": 3, "turn_drift": 0.1, "time": 9, "collisions": 1}
    assert leading_measures(turn) == ("heading_error_deg", "turn_drift", "time")
    assert leading_measures({"sparc": -4, "mean_speed": 0.3}) == ("sparc",)
    assert leading_measures({}) == ()
    missed = {"gaps": 2, "gap_clearance": None, "e_diff": 1, "time": 3}
    assert leading_of_task([missed, missed | {"gap_clearance": 0.1}]) == ("gap_clearance", "e_diff", "time")
