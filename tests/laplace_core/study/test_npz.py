"""Saved studies and gamma-spaces of one's own: they come back whole, and hostile files are refused unread."""

import io
import tracemalloc
import warnings
import zipfile

import numpy as np
import pytest

from laplace_core import InputError, load_world
from laplace_core.cli import main
from laplace_core.code.gamma_space import with_noise
from laplace_core.inverse.bands import reward_gain
from laplace_core.study import npz as saved_module
from laplace_core.study.npz import bands_of_study, npz_bytes, read_gamma_space, save_study, states_of, study_arrays
from laplace_core.study.pipeline import GammaSpace, basis_of, decoder, read_study, study, study_of_gamma_space
from laplace_core.study.settings import Settings
from tests.support.hostile import assert_nothing_written, assert_one_sentence
from tests.support.malformed_saved import (
    CASES,
    DATA,
    GOOD,
    described,
    npy,
    npy_by_hand,
    npz,
    own_values,
    pickles,
    with_arrays,
    with_member,
)


@pytest.fixture
def own(tmp_path):
    """The path of a gamma-space file with this content."""

    def write(content: bytes):
        path = tmp_path / "own.npz"
        path.write_bytes(content)
        return path

    return write


def refusal(path, state: str | None = None) -> str:
    with warnings.catch_warnings(record=True) as heard:
        warnings.simplefilter("always")
        with pytest.raises(InputError) as refused:
            read_gamma_space(path, state)
    assert [str(warning.message) for warning in heard] == []
    return f"laplace: {refused.value}"


def assert_sound(found: GammaSpace) -> None:
    actions, gammas, thetas = found.values.shape
    assert actions >= 1
    assert found.constant.shape == (actions, gammas)
    assert found.gammas.shape == (gammas,)
    assert found.thetas.shape == (thetas,)
    for array in (found.values, found.constant, found.gammas, found.thetas):
        assert array.dtype == np.float64
        assert np.all(np.isfinite(array))
    assert np.all((found.gammas > 0) & (found.gammas < 1))
    assert np.all(np.diff(found.thetas) > 0)


# --- there and back ---


@pytest.mark.parametrize("source", ["two_branch", "fig6_chain", "cliff_grid", "gym:FrozenLake-v1"])
@pytest.mark.parametrize("normalise", ["none", "paper"])
def test_a_saved_study_is_read_and_decoded_to_the_same(tmp_path, source, normalise):
    first = study(load_world(source), Settings(world=source, thetas=20, normalise=normalise, softness=0.2))
    path = tmp_path / "study.npz"
    save_study(first, path)
    space = read_gamma_space(path)
    assert_sound(space)
    for name in ("values", "constant", "gammas", "thetas"):
        np.testing.assert_array_equal(getattr(space, name), getattr(first.gamma_space, name))
    s = first.settings
    reading = Settings(alpha=s.alpha, steps=s.steps, normalise=normalise, acting_gamma=s.acting_gamma, softness=0.2)
    again = study_of_gamma_space(space, reading)
    for name in ("tau_space", "survival", "expected_reward", "horizon_values", "actions"):
        np.testing.assert_array_equal(getattr(again.decoded, name), getattr(first.decoded, name))
    assert again.truth is None


def test_a_saved_file_holds_the_arrays_of_the_study_and_no_objects(tmp_path):
    found = study(load_world("two_branch"), Settings(thetas=10))
    path = tmp_path / "study.npz"
    save_study(found, path)
    assert [entry.name for entry in tmp_path.iterdir()] == ["study.npz"]
    with np.load(path, allow_pickle=False) as file:
        assert set(file.files) == set(study_arrays(found))
        for name, array in study_arrays(found).items():
            np.testing.assert_array_equal(file[name], array)
            assert file[name].dtype == array.dtype


def test_a_study_without_truth_saves_none(tmp_path, own):
    found = study_of_gamma_space(read_gamma_space(own(with_arrays())), Settings(world="own.npz", steps=4))
    save_study(found, tmp_path / "study.npz")
    with np.load(tmp_path / "study.npz", allow_pickle=False) as file:
        assert file["tau_space"].shape == (2, 4, 3)
        assert not [name for name in file.files if name.startswith("true") or name == "optimal_action"]


def test_a_download_holds_what_a_saved_file_holds(tmp_path):
    found = study(load_world("two_branch"), Settings(thetas=10))
    save_study(found, tmp_path / "study.npz")
    with np.load(tmp_path / "study.npz") as file, np.load(io.BytesIO(npz_bytes(found))) as download:
        assert file.files == download.files
        for name in file.files:
            np.testing.assert_array_equal(download[name], file[name])
    np.testing.assert_array_equal(read_gamma_space(npz_bytes(found)).values, found.gamma_space.values)


