namespace Nowpose.Cli.Messages;

/// <summary>Instructions for finding L_visu by eye.</summary>
static class NudgeGuide
{
    public const string Text = """
        How to find L_visu by eye, without camera or LEDs, to about 5 ms:

        1. Show the gripper on the robot. When the clock is synchronised, note the L_visu on the panel (--visu-ms, for example 40).
        2. Move the robot back and forth at a constant speed along one axis of its base (--speed-mm-s, 250 or more).
        3. While it moves forwards, shift the hologram along that axis (component Latency Nudge, or any slider that moves
           the base) until hologram and tool coincide. Note the offset in mm, positive forwards (--forward-mm).
        4. Do the same while it moves backwards; positive is again forwards (--backward-mm). Repeat both a few times.

        nowpose calibrate nudge --speed-mm-s 250 --visu-ms 40 --forward-mm 2.1 1.8 --backward-mm -2.4 -2.0

        If L_visu is too small by e, the hologram lags by v · e, so you shift it in the direction of the motion both times:
        e is half the difference of the two offsets divided by the speed. Half the sum of the offsets is an error of the
        base, which does not depend on the latency.

        """;
}
