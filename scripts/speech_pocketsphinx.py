#!/usr/bin/env python3
"""Speech to the bridge through PocketSphinx: a wav file, or the microphone, with a grammar of the domain's words.

PocketSphinx's free language model mishears short wishes; a grammar of just what can be said about this table does not. The
grammar has answers ("yes", "no, the blue one"), carrier phrases ("give me the red ball") and negation ("not the red one but
the blue one"). Words that the dictionary lacks are named and left out.
"""
import array
import sys
import time
import wave
from typing import Any, Dict, Iterable, Iterator, List, Optional, Tuple

import client
from client import BadInput
from person import read_json

RATE = 16000  # samples a second, as the acoustic model was trained
INSTALL = "pip install -r scripts/requirements-speech.txt"
# The first utterance is read so often: PocketSphinx learns the mean of a voice and microphone as it goes, and before it has,
# it misreads half of what it reads rightly later (measured with synthetic voices).
ADAPT = 5
ANSWERS = "yes yeah yep yup sure correct no nope nah wrong".split()
CARRIERS = ["give me", "hand me", "i want", "i need", "i would like", "can i have", "could you give me"]


def main() -> int:
    parser = client.options(__doc__)
    parser.add_argument("--wav", metavar="FILE", help="16-bit PCM of any rate (default: the microphone)")
    parser.add_argument("--domain", metavar="FILE", help="whose words may be said (default: those of the bridge)")
    parser.add_argument("--dictionary", metavar="FILE", help="pronunciations (default: PocketSphinx's own, US English)")
    parser.add_argument("--dry-run", action="store_true", help="print what is heard, send nothing (needs --domain)")
    given = parser.parse_args()
    if given.dry_run:
        if not given.domain:
            client.fail("expected --domain with --dry-run")
        return listen(given, read_json(given.domain), None)
    with client.connect(given, "pocketsphinx") as bridge:
        return listen(given, read_json(given.domain) if given.domain else bridge.hello(), bridge)


def listen(given: Any, domain: Dict[str, Any], bridge: Optional[client.Bridge]) -> int:
    """Sends each utterance as it ends; the number of the last belief is printed with it."""
    sound = wav(given.wav) if given.wav else microphone()
    recogniser = Recogniser(vocabulary(domain), given.dictionary)
    if recogniser.missing:
        print("not in the dictionary, so never heard:", ", ".join(recogniser.missing), file=sys.stderr)
    heard = 0
    for text, ago in recogniser.utterances(sound):
        heard += 1
        when = {} if given.wav else {"t": time.time() - ago}  # a file is as if it were said now
        reply = bridge.sensed("speech", text=text, **when) if bridge else None
        print(f'heard "{text}"' + (f", belief {reply['belief']}" if reply else ""), flush=True)
    if not heard and given.wav:
        print(f"{given.wav}: nothing was heard", file=sys.stderr)
    return 0


def vocabulary(domain: Dict[str, Any]) -> List[str]:
    """The words of all objects, in order."""
    try:
        return sorted({w for o in domain["objects"] for w in o["words"]})
    except (KeyError, TypeError) as e:
        raise BadInput("expected objects with words, as in a domain file") from e


def grammar(words: Iterable[str], answers: Iterable[str], carriers: Iterable[str]) -> str:
    """A JSGF grammar of wishes, answers and negations; before a wish only plain answers, as rare ones are often misheard there."""
    return f"""#JSGF V1.0;
grammar handover;
public <utterance> = <answer> | [yes | no] <wish> | [no] not <thing> [<other>];
<answer> = {' | '.join(answers)};
<wish> = [<carrier>] <thing> [please];
<carrier> = {' | '.join(carriers)};
<other> = but <thing> | the <words> [one];
<thing> = [the | a | that] <words> [one];
<words> = <word> [<word>] [<word>];
<word> = {' | '.join(words)};
"""


