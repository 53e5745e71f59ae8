"""Runs the tests of a file inside Blender: one line for each that fails, and the exit status."""
import os
import sys
import unittest

import desk

FOLDER = desk.ARGUMENTS[1] if len(desk.ARGUMENTS) > 1 else ''
PROGRAM = os.environ.get('PENPOSE', '')  # the program itself, for what is compared with it


def model(name):
    """The path of a model of the folder that was given; the test is left out where there is none."""
    path = os.path.join(FOLDER, name)
    if not FOLDER or not os.path.exists(path):
        raise unittest.SkipTest('%s is not there' % name)
    return path


def main(module):
    """Runs all tests of a module (those whose name holds a further argument) and ends Blender."""
    chosen = desk.ARGUMENTS[2] if len(desk.ARGUMENTS) > 2 else ''
    tests = unittest.defaultTestLoader.loadTestsFromModule(sys.modules[module])
    suite = unittest.TestSuite(t for case in tests for t in case if chosen in t.id())
    result = unittest.TestResult()
    suite.run(result)
    for test, text in result.failures + result.errors:
        lines = text.strip().splitlines()
        print('WRONG %s: %s' % (test.id().split('.', 2)[-1], text if chosen else lines[-1]))
    for test, why in result.skipped:
        print('left out %s: %s' % (test.id().split('.')[-1], why))
    print('%d tests, %d wrong' % (result.testsRun, len(result.failures) + len(result.errors)))
    sys.stdout.flush()
    os._exit(0 if result.wasSuccessful() and result.testsRun else 1)
