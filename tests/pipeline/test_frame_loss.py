from app.pipeline.frame_loss import LossWindow


def test_a_tenth_of_the_frames_may_get_lost_and_not_more():
    few, many = LossWindow(), LossWindow()
    for i in range(300):
        few.step(i / 100, 1 if i % 12 == 0 else 0)
        many.step(i / 100, 1 if i % 8 == 0 else 0)
    assert not few.too_lossy
    assert many.too_lossy
    for i in range(300, 450):
        many.step(i / 100, 0)
    assert not many.too_lossy