def test_a_study_that_cannot_be_written_leaves_the_old_file_and_no_other(tmp_path, monkeypatch):
    path = tmp_path / "study.npz"
    path.write_bytes(b"old")
    found = study(load_world("two_branch"), Settings(thetas=10))

    def run_out_of_space(file, **arrays):
        file.write(b"half a file")
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(saved_module.np, "savez_compressed", run_out_of_space)
    with pytest.raises(InputError, match="no space left"):
        save_study(found, path)
    monkeypatch.setattr(saved_module.np, "savez_compressed", lambda *_, **__: pytest.fail("interrupted"))
    with pytest.raises(pytest.fail.Exception):
        save_study(found, path)
    assert [entry.name for entry in tmp_path.iterdir()] == ["study.npz"]
    assert path.read_bytes() == b"old"


# --- one's own data ---


def test_own_data_of_every_shape(subtests, own):
    for with_constant in [True, False]:
        for leading in [(), (1,), (2,), (5, 2), (1, 1)]:
            with subtests.test(with_constant=with_constant, leading=leading):
                values, constant = own_values(leading), None
                if with_constant:
                    constant = np.broadcast_to(np.array([1.0, 1.5, 5.0]), (*leading, 3))
                path = own(with_arrays(gamma_space=values, constant_channel=constant))
                expected_constant = values[..., 0] if constant is None else constant
                if len(leading) < 2:
                    found = read_gamma_space(path)
                    np.testing.assert_array_equal(found.values, values.reshape(-1, 3, 4))
                    np.testing.assert_array_equal(found.constant, expected_constant.reshape(-1, 3))
                    assert_sound(read_gamma_space(path, "0"))
                for state in range(leading[0]) if len(leading) == 2 else ():
                    found = read_gamma_space(path, str(state))
                    np.testing.assert_array_equal(found.values, values[state])
                    np.testing.assert_array_equal(found.constant, expected_constant[state])


def test_own_data_of_every_real_number_type(subtests, own):
    for kind in ["<f4", ">f8", "<f2", "<i4", "|i1", ">u2", "<f16"]:
        with subtests.test(kind=kind):
            values = np.array([[[1, 1, 0, 0], [1, 1, 1, 0], [6, 4, 2, 0]], [[1, 0, 0, 0], [1, 1, 0, 0], [5, 4, 1, 1]]])
            found = read_gamma_space(own(with_arrays(gamma_space=np.asfortranarray(values, dtype=kind))))
            np.testing.assert_array_equal(found.values, values)
            assert_sound(found)


@pytest.mark.parametrize("version", [(1, 0), (2, 0), (3, 0)])
def test_own_data_of_every_header_version(own, version):
    found = read_gamma_space(own(with_member(npy_by_hand(described(), version=version))))
    np.testing.assert_array_equal(found.values, GOOD["gamma_space"])


@pytest.mark.parametrize("compression", [zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED, zipfile.ZIP_BZIP2, zipfile.ZIP_LZMA])
def test_own_data_in_every_packing(own, compression):
    path = own(npz({name: npy(array) for name, array in GOOD.items()}, compression))
    np.testing.assert_array_equal(read_gamma_space(path).values, GOOD["gamma_space"])


def test_headers_of_old_files_are_read_without_remarks(own):
    path = own(with_member(npy_by_hand(described(shape="(2L, 3L, 4L)"))))
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        np.testing.assert_array_equal(read_gamma_space(path).values, GOOD["gamma_space"])


def test_states_that_the_data_does_not_hold_are_refused(subtests, own):
    for state in ["2", "-1", "a", "1.5", "1e0", " 1", "0x1", "9" * 5000, "²", "None", "start"]:
        with subtests.test(state=state):
            one, two = with_arrays(), with_arrays(gamma_space=np.ones((2, 2, 3, 4)), constant_channel=None)
            for content in (one, two):
                assert_one_sentence(refusal(own(content), state), "state", state[:10])


