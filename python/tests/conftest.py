"""Names of ufuncs in the names of tests."""


def pytest_make_parametrize_id(config, val, argname):
    return getattr(val, "__name__", None)
