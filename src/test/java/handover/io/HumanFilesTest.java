package handover.io;

import static handover.io.BadDomains.json;
import static handover.io.BadDomains.quoted;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import handover.domain.ActParameters;
import handover.domain.DomainSpec;
import handover.math.Vector3;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Map;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A human file changes what it says about people, and nothing else. */
class HumanFilesTest {
    private static final String TOP = "; this is a human file, which may have here description, tau, tau_human, "
            + "understanding, perception, speech, gesture, shoulder, objects, acts";
    private static final DomainSpec PLANNER = DomainFiles.fromJson(json(BadDomains.GOOD), "x")
            .with(s -> s.tau = 0.9);

    @TempDir
    Path folder;

    @Test
    void anEmptyOneChangesNothing() throws IOException {
        assertEquals(PLANNER, read("{'$schema': '../schema/human.schema.json'}"));
    }

    @Test
    void everyKeyArrives() throws IOException {
        DomainSpec people = read("{'description': 'odd', 'tau_human': 0.5, 'understanding': {'sigma_look': 1},"
                + "'speech': {'alpha': 3}, 'gesture': {'variance': 0.2}, 'shoulder': [0, 2, 0],"
                + "'objects': [{'name': 'box', 'words': {'crate': 4}}], 'acts': {'ask': {'speech_rate': 0.1}}}");
        assertEquals(PLANNER.tau(), people.tau());
        assertEquals(0.5, people.tauHuman());
        assertEquals(1, people.understanding().sigmaLook());
        assertEquals(PLANNER.understanding().sigmaPoint(), people.understanding().sigmaPoint());
        assertEquals(3, people.speech().alpha());
        assertEquals(0.2, people.gesture().variance());
        assertEquals(new Vector3(0, 2, 0), people.shoulder());
        assertEquals("odd", people.description());
        assertEquals(PLANNER.objects().get(0), people.objects().get(0));
        assertEquals(Map.of("crate", 4.0), people.objects().get(1).words());
        assertEquals(PLANNER.objects().get(1).position(), people.objects().get(1).position());
        ActParameters ask = PLANNER.act("ask");
        assertEquals(new ActParameters(ask.reward(), ask.duration(), 0.1, ask.gestureRate(), ask.answerIfMatch(),
                ask.answerIfMiss()), people.act("ask"));
        assertEquals(PLANNER.act("pick"), people.act("pick"));
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            {'tau': 2} | tau: expected a probability in [0, 1], got 2.0
            {'tau': null} | tau: expected a number, got null
            {'speech': {'contrast': 2}} | speech.contrast: expected a probability in [0, 1], got 2.0
            {'shoulder': [0, 200, 0]} | shoulder[1]: expected metres in [-100, 100], got 200.0
            {'objects': {}} | objects: expected a list [...], got {}
            {'objects': [{'name': 'cup'}]} | objects[0].words: this key is missing
            {'objects': [{'name': 'box', 'words': {'Red': 1}}]} \
            | objects[0].words.Red: expected one lower-case word, got "Red"
            {'objects': [{'name': 'mug', 'words': {}}]} \
            | objects[0].name: expected the name of an object, one of cup, box, got "mug"
            {'objects': [{'name': 'cup', 'words': {}}, {'name': 'cup', 'words': {}}]} \
            | objects[1].name: expected each object once, got "cup" again
            {'acts': {'ask': {'gesture_rate': 3}}} \
            | acts.ask.gesture_rate: expected a probability in [0, 1], got 3.0
            {'acts': {'ask': {'reward': 3}}} | acts.ask.reward: unknown key; \
            this is a human file, which may have here speech_rate, gesture_rate, answer_if_match, answer_if_miss
            {'acts': {'aks': {}}} | acts.aks: unknown key (did you mean "ask"?); \
            this is a human file, which may have here wait, look, point, ask, pick
            {'objects': [{'name': 'cup', 'words': {}, 'position': [0, 0, 0]}]} | objects[0].position: unknown key; \
            this is a human file, which may have here name, words
            {'speech': {'alpha': 0}, 'objects': [{'name': 'box', 'words': {}}]} \
            | with these people in the domain: objects[1].words: expected at least one word with a count above 0, \
            because with speech.alpha = 0 nothing that is said could mean this object
            """)
    void saysExactlyWhatIsWrong(String text, String message) {
        assertMessage(message, text);
    }

    @Test
    void whatIsNotAboutPeopleIsRefused() {
        assertMessage("rewards: unknown key" + TOP, "{'rewards': {}}");
        assertMessage("prior: unknown key" + TOP, "{'prior': {}}");
        assertMessage("spech: unknown key (did you mean \"speech\"?)" + TOP, "{'spech': {}}");
    }

    @Test
    void aMissingFileIsNamed() {
        Path missing = folder.resolve("missing.json");
        assertEquals(missing + ": there is no such file",
                assertThrows(DomainFileException.class, () -> DomainFiles.readHuman(PLANNER, missing)).getMessage());
        assertEquals(folder + ": is a directory, not a file",
                assertThrows(DomainFileException.class, () -> DomainFiles.readHuman(PLANNER, folder)).getMessage());
    }

    private void assertMessage(String message, String text) {
        DomainFileException e = assertThrows(DomainFileException.class, () -> read(text));
        assertEquals(folder.resolve("human.json") + ": " + message, e.getMessage());
    }

    private DomainSpec read(String text) throws IOException {
        return DomainFiles.readHuman(PLANNER, Files.writeString(folder.resolve("human.json"), quoted(text)));
    }
}
