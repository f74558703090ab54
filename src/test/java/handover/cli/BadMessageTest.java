package handover.cli;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import handover.io.Messages;
import java.io.IOException;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** A bad message is answered with its code and path, and changes nothing. */
class BadMessageTest {
    private static final String STATE = "{\"v\":1,\"type\":\"state\"}\n";
    private static final String BEFORE = """
            {"v":1,"type":"speech","text":"a silver bowl"}
            {"v":1,"type":"acted","act":"POINT","objects":["metal_bowl"],"status":"started"}
            """;

    @ParameterizedTest
    @CsvSource(delimiter = '|', quoteCharacter = '`', textBlock = """
            hello                                                       | not_json      | ``
            {'v':1,'type':'state'                                       | not_json      | ``
            {'v':1,'type':'state'}{}                                    | not_json      | ``
            [1]                                                         | not_json      | ``
            null                                                        | not_json      | ``
            {'v':1,'v':1,'type':'state'}                                | bad_field     | v
            {'type':'state'}                                            | missing_field | v
            {'v':null,'type':'state'}                                   | missing_field | v
            {'v':2,'type':'state'}                                      | bad_version   | v
            {'v':'1','type':'state'}                                    | bad_version   | v
            {'v':1}                                                     | missing_field | type
            {'v':1,'type':'sing'}                                       | bad_type      | type
            {'v':1,'type':7}                                            | bad_type      | type
            {'v':1,'type':'state','id':7}                               | bad_field     | id
            {'v':1,'type':'state','source':['mic']}                     | bad_field     | source
            {'v':1,'type':'state','t':'now'}                            | bad_field     | t
            {'v':1,'type':'state','t':1763800000120}                    | bad_field     | t
            {'v':1,'type':'speech'}                                     | missing_field | text
            {'v':1,'type':'speech','text':5}                            | bad_field     | text
            {'v':1,'type':'speech','text':'red','final':'no'}           | bad_field     | final
            {'v':1,'type':'speech','text':'a','alternatives':[]}        | bad_field     | text
            {'v':1,'type':'speech','alternatives':[]}                   | bad_field     | alternatives
            {'v':1,'type':'speech','alternatives':{}}                   | bad_field     | alternatives
            {'v':1,'type':'speech','alternatives':['red']}              | bad_field     | alternatives[0]
            {'v':1,'type':'speech','alternatives':[{'transcript':'a'}]} | missing_field | alternatives[0].confidence
            {'v':1,'type':'speech','alternatives':[{'transcript':'a','confidence':1.1}]}   | bad_field | alternatives[0].confidence
            {'v':1,'type':'speech','alternatives':[{'transcript':'a','confidence':NaN}]}   | bad_field | alternatives[0].confidence
            {'v':1,'type':'speech','alternatives':[{'transcript':'a','confidence':'0.5'}]} | bad_field | alternatives[0].confidence
            {'v':1,'type':'gesture','shoulder':[0,0,1]}                         | missing_field | hand
            {'v':1,'type':'gesture','hand':[0,1,1]}                             | missing_field | shoulder
            {'v':1,'type':'gesture','hand':[0,'left',1],'shoulder':[0,0,1]}     | bad_field     | hand[1]
            {'v':1,'type':'gesture','hand':[0,1],'shoulder':[0,0,1]}            | bad_field     | hand
            {'v':1,'type':'gesture','hand':[0,1,1,1],'shoulder':[0,0,1]}        | bad_field     | hand
            {'v':1,'type':'gesture','hand':'up','shoulder':[0,0,1]}             | bad_field     | hand
            {'v':1,'type':'gesture','hand':[0,1,NaN],'shoulder':[0,0,1]}        | bad_field     | hand[2]
            {'v':1,'type':'gesture','hand':[0,1,1],'shoulder':[0,-Infinity,1]}  | bad_field     | shoulder[1]
            {'v':1,'type':'gesture','hand':[0,1e999,1],'shoulder':[0,0,1]}      | bad_field     | hand[1]
            {'v':1,'type':'gesture','hand':[0,1e308,1],'shoulder':[0,0,1]}      | bad_field     | hand[1]
            {'v':1,'type':'gesture','hand':[0,null,1],'shoulder':[0,0,1]}       | bad_field     | hand[1]
            {'v':1,'type':'gesture','hand':[0,0,1],'shoulder':[0,0,1]}          | bad_field     | hand
            {'v':1,'type':'gesture','hand':[0,0,0],'shoulder':[-0.3,0.6,0]}     | bad_field     | shoulder
            {'v':1,'type':'gesture','hand':[0,1,1],'shoulder':[0,0,1],'frame':'camera'}  | unknown_frame | frame
            {'v':1,'type':'gesture','hand':[0,1,1],'shoulder':[0,0,1],'confidence':7}    | bad_field     | confidence
            {'v':1,'type':'gesture','hand':[0,1,1],'joints':{}}                 | bad_field     | joints
            {'v':1,'type':'gesture','joints':{}}                                | missing_field | joints.hand_right
            {'v':1,'type':'gesture','joints':{},'side':'best'}                  | missing_field | joints.hand_right
            {'v':1,'type':'gesture','joints':{},'side':'both'}                  | bad_field     | side
            {'v':1,'type':'gesture','joints':{},'side':'left'}                  | missing_field | joints.hand_left
            {'v':1,'type':'gesture','joints':{'hand_left':[1,1,1]},'side':'left'} | missing_field | joints.shoulder_left
            {'v':1,'type':'acted','act':'WAIT'}                                 | missing_field | status
            {'v':1,'type':'acted','status':'started'}                           | missing_field | act
            {'v':1,'type':'acted','act':'WAIT','status':'done'}                 | bad_field     | status
            {'v':1,'type':'acted','act':'wait','status':'started'}              | illegal_act   | act
            {'v':1,'type':'acted','act':'ASK','status':'started'}               | illegal_act   | objects
            {'v':1,'type':'acted','act':'WAIT','objects':['color_bowl'],'status':'started'} | illegal_act    | objects
            {'v':1,'type':'acted','act':'ASK','objects':'color_bowl','status':'started'}    | bad_field      | objects
            {'v':1,'type':'acted','act':'ASK','objects':[3],'status':'started'}             | bad_field      | objects[0]
            {'v':1,'type':'acted','act':'ASK','objects':['cup'],'status':'started'}         | unknown_object | objects[0]
            {'v':1,'type':'acted','act':'ASK','objects':['color_bowl','color_bowl'],'status':'started'} | bad_field | objects[1]
            {'v':1,'type':'acted','act':'ASK','objects':['color_bowl','cup'],'status':'failed'}    | unknown_object | objects[1]
            {'v':1,'type':'acted','act':'PICK','objects':['color_bowl'],'status':'completed'}      | missing_field  | pick
            {'v':1,'type':'acted','act':'PICK','objects':['color_bowl'],'status':'completed','pick':'moving'} | bad_field | pick
            {'v':1,'type':'acted','act':'PICK','objects':['color_bowl'],'status':'started','pick':'accepted'} | bad_field | pick
            {'v':1,'type':'acted','act':'WAIT','status':'completed','pick':'moving'}               | bad_field      | pick
            {'v':1,'type':'begin','prior':[1]}                          | bad_field      | prior
            {'v':1,'type':'begin','prior':{'color_bowl':0.5}}           | bad_field      | prior
            {'v':1,'type':'begin','prior':{}}                           | bad_field      | prior
            {'v':1,'type':'begin','prior':{'color_bowl':-1}}            | bad_field      | prior.color_bowl
            {'v':1,'type':'begin','prior':{'cup':1}}                    | unknown_object | prior.cup
            """)
    void hasACodeAndAPath(String message, String code, String path) throws IOException {
        assertRefused(message.replace('\'', '"'), code, path);
    }

