namespace Nowpose.Cli.Calibrate.Nudge;

/// <summary>Instructions for finding L_visu by eye.</summary>
static class NudgeGuide
{
    public const string Text = """
        L_visu by eye, without camera or LEDs, to about 5 ms:

        1. Show the gripper on the robot, synchronised; note the L_visu that the panel shows (--told-ms, say 40).
        2. Let the robot go to and fro at a constant speed along one axis of its base (--speed-mm-s, 250 or more).
        3. While it goes forwards, shift the hologram along that axis (component Latency Nudge, or any slider that moves
           the base) until hologram and tool agree; note the offset in mm, positive forwards (--forward-mm).
        4. The same while it goes backwards; positive is forwards again (--backward-mm). Repeat both a few times.

        nowpose calibrate nudge --speed-mm-s 250 --told-ms 40 --forward-mm 2.1 1.8 --backward-mm -2.4 -2.0

        A hologram that is told too little lags by v · e, so it is pushed forwards on the way there and back on the way
        back: e is half the difference of the two offsets divided by the speed. Half their sum is an error of the base, that
        no latency explains.

        """;
}
