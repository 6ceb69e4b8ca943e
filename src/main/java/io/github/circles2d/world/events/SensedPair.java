package io.github.circles2d.world.events;

import io.github.circles2d.world.model.Cells;
import io.github.circles2d.world.model.CircleMath;
import io.github.circles2d.world.model.SensorRule;
import io.github.circles2d.world.model.TouchRule;
import io.github.circles2d.world.model.Tuning;
import io.github.circles2d.world.model.Wrapping;

/** What a step reports of two circles that are only sensed. All back ends have it computed here. */
public final class SensedPair {
    private SensedPair() {}

    /** Records a pair, by starts and paths, if needed: as it begins to touch, or across a gap when it is closest. */
    public static void tell(
            ContactEvents events,
            TouchRecords records,
            int a,
            int b,
            float ax,
            float ay,
            float apx,
            float apy,
            float ar,
            float bx,
            float by,
            float bpx,
            float bpy,
            float br,
            float dt) {
        float dx = Wrapping.shortWay(bx - ax, events.arena().periodX());
        float dy = Wrapping.shortWay(by - ay, events.arena().periodY());
        float ux = bpx - apx;
        float uy = bpy - apy;
        float sum = ar + br;
        float closest = SensorRule.timeOfClosest(dx, dy, ux, uy);
        float least = SensorRule.separation(dx, dy, ux, uy, closest, sum);
        boolean touches = TouchRule.touches(TouchRule.NONE, least);
        if (!TouchRule.staysInTouch(TouchRule.NONE, least, sum)) {
            return;
        }
        int pair = events.find(a, b);
        records.stay(pair == ContactEvents.NONE ? 0 : 1);
        if (!events.concerns(pair, a, b, touches, 0f, 0f, Float.MAX_VALUE)) {
            return;
        }
        float t = touches ? SensorRule.timeOfTouch(dx, dy, ux, uy, sum) : closest;
        float mx = dx + t * ux;
        float my = dy + t * uy;
        float distance = CircleMath.length(mx, my);
        boolean apart = distance > Tuning.COINCIDENT * sum;
        float towardsX = apart ? mx : Cells.partingX(Cells.pairHash(a, b));
        float towardsY = apart ? my : Cells.partingY(Cells.pairHash(a, b));
        float length = CircleMath.length(towardsX, towardsY);
        float nx = towardsX / length;
        float ny = towardsY / length;
        float vn = CircleMath.dot(nx, ny, ux / dt, uy / dt);
        float separation = distance - sum;
        records.add(
                pair,
                a,
                b,
                TouchRule.approach(vn),
                0f,
                nx,
                ny,
                TouchRule.point(ax, t * apx, nx, ar, separation),
                TouchRule.point(ay, t * apy, ny, ar, separation),
                vn,
                Float.MAX_VALUE);
    }
}
