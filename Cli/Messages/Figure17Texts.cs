namespace Nowpose.Cli.Messages;

/// <summary>Text of Fig. 17.</summary>
static class Figure17Texts
{
    public const string Title = "The arm at three moments";

    public const string Claim =
        "The compensation is clearly visible in the headset: with it, the gripper is at the robot; without it, the gripper is beside the robot.";

    public static string Beyond(string gaps) => $"With adaptive the gaps are {gaps}.";

    public const string Conditions =
        "The moments are those marked in Fig. 16: A when the robot reaches its full speed, B halfway, C when the speed has fallen to "
        + "half. Gaps are distances between the tool centre points; drawings and table show the first run.";

    public static string Criterion(string moment) =>
        $"At {moment} the gap with compensation is less than half of the gap without (RMS over all runs).";

    public static string Drawing(string held, string predicted, string predictor) =>
        $"The youBot's arm seen from above and in front. The distance to the real gripper is {held} for the uncompensated gripper and {predicted} "
        + $"for the gripper compensated by {predictor}.";

    public const string FullSpeed = "full speed is reached";
    public const string HalfSpeed = "the speed has fallen to half";
}