class Recogniser:
    """PocketSphinx with a grammar. missing: words that its dictionary lacks."""

    def __init__(self, words: List[str], dictionary: Optional[str] = None):
        self._ps = client.need("pocketsphinx", INSTALL)
        model = self._ps.get_model_path
        try:
            self._decoder = self._ps.Decoder(self._ps.Config(
                hmm=model("en-us/en-us"), dict=dictionary or model("en-us/cmudict-en-us.dict"), lm=None, loglevel="FATAL"))
        except (RuntimeError, ValueError) as e:
            raise BadInput(f"{dictionary or 'pocketsphinx'}: expected a pronunciation dictionary ({e})") from e
        known = [w for w in words if self._decoder.lookup_word(w)]
        self.missing = [w for w in words if w not in known]
        if not known:
            raise BadInput("none of the domain's words is in the dictionary: " + ", ".join(words))
        self._decoder.add_jsgf_string("handover", grammar(known, ANSWERS, CARRIERS))
        self._decoder.activate_search("handover")
        self._adapted = False

    def utterances(self, sound: Iterable[bytes]) -> Iterator[Tuple[str, float]]:
        """What was said between pauses, and how many seconds ago it began.

        sound: 16-bit mono at RATE in pieces of any length
        """
        ends = self._ps.Endpointer(sample_rate=RATE)
        said: List[bytes] = []
        seconds = began = 0.0
        for frame in frames(sound, ends.frame_bytes):
            speech = ends.process(frame)
            seconds += ends.frame_length
            if speech is not None:
                began = began if said else seconds
                said.append(speech)
            if said and not ends.in_speech:
                yield from self._read(b"".join(said), seconds - began)
                said = []
        if said:
            yield from self._read(b"".join(said), seconds - began)

    def _read(self, speech: bytes, ago: float) -> Iterator[Tuple[str, float]]:
        for _ in range(1 if self._adapted else ADAPT):
            self._decoder.start_utt()
            self._decoder.process_raw(speech)
            self._decoder.end_utt()
        self._adapted = True
        best = self._decoder.hyp()
        if best and best.hypstr:
            yield best.hypstr, ago


def frames(sound: Iterable[bytes], size: int) -> Iterator[bytes]:
    """The same sound in pieces of one size, the last one filled up with silence."""
    rest = b""
    for piece in sound:
        rest += piece
        while len(rest) >= size:
            yield rest[:size]
            rest = rest[size:]
    if rest:
        yield rest.ljust(size, b"\0")


def wav(path: str) -> Iterator[bytes]:
    """A wav file's first channel at RATE, between a pause before and after it, without which its ends would not be heard."""
    try:
        with wave.open(path, "rb") as file:
            channels, width, rate = file.getnchannels(), file.getsampwidth(), file.getframerate()
            if width != 2:
                raise BadInput(f"{path}: expected 16-bit samples, got {8 * width}-bit ones")
            samples = array.array("h", file.readframes(file.getnframes()))
    except (wave.Error, EOFError) as e:
        raise BadInput(f"{path}: expected a wav file with PCM ({e})") from e
    if sys.byteorder == "big":
        samples.byteswap()
    pause = bytes(RATE)  # half a second
    return iter([pause, resampled(samples[::channels], rate).tobytes(), pause, pause])


def resampled(samples: "array.array[int]", rate: int) -> "array.array[int]":
    """At RATE instead, by straight lines between the samples."""
    if rate == RATE or not samples:
        return samples
    last = len(samples) - 1
    out = array.array("h", bytes(2 * int(len(samples) * RATE / rate)))
    for k in range(len(out)):
        at = k * rate / RATE
        i = min(int(at), last)
        out[k] = round(samples[i] + (at - i) * (samples[min(i + 1, last)] - samples[i]))
    return out


def microphone() -> Iterator[bytes]:
    """The default microphone, until Ctrl-C."""
    device = client.need("sounddevice", INSTALL + " and, on Debian or Ubuntu, apt-get install libportaudio2")
    try:
        with device.RawInputStream(samplerate=RATE, channels=1, dtype="int16") as stream:
            print("listening ...", file=sys.stderr)
            while True:
                yield bytes(stream.read(RATE // 10)[0])
    except device.PortAudioError as e:
        raise BadInput(f"the microphone: {e}") from e


if __name__ == "__main__":
    client.run(main)