@pytest.mark.parametrize("leading", [(), (1,), (2,), (5, 2), (1, 1)])
def test_uploads_need_no_file(own, leading):
    values = own_values(leading)
    content = with_arrays(gamma_space=values, constant_channel=None)
    count = leading[0] if len(leading) == 2 else 1
    path = own(content)
    for make in (lambda: content, lambda: io.BytesIO(content), lambda: path, lambda: str(path)):
        assert states_of(make()) == count
        for state in (None, *map(str, range(count))):
            found = read_gamma_space(make(), state)
            np.testing.assert_array_equal(found.values, read_gamma_space(path, state).values)
        assert str(count) in refusal(make(), str(count)) or count == 1
    with path.open("rb") as file:
        file.seek(20)
        assert states_of(file) == count  # and once more from the same file, as a page that is drawn again does
        np.testing.assert_array_equal(read_gamma_space(file).values, read_gamma_space(path).values)


def test_an_upload_is_called_by_its_name():
    assert "the file holds no array 'gammas'" in refusal(with_arrays(gammas=None))
    for name in ("mine.npz", "two\nlines.npz", "x" * 400 + ".npz", "\ud800.npz"):
        for content in (with_arrays(gammas=None), b"no zip"):
            with pytest.raises(InputError) as refused:
                read_gamma_space(content, name=name)
            assert_one_sentence(f"laplace: {refused.value}", name[:3].strip("\ud800"))


# --- what is refused ---


def test_a_malformed_file_is_refused_by_name(subtests, own):
    assert CASES
    assert_sound(read_gamma_space(own(with_arrays())))  # what the cases spoil is sound itself
    for name, content, named in CASES:
        with subtests.test(name):
            path = own(content)
            message = refusal(path)
            assert_one_sentence(message, *named)
            assert refusal(content) == refusal(io.BytesIO(content)) == message.replace("own.npz", "the file")
            try:
                assert 1 <= states_of(content) <= 10**6  # what the header shows may be sound all the same
            except InputError as error:
                assert_one_sentence(f"laplace: {error}")


def test_decode_refuses_a_malformed_file_and_writes_nothing(subtests, tmp_path, capsys, own):
    for name, content, named in CASES[::11]:
        with subtests.test(name):
            assert_nothing_written(capsys, ["decode", str(own(content))], tmp_path, *named)


def test_an_ending_in_capitals_is_as_good(tmp_path, capsys):
    path = tmp_path / "MINE.NPZ"
    path.write_bytes(with_arrays())
    assert main(["decode", str(path), "--steps", "5", "--json"]) == 0
    assert "chosen" in capsys.readouterr().out
    assert "read_gamma_space" in Settings(world=str(path)).to_python()


def test_files_that_cannot_be_read_are_refused(tmp_path, capsys):
    (tmp_path / "folder.npz").mkdir()
    (tmp_path / "empty.npz").touch()
    for name in ("folder.npz", "missing.npz", "empty.npz/own.npz", "zero\0byte.npz", "x" * 400 + ".npz", "empty.npz"):
        assert_nothing_written(capsys, ["decode", str(tmp_path / name)], tmp_path, name.rsplit("/")[-1][:4])


def test_nothing_is_unpickled(tmp_path, own):
    trap = tmp_path / "trap"
    for name, content in pickles(str(trap)):
        assert_one_sentence(refusal(own(content)))
        assert not trap.exists(), name
    _, content = next(pickles(str(trap)))
    with np.load(io.BytesIO(content), allow_pickle=True) as file:
        assert file["gamma_space"].shape == (1,)
    assert trap.exists()  # the trap itself works, where pickles are allowed


def test_members_that_are_not_asked_for_are_not_touched(tmp_path, own):
    trap = tmp_path / "trap"
    _, pickled = next(pickles(str(trap)))
    with zipfile.ZipFile(io.BytesIO(pickled)) as archive:
        content = archive.read("gamma_space.npy")
    members = {name: npy(array) for name, array in GOOD.items()}
    path = own(npz(members | {"settings": content, "notes": b"\xff" * 50, "../../escape": content}))
    assert_sound(read_gamma_space(path))
    assert not trap.exists()


@pytest.mark.parametrize("flip", [0x01, 0x80, 0xFF])
def test_a_flipped_byte_is_refused_or_still_sound(own, flip):
    whole = with_arrays()
    outcomes = {True: 0, False: 0}
    for at in range(0, len(whole), 3):
        path = own(whole[:at] + bytes([whole[at] ^ flip]) + whole[at + 1 :])
        try:
            assert_sound(read_gamma_space(path))
            outcomes[True] += 1
        except InputError as error:
            assert_one_sentence(f"laplace: {error}")
            outcomes[False] += 1
    assert min(outcomes.values()) > 50  # dates and the like may change, data and sizes may not


# --- bombs ---


