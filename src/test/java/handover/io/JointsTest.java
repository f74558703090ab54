package handover.io;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The arms of a skeleton by whatever name. */
class JointsTest {
    @ParameterizedTest
    @CsvSource({
        "ShoulderLeft, HandLeft, WristLeft, left",
        "JointType_ShoulderRight, JointType_HandRight, JointType_WristRight, right",
        "K4ABT_JOINT_SHOULDER_RIGHT, K4ABT_JOINT_HAND_RIGHT, K4ABT_JOINT_WRIST_RIGHT, right",
        "SHOULDER_LEFT, HAND_LEFT, WRIST_LEFT, left",
        "LEFT_SHOULDER, LEFT_HAND, LEFT_WRIST, left",
        "left_shoulder, left_hand, left_wrist, left",
        "r_shoulder, r_hand, r_wrist, right",
        "shoulder_right, hand_right, wrist_right, right"})
    void areFoundByTheirNames(String shoulder, String hand, String wrist, String side) {
        Joints both = Joints.of(Stream.of("Head", wrist, shoulder, hand));
        assertEquals(shoulder + " " + hand, both.shoulder(side) + " " + both.hand(side), "the hand rather than the wrist");
        Joints noHand = Joints.of(Stream.of(wrist, shoulder));
        assertEquals(shoulder + " " + wrist, noHand.shoulder(side) + " " + noHand.hand(side));
        assertFalse(noHand.hasArm(side.equals("left") ? "right" : "left"));
    }

    @Test
    void nothingElseIsAnArm() {
        Joints names = Joints.of(Stream.of("HandTipLeft", "ThumbLeft", "ElbowLeft", "left_index", "hand", "SpineShoulder", "HANDTIP_LEFT",
                "left_shoulder"));
        assertEquals(Map.of("shoulder_left", "left_shoulder"), names.names());
        assertEquals("hand_left", names.hand("left"), "what is missing is named in the standard way");
    }
}