    @Test
    void sizeAndDepthAreLimited() throws IOException {
        assertRefused("{\"v\":1,\"type\":\"speech\",\"text\":\"" + "red ".repeat(Messages.LARGEST / 4) + "\"}", "too_large", "");
        assertRefused("[".repeat(100_000), "not_json", "");
        assertRefused("{\"v\":1,\"type\":\"state\",\"new\":" + "[".repeat(60) + "]".repeat(60) + "}", "not_json", "");
    }

    @Test
    void unknownFieldsDoNoHarm() {
        Output o = Output.withInput("{\"v\":1,\"type\":\"speech\",\"text\":\"silver\",\"new\":{\"a\":[1]}}\n", "infer",
                "bowls-and-spoons");
        assertTrue(o.out().startsWith("{\"v\":1,\"type\":\"belief\""), o.out());
    }

    @Test
    void theReplyNamesTheMessage() {
        Output o = Output.withInput("{\"type\":\"state\",\"id\":\"m-1\"}", "infer", "bowls-and-spoons");
        assertEquals("{\"v\":1,\"type\":\"error\",\"re\":\"m-1\",\"code\":\"missing_field\",\"path\":\"v\","
                + "\"message\":\"this field is missing\"}\n", o.out());
    }

    @Test
    void whatIsOverIsOver() throws IOException {
        List<String> lines = Output.withInput("""
                {"v":1,"type":"acted","act":"PICK","objects":["color_bowl"],"status":"completed","pick":"accepted"}
                {"v":1,"type":"acted","act":"WAIT","status":"started"}
                {"v":1,"type":"acted","act":"ASK","objects":["color_bowl"],"status":"started"}
                """, "infer", "bowls-and-spoons").lines();
        assertError(lines.get(1), "illegal_act", "act");
        assertError(lines.get(2), "unknown_object", "objects[0]");
    }

    private static void assertRefused(String message, String code, String path) throws IOException {
        List<String> lines = Output.withInput(BEFORE + STATE + message + "\n" + STATE, "infer", "bowls-and-spoons").lines();
        assertEquals(5, lines.size(), lines.toString());
        assertError(lines.get(3), code, path);
        assertEquals(lines.get(2), lines.get(4), "the state is as before");
    }

    private static void assertError(String line, String code, String path) throws IOException {
        JsonNode reply = new ObjectMapper().readTree(line);
        assertEquals("error " + code + " " + path, reply.get("type").asText() + " " + reply.path("code").asText() + " "
                + reply.path("path").asText(), line);
        assertTrue(reply.get("message").asText().length() > 5, line);
    }
}