def test_the_limit_counts_what_the_arrays_take_as_float64(own, monkeypatch):
    """One byte a number in the file, eight in memory."""
    path = own(with_member(npy(np.zeros((2, 3, 4), dtype="i1"))))
    total = 8 * (24 + 3 + 4 + 6)
    monkeypatch.setattr(saved_module, "MAX_BYTES", total)
    assert_sound(read_gamma_space(path))
    monkeypatch.setattr(saved_module, "MAX_BYTES", total - 1)
    assert_one_sentence(refusal(path), "MB")


@pytest.mark.parametrize(
    ("shape", "descr"), [("(300000000,)", "'|i1'"), ("(1000, 1000, 200)", "'<f4'"), ("(60000000,)", "'<f8'")]
)
def test_a_zip_bomb_is_refused_before_it_grows(own, monkeypatch, shape, descr):
    """A header with far less behind it than the zip's directory says; memory must not follow either."""
    real_size = zipfile.ZipFile.getinfo

    def inflated(archive, name):
        info = real_size(archive, name)
        info.file_size = 10**10 if name == "gamma_space.npy" else info.file_size
        return info

    path = own(with_member(npy_by_hand(described(descr, shape))))
    monkeypatch.setattr(zipfile.ZipFile, "getinfo", inflated)
    tracemalloc.start()
    try:
        assert_one_sentence(refusal(path), "'gamma_space'", "400 MB")
        assert tracemalloc.get_traced_memory()[1] < 10_000_000
    finally:
        tracemalloc.stop()


def test_a_shape_without_its_numbers_takes_no_memory(own):
    path = own(with_member(npy_by_hand(described(shape="(1000000, 3, 4)"), DATA)))
    tracemalloc.start()
    try:
        assert_one_sentence(refusal(path), "'gamma_space'", "too short")
        with pytest.raises(InputError, match="too short"):
            states_of(path)
        assert tracemalloc.get_traced_memory()[1] < 10_000_000
    finally:
        tracemalloc.stop()


# --- bands ---


@pytest.mark.parametrize(
    "changes",
    [
        {"solver": "nonnegative", "weighting": "equal"},
        {"solver": "nonnegative", "weighting": "deviation"},
        {"solver": "nonnegative", "weighting": "equal", "shift": True},
        {"solver": "nonnegative", "weighting": "equal", "filter": "savgol"},
        {"solver": "tikhonov", "weighting": "equal", "shift": True},
    ],
    ids=lambda changes: " ".join(map(str, changes.values())),
)
def test_the_band_of_a_file_is_the_spread_of_what_is_drawn(changes):
    # A slow twin: the same world under 100 noises, decoded by the same settings. The band of a solver that is not
    # linear is itself the spread of 20 draws around a fitted timeline and not around the true one.
    settings = Settings(world="two_branch", steps=8, thetas=30, alpha=0.3, noise_level=0.01, **changes)
    exact = study(load_world("two_branch"), settings)
    drawn = [
        read_study(with_noise(exact.gamma_space, 0.01, seed), exact.settings).expected_reward for seed in range(100)
    ]
    spread, found = np.std(drawn, axis=0), bands_of_study(exact).noise
    ratio = np.sqrt((found**2).mean(axis=-1) / (spread**2).mean(axis=-1))
    assert np.all((ratio > 0.7) & (ratio < 1.4)), ratio


def test_a_file_of_a_network_has_a_band_of_errors_that_sensitivities_share():
    space = study(load_world("two_branch"), Settings(world="two_branch", thetas=30)).gamma_space
    own = study_of_gamma_space(space, Settings(noise_level=0.01, steps=8, alpha=0.3))
    shared = bands_of_study(own).noise
    inverse = decoder(space.gammas, own.settings)
    deviations = 0.01 / (1.0 - space.gammas)
    gain = reward_gain(space, independent=False)
    np.testing.assert_allclose(shared[0], gain * np.sqrt(inverse**2 @ deviations**2))
    assert gain > 1.0  # a step of reward for each layer, in units of reward


def test_a_file_of_a_learner_has_a_band_of_errors_that_sensitivities_share():
    """As the page of the inverse and the verdict have it: all are learned from the same steps."""
    world, settings = load_world("two_branch"), Settings(world="two_branch", noise_level=0.01, steps=8, thetas=30)
    exact = study(world, settings)
    learned = study(world, settings, learned=basis_of(exact))
    ratio = bands_of_study(learned).noise / bands_of_study(exact).noise
    gains = [reward_gain(exact.gamma_space, independent=each) for each in (False, True)]
    np.testing.assert_allclose(ratio, gains[0] / gains[1])
    assert abs(gains[0] / gains[1] - 1.0) > 0.1
