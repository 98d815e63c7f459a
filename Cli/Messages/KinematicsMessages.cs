namespace Nowpose.Cli.Messages;

/// <summary>Error messages and notes of the command <c>kinematics</c>, with the allowed values.</summary>
static class KinematicsMessages
{
    public static string BeyondLimits(string joint, double value, string unit, double lower, double upper) =>
        FormattableString.Invariant($"joint {joint}: {value} {unit} is outside its limits {lower} to {upper} {unit}; this value is used. ")
        + $"To use another, set {joint} in --joints";

    public static string NotAPair(string entry) => $"--joints: '{entry}' must have the form name=value";
    public static string FixedJoint(string joint) => $"{joint} is a fixed joint";
    public static string UnknownJoint(string joint) => $"the robot has no joint {joint}";

    public static string JointTwice(string joint) => $"--joints: {joint} is given twice; remove one";
    public static string NotAMovingJoint(string reason, string allowed) => $"--joints: {reason}; allowed: {allowed}";
    public static string WithoutMovingJoint(string reason) => $"--joints: {reason}; {NoMovingJoint}";

    public const string NoMovingJoint = "this robot has no moving joint; remove --joints";

    public static string NotANumber(string joint, string text, string unit) =>
        $"--joints: {joint}: '{text}' is not a finite number in {unit}; use a point as the decimal separator";

    public const string TooLarge = "--joints: these values are too large to compute the poses; use smaller ones";

    public static string Title(string robot, string root) => $"{robot}: poses relative to {root}, metres\n";
}
