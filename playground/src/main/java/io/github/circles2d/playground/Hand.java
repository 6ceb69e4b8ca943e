package io.github.circles2d.playground;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;

/** The tools, of which the mouse has one; and a stream that a key pours, whichever that is. */
final class Hand {
    private static final float STRONGER = 1.25f;
    private static final float LEAST = 0.25f;
    private static final float GREATEST = 12;

    private final Map<ToolKind, Tool> tools = new EnumMap<>(ToolKind.class);
    private final PourTool stream = new PourTool();
    private ToolKind kind = ToolKind.GRAB;
    private float brush = 1;
    private float size = 1;
    private boolean pressed;
    private boolean pouring;
    private float x;
    private float y;

    Hand() {
        tools.put(ToolKind.GRAB, new GrabTool());
        tools.put(ToolKind.POUR, new PourTool());
        tools.put(ToolKind.EXPLODE, new ExplodeTool());
        tools.put(ToolKind.WALL, new WallTool());
        tools.put(ToolKind.ERASE, new EraseTool());
        tools.put(ToolKind.LINE, new ShapeTool(ShapeTool.LINE));
        tools.put(ToolKind.ARC, new ShapeTool(ShapeTool.ARC));
        tools.put(ToolKind.CHAIN, new ChainTool());
        tools.put(ToolKind.CUT, new CutTool());
        tools.put(ToolKind.ROPE, new JointTool(JointTool.ROPE));
        tools.put(ToolKind.SPRING, new JointTool(JointTool.SPRING));
        tools.put(ToolKind.PIN, new PinTool());
        tools.put(ToolKind.BODY, new BodyTool());
    }

    ToolKind kind() {
        return kind;
    }

    Tool tool(ToolKind which) {
        return tools.get(which);
    }

    void take(Sandbox sandbox, ToolKind next) {
        release(sandbox);
        kind = next;
    }

    void press(Sandbox sandbox, float atX, float atY) {
        move(sandbox, atX, atY);
        pressed = true;
        tools.get(kind).press(sandbox, atX, atY, brush);
    }

    /** The mouse is somewhere else, with its button down or not. */
    void move(Sandbox sandbox, float toX, float toY) {
        x = toX;
        y = toY;
        stream.drag(sandbox, toX, toY);
        if (pressed) {
            tools.get(kind).drag(sandbox, toX, toY);
        }
    }

    void release(Sandbox sandbox) {
        if (pressed) {
            tools.get(kind).release(sandbox);
        }
        pressed = false;
    }

    boolean isPressed() {
        return pressed;
    }

    /** An explosion where the mouse is, whatever the tool. */
    void explode(Sandbox sandbox) {
        tools.get(ToolKind.EXPLODE).press(sandbox, x, y, brush);
    }

    /** Whether circles are to be poured where the mouse is, whatever the tool. */
    void pour(Sandbox sandbox, boolean on) {
        if (on && !pouring) {
            stream.press(sandbox, x, y, brush);
        } else if (!on) {
            stream.release(sandbox);
        }
        pouring = on;
    }

    /** Lets go of all that is held: another world comes. */
    void letGo(Sandbox sandbox) {
        release(sandbox);
        pour(sandbox, false);
    }

    /** The same without a look at the world, which has failed. */
    void forget() {
        pressed = false;
        pouring = false;
        stream.forget();
        for (Tool tool : tools.values()) {
            tool.forget();
        }
    }

    void wentBack(Sandbox sandbox) {
        for (Tool tool : tools.values()) {
            tool.wentBack(sandbox);
        }
    }

    /** Scales the brush, or turns the terrain that is held. */
    void scaleBrush(int notches) {
        if (((GrabTool) tools.get(ToolKind.GRAB)).turn(notches)) {
            return;
        }
        brush = (float) Math.min(Math.max(brush * Math.pow(STRONGER, notches), LEAST), GREATEST);
    }

    /** Sets how large circles are that are poured, in those that are usual in the world. */
    void setSize(float factor) {
        size = Math.max(factor, LEAST);
        stream.setSize(size);
        ((PourTool) tools.get(ToolKind.POUR)).setSize(size);
    }

    float size() {
        return size;
    }

    /** How far the tool in hand reaches. */
    float reach(Sandbox sandbox) {
        return tools.get(kind).reach(sandbox.grain()) * brush;
    }

    void beforeStep(Sandbox sandbox) {
        stream.beforeStep(sandbox);
        for (Tool tool : tools.values()) {
            tool.beforeStep(sandbox);
        }
    }

    List<Mark> marks(Sandbox sandbox) {
        List<Mark> marks = new ArrayList<>();
        for (Tool tool : tools.values()) {
            tool.mark(sandbox, marks);
        }
        return marks;
    }
}
