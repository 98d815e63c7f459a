namespace Nowpose.Cli.Messages;

/// <summary>Messages about failures and states of the command <c>headset</c>, with remedies.</summary>
static class HeadsetMessages
{
    /// <param name="fault">Fault of the connection or of the description; null if there is none.</param>
    /// <param name="robotNamespace">Namespace of the robot; empty for the robot without a namespace.</param>
    public static string NoRobot(double seconds, string fault, string robotNamespace) =>
        (fault == null ? "" : fault + "; ") + "the gateway did not describe a robot"
        + (robotNamespace.Length == 0 ? "" : $" in the namespace {robotNamespace}")
        + FormattableString.Invariant($" within {seconds} s; check the gateway, its source and the packet size (MTU) of a VPN, ")
        + "or use --robot with youbot, ur5 or a .urdf file";

    /// <param name="fault">Message that lists the namespaces of the robots that the gateway serves.</param>
    public static string OtherNamespaces(string fault) => "--namespace: " + fault;

    public static string NamespaceInvalid(string name, int max) =>
        $"--namespace: is '{name}'; allowed: a letter, then letters, digits and underscores, up to {max} characters";

    public static string PlainNotAllowed(string host) =>
        $"--host: {host} is another machine; use --pin with the gateway's pin, or, on a trusted network only, --insecure-lan";

    public static string TokenUnencrypted(string host) =>
        $"--token-file: the token would be sent unencrypted to {host}; use --pin with the gateway's pin";

    public static string LinesLost(long lines) =>
        FormattableString.Invariant($"--record: {lines} lines are missing, because the disk was too slow; record to a faster disk");

    public static string RecordingName(string path) =>
        $"--record: {path}: the recording is neither compressed nor a table; use a name that ends in .jsonl";

    public const string MaximumWithoutRecording = "--record-max-mb: only a recording has a maximum size; use it with --record";

    public static string RecordingStopped(double seconds, string problem) => FormattableString.Invariant($"at {seconds:0.0} s: {problem}");

    public static string NoClock(string reason) => $"the clock was never synchronised: {reason}; run longer (--seconds), or check the connection to the gateway";

    /// <param name="reason">Fault of the connection; null if there is none.</param>
    public static string NoJoints(string reason) =>
        "no joint positions arrived" + (reason == null ? "" : ": " + reason) + "; check that a source publishes them to the gateway";

    /// <param name="reason">Reason why the positions that arrived are not of this robot, with the remedy.</param>
    public static string NoJointsOfRobot(string reason) => $"no joint positions of this robot arrived: {reason}";

    /// <param name="frame">Frame of the robot's base.</param>
    public static string BaseNotCurrent(string frame, string reason) => $"frame {frame}, the base of the robot, is not current: {reason}";

    public static string AtEnd(string state) => $"at the end, the pose is {state}";
    public static string NeverCurrent(string reason) => $"the pose was never current; {reason}";

    public static string RarelyCurrent(double percent, double minPercent, string reason) =>
        FormattableString.Invariant($"the pose was current for {percent:0} % of the time; at least {minPercent:0} % is required; {reason}");

    public static string Outage(double from, double? to, string pose, string reason) =>
        FormattableString.Invariant($"from {from:0.0} to {to:0.0} s the pose was {pose}: {reason}");

    public static string CurrentAgain(double seconds, double outageSeconds) =>
        FormattableString.Invariant($"at {seconds:0.0} s: the pose is current again, after {outageSeconds:0.0} s");

    /// <param name="reason">Empty if it is unknown.</param>
    public static string Pose(double seconds, string pose, string reason) =>
        FormattableString.Invariant($"at {seconds:0.0} s: the pose is {pose}{(reason.Length == 0 ? "" : "; ")}{reason}");
}
