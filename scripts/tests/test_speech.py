"""Sound to words. What needs PocketSphinx or espeak-ng is skipped where they are missing."""
import array
import importlib.util
import math
import os
import shutil
import subprocess
import sys
import tempfile
import unittest
import wave

HERE = os.path.dirname(os.path.abspath(__file__))
sys.path.insert(0, os.path.dirname(HERE))
import speech_pocketsphinx as speech  # noqa: E402
from client import BadInput  # noqa: E402

COLOURS = ["red", "blue", "green", "yellow", "ball", "block", "marker"]
HAS_SPHINX = importlib.util.find_spec("pocketsphinx") is not None


class SoundTest(unittest.TestCase):
    def test_pieces_have_one_size_and_lose_nothing(self):
        sound = [b"abc", b"", b"defgh", b"i"]
        self.assertEqual([b"abcd", b"efgh", b"i\0\0\0"], list(speech.frames(sound, 4)))
        self.assertEqual([b"abcd"], list(speech.frames([b"abcd"], 4)))

    def test_resampling_keeps_a_tone(self):
        tone = lambda rate: array.array("h", [round(9000 * math.sin(2 * math.pi * 440 * k / rate)) for k in range(rate)])
        made, true = speech.resampled(tone(22050), 22050), tone(speech.RATE)
        self.assertEqual(len(true), len(made))
        self.assertLess(max(abs(a - b) for a, b in zip(made[:-1], true)), 100)

    def test_a_wav_file_is_read_at_any_rate_and_from_its_first_channel(self):
        with tempfile.TemporaryDirectory() as folder:
            path = os.path.join(folder, "two.wav")
            with wave.open(path, "wb") as file:
                file.setparams((2, 2, 8000, 0, "NONE", ""))
                file.writeframes(array.array("h", [500, -7] * 8000).tobytes())
            sound = array.array("h", b"".join(speech.wav(path)))
        self.assertEqual({0, 500}, set(sound))
        self.assertEqual(speech.RATE, sound.count(500))

    def test_what_is_no_wav_file_is_named(self):
        with self.assertRaisesRegex(BadInput, "test_speech.py: expected a wav file"):
            speech.wav(os.path.join(HERE, "test_speech.py"))

    def test_the_vocabulary_is_of_all_objects(self):
        objects = [{"words": {"red": 1, "cup": 2}}, {"words": {"cup": 1}}]
        self.assertEqual(["cup", "red"], speech.vocabulary({"objects": objects}))
        with self.assertRaises(BadInput):
            speech.vocabulary({"name": "x"})


@unittest.skipUnless(HAS_SPHINX, "pocketsphinx is missing: pip install -r scripts/requirements-speech.txt")
class RecogniserTest(unittest.TestCase):
    def test_words_that_the_dictionary_lacks_are_left_out(self):
        self.assertEqual(["fnord"], speech.Recogniser(["red", "fnord"]).missing)
        with self.assertRaisesRegex(BadInput, "none of the domain's words is in the dictionary: fnord"):
            speech.Recogniser(["fnord"])

    def test_a_bad_dictionary_is_named(self):
        with self.assertRaisesRegex(BadInput, "/nowhere.dict"):
            speech.Recogniser(["red"], "/nowhere.dict")

    def test_silence_is_nothing(self):
        self.assertEqual([], list(speech.Recogniser(COLOURS).utterances([bytes(64000)])))

    @unittest.skipUnless(shutil.which("espeak-ng"), "espeak-ng is missing: apt-get install espeak-ng")
    def test_hears_what_is_said(self):
        for said, heard in (("give me the red ball", "give me the red ball"), ("no", "no"),
                            ("i want the green marker", "i want the green marker"),
                            ("not the red one, but the blue one", "not the red one but the blue one"),
                            ("the green marker please", "the green marker please")):
            with self.subTest(said), tempfile.TemporaryDirectory() as folder:
                path = os.path.join(folder, "said.wav")
                subprocess.run(["espeak-ng", "-v", "en-us", "-w", path, said], check=True)
                (text, ago), = speech.Recogniser(COLOURS).utterances(speech.wav(path))
                self.assertEqual(heard, text)
                self.assertTrue(0.2 < ago < 5, ago)


if __name__ == "__main__":
    unittest.main()
