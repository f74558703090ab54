package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import handover.math.Vector3;
import java.nio.charset.StandardCharsets;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Skeletons of which not every joint is tracked, as trackers send them. */
class SkeletonTest {
    private static final WireMessage.Arm LEFT = new WireMessage.Arm(new Vector3(0, 1, 1), new Vector3(0, 0, 1));

    private static List<WireMessage.Arm> arms(String joints, String side) {
        String json = "{'v':1,'type':'gesture','side':'" + side + "','joints':{" + joints + "}}";
        return ((WireMessage.Pointed) Messages.decode(json.replace('\'', '"').getBytes(StandardCharsets.UTF_8))).arms();
    }

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', value = {
        "'left_wrist':[0,1,1],'left_shoulder':[0,0,1],'right_wrist':null,'right_shoulder':[1,0,1] | best",
        "'left_wrist':[0,1,1],'left_shoulder':[0,0,1],'right_wrist':[1,1,1],'right_shoulder':null | best",
        "'left_wrist':[0,1,1],'left_shoulder':[0,0,1],'right_wrist':'lost','right_shoulder':[1,0,1] | best",
        "'left_hand':null,'left_wrist':[0,1,1],'left_shoulder':[0,0,1] | best",
        "'left_hand':null,'left_wrist':[0,1,1],'left_shoulder':[0,0,1] | left"})
    void theArmThatIsTrackedCounts(String joints, String side) {
        assertEquals(List.of(LEFT), arms(joints, side));
    }

    @Test
    void whatIsWrongIsSaidIfNoArmIsLeft() {
        WireException missing = assertThrows(WireException.class, () -> arms("'left_wrist':[0,1,1],'left_shoulder':null", "best"));
        assertEquals(WireCode.MISSING_FIELD, missing.code());
        WireException wrong = assertThrows(WireException.class,
                () -> arms("'left_wrist':'lost','left_shoulder':[0,0,1],'right_wrist':'lost','right_shoulder':[0,0,1]", "best"));
        assertEquals(WireCode.BAD_FIELD + " joints.left_wrist", wrong.code() + " " + wrong.path());
        WireException asked = assertThrows(WireException.class,
                () -> arms("'left_wrist':[0,1,1],'left_shoulder':[0,0,1],'right_wrist':null,'right_shoulder':[1,0,1]", "right"));
        assertEquals(WireCode.MISSING_FIELD, asked.code());
    }
}
